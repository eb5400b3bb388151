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
    case Role::DotsBefore:
      return scene::kBefore;
    case Role::After:
    case Role::Curve:
    case Role::DotsAfter:
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

void ChartView::show(const QString& x_title, const QString& y_title, std::vector<Curve> curves,
                     const std::vector<Frame>& frames) {
  scene::ChartData chart;
  chart.x_title = x_title.toStdString();
  chart.y_title = y_title.toStdString();
  for (const Frame& frame : frames) {
    const scene::Colour colour = frame.meaning == Frame::Meaning::Place ? scene::kMark : scene::kIdeal;
    chart.series.push_back({"y",
                            {frame.x_low, frame.x_high, frame.x_high, frame.x_low, frame.x_low},
                            {frame.y_low, frame.y_low, frame.y_high, frame.y_high, frame.y_low},
                            scene::Series::Style::Line,
                            colour});
  }
  for (Curve& curve : curves) {
    const bool line = curve.role == Role::Before || curve.role == Role::After || curve.role == Role::Curve;
    const auto style = line ? scene::Series::Style::Line : scene::Series::Style::Nodes;
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
