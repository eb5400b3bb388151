#include "core/smoothing/certificate.h"

#include <algorithm>
#include <cmath>

namespace nineline::smoothing {

namespace {

constexpr int kMostHalvings = 4000;

using TipPiece = std::array<Vector3d, 4>;

struct Part {
  TipPiece b;
  double upper = 0.0;
  friend bool operator<(const Part& one, const Part& other) { return one.upper < other.upper; }
};

/// The segment that distances refer to.
struct Segment {
  Vector3d a;
  Vector3d along;
  double square = 0.0;
  Segment(const Vector3d& from, const Vector3d& to)
      : a(from), along(to - from), square(along.squaredNorm()) {}
  [[nodiscard]] double distance(const Vector3d& point) const {
    const Vector3d way = point - a;
    const double s = square > 0.0 ? std::clamp(way.dot(along) / square, 0.0, 1.0) : 0.0;
    return (way - s * along).norm();
  }
};

Part partOf(const TipPiece& b, const Segment& segment, double& lower) {
  const double first = segment.distance(b[0]);
  const double last = segment.distance(b[3]);
  lower = std::max({lower, first, last});
  return {b, std::max({first, last, segment.distance(b[1]), segment.distance(b[2])})};
}

std::array<TipPiece, 2> halves(const TipPiece& b) {
  const Vector3d p01 = 0.5 * (b[0] + b[1]);
  const Vector3d p12 = 0.5 * (b[1] + b[2]);
  const Vector3d p23 = 0.5 * (b[2] + b[3]);
  const Vector3d p012 = 0.5 * (p01 + p12);
  const Vector3d p123 = 0.5 * (p12 + p23);
  const Vector3d middle = 0.5 * (p012 + p123);
  return {TipPiece{b[0], p01, p012, middle}, TipPiece{middle, p123, p23, b[3]}};
}

TipPiece tipOf(const BezierPiece& piece) {
  return {piece[0].head<3>(), piece[1].head<3>(), piece[2].head<3>(), piece[3].head<3>()};
}

/// Calls `use(span, a, b)` for each part of u_a … u_b between knots.
template <typename Use>
void forEachPart(const BSpline& curve, double u_a, double u_b, const Use& use) {
  const std::vector<double>& knots = curve.knots();
  std::size_t span = curve.spanAt(u_a);
  double from = u_a;
  while (true) {
    const bool is_last = span + 5 >= knots.size() || u_b <= knots[span + 1];
    const double to = is_last ? u_b : knots[span + 1];
    use(span, from, to);
    if (is_last) return;
    from = to;
    ++span;
  }
}

DistanceBounds refine(std::vector<Part>& parts, const Segment& segment, double lower, double enough,
                      double precision) {
  std::make_heap(parts.begin(), parts.end());
  for (int halving = 0; halving < kMostHalvings; ++halving) {
    const double upper = parts.front().upper;
    if ((enough >= 0.0 && (upper <= enough || lower > enough)) || upper - lower <= precision) break;
    std::pop_heap(parts.begin(), parts.end());
    const TipPiece worst = parts.back().b;
    parts.pop_back();
    for (const TipPiece& half : halves(worst)) {
      parts.push_back(partOf(half, segment, lower));
      std::push_heap(parts.begin(), parts.end());
    }
  }
  return {lower, std::max(lower, parts.front().upper)};
}

}  // namespace

double distanceToSegment(const Vector3d& point, const Vector3d& a, const Vector3d& b) {
  return Segment(a, b).distance(point);
}

DistanceBounds boundDistance(const BezierPiece& piece, const Vector3d& a, const Vector3d& b, double enough,
                             double precision) {
  const Segment segment(a, b);
  double lower = 0.0;
  std::vector<Part> parts{partOf(tipOf(piece), segment, lower)};
  return refine(parts, segment, lower, enough, precision);
}

DistanceBounds boundDistance(const BSpline& curve, double u_a, double u_b, const Vector3d& a,
                             const Vector3d& b, double enough, double precision) {
  const Segment segment(a, b);
  double lower = 0.0;
  std::vector<Part> parts;
  forEachPart(curve, u_a, u_b, [&](std::size_t span, double from, double to) {
    parts.push_back(partOf(tipOf(curve.bezier(span, from, to)), segment, lower));
  });
  return refine(parts, segment, lower, enough, precision);
}

double boundTurn(const BSpline& curve, double u_a, double u_b, const CurvePoint& from, const CurvePoint& to) {
  const Eigen::Index turns = from.size() - 3;
  if (turns == 0) return 0.0;
  double bound = 0.0;
  forEachPart(curve, u_a, u_b, [&](std::size_t span, double a, double b) {
    const BezierPiece piece = curve.bezier(span, a, b);
    for (std::size_t k = 0; k < 4; ++k) {
      const double u = a + (b - a) * static_cast<double>(k) / 3.0;
      const double s = (u - u_a) / (u_b - u_a);
      const CurvePoint straight = from + s * (to - from);
      bound = std::max(bound, (piece[k] - straight).tail(turns).lpNorm<1>());
    }
  });
  return bound;
}

double largestSecondDerivative(const BSpline& curve, double u_a, double u_b) {
  double largest = 0.0;
  forEachPart(curve, u_a, u_b, [&](std::size_t span, double a, double b) {
    if (!(b > a)) return;
    const TipPiece p = tipOf(curve.bezier(span, a, b));
    const double scale = 6.0 / ((b - a) * (b - a));
    largest = std::max(
        {largest, scale * (p[2] - 2.0 * p[1] + p[0]).norm(), scale * (p[3] - 2.0 * p[2] + p[1]).norm()});
  });
  return largest;
}

}  // namespace nineline::smoothing
