#include "core/errors/rotary_effects.h"

#include <cmath>

#include "core/base/units.h"

namespace nineline::errors {

namespace {

constexpr double kJaws = 3.0;
constexpr double kPiecesOfAWave = 8.0;

}  // namespace

TurningEffect::TurningEffect(const EffectParts& parts)
    : ParametricEffect(parts),
      amplitude_(parts.value("amplitude")),
      waves_(parts.spec.id == "clamping" ? kJaws : parts.valueOr("n", 1.0)),
      phase_(parts.valueOr("phase", 0.0)),
      first_((positioningOf(parts.joint()).row + 1) % 3),
      second_((positioningOf(parts.joint()).row + 2) % 3),
      length_(parts.valueOr("length", 0.0)),
      reference_(parts.valueOr("q_ref", 0.0)),
      angular_(parts.placement.component.isAngular()) {}

double TurningEffect::featureLength() const { return kTurn / waves_ / kPiecesOfAWave; }

double TurningEffect::size(const MachineState& state) const {
  if (placement().along < 0 || length_ <= 0.0) return amplitude_;
  const double distance = std::abs(state.q[static_cast<std::size_t>(placement().along)] - reference_);
  return amplitude_ * std::exp(-distance / length_);
}

void TurningEffect::add(double first, double second, SmallMotion& sum) const {
  Eigen::Vector3d& vector = angular_ ? sum.rotation : sum.translation;
  vector[first_] += first;
  vector[second_] += second;
}

void TurningEffect::addMotion(const MachineState& state, std::span<const double>, SmallMotion& sum) const {
  const double angle = waves_ * position(state) + phase_;
  const double radius = size(state);
  add(radius * std::cos(angle), radius * std::sin(angle), sum);
}

void TurningEffect::addSlope(const MachineState& state, SmallMotion& sum) const {
  const double angle = waves_ * position(state) + phase_;
  const double radius = size(state) * waves_;
  add(-radius * std::sin(angle), radius * std::cos(angle), sum);
}

}  // namespace nineline::errors
