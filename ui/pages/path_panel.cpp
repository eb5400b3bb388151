#include "ui/pages/path_panel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <array>

#include "ui/models/quantities.h"
#include "ui/pages/camera_buttons.h"
#include "ui/views/path_view.h"

namespace nineline::pages {

namespace {

constexpr std::array kFactors = {1.0,   2.0,   5.0,    10.0,   20.0,   50.0,    100.0,  200.0,
                                 500.0, 1000., 2000.0, 5000.0, 10000., 20000.0, 50000., 100000.};
enum Shown { Both, Before, After };

}  // namespace

PathPanel::PathPanel(QWidget* parent) : QWidget(parent) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 6, 0);
  view_ = new views::PathView(this);
  layout->addWidget(makeControls());
  layout->addWidget(view_, 1);
  picked_ = new QLabel(tr("Click the path to see block, command and deviation."), this);
  picked_->setWordWrap(true);
  picked_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  picked_->setMinimumHeight(3 * picked_->fontMetrics().lineSpacing());
  picked_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  layout->addWidget(picked_);
  auto* row = new QHBoxLayout;
  auto* cameras = new CameraButtons(this);
  connect(cameras, &CameraButtons::chosen, view_, &views::PathView::setCamera);
  auto* save = new QPushButton(tr("Save picture…"), this);
  connect(save, &QPushButton::clicked, this, &PathPanel::pictureWanted);
  row->addWidget(cameras, 1);
  row->addWidget(save);
  layout->addLayout(row);
  connect(view_, &views::PathView::picked, this, &PathPanel::showPicked);
}

QWidget* PathPanel::makeControls() {
  auto* panel = new QWidget(this);
  auto* layout = new QHBoxLayout(panel);
  layout->setContentsMargins(0, 0, 0, 0);
  shown_ = new QComboBox(panel);
  shown_->addItem(tr("Before and after"), Both);
  shown_->addItem(tr("Before compensation"), Before);
  shown_->addItem(tr("After compensation"), After);
  magnification_ = new QComboBox(panel);
  for (const double factor : kFactors) {
    magnification_->addItem(QStringLiteral("× %L1").arg(factor, 0, 'f', 0), factor);
  }
  layout->addWidget(new QLabel(tr("Show"), panel));
  layout->addWidget(shown_, 1);
  layout->addWidget(new QLabel(tr("Deviation magnified"), panel));
  layout->addWidget(magnification_);
  connect(shown_, qOverload<int>(&QComboBox::currentIndexChanged), this, &PathPanel::applyShown);
  connect(magnification_, qOverload<int>(&QComboBox::currentIndexChanged), this,
          [this](int index) { view_->setMagnification(magnification_->itemData(index).toDouble()); });
  return panel;
}

void PathPanel::setOutcome(const kinematics::Machine& machine, const jobs::OutcomePtr& outcome) {
  machine_ = machine;
  view_->setPaths(outcome->before, outcome->after);
  const int index = magnification_->findData(view_->suggestedMagnification());
  {
    const QSignalBlocker blocker(magnification_);
    magnification_->setCurrentIndex(index < 0 ? 0 : index);
  }
  view_->setMagnification(magnification_->currentData().toDouble());
  applyShown();
  view_->setCamera(views::Camera::Isometric);
}

void PathPanel::applyShown() {
  const int shown = shown_->currentData().toInt();
  view_->setShown(true, shown != After, shown != Before);
}

void PathPanel::showPicked(const simulation::PathSample* before, const simulation::PathSample* after) {
  if (before == nullptr || !machine_) return;
  const auto deviations = [this](const simulation::PathSample& sample) {
    QString text = models::deviationText(sample.deviation.tip.norm(), false).mid(1);
    for (int joint = 0; joint < machine_->jointCount(); ++joint) {
      const double error = sample.deviation.joints[static_cast<std::size_t>(joint)];
      text += QStringLiteral("  %1 %2").arg(QString::fromStdString(machine_->joint(joint).axis.text()),
                                            models::deviationText(error, machine_->isRotary(joint)));
    }
    return text;
  };
  QString text = tr("Line %1 · command %2").arg(before->line).arg(models::commandText(*machine_, before->q));
  text += QLatin1Char('\n') + tr("before: %1").arg(deviations(*before));
  if (after != nullptr) text += QLatin1Char('\n') + tr("after: %1").arg(deviations(*after));
  picked_->setText(text);
}

void PathPanel::savePicture(const QString& path) const {
  if (!path.isEmpty()) view_->picture().save(path, "PNG");
}

}  // namespace nineline::pages
