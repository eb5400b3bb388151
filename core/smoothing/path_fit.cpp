#include "core/smoothing/path_fit.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/smoothing/certificate.h"
#include "core/smoothing/knot_placement.h"
#include "core/smoothing/spline_fit.h"

namespace nineline::smoothing {

namespace {

constexpr int kMostRounds = 12;
constexpr int kMostInsertions = 30;
constexpr std::size_t kLeastPoints = 4;

using Index = Eigen::Index;

Vector3d tipOf(const PointRows& points, std::size_t j) {
  return points.row(static_cast<Index>(j)).head<3>().transpose();
}

/// Angle by which the path turns at point j, rad.
double turnAt(const PointRows& points, std::size_t j) {
  const Vector3d in = tipOf(points, j) - tipOf(points, j - 1);
  const Vector3d out = tipOf(points, j + 1) - tipOf(points, j);
  return std::atan2(in.cross(out).norm(), in.dot(out));
}

double curvatureAt(const PointRows& points, std::size_t j) {
  const double across = (tipOf(points, j + 1) - tipOf(points, j - 1)).norm();
  return across > 0.0 ? 2.0 * std::sin(turnAt(points, j)) / across : 0.0;
}

/// Second derivative of the rotary axes over the chord length at point j: sum of magnitudes.
double turnBendAt(const PointRows& points, std::size_t j) {
  const auto row = static_cast<Index>(j);
  const Index turns = points.cols() - 3;
  if (turns == 0) return 0.0;
  const double before = (tipOf(points, j) - tipOf(points, j - 1)).norm();
  const double after = (tipOf(points, j + 1) - tipOf(points, j)).norm();
  return (2.0 / (before + after)) * ((points.row(row + 1) - points.row(row)).tail(turns) / after -
                                     (points.row(row) - points.row(row - 1)).tail(turns) / before)
                                        .lpNorm<1>();
}

/// l²/8 times the smaller `bend` of both ends of each chord.
template <typename Bend>
std::vector<double> sagittasFrom(const PointRows& points, const Bend& bend) {
  const auto count = static_cast<std::size_t>(points.rows());
  std::vector<double> result(count - 1, 0.0);
  if (count < kLeastPoints) return result;
  std::vector<double> at(count, 0.0);
  for (std::size_t j = 1; j + 1 < count; ++j) at[j] = bend(points, j);
  at[0] = at[2];  // the ends have no bend of their own: the next but one stands in
  at[count - 1] = at[count - 3];
  for (std::size_t j = 0; j + 1 < count; ++j) {
    const double length = (tipOf(points, j + 1) - tipOf(points, j)).norm();
    result[j] = std::min(at[j], at[j + 1]) * length * length / 8.0;
  }
  return result;
}

std::vector<double> turnSagittas(const PointRows& points, const FitTolerances& tolerances) {
  if (tolerances.criterion == Criterion::Polyline)
    return std::vector<double>(static_cast<std::size_t>(points.rows()) - 1, 0.0);
  return sagittasFrom(points, turnBendAt);
}

/// Chord lengths stretched so that the end lies on the grid of knots.
std::vector<double> gridParameters(const PointRows& points) {
  std::vector<Vector3d> tips;
  for (Index j = 0; j < points.rows(); ++j) tips.push_back(points.row(j).head<3>().transpose());
  std::vector<double> lengths = chordLengths(tips);
  const double whole = std::max(std::round(lengths.back() / kKnotGrid), 1.0) * kKnotGrid;
  const double stretch = whole / lengths.back();
  for (double& length : lengths) length *= stretch;
  lengths.back() = whole;
  return lengths;
}

/// Fits one part of a path.
class PieceFitter {
 public:
  PieceFitter(PointRows points, const FitTolerances& tolerances)
      : points_(std::move(points)),
        tolerances_(tolerances),
        parameters_(gridParameters(points_)),
        sagittas_(sagittas(points_, tolerances)),
        turn_sagittas_(turnSagittas(points_, tolerances)) {
    if (tolerances_.criterion == Criterion::Polyline) addMiddles();
  }

  std::optional<FittedCurve> fit() {
    if (tolerances_.criterion == Criterion::Polyline && !isPossible()) return std::nullopt;
    std::vector<double> limits = firstLimits(parameters_, mostSpans());
    double aim = 0.8;
    std::vector<double> last = limits;
    int no_better = 0;
    for (int round = 0; round < kMostRounds && no_better < 4; ++round) {
      last = limits;
      const bool passes = attempt(limits);
      aim = passes ? std::min(aim * 1.1, 0.98) : aim * 0.85;
      no_better = passes && improved_ ? 0 : no_better + (best_ ? 1 : 0);
      limits = redistribute(limits, ratios_, aim, parameters_, mostSpans());
    }
    if (!best_) insertWhereItFails(std::move(last));
    if (!best_) return std::nullopt;
    FitTolerances plain = tolerances_;
    return FittedCurve{*best_, parameters_, certify(*best_, parameters_, points_, plain)};
  }

  /// The point that lies farthest from the last curve that failed.
  [[nodiscard]] std::size_t worstPoint() const { return worst_; }
  [[nodiscard]] double failingShare() const { return failing_share_; }

 private:
  [[nodiscard]] std::size_t mostSpans() const {
    const auto count = static_cast<std::size_t>(points_.rows());
    return count / 2 > 4 ? count / 2 - 3 : 1;
  }

  /// A smooth curve cannot stay nearer to the polyline than half its sagitta (theory.md, 5.3).
  [[nodiscard]] bool isPossible() const {
    FitTolerances by_points = tolerances_;
    by_points.criterion = Criterion::Points;
    const std::vector<double> chords = sagittas(points_, by_points);
    return tolerances_.position >= 0.6 * *std::max_element(chords.begin(), chords.end());
  }

  void addMiddles() {
    const Index count = points_.rows();
    data_.resize(2 * count - 1, points_.cols());
    for (Index j = 0; j < count; ++j) {
      const auto k = static_cast<std::size_t>(j);
      data_.row(2 * j) = points_.row(j);
      data_parameters_.push_back(parameters_[k]);
      if (j + 1 == count) break;
      data_.row(2 * j + 1) = 0.5 * (points_.row(j) + points_.row(j + 1));
      data_parameters_.push_back(0.5 * (parameters_[k] + parameters_[k + 1]));
    }
  }

  bool attempt(const std::vector<double>& limits) {
    improved_ = false;
    const bool plain = data_.rows() == 0;
    const std::optional<BSpline> curve =
        fitSpline(plain ? parameters_ : data_parameters_, plain ? points_ : data_, clampedKnots(limits));
    ratios_.assign(limits.size() - 1, 0.3);
    if (!curve) return false;
    if (!measure(*curve)) return false;
    improved_ = !best_ || curve->control().rows() < best_->control().rows();
    if (improved_) best_ = curve;
    return true;
  }

  void note(std::size_t span, double ratio, std::size_t point) {
    ratios_[span] = std::max(ratios_[span], ratio);
    if (ratio > 1.0) ++failing_;
    if (ratio <= worst_ratio_) return;
    worst_ratio_ = ratio;
    worst_ = point;
  }

  /// Error of each span as a multiple of what is allowed; the segments only once all points hold.
  bool measure(const BSpline& curve) {
    ratios_.assign(curve.spanCount(), 0.0);
    worst_ratio_ = 0.0;
    failing_ = 0;
    measurePoints(curve);
    if (worst_ratio_ <= 1.0) measureSegments(curve);
    failing_share_ = static_cast<double>(failing_) / static_cast<double>(points_.rows());
    return worst_ratio_ <= 1.0;
  }

  void measurePoints(const BSpline& curve) {
    const Index turns = points_.cols() - 3;
    for (std::size_t j = 1; j + 1 < parameters_.size(); ++j) {
      const CurvePoint off = curve.at(parameters_[j]) - points_.row(static_cast<Index>(j)).transpose();
      const double turn = turns > 0 ? off.tail(turns).lpNorm<1>() / tolerances_.turn : 0.0;
      note(curve.spanAt(parameters_[j]) - kDegree,
           std::max(off.head<3>().norm() / tolerances_.position, turn), j);
    }
  }

  void measureSegments(const BSpline& curve) {
    for (std::size_t j = 0; j + 1 < parameters_.size(); ++j) {
      const auto row = static_cast<Index>(j);
      const double enough = tolerances_.position + sagittas_[j];
      const DistanceBounds bounds = boundDistance(curve, parameters_[j], parameters_[j + 1],
                                                  tipOf(points_, j), tipOf(points_, j + 1), enough);
      double ratio = bounds.upper > enough ? (bounds.upper - sagittas_[j]) / tolerances_.position : 0.0;
      if (points_.cols() > 3) {
        const double turn = boundTurn(curve, parameters_[j], parameters_[j + 1], points_.row(row).transpose(),
                                      points_.row(row + 1).transpose());
        ratio = std::max(ratio, (turn - turn_sagittas_[j]) / tolerances_.turn);
      }
      note(curve.spanAt(0.5 * (parameters_[j] + parameters_[j + 1])) - kDegree, ratio, j > 0 ? j : 1);
    }
  }

  /// theory.md, 5.4: one knot in the middle of each failing span, until the bound holds or knots run out.
  void insertWhereItFails(std::vector<double> limits) {
    for (int round = 0; round < kMostInsertions; ++round) {
      if (attempt(limits)) return;
      const std::size_t before = limits.size();
      limits = splitFailing(limits, ratios_, parameters_, mostSpans());
      if (limits.size() == before) return;
    }
  }

  PointRows points_;
  FitTolerances tolerances_;
  std::vector<double> parameters_;
  std::vector<double> sagittas_;
  std::vector<double> turn_sagittas_;
  PointRows data_;  // with the middles of the chords, for Criterion::Polyline
  std::vector<double> data_parameters_;
  std::vector<double> ratios_;
  std::optional<BSpline> best_;
  bool improved_ = false;
  double worst_ratio_ = 0.0;
  std::size_t worst_ = 1;
  std::size_t failing_ = 0;
  double failing_share_ = 0.0;
};

/// Covers first … last, cutting where no curve is found.
void fitPart(const PointRows& points, const FitTolerances& tolerances, std::size_t first, std::size_t last,
             std::vector<PathPiece>& pieces) {
  std::vector<std::pair<std::size_t, std::size_t>> waiting{{first, last}};
  while (!waiting.empty()) {
    const auto [from, to] = waiting.back();
    waiting.pop_back();
    const std::size_t count = to - from + 1;
    if (count < kLeastPoints) {
      pieces.push_back({from, to, std::nullopt});
      continue;
    }
    PieceFitter fitter(points.middleRows(static_cast<Index>(from), static_cast<Index>(count)), tolerances);
    if (std::optional<FittedCurve> fitted = fitter.fit()) {
      pieces.push_back({from, to, std::move(fitted)});
      continue;
    }
    // Where much of the path fails, halving ends sooner than cutting off one point after the other.
    const bool halve = fitter.failingShare() > 0.2;
    const std::size_t cut = halve ? count / 2 : std::clamp<std::size_t>(fitter.worstPoint(), 1, count - 2);
    waiting.emplace_back(from + cut, to);
    waiting.emplace_back(from, from + cut);
  }
}

}  // namespace

std::vector<double> sagittas(const PointRows& points, const FitTolerances& tolerances) {
  const auto chords = static_cast<std::size_t>(points.rows()) - 1;
  if (tolerances.criterion == Criterion::Polyline) return std::vector<double>(chords, 0.0);
  if (tolerances.chord) return std::vector<double>(chords, *tolerances.chord);
  return sagittasFrom(points, curvatureAt);
}

FitErrors certify(const BSpline& curve, const std::vector<double>& parameters, const PointRows& points,
                  const FitTolerances& tolerances) {
  const std::vector<double> chords = sagittas(points, tolerances);
  const std::vector<double> turn_chords = turnSagittas(points, tolerances);
  const Index turns = points.cols() - 3;
  FitErrors errors;
  for (std::size_t j = 0; j < parameters.size(); ++j) {
    const CurvePoint off = curve.at(parameters[j]) - points.row(static_cast<Index>(j)).transpose();
    errors.position = std::max(errors.position, off.head<3>().norm());
    if (turns > 0) errors.turn = std::max(errors.turn, off.tail(turns).lpNorm<1>());
  }
  errors.bound = errors.position;
  errors.turn_bound = errors.turn;
  for (std::size_t j = 0; j + 1 < parameters.size(); ++j) {
    const auto row = static_cast<Index>(j);
    const Vector3d from = tipOf(points, j);
    const Vector3d to = tipOf(points, j + 1);
    DistanceBounds bounds =
        boundDistance(curve, parameters[j], parameters[j + 1], from, to, errors.bound + chords[j]);
    if (bounds.upper > errors.bound + chords[j])  // it decides: as exact as needed
      bounds = boundDistance(curve, parameters[j], parameters[j + 1], from, to, -1.0, kNanometre);
    errors.bound = std::max(errors.bound, bounds.upper - chords[j]);
    if (turns == 0) continue;
    const double turn = boundTurn(curve, parameters[j], parameters[j + 1], points.row(row).transpose(),
                                  points.row(row + 1).transpose());
    errors.turn_bound = std::max(errors.turn_bound, turn - turn_chords[j]);
  }
  return errors;
}

std::vector<PathPiece> fitPath(const PointRows& points, const FitTolerances& tolerances) {
  std::vector<PathPiece> pieces;
  const auto count = static_cast<std::size_t>(points.rows());
  if (count < 2) return pieces;
  std::size_t first = 0;
  for (std::size_t j = 1; j + 1 < count; ++j) {
    if (turnAt(points, j) <= tolerances.corner) continue;
    fitPart(points, tolerances, first, j, pieces);
    first = j;
  }
  fitPart(points, tolerances, first, count - 1, pieces);
  return pieces;
}

}  // namespace nineline::smoothing
