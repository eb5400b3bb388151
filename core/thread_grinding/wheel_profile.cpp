#include "core/thread_grinding/wheel_profile.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <optional>

namespace nineline::thread_grinding {
namespace {

using Eigen::Vector3d;

/// Flank, wheel axis, and the condition of contact between them.
class FlankContact {
 public:
  FlankContact(const ThreadGeometry& thread, Hand hand, const WheelSetup& wheel, int side, double r)
      : r_(r),
        slope_(std::tan(thread.half_angle) * side),
        offset_(side *
                (thread.pitch / 4.0 + (r - thread.pitch_diameter / 2.0) * std::tan(thread.half_angle))),
        rise_(signOf(hand) * thread.lead / kTurn),
        centre_((thread.root_diameter + wheel.wheel_diameter) / 2.0, 0.0, 0.0),
        axis_(0.0, -std::sin(wheel.tilt), std::cos(wheel.tilt)) {}

  [[nodiscard]] Vector3d point(double theta) const {
    return {r_ * std::cos(theta), r_ * std::sin(theta), rise_ * theta + offset_};
  }
  /// Zero where the normal of the flank meets the wheel axis.
  [[nodiscard]] double gap(double theta) const {
    const Vector3d along_radius(std::cos(theta), std::sin(theta), slope_);
    const Vector3d along_helix(-r_ * std::sin(theta), r_ * std::cos(theta), rise_);
    return (point(theta) - centre_).dot(axis_.cross(along_radius.cross(along_helix)));
  }
  [[nodiscard]] WheelPoint wheelPoint(double theta) const {
    const Vector3d p = point(theta) - centre_;
    const double axial = p.dot(axis_);
    return {axial, (p - axial * axis_).norm(), theta};
  }

 private:
  double r_;
  double slope_;
  double offset_;
  double rise_;
  Vector3d centre_;
  Vector3d axis_;
};

/// Secant from two guesses; nothing when it does not settle.
template <typename Function>
std::optional<double> secantRoot(const Function& f, double a, double b, double tolerance) {
  double fa = f(a);
  for (int step = 0; step < 60; ++step) {
    const double fb = f(b);
    if (fb == 0.0) return b;
    if (fb == fa) return std::abs(b - a) <= tolerance ? std::optional(b) : std::nullopt;
    const double next = b - fb * (b - a) / (fb - fa);
    if (!std::isfinite(next)) return std::nullopt;
    a = b, fa = fb, b = next;
    if (std::abs(b - a) <= tolerance) return b;
  }
  return std::nullopt;
}

}  // namespace

Result<WheelPoint> conjugateWheelPoint(const ThreadGeometry& thread, Hand hand, const WheelSetup& wheel,
                                       int side, double r) {
  NL_EXPECTS(side == 1 || side == -1, side);
  const FlankContact contact(thread, hand, wheel, side, r);
  const std::optional<double> theta =
      secantRoot([&](double angle) { return contact.gap(angle); }, 0.0, 1e-3, 1e-15);
  if (!theta || std::abs(*theta) > kPi / 4.0) {
    return noAnswer(
        "thread.no_contact",
        fmt::format("The wheel of {} mm tilted by {} rad finds no contact with the flank at radius {} mm.",
                    wheel.wheel_diameter, wheel.tilt, r));
  }
  return contact.wheelPoint(*theta);
}

Result<double> halfWidthAtPitchLine(const ThreadGeometry& thread, Hand hand, const WheelSetup& wheel) {
  const double pitch_radius = thread.pitch_diameter / 2.0;
  const double pitch_line = (thread.root_diameter + wheel.wheel_diameter) / 2.0 - pitch_radius;
  std::optional<Error> failure;
  const auto miss = [&](double r) {
    const Result<WheelPoint> point = conjugateWheelPoint(thread, hand, wheel, 1, r);
    if (!point) failure = point.error();
    return point ? point->radius - pitch_line : 0.0;
  };
  const std::optional<double> r = secantRoot(miss, pitch_radius, pitch_radius + 1e-3, 1e-13);
  if (failure) return *failure;
  if (!r) return noAnswer("thread.no_contact", "The wheel's pitch line is not reached by the flank.");
  const Result<WheelPoint> point = conjugateWheelPoint(thread, hand, wheel, 1, *r);
  if (!point) return point.error();
  return point->axial;
}

Result<double> pitchDiameterChange(const ThreadGeometry& thread, Hand hand, const WheelSetup& wheel) {
  const WheelSetup right_tilt{wheel.wheel_diameter, signOf(hand) * thread.helix_angle};
  const Result<double> profiled = halfWidthAtPitchLine(thread, hand, right_tilt);
  if (!profiled) return profiled.error();
  const Result<double> needed = halfWidthAtPitchLine(thread, hand, wheel);
  if (!needed) return needed.error();
  return 2.0 * (*needed - *profiled) / std::tan(thread.half_angle);
}

double overcutRule(const ThreadGeometry& thread, const WheelSetup& wheel, double tilt_error) {
  const double wheel_radius =
      (thread.root_diameter + wheel.wheel_diameter) / 2.0 - thread.pitch_diameter / 2.0;
  const double effective = 1.0 / (2.0 / thread.pitch_diameter + 1.0 / wheel_radius);
  return tilt_error * tilt_error * effective / (2.0 * std::tan(thread.half_angle));
}

}  // namespace nineline::thread_grinding
