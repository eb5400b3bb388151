#include "core/identification/nine_line_joint.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>

#include "core/identification/nine_line_solver.h"

namespace nineline::identification {

namespace {

constexpr double kSettled = 1e-12;  // mm
constexpr int kMostSteps = 30;
constexpr double kSeen = 1e-6;  // share of a slope that may lie in the open directions
constexpr double kBlunderProbability = 0.001;

/// Where the unknowns stand: six for each position but the datum, then one for each inclination.
class Layout {
 public:
  Layout(const LineSetup& setup, const ZeroedReadings& data, std::optional<std::size_t> datum) {
    for (Eigen::Index p = 0; p < data.positions.size(); ++p) {
      const bool is_datum = datum && static_cast<std::size_t>(p) == *datum;
      first_of_position_.push_back(is_datum ? -1 : 6 * positions_++);
    }
    origin_ = data.positions(datum ? static_cast<Eigen::Index>(*datum) : 0);
    for (const LineReading& reading : setup.readings) {
      if (reading.reference < 0) continue;
      references_.try_emplace(reading.reference,
                              6 * positions_ + static_cast<Eigen::Index>(references_.size()));
    }
  }
  [[nodiscard]] Eigen::Index size() const {
    return 6 * positions_ + static_cast<Eigen::Index>(references_.size());
  }
  /// −1 for the datum.
  [[nodiscard]] Eigen::Index position(Eigen::Index p) const {
    return first_of_position_[static_cast<std::size_t>(p)];
  }
  /// −1 for a reading without inclination.
  [[nodiscard]] Eigen::Index inclination(const LineReading& reading) const {
    return reading.reference < 0 ? -1 : references_.at(reading.reference);
  }
  [[nodiscard]] Eigen::Index firstInclination() const { return 6 * positions_; }
  [[nodiscard]] double origin() const { return origin_; }

 private:
  Eigen::Index positions_ = 0;
  std::vector<Eigen::Index> first_of_position_;
  std::map<int, Eigen::Index> references_;
  double origin_ = 0.0;
};

SixErrors errorsAt(const Layout& layout, const Eigen::VectorXd& unknown, Eigen::Index p) {
  return layout.position(p) < 0 ? SixErrors::Zero() : SixErrors(unknown.segment<6>(layout.position(p)));
}

struct System {
  Eigen::MatrixXd matrix;  // weighted
  Eigen::VectorXd rest;    // weighted
};

System systemAt(const LineSetup& setup, const ZeroedReadings& data, const Layout& layout,
                const Eigen::VectorXd& unknown, LineMethod method) {
  const Eigen::Index readings = data.values.rows(), positions = data.values.cols();
  System system{Eigen::MatrixXd::Zero(readings * positions, layout.size()),
                Eigen::VectorXd::Zero(readings * positions)};
  for (Eigen::Index p = 0; p < positions; ++p) {
    const SixErrors errors = errorsAt(layout, unknown, p);
    const double travel = data.positions(p) - layout.origin();
    for (Eigen::Index k = 0; k < readings; ++k) {
      const LineReading& reading = setup.readings[static_cast<std::size_t>(k)];
      const Eigen::Index row = p * readings + k;
      const double weight = 1.0 / data.sigma(k, p);
      double predicted = predictReading(reading, errors, method);
      if (layout.position(p) >= 0) {
        system.matrix.block<1, 6>(row, layout.position(p)) =
            weight * readingGradient(reading, errors, method);
      }
      if (const Eigen::Index at = layout.inclination(reading); at >= 0) {
        predicted += unknown(at) * travel;
        system.matrix(row, at) = weight * travel;
      }
      system.rest(row) = weight * (data.values(k, p) - predicted);
    }
  }
  return system;
}

/// Sizes that count as one: 1 mm, 1 mm at the lever, 1 mm over the travel.
Eigen::VectorXd scaleOf(const LineSetup& setup, const ZeroedReadings& data, const Layout& layout) {
  Eigen::VectorXd scale = Eigen::VectorXd::Ones(layout.size());
  const double lever = leverOf(setup);
  for (Eigen::Index p = 0; p < data.positions.size(); ++p) {
    if (layout.position(p) >= 0) scale.segment<3>(layout.position(p) + 3).setConstant(1.0 / lever);
  }
  const double travel = std::max((data.positions.array() - layout.origin()).abs().maxCoeff(), 1.0);
  scale.tail(layout.size() - layout.firstInclination()).setConstant(1.0 / travel);
  return scale;
}

/// Row r: the mean slope of error r along the axis, as a linear function of the unknowns.
Eigen::MatrixXd slopeRows(const ZeroedReadings& data, const Layout& layout) {
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(6, layout.size());
  Eigen::ArrayXd travel = data.positions.array() - layout.origin();
  if (travel.size() > 0 && layout.position(0) >= 0)
    travel -= travel.mean();  // no datum: slope about the mean
  for (Eigen::Index p = 0; p < travel.size(); ++p) {
    if (layout.position(p) < 0) continue;
    for (Eigen::Index r = 0; r < 6; ++r) rows(r, layout.position(p) + r) = travel(p) / travel.square().sum();
  }
  return rows;
}

/// The errors whose mean slope the open directions change, from the matrix where all errors are zero.
std::vector<int> hiddenSlopes(const Decomposition& matrix, const Eigen::VectorXd& scale,
                              const Eigen::MatrixXd& slopes) {
  std::vector<int> hidden;
  const Eigen::MatrixXd open = scale.asDiagonal() * matrix.open;
  for (int r = 0; r < 6; ++r) {
    const double whole = slopes.row(r).transpose().cwiseProduct(scale).norm();
    if (open.cols() > 0 && (slopes.row(r) * open).norm() > kSeen * whole) hidden.push_back(r);
  }
  return hidden;
}

/// The map that takes the hidden slopes out of the unknowns along the open directions.
Result<Eigen::MatrixXd> gaugeOf(const Decomposition& matrix, const Eigen::VectorXd& scale,
                                const Eigen::MatrixXd& slopes, const std::vector<int>& hidden) {
  Eigen::MatrixXd projection = Eigen::MatrixXd::Identity(scale.size(), scale.size());
  if (matrix.open.cols() == 0) return projection;
  const Eigen::MatrixXd open = scale.asDiagonal() * matrix.open;
  Eigen::MatrixXd chosen(static_cast<Eigen::Index>(hidden.size()), scale.size());
  for (Eigen::Index i = 0; i < chosen.rows(); ++i) {
    chosen.row(i) = slopes.row(hidden[static_cast<std::size_t>(i)]);
  }
  const Eigen::MatrixXd seen = chosen * open;
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver(seen);
  if (hidden.empty() || solver.rank() < open.cols()) {
    return noAnswer("lines.open",
                    fmt::format("{} combinations of errors change no reading and are more than slopes; "
                                "the lines need another place or reading.",
                                open.cols()));
  }
  projection -= open * solver.solve(chosen);
  return projection;
}

LineReport reportOf(const ZeroedReadings& data, const Layout& layout, const Eigen::VectorXd& unknown,
                    const Eigen::MatrixXd& covariance, const System& system) {
  LineReport report;
  const Eigen::Index readings = data.values.rows();
  for (Eigen::Index p = 0; p < data.positions.size(); ++p) {
    LineErrors here;
    here.position = data.positions(p);
    const SixErrors errors = errorsAt(layout, unknown, p);
    for (Eigen::Index r = 0; r < 6; ++r) {
      const Eigen::Index at = layout.position(p) + r;
      here.value[static_cast<std::size_t>(r)] = errors(r);
      here.sigma[static_cast<std::size_t>(r)] =
          layout.position(p) < 0 ? 0.0 : std::sqrt(std::max(covariance(at, at), 0.0));
    }
    here.chi_square = system.rest.segment(p * readings, readings).squaredNorm();
    here.freedom = std::max(static_cast<int>(readings) - 6, 0);
    here.is_blunder = here.freedom > 0 && chiSquareTail(here.chi_square, here.freedom) < kBlunderProbability;
    report.positions.push_back(here);
  }
  for (Eigen::Index at = layout.firstInclination(); at < layout.size(); ++at) {
    report.inclinations.push_back(unknown(at));
  }
  report.unknowns = static_cast<int>(layout.size());
  return report;
}

}  // namespace

Result<LineReport> identifyTogether(const LineSetup& setup, const ZeroedReadings& data,
                                    std::optional<std::size_t> datum, LineMethod method) {
  const Layout layout(setup, data, datum);
  const Eigen::VectorXd scale = scaleOf(setup, data, layout);
  const Eigen::MatrixXd slopes = slopeRows(data, layout);
  Eigen::VectorXd unknown = Eigen::VectorXd::Zero(layout.size());
  std::vector<int> hidden;
  std::optional<int> rank;
  for (int step = 0; step < kMostSteps; ++step) {
    const System system = systemAt(setup, data, layout, unknown, method);
    const Decomposition matrix = decompose(system.matrix, scale, rank);
    rank = matrix.rank;
    if (step == 0) hidden = hiddenSlopes(matrix, scale, slopes);
    const Result<Eigen::MatrixXd> gauge = gaugeOf(matrix, scale, slopes, hidden);
    if (!gauge) return gauge.error();
    const Eigen::VectorXd next = *gauge * (unknown + matrix.pseudo_inverse * system.rest);
    const double change = (next - unknown).cwiseQuotient(scale).norm();
    unknown = next;
    if (change > kSettled * std::sqrt(static_cast<double>(layout.size())) && step + 1 < kMostSteps) continue;
    if (change > 1e-9) break;
    const Eigen::MatrixXd covariance = *gauge * matrix.covariance * gauge->transpose();
    LineReport report =
        reportOf(data, layout, unknown, covariance, systemAt(setup, data, layout, unknown, method));
    report.rank = matrix.rank;
    report.condition_number = matrix.condition_number;
    for (const int row : hidden) report.slope_unobservable.push_back(motionErrorName(setup.axis, row).iso);
    return report;
  }
  return noAnswer("lines.steps", "The errors along the axis did not settle.");
}

}  // namespace nineline::identification
