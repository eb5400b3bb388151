#pragma once

#include <vtkChartXY.h>
#include <vtkContextView.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

#include "ui/scene/colour_map.h"

namespace nineline::scene {

/// One curve or set of nodes.
struct Series {
  enum class Style { Line, Nodes };
  std::string name;
  std::vector<double> x;
  std::vector<double> y;
  Style style = Style::Line;
  Colour colour = kAfter;
};

struct ChartData {
  std::string x_title;
  std::string y_title;
  std::vector<Series> series;
};

/// Curves over one variable. Titles hold names and units only ("Z / mm"), so that nothing here needs a
/// translation.
class CurveChart {
 public:
  CurveChart();
  void show(const ChartData& data);
  [[nodiscard]] vtkContextView* view() const { return view_; }

 private:
  vtkSmartPointer<vtkContextView> view_;
  vtkSmartPointer<vtkChartXY> chart_;
};

}  // namespace nineline::scene
