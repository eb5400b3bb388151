#include "app/cli/curve_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

namespace nineline::cli {

namespace {

constexpr double kWidth = 900.0, kHeight = 420.0;                             // of the picture, px
constexpr double kLeft = 80.0, kRight = 880.0, kTop = 50.0, kBottom = 360.0;  // of the plot

/// One scale: values to pixels, and round values to mark.
struct Scale {
  double low = 0.0, high = 1.0;  // values at the ends
  double from = 0.0, to = 1.0;   // pixels at the ends
  double step = 1.0;

  [[nodiscard]] double place(double value) const { return from + (to - from) * (value - low) / (high - low); }
  [[nodiscard]] std::vector<double> ticks() const {
    std::vector<double> values;
    for (double k = std::ceil(low / step); k * step <= high + 1e-9 * step; k += 1.0) {
      values.push_back(k * step + 0.0);  // never -0
    }
    return values;
  }
};

double roundStep(double span) {
  const double raw = span / 7.0;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= raw) return factor * power;
  }
  return 10.0 * power;
}

Scale makeScale(double low, double high, double from, double to) {
  if (!(low <= high)) low = 0.0, high = 1.0;
  const double margin = std::max(0.05 * (high - low), 1e-6);
  Scale scale{low - margin, high + margin, from, to, 1.0};
  scale.step = roundStep(scale.high - scale.low);
  return scale;
}

std::array<double, 2> rangeOf(const std::vector<PlotLine>& lines, bool x, double with) {
  std::array range{with, with};
  for (const PlotLine& line : lines) {
    for (const double value : x ? line.x : line.y) {
      if (!std::isfinite(value)) continue;
      range[0] = std::fmin(range[0], value);
      range[1] = std::fmax(range[1], value);
    }
  }
  return range;
}

std::string label(double x, double y, const char* anchor, const std::string& text, const char* more = "") {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y, anchor, more,
                     text);
}

std::string gridSvg(const Scale& x, const Scale& y) {
  std::string svg;
  const auto line = [&svg](double x1, double y1, double x2, double y2) {
    fmt::format_to(std::back_inserter(svg),
                   "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"#ddd\"/>\n", x1,
                   y1, x2, y2);
  };
  for (const double value : x.ticks()) {
    line(x.place(value), kTop, x.place(value), kBottom);
    svg += label(x.place(value), kBottom + 18.0, "middle", fmt::format("{:.6g}", value));
  }
  for (const double value : y.ticks()) {
    line(kLeft, y.place(value), kRight, y.place(value));
    svg += label(kLeft - 8.0, y.place(value) + 4.0, "end", fmt::format("{:.6g}", value));
  }
  return svg;
}

std::string curveSvg(const PlotLine& line, const Scale& x, const Scale& y) {
  std::string points;
  for (std::size_t i = 0; i < std::min(line.x.size(), line.y.size()); ++i) {
    if (!std::isfinite(line.x[i]) || !std::isfinite(line.y[i])) continue;
    fmt::format_to(std::back_inserter(points), "{:.2f},{:.2f} ", x.place(line.x[i]), y.place(line.y[i]));
  }
  return fmt::format("<polyline fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\" points=\"{}\"/>\n",
                     line.colour, points);
}

}  // namespace

std::string plotSvg(const std::string& title, const std::string& x_label, const std::string& y_label,
                    const std::vector<PlotLine>& lines) {
  constexpr double kUnset = std::numeric_limits<double>::quiet_NaN();
  const std::array x_range = rangeOf(lines, true, kUnset);
  const std::array y_range = rangeOf(lines, false, 0.0);  // zero is always in view
  const Scale x = makeScale(x_range[0], x_range[1], kLeft, kRight);
  const Scale y = makeScale(y_range[0], y_range[1], kBottom, kTop);
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
      "font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
      kWidth, kHeight);
  svg += label(kWidth / 2.0, 24.0, "middle", title, " font-size=\"16\"");
  svg += gridSvg(x, y);
  svg += label((kLeft + kRight) / 2.0, kHeight - 18.0, "middle", x_label);
  svg += label(20.0, (kTop + kBottom) / 2.0, "middle", y_label,
               fmt::format(" transform=\"rotate(-90 20 {:.1f})\"", (kTop + kBottom) / 2.0).c_str());
  double legend = kLeft + 10.0;
  for (const PlotLine& line : lines) {
    svg += curveSvg(line, x, y);
    svg += label(legend, kTop - 8.0, "start", line.name, fmt::format(" fill=\"{}\"", line.colour).c_str());
    legend += 30.0 + 7.0 * static_cast<double>(line.name.size());
  }
  return svg + "</svg>\n";
}

}  // namespace nineline::cli
