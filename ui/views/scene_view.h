#pragma once

#include <QImage>
#include <QWidget>

class QVTKOpenGLNativeWidget;
class QVBoxLayout;
class vtkRenderer;

namespace nineline::views {

/// A VTK window in a widget.
class SceneView : public QWidget {
  Q_OBJECT

 public:
  explicit SceneView(QWidget* parent = nullptr);
  ~SceneView() override;
  /// True once the window has a working OpenGL context.
  [[nodiscard]] bool isValid() const;
  [[nodiscard]] QImage picture() const;
  void redraw();

 signals:
  /// A click without dragging: pixels of the VTK window from its lower left.
  void clicked(double x, double y);

 protected:
  void addRenderer(vtkRenderer* renderer);
  void addOverlay(vtkRenderer* renderer);
  [[nodiscard]] QVTKOpenGLNativeWidget* window3d() const { return widget_; }
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QVTKOpenGLNativeWidget* widget_;
  QPoint pressed_;
};

}  // namespace nineline::views
