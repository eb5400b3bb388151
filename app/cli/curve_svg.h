#pragma once

#include <string>
#include <vector>

namespace nineline::cli {

/// A line of a plot.
struct PlotLine {
  std::string name;
  std::string colour;  ///< as SVG names it
  std::vector<double> x;
  std::vector<double> y;
};

/// A plot of lines over one axis, with ticks and a legend, as an SVG document. Points that are not finite are
/// left out.
[[nodiscard]] std::string plotSvg(const std::string& title, const std::string& x_label,
                                  const std::string& y_label, const std::vector<PlotLine>& lines);

}  // namespace nineline::cli
