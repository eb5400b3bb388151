#include "ui/pages/camera_buttons.h"

#include <QHBoxLayout>
#include <QToolButton>

namespace nineline::pages {

CameraButtons::CameraButtons(QWidget* parent) : QWidget(parent) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  const auto add = [this, layout](const QString& text, views::Camera camera) {
    auto* button = new QToolButton(this);
    button->setText(text);
    connect(button, &QToolButton::clicked, this, [this, camera]() { emit chosen(camera); });
    layout->addWidget(button);
  };
  add(tr("3D"), views::Camera::Isometric);
  add(tr("Front"), views::Camera::Front);
  add(tr("Top"), views::Camera::Top);
  add(tr("Side"), views::Camera::Side);
  layout->addStretch(1);
}

}  // namespace nineline::pages
