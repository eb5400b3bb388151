#include "ui/views/scene_view.h"

#include <QVTKOpenGLNativeWidget.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

#include <QMouseEvent>
#include <QVBoxLayout>

namespace nineline::views {

namespace {
constexpr int kClickDistance = 4;  // pixels
}

SceneView::SceneView(QWidget* parent) : QWidget(parent), widget_(new QVTKOpenGLNativeWidget(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(widget_);
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  widget_->setRenderWindow(window);
  widget_->installEventFilter(this);
  widget_->setMinimumSize(120, 90);
}

SceneView::~SceneView() = default;

void SceneView::addRenderer(vtkRenderer* renderer) {
  widget_->renderWindow()->AddRenderer(renderer);
  vtkNew<vtkInteractorStyleTrackballCamera> style;
  widget_->interactor()->SetInteractorStyle(style);
}

void SceneView::addOverlay(vtkRenderer* renderer) {
  widget_->renderWindow()->SetNumberOfLayers(2);
  widget_->renderWindow()->AddRenderer(renderer);
}

bool SceneView::isValid() const { return widget_->isValid(); }

QImage SceneView::picture() const { return widget_->grabFramebuffer(); }

void SceneView::redraw() {
  if (isVisible()) widget_->renderWindow()->Render();
}

bool SceneView::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::MouseButtonPress) {
    pressed_ = static_cast<QMouseEvent*>(event)->pos();
  } else if (event->type() == QEvent::MouseButtonRelease) {
    const QPoint released = static_cast<QMouseEvent*>(event)->pos();
    if ((released - pressed_).manhattanLength() < kClickDistance) {
      const double ratio = widget_->devicePixelRatioF();
      emit clicked(released.x() * ratio, (widget_->height() - 1 - released.y()) * ratio);
    }
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace nineline::views
