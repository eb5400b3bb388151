#include "core/identification/nine_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "core/base/units.h"
#include "core/errors/component.h"
#include "core/identification/nine_line_joint.h"
#include "core/identification/nine_line_solver.h"

namespace nineline::identification {

namespace {

constexpr double kBlunderProbability = 0.001;
constexpr double kSeen = 1e-7;      // of a unit unknown: less than this lies in the open directions
constexpr double kSettled = 1e-12;  // mm: last step of the iteration
constexpr int kMostSteps = 30;

int referenceOf(StraightnessInclination inclination, int direction, int next) {
  if (inclination == StraightnessInclination::Known) return -1;
  return inclination == StraightnessInclination::EachLine ? next : direction;
}

Result<void> checkMatrix(const std::vector<std::vector<double>>& matrix, std::size_t rows,
                         std::size_t columns, const char* what) {
  if (matrix.size() != rows) {
    return badInput("lines.count", fmt::format("The set-up has {} readings, the data have {} rows of {}.",
                                               rows, matrix.size(), what));
  }
  for (std::size_t k = 0; k < rows; ++k) {
    if (matrix[k].size() != columns) {
      return badInput("lines.count", fmt::format("Reading {} has {} {} for {} positions.", k + 1,
                                                 matrix[k].size(), what, columns));
    }
    for (std::size_t p = 0; p < columns; ++p) {
      if (std::isfinite(matrix[k][p])) continue;
      return badInput("lines.number", fmt::format("Reading {} at position {} is no number.", k + 1, p + 1));
    }
  }
  return {};
}

Result<void> checkData(const LineSetup& setup, const LineData& data) {
  const std::size_t rows = setup.readings.size(), columns = data.positions.size();
  if (rows == 0 || columns == 0) return badInput("lines.empty", "There are no lines or no positions.");
  if (Result<void> good = checkMatrix(data.readings, rows, columns, "readings"); !good) return good;
  if (!data.sigma.empty()) {
    if (Result<void> good = checkMatrix(data.sigma, rows, columns, "uncertainties"); !good) return good;
  }
  for (const LineReading& reading : setup.readings) {
    if (reading.sigma > 0.0 && reading.target.allFinite() &&
        std::abs(reading.direction.norm() - 1.0) < 1e-9) {
      continue;
    }
    return badInput("lines.setup", fmt::format("Line {} needs a sigma above 0, a place and a unit direction.",
                                               reading.line));
  }
  if (data.datum && *data.datum >= columns) {
    return badInput("lines.datum", fmt::format("The datum is position {} of {}.", *data.datum + 1, columns));
  }
  return {};
}

struct PositionSolution {
  SixErrors errors = SixErrors::Zero();
  Decomposition matrix;
  double chi_square = 0.0;
};

/// Gauss–Newton on the readings of one position; the first-order form needs a single step.
Result<PositionSolution> solvePosition(const LineSetup& setup, const Eigen::VectorXd& values,
                                       const Eigen::VectorXd& weights, LineMethod method) {
  const auto count = static_cast<Eigen::Index>(setup.readings.size());
  const double lever = leverOf(setup);
  SixErrors scale;
  scale << 1.0, 1.0, 1.0, 1.0 / lever, 1.0 / lever, 1.0 / lever;
  PositionSolution solution;
  std::optional<int> rank;
  for (int step = 0; step < kMostSteps; ++step) {
    Eigen::MatrixXd matrix(count, 6);
    Eigen::VectorXd rest(count);
    for (Eigen::Index k = 0; k < count; ++k) {
      const LineReading& reading = setup.readings[static_cast<std::size_t>(k)];
      matrix.row(k) = weights(k) * readingGradient(reading, solution.errors, method);
      rest(k) = weights(k) * (values(k) - predictReading(reading, solution.errors, method));
    }
    solution.matrix = decompose(matrix, scale, rank);
    rank = solution.matrix.rank;
    const SixErrors change = solution.matrix.pseudo_inverse * rest;
    solution.chi_square = rest.squaredNorm() - (matrix * change).squaredNorm();
    solution.errors += change;
    if (method == LineMethod::FirstOrder || change.cwiseQuotient(scale).norm() <= kSettled) return solution;
  }
  return noAnswer("lines.steps", "The errors at a position did not settle.");
}

LineErrors errorsOf(const PositionSolution& solution, double position, std::size_t readings) {
  LineErrors result;
  result.position = position;
  for (int row = 0; row < 6; ++row) {
    if (solution.matrix.open.cols() > 0 && solution.matrix.open.row(row).norm() > kSeen) continue;
    const auto at = static_cast<std::size_t>(row);
    result.value[at] = solution.errors(row);
    result.sigma[at] = std::sqrt(solution.matrix.covariance(row, row));
  }
  result.chi_square = std::max(solution.chi_square, 0.0);
  result.freedom = static_cast<int>(readings) - solution.matrix.rank;
  result.is_blunder =
      result.freedom > 0 && chiSquareTail(result.chi_square, result.freedom) < kBlunderProbability;
  return result;
}

Result<LineReport> identifyEachPosition(const LineSetup& setup, const ZeroedReadings& data,
                                        LineMethod method) {
  LineReport report;
  for (Eigen::Index p = 0; p < data.values.cols(); ++p) {
    const Result<PositionSolution> solution =
        solvePosition(setup, data.values.col(p), data.sigma.col(p).cwiseInverse(), method);
    if (!solution) return solution.error();
    report.positions.push_back(errorsOf(*solution, data.positions(p), setup.readings.size()));
    report.unknowns += 6;
    report.rank += solution->matrix.rank;
    report.condition_number = std::max(report.condition_number, solution->matrix.condition_number);
  }
  for (int row = 0; row < 6; ++row) {
    if (!report.positions.front().value[static_cast<std::size_t>(row)]) {
      report.unobservable.push_back(motionErrorName(setup.axis, row).iso);
    }
  }
  return report;
}

}  // namespace

ZeroedReadings zeroedReadings(const LineSetup& setup, const LineData& data) {
  const auto rows = static_cast<Eigen::Index>(setup.readings.size());
  const auto columns = static_cast<Eigen::Index>(data.positions.size());
  ZeroedReadings result{Eigen::Map<const Eigen::VectorXd>(data.positions.data(), columns),
                        Eigen::MatrixXd(rows, columns), Eigen::MatrixXd(rows, columns)};
  for (Eigen::Index k = 0; k < rows; ++k) {
    const auto row = static_cast<std::size_t>(k);
    const double zero = data.datum ? data.readings[row][*data.datum] : 0.0;
    const auto sigmaAt = [&](std::size_t p) {
      return data.sigma.empty() ? setup.readings[row].sigma : data.sigma[row][p];
    };
    for (Eigen::Index p = 0; p < columns; ++p) {
      const auto at = static_cast<std::size_t>(p);
      result.values(k, p) = data.readings[row][at] - zero;
      const double of_zero = zero != 0.0 ? sigmaAt(*data.datum) : 0.0;
      result.sigma(k, p) = std::hypot(sigmaAt(at), of_zero);
    }
  }
  return result;
}

LineSetup makeNineLineSetup(const AxisId& axis, const NineLinePattern& pattern) {
  const int b = (pattern.along + 1) % 3, c = (pattern.along + 2) % 3;
  const std::array<Vector3d, 3> places{pattern.first, pattern.first + pattern.span_b * Vector3d::Unit(b),
                                       pattern.first + pattern.span_c * Vector3d::Unit(c)};
  LineSetup setup;
  setup.axis = axis;
  int next = 0;
  for (int line = 1; line <= 3; ++line) {
    const Vector3d& place = places[static_cast<std::size_t>(line - 1)];
    setup.readings.push_back({place, Vector3d::Unit(pattern.along), pattern.sigma_displacement, line, -1});
    for (int direction = 0; direction < 2; ++direction) {
      const bool is_minimal = line == 1 || (line == 2 && direction == 1);
      if (pattern.set == LineSet::Minimal && !is_minimal) continue;
      setup.readings.push_back({place, Vector3d::Unit(direction == 0 ? b : c), pattern.sigma_straightness,
                                line, referenceOf(pattern.inclination, direction, next)});
      ++next;
    }
  }
  return setup;
}

ErrorName motionErrorName(const AxisId& axis, int row) {
  NL_EXPECTS(row >= 0 && row < 6, row);
  std::string joint = axis.text();
  for (char& letter : joint) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  const char direction = static_cast<char>('x' + row % 3);
  return {errors::Component{axis, row, false}.text(),
          fmt::format("{}{}({})", row < 3 ? "δ" : "ε", direction, joint)};
}

Result<LineReport> identifyLines(const LineSetup& setup, const LineData& data, LineMethod method) {
  if (const Result<void> checked = checkData(setup, data); !checked) return checked.error();
  const ZeroedReadings zeroed = zeroedReadings(setup, data);
  const bool has_inclinations =
      std::any_of(setup.readings.begin(), setup.readings.end(),
                  [](const LineReading& reading) { return reading.reference >= 0; });
  if (has_inclinations) return identifyTogether(setup, zeroed, data.datum, method);
  return identifyEachPosition(setup, zeroed, method);
}

std::vector<double> predictLines(const LineSetup& setup, const Vector3d& delta, const Vector3d& epsilon,
                                 LineMethod method) {
  SixErrors errors;
  errors << delta, epsilon;
  std::vector<double> result;
  for (const LineReading& reading : setup.readings) result.push_back(predictReading(reading, errors, method));
  return result;
}

double chiSquareTail(double value, int freedom) {
  NL_EXPECTS(freedom >= 1, freedom);
  if (value <= 0.0) return 1.0;
  const double half = 0.5 * value;
  const bool is_odd = freedom % 2 == 1;
  double term = is_odd ? std::sqrt(2.0 * value / kPi) * std::exp(-half) : std::exp(-half);
  double sum = is_odd ? std::erfc(std::sqrt(half)) : 0.0;
  for (int k = is_odd ? 3 : 2; k <= freedom; k += 2) {
    sum += term;
    term *= value / k;
  }
  return std::min(sum, 1.0);
}

}  // namespace nineline::identification
