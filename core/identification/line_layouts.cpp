#include "core/identification/line_layouts.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>

namespace nineline::identification {

namespace {

constexpr int kSamples = 13;  // along a line: more than any product of cubics has coefficients
constexpr double kZeroSingularValue = 1e-9;
constexpr double kSeen = 1e-6;

/// One coefficient: error `row` of axis `axis` times (q / length)^power; or a squareness (power 0).
struct Coefficient {
  int axis = 0;
  int row = 0;
  int power = 0;
  std::string name;
};

std::vector<Coefficient> coefficients() {
  std::vector<Coefficient> result;
  constexpr std::array<const char*, 6> kRows{"EX", "EY", "EZ", "EA", "EB", "EC"};
  for (int axis = 0; axis < 3; ++axis) {
    for (int row = 0; row < 6; ++row) {
      const bool is_straightness = row < 3 && row != axis;
      for (int power = is_straightness ? 2 : 1; power <= 3; ++power) {
        result.push_back({axis, row, power,
                          fmt::format("{}{} q^{}", kRows[static_cast<std::size_t>(row)],
                                      static_cast<char>('X' + axis), power)});
      }
    }
  }
  result.push_back({1, 5, 0, "C0Y"});
  result.push_back({2, 4, 0, "B0Z"});
  result.push_back({2, 3, 0, "A0Z"});
  return result;
}

/// Displacement of the target per unit of a coefficient (first order): a translation of its axis moves it as
/// it is, a rotation turns the arm from the axis' carriage to the target; a squareness turns the axis' own
/// motion.
Vector3d effectOf(const Coefficient& one, const Vector3d& at, const Vector3d& target,
                  const Vector3d& length) {
  if (one.power == 0) return Vector3d::Unit(one.row - 3).cross(at(one.axis) * Vector3d::Unit(one.axis));
  const double size = std::pow(at(one.axis) / length(one.axis), one.power);
  if (one.row < 3) return size * Vector3d::Unit(one.row);
  Vector3d arm = target;
  for (int outer = one.axis + 1; outer < 3; ++outer) arm += at(outer) * Vector3d::Unit(outer);
  return size * Vector3d::Unit(one.row - 3).cross(arm);
}

Eigen::MatrixXd matrixOf(const std::vector<VolumeLine>& lines, const std::vector<Coefficient>& unknowns,
                         const Vector3d& length, Eigen::Index inclinations) {
  const auto known = static_cast<Eigen::Index>(unknowns.size());
  Eigen::MatrixXd matrix =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(lines.size()) * kSamples, known + inclinations);
  Eigen::Index row = 0, inclination = known;
  for (const VolumeLine& line : lines) {
    for (int i = 1; i <= kSamples; ++i, ++row) {
      const double part = static_cast<double>(i) / kSamples;
      const Vector3d at = line.from + part * (line.to - line.from);
      for (Eigen::Index k = 0; k < known; ++k) {
        const Coefficient& one = unknowns[static_cast<std::size_t>(k)];
        matrix(row, k) = line.direction.dot(effectOf(one, at, line.target, length) -
                                            effectOf(one, line.from, line.target, length));
      }
      if (line.is_inclined) matrix(row, inclination) = part * length.maxCoeff();
    }
    if (line.is_inclined) ++inclination;
  }
  return matrix;
}

Vector3d lengthOf(const std::vector<VolumeLine>& lines) {
  Vector3d length = Vector3d::Ones();
  for (const VolumeLine& line : lines)
    length = length.cwiseMax(line.from.cwiseAbs()).cwiseMax(line.to.cwiseAbs());
  return length;
}

VolumeLine diagonal(const Vector3d& from, const Vector3d& to, const Vector3d& target = Vector3d::Zero()) {
  return {from, to, target, (to - from).normalized(), false};
}

Vector3d corner(const LayoutSize& size, double x, double y, double z) {
  return size.volume.cwiseProduct(Vector3d(x, y, z));
}

std::array<Vector3d, 3> targetsOf(const LayoutSize& size, int along) {
  const int b = (along + 1) % 3, c = (along + 2) % 3;
  return {Vector3d::Zero(), size.offset(b) * Vector3d::Unit(b), size.offset(c) * Vector3d::Unit(c)};
}

}  // namespace

LayoutReport layoutReport(const std::vector<VolumeLine>& lines) {
  const std::vector<Coefficient> unknowns = coefficients();
  const auto known = static_cast<Eigen::Index>(unknowns.size());
  Eigen::Index inclinations = 0;
  for (const VolumeLine& line : lines) inclinations += line.is_inclined ? 1 : 0;
  Eigen::MatrixXd matrix = matrixOf(lines, unknowns, lengthOf(lines), inclinations);
  for (Eigen::Index k = 0; k < matrix.cols(); ++k) {
    if (const double size = matrix.col(k).norm(); size > 0.0) matrix.col(k) /= size;
  }
  const Eigen::BDCSVD<Eigen::MatrixXd> svd(matrix, Eigen::ComputeFullV);
  const Eigen::VectorXd& values = svd.singularValues();
  Eigen::Index rank = 0;
  while (rank < values.size() && values(rank) > kZeroSingularValue * values(0)) ++rank;
  const Eigen::MatrixXd open = svd.matrixV().rightCols(matrix.cols() - rank);
  LayoutReport report;
  report.unknowns = static_cast<int>(known);
  report.rank = static_cast<int>(rank - inclinations);
  for (Eigen::Index k = 0; k < known; ++k) {
    if (open.row(k).norm() > kSeen) report.unobservable.push_back(unknowns[static_cast<std::size_t>(k)].name);
  }
  return report;
}

std::vector<VolumeLine> nineLengthLines(const LayoutSize& size) {
  std::vector<VolumeLine> lines;
  for (int along = 0; along < 3; ++along) {
    for (const Vector3d& target : targetsOf(size, along)) {
      lines.push_back(diagonal(Vector3d::Zero(), size.volume(along) * Vector3d::Unit(along), target));
    }
  }
  return lines;
}

std::vector<VolumeLine> nineFullLines(const LayoutSize& size, bool is_inclined) {
  std::vector<VolumeLine> lines;
  for (int along = 0; along < 3; ++along) {
    for (const Vector3d& target : targetsOf(size, along)) {
      const Vector3d end = size.volume(along) * Vector3d::Unit(along);
      lines.push_back(diagonal(Vector3d::Zero(), end, target));
      for (const int across : {(along + 1) % 3, (along + 2) % 3}) {
        lines.push_back({Vector3d::Zero(), end, target, Vector3d::Unit(across), is_inclined});
      }
    }
  }
  return lines;
}

std::vector<VolumeLine> faceDiagonals(const LayoutSize& size) {
  const Vector3d origin = Vector3d::Zero();
  return {diagonal(origin, corner(size, 1, 1, 0)), diagonal(origin, corner(size, 0, 1, 1)),
          diagonal(origin, corner(size, 1, 0, 1))};
}

std::vector<VolumeLine> twelveLines(const LayoutSize& size) {
  std::vector<VolumeLine> lines = nineLengthLines(size);
  for (const VolumeLine& line : faceDiagonals(size)) lines.push_back(line);
  return lines;
}

std::vector<VolumeLine> fourteenLines(const LayoutSize& size) {
  std::vector<VolumeLine> lines = twelveLines(size);
  const Vector3d origin = Vector3d::Zero();
  lines.push_back(diagonal(origin, corner(size, 1, 1, 0), size.offset.z() * Vector3d::UnitZ()));
  lines.push_back(diagonal(origin, corner(size, 0, 1, 1), size.offset.x() * Vector3d::UnitX()));
  return lines;
}

std::vector<VolumeLine> twentyTwoLines(const LayoutSize& size) {
  std::vector<VolumeLine> lines = twelveLines(size);
  lines.push_back(diagonal(corner(size, 0, 1, 0), corner(size, 1, 0, 0)));
  lines.push_back(diagonal(corner(size, 0, 0, 1), corner(size, 0, 1, 0)));
  lines.push_back(diagonal(corner(size, 0, 0, 1), corner(size, 1, 0, 0)));
  lines.push_back(diagonal(corner(size, 0, 0, 0), corner(size, 1, 1, 1)));
  lines.push_back(diagonal(corner(size, 1, 0, 0), corner(size, 0, 1, 1)));
  lines.push_back(diagonal(corner(size, 0, 1, 0), corner(size, 1, 0, 1)));
  lines.push_back(diagonal(corner(size, 0, 0, 1), corner(size, 1, 1, 0)));
  const Vector3d origin = Vector3d::Zero();
  lines.push_back(diagonal(origin, corner(size, 1, 1, 0), size.offset.z() * Vector3d::UnitZ()));
  lines.push_back(diagonal(origin, corner(size, 0, 1, 1), size.offset.x() * Vector3d::UnitX()));
  lines.push_back(diagonal(origin, corner(size, 1, 0, 1), size.offset.y() * Vector3d::UnitY()));
  return lines;
}

}  // namespace nineline::identification
