#include "ui/scene/curve_chart.h"

#include <vtkAxis.h>
#include <vtkBrush.h>
#include <vtkContextScene.h>
#include <vtkDoubleArray.h>
#include <vtkPen.h>
#include <vtkPlotPoints.h>
#include <vtkRenderer.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>

#include <algorithm>

namespace nineline::scene {

namespace {

constexpr int kTitleSize = 15;
constexpr int kLabelSize = 13;
constexpr int kOuterBorder = 36;
constexpr float kLineWidth = 2.0F;
constexpr float kNodeSize = 8.0F;
constexpr float kDotSize = 6.0F;  // of many
constexpr std::size_t kManyNodes = 40;
constexpr unsigned char kGridShade = 225;

unsigned char byteOf(double part) { return static_cast<unsigned char>(part * 255.0 + 0.5); }

vtkSmartPointer<vtkTable> tableOf(const Series& series) {
  vtkNew<vtkDoubleArray> x;
  vtkNew<vtkDoubleArray> y;
  x->SetName("x");
  y->SetName(series.name.c_str());
  const std::size_t count = std::min(series.x.size(), series.y.size());
  x->SetNumberOfValues(static_cast<vtkIdType>(count));
  y->SetNumberOfValues(static_cast<vtkIdType>(count));
  for (std::size_t i = 0; i < count; ++i) {
    x->SetValue(static_cast<vtkIdType>(i), series.x[i]);
    y->SetValue(static_cast<vtkIdType>(i), series.y[i]);
  }
  auto table = vtkSmartPointer<vtkTable>::New();
  table->AddColumn(x);
  table->AddColumn(y);
  return table;
}

void styleAxis(vtkAxis* axis, const std::string& title) {
  axis->SetTitle(title);
  axis->GetTitleProperties()->SetFontSize(kTitleSize);
  axis->GetTitleProperties()->SetBold(0);
  axis->GetTitleProperties()->SetColor(kInk[0], kInk[1], kInk[2]);
  axis->GetLabelProperties()->SetFontSize(kLabelSize);
  axis->GetLabelProperties()->SetColor(kInk[0], kInk[1], kInk[2]);
  axis->GetGridPen()->SetColor(kGridShade, kGridShade, kGridShade);
  axis->SetBehavior(vtkAxis::AUTO);
}

}  // namespace

CurveChart::CurveChart()
    : view_(vtkSmartPointer<vtkContextView>::New()), chart_(vtkSmartPointer<vtkChartXY>::New()) {
  view_->GetRenderer()->SetBackground(1.0, 1.0, 1.0);
  view_->GetScene()->AddItem(chart_);
  chart_->SetShowLegend(false);
  chart_->SetHiddenAxisBorder(kOuterBorder);
}

void CurveChart::show(const ChartData& data) {
  chart_->ClearPlots();
  styleAxis(chart_->GetAxis(vtkAxis::BOTTOM), data.x_title);
  styleAxis(chart_->GetAxis(vtkAxis::LEFT), data.y_title);
  for (const Series& series : data.series) {
    if (series.x.empty() || series.y.empty()) continue;
    const bool line = series.style == Series::Style::Line && series.x.size() > 1;
    vtkPlot* plot = chart_->AddPlot(line ? vtkChart::LINE : vtkChart::POINTS);
    plot->SetInputData(tableOf(series), 0, 1);
    const auto& c = series.colour;
    plot->SetColor(byteOf(c[0]), byteOf(c[1]), byteOf(c[2]), 255);
    plot->SetWidth(kLineWidth);
    if (auto* points = vtkPlotPoints::SafeDownCast(plot); points != nullptr && !line) {
      points->SetMarkerStyle(vtkPlotPoints::CIRCLE);
      points->SetMarkerSize(series.x.size() > kManyNodes ? kDotSize : kNodeSize);
    }
  }
  chart_->RecalculateBounds();
  view_->GetScene()->SetDirty(true);
}

}  // namespace nineline::scene
