#include "core/errors/error_table.h"

#include <fmt/format.h>

#include <cmath>

namespace nineline::errors {

namespace {

/// Second derivatives at the nodes of the natural cubic spline on a grid of spacing h (Thomas algorithm).
std::vector<double> naturalCurvatures(const std::vector<double>& y, double h) {
  const std::size_t n = y.size();
  std::vector<double> m(n, 0.0);
  if (n < 3) return m;
  std::vector<double> upper(n, 0.0);
  std::vector<double> right(n, 0.0);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double pivot = 4.0 - upper[i - 1];
    upper[i] = 1.0 / pivot;
    right[i] = (6.0 * (y[i - 1] - 2.0 * y[i] + y[i + 1]) / (h * h) - right[i - 1]) / pivot;
  }
  for (std::size_t i = n - 2; i >= 1; --i) m[i] = right[i] - upper[i] * m[i + 1];
  return m;
}

/// The same for the periodic spline through y[0…n−1], y[n] = y[0]: the cyclic system by Sherman and Morrison.
std::vector<double> periodicCurvatures(const std::vector<double>& y, double h) {
  const std::size_t n = y.size();
  if (n == 1) return {0.0};
  if (n == 2) {  // both neighbours of a value are the other one
    const double m0 = 6.0 * (y[1] - y[0]) / (h * h);
    return {m0, -m0};
  }
  std::vector<double> b(n);
  for (std::size_t i = 0; i < n; ++i) {
    b[i] = 6.0 * (y[(i + n - 1) % n] - 2.0 * y[i] + y[(i + 1) % n]) / (h * h);
  }
  // The matrix with 4 on the diagonal, 1 beside it and in the corners is A + u vᵀ with A tridiagonal.
  const double gamma = -4.0;
  const auto solveTridiagonal = [n, gamma](std::vector<double> right) {
    std::vector<double> upper(n);
    for (std::size_t i = 0; i < n; ++i) {
      const double diagonal = 4.0 - (i == 0 ? gamma : 0.0) - (i == n - 1 ? 1.0 / gamma : 0.0);
      const double pivot = diagonal - (i > 0 ? upper[i - 1] : 0.0);
      upper[i] = 1.0 / pivot;
      right[i] = (right[i] - (i > 0 ? right[i - 1] : 0.0)) / pivot;
    }
    for (std::size_t i = n - 1; i-- > 0;) right[i] -= upper[i] * right[i + 1];
    return right;
  };
  std::vector<double> u(n, 0.0);
  u[0] = gamma;
  u[n - 1] = 1.0;
  const std::vector<double> x = solveTridiagonal(b);
  const std::vector<double> z = solveTridiagonal(u);
  const double factor = (x[0] + x[n - 1] / gamma) / (1.0 + z[0] + z[n - 1] / gamma);
  std::vector<double> m(n);
  for (std::size_t i = 0; i < n; ++i) m[i] = x[i] - factor * z[i];
  return m;
}

}  // namespace

Result<ErrorTable> ErrorTable::make(const Grid& grid, std::vector<double> values) {
  if (values.empty()) return badInput("table.empty", "An error table needs at least one value.");
  if (!std::isfinite(grid.start))
    return badInput("table.start", "The start of an error table is not finite.");
  if (!(grid.spacing > 0.0) || !std::isfinite(grid.spacing)) {
    return badInput(
        "table.spacing",
        fmt::format("The spacing of an error table is {}, expected a number above 0.", grid.spacing));
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i]))
      return badInput("table.value", fmt::format("Value {} of an error table is not finite.", i + 1));
  }
  const std::size_t n = values.size();
  if (grid.period &&
      !(std::abs(static_cast<double>(n) * grid.spacing - *grid.period) <= 1e-6 * *grid.period)) {
    return badInput("table.period", "A periodic error table must cover the whole period.");
  }
  ErrorTable table;
  table.grid_ = grid;
  if (grid.period) table.grid_.spacing = *grid.period / static_cast<double>(n);
  table.values_ = std::move(values);
  const std::vector<double>& y = table.values_;
  const double h = table.grid_.spacing;
  const bool cubic = grid.interpolation == Interpolation::Cubic;
  const std::vector<double> m = !cubic        ? std::vector<double>(n, 0.0)
                                : grid.period ? periodicCurvatures(y, h)
                                              : naturalCurvatures(y, h);
  const std::size_t segments = grid.period ? n : (n > 1 ? n - 1 : 1);
  for (std::size_t i = 0; i < segments; ++i) {
    const std::size_t k = (i + 1) % n;
    table.coefficients_.push_back(
        {y[i], (y[k] - y[i]) / h - h * (2.0 * m[i] + m[k]) / 6.0, 0.5 * m[i], (m[k] - m[i]) / (6.0 * h)});
  }
  return table;
}

double ErrorTable::end() const {
  return grid_.period ? grid_.start + *grid_.period
                      : grid_.start + grid_.spacing * static_cast<double>(values_.size() - 1);
}

bool ErrorTable::covers(double position) const {
  constexpr double kSlack = 1e-9;
  return grid_.period || (position >= grid_.start - kSlack && position <= end() + kSlack);
}

ErrorTable::Place ErrorTable::place(double position) const {
  double x = position - grid_.start;
  if (grid_.period) x -= *grid_.period * std::floor(x / *grid_.period);
  const double last = end() - grid_.start;
  if (x <= 0.0) return {0, 0.0, x < 0.0};
  if (x >= last)
    return {coefficients_.size() - 1, values_.size() > 1 || grid_.period ? grid_.spacing : 0.0,
            x > last && !grid_.period};
  const auto segment = std::min(static_cast<std::size_t>(x / grid_.spacing), coefficients_.size() - 1);
  return {segment, x - static_cast<double>(segment) * grid_.spacing, false};
}

double ErrorTable::value(double position) const {
  const Place at = place(position);
  const Cubic& c = coefficients_[at.segment];
  return c.c0 + at.t * (c.c1 + at.t * (c.c2 + at.t * c.c3));
}

double ErrorTable::slope(double position) const {
  const Place at = place(position);
  if (at.outside) return 0.0;
  const Cubic& c = coefficients_[at.segment];
  return c.c1 + at.t * (2.0 * c.c2 + 3.0 * at.t * c.c3);
}

}  // namespace nineline::errors
