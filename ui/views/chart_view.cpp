#include "ui/views/chart_view.h"

#include <QVTKOpenGLNativeWidget.h>
#include <vtkContextView.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>

#include <QColor>

#include "ui/scene/curve_chart.h"

namespace nineline::views {

namespace {

scene::Colour sceneColour(Role role) {
  switch (role) {
    case Role::Before:
    case Role::Nodes:
      return scene::kBefore;
    case Role::After:
    case Role::Curve:
      return scene::kAfter;
  }
  return scene::kInk;
}

}  // namespace

ChartView::ChartView(QWidget* parent) : SceneView(parent), chart_(std::make_unique<scene::CurveChart>()) {
  chart_->view()->SetRenderWindow(window3d()->renderWindow());
  chart_->view()->SetInteractor(window3d()->interactor());
}

ChartView::~ChartView() = default;

void ChartView::show(const QString& x_title, const QString& y_title, std::vector<Curve> curves) {
  scene::ChartData chart;
  chart.x_title = x_title.toStdString();
  chart.y_title = y_title.toStdString();
  for (Curve& curve : curves) {
    const auto style = curve.role == Role::Nodes ? scene::Series::Style::Nodes : scene::Series::Style::Line;
    chart.series.push_back({"y", std::move(curve.x), std::move(curve.y), style, sceneColour(curve.role)});
  }
  chart_->show(chart);
  redraw();
}

QString ChartView::colourOf(Role role) {
  const scene::Colour colour = sceneColour(role);
  return QColor::fromRgbF(colour[0], colour[1], colour[2]).name();
}

}  // namespace nineline::views
