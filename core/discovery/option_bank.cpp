#include <algorithm>
#include <cmath>

#include "core/discovery/dictionary.h"

namespace nineline::discovery {

namespace {

/// Distance of a grid value to its farther neighbour; the whole range for a single one.
double stepOf(const Nonlinear& parameter, std::size_t at) {
  if (parameter.choice) return 0.0;
  if (parameter.grid.size() < 2) return parameter.high - parameter.low;
  const double below =
      at > 0 ? parameter.grid[at] - parameter.grid[at - 1] : parameter.grid[at] - parameter.low;
  const double above = at + 1 < parameter.grid.size() ? parameter.grid[at + 1] - parameter.grid[at]
                                                      : parameter.high - parameter.grid[at];
  return std::max(below, above);
}

struct GridPoint {
  std::vector<double> shape;
  std::vector<double> step;
};

/// All combinations of the grids.
std::vector<GridPoint> combinations(const std::vector<Nonlinear>& nonlinear) {
  std::vector<GridPoint> all(1);
  for (const Nonlinear& parameter : nonlinear) {
    std::vector<GridPoint> longer;
    for (const GridPoint& start : all) {
      for (std::size_t i = 0; i < parameter.grid.size(); ++i) {
        longer.push_back(start);
        longer.back().shape.push_back(parameter.grid[i]);
        longer.back().step.push_back(stepOf(parameter, i));
      }
    }
    all = std::move(longer);
  }
  return all;
}

}  // namespace

void OptionBank::add(Candidate candidate) {
  std::vector<GridPoint> points = combinations(candidate.nonlinear);
  const auto grid = static_cast<double>(points.size());
  const std::size_t index = candidates.size();
  candidates.push_back(std::move(candidate));
  for (GridPoint& point : points) {
    RowMatrix raw = candidates[index].columns(point.shape);
    if (!raw.allFinite() || raw.cols() == 0 || raw.squaredNorm() < 1e-18) continue;
    options.push_back({index, std::move(point.shape), std::move(point.step), std::move(raw), grid});
  }
}

std::size_t OptionBank::addOption(std::size_t candidate, std::vector<double> shape, std::vector<double> step,
                                  double prior_grid) {
  for (std::size_t o = 0; o < options.size(); ++o) {
    if (options[o].candidate == candidate && options[o].shape == shape) return o;
  }
  RowMatrix raw = candidates[candidate].columns(shape);
  options.push_back({candidate, std::move(shape), std::move(step), std::move(raw), prior_grid});
  return options.size() - 1;
}

std::vector<std::size_t> OptionBank::keepOnly(const std::vector<bool>& kept) {
  std::vector<std::size_t> moved(options.size(), options.size());
  std::vector<Option> left;
  for (std::size_t o = 0; o < options.size(); ++o) {
    if (!kept[o]) continue;
    moved[o] = left.size();
    left.push_back(std::move(options[o]));
  }
  options = std::move(left);
  return moved;
}

}  // namespace nineline::discovery
