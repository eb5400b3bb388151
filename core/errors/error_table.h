#pragma once

#include <optional>
#include <vector>

#include "core/base/result.h"

namespace nineline::errors {

enum class Interpolation {
  Cubic,  ///< twice continuously differentiable; natural ends, or periodic
  Linear
};

/// One error over the positions of one joint, on an equally spaced grid. Positions in mm or rad, values in mm
/// or rad. Outside the grid the end value holds; a periodic table has no outside. A value.
class ErrorTable {
 public:
  struct Grid {
    double start = 0.0;
    double spacing = 1.0;  ///< above 0
    Interpolation interpolation = Interpolation::Cubic;
    std::optional<double> period;  ///< the last value's successor is the first: count · spacing = period
    friend bool operator==(const Grid&, const Grid&) = default;
  };

  /// Fails on an empty table, a spacing that is not above 0, values that are not finite, or a period that
  /// differs from count · spacing.
  [[nodiscard]] static Result<ErrorTable> make(const Grid& grid, std::vector<double> values);

  [[nodiscard]] double value(double position) const;
  /// Derivative with respect to the position; 0 outside the grid.
  [[nodiscard]] double slope(double position) const;
  [[nodiscard]] bool covers(double position) const;

  [[nodiscard]] const Grid& grid() const { return grid_; }
  [[nodiscard]] const std::vector<double>& values() const { return values_; }
  /// Last grid position (start + period for a periodic table).
  [[nodiscard]] double end() const;
  [[nodiscard]] std::size_t segmentCount() const { return coefficients_.size(); }

  /// Segment and local coordinate t ∈ [0, spacing] of a position (clamped or wrapped).
  struct Place {
    std::size_t segment = 0;
    double t = 0.0;
    bool outside = false;
  };
  [[nodiscard]] Place place(double position) const;

  /// value = c0 + c1 t + c2 t² + c3 t³ on a segment.
  struct Cubic {
    double c0 = 0.0, c1 = 0.0, c2 = 0.0, c3 = 0.0;
  };
  [[nodiscard]] const Cubic& coefficients(std::size_t segment) const { return coefficients_[segment]; }

 private:
  ErrorTable() = default;
  Grid grid_;
  std::vector<double> values_;
  std::vector<Cubic> coefficients_;
};

}  // namespace nineline::errors
