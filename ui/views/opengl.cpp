#include "ui/views/opengl.h"

#include <QVTKOpenGLNativeWidget.h>
#include <vtkOpenGLRenderWindow.h>

#include <QSurfaceFormat>

namespace nineline::views {

namespace {
constexpr int kSamples = 4;
}

void prepareOpenGl() {
  vtkOpenGLRenderWindow::SetGlobalMaximumNumberOfMultiSamples(kSamples);
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
}

}  // namespace nineline::views
