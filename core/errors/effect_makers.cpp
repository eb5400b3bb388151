#include "core/errors/effect_makers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/errors/dynamic_effects.h"
#include "core/errors/load_effects.h"
#include "core/errors/position_effects.h"
#include "core/errors/reversal_effects.h"
#include "core/errors/rotary_effects.h"
#include "core/errors/table_effects.h"
#include "core/errors/thermal_effects.h"

namespace nineline::errors {

namespace {

constexpr double kLargestError_um = 1000.0;
constexpr double kLargestError_arcsec = 2063.0;  // 0.01 rad
constexpr double kLargestRatio_um_m = 10000.0;
constexpr double kLargestGrowth_um_m_C = 1000.0;

using Maker = std::shared_ptr<Effect> (*)(const EffectParts&);

template <typename T>
std::shared_ptr<Effect> make(const EffectParts& parts) {
  return std::make_shared<T>(parts);
}

std::shared_ptr<Effect> makeLocation(const EffectParts& parts) {
  const Parameter& value = parts.parameters.front();
  const double scale = scaleOf(Quantity::Error, unitChoice(parts.machine, parts.placement));
  const std::optional<double> sigma =
      value.sigma ? std::optional(*value.sigma * scale) : std::optional<double>();
  return std::make_shared<LocationEffect>(parts.placement.joint, parts.placement.component,
                                          value.value * scale, sigma);
}

struct MakerEntry {
  std::string_view id;
  Maker make;
};

constexpr std::array kMakers{
    MakerEntry{"location", &makeLocation},
    MakerEntry{"scale", &make<ScaleEffect>},
    MakerEntry{"cyclic", &make<WaveEffect>},
    MakerEntry{"straightness", &make<BendEffect>},
    MakerEntry{"angular", &make<BendEffect>},
    MakerEntry{"periodic_tilt", &make<WaveEffect>},
    MakerEntry{"eccentricity", &make<TurningEffect>},
    MakerEntry{"lobing", &make<TurningEffect>},
    MakerEntry{"wobble", &make<TurningEffect>},
    MakerEntry{"axial_runout", &make<WaveEffect>},
    MakerEntry{"encoder_eccentricity", &make<WaveEffect>},
    MakerEntry{"encoder_subdivision", &make<WaveEffect>},
    MakerEntry{"backlash", &make<BacklashEffect>},
    MakerEntry{"lateral_play", &make<SideEffect>},
    MakerEntry{"angular_play", &make<SideEffect>},
    MakerEntry{"windup", &make<SideEffect>},
    MakerEntry{"lost_motion", &make<SideEffect>},
    MakerEntry{"hysteresis", &make<HysteresisEffect>},
    MakerEntry{"reversal_spike", &make<SpikeEffect>},
    MakerEntry{"friction_speed", &make<FrictionEffect>},
    MakerEntry{"servo_lag", &make<DelayEffect>},
    MakerEntry{"acceleration", &make<AccelerationEffect>},
    MakerEntry{"sync_delay", &make<DelayEffect>},
    MakerEntry{"vibration", &make<VibrationEffect>},
    MakerEntry{"counterweight", &make<CounterweightEffect>},
    MakerEntry{"thermal_screw", &make<GrowthEffect>},
    MakerEntry{"thermal_scale", &make<GrowthEffect>},
    MakerEntry{"thermal_head", &make<LagEffect>},
    MakerEntry{"thermal_ambient", &make<LagEffect>},
    MakerEntry{"coolant", &make<LagEffect>},
    MakerEntry{"thermal_tilt", &make<DifferenceEffect>},
    MakerEntry{"thermal_workpiece", &make<GrowthEffect>},
    MakerEntry{"drift", &make<DriftEffect>},
    MakerEntry{"sag", &make<SagEffect>},
    MakerEntry{"load_deformation", &make<LoadEffect>},
    MakerEntry{"load_tilt", &make<LoadEffect>},
    MakerEntry{"wheel_wear", &make<WearEffect>},
    MakerEntry{"wheel_deflection", &make<DeflectionEffect>},
    MakerEntry{"spark_out", &make<DeflectionEffect>},
    MakerEntry{"workpiece_bending", &make<LoadEffect>},
    MakerEntry{"clamping", &make<TurningEffect>},
};

bool onlySites(const EffectSpec& spec, unsigned allowed) {
  return spec.sites != 0 && (spec.sites & ~allowed) == 0;
}

Error placementFault(std::string text) { return badInput("effect.placement", std::move(text)); }

/// Whether the parameters' units fit the component.
Result<void> checkUnits(const EffectSpec& spec, const Component& component, bool rotary) {
  for (const ParameterSpec& one : spec.parameters) {
    const bool per_length = one.quantity == Quantity::Ratio || one.quantity == Quantity::Growth;
    if (per_length && component.isAngular() != rotary) {
      return placementFault(fmt::format("'{}' in um/m has no meaning for {} of a {} axis.", spec.id,
                                        component.text(), rotary ? "rotary" : "linear"));
    }
  }
  if (onlySites(spec, kTilt | kTiltPair) && !component.isAngular()) {
    return placementFault(fmt::format("'{}' is a rotation; {} is none.", spec.id, component.text()));
  }
  if (onlySites(spec, kLateral | kRadialPair | kAxial) && component.isAngular()) {
    return placementFault(fmt::format("'{}' is a displacement; {} is none.", spec.id, component.text()));
  }
  return {};
}

/// Whether a rotating pair is named by one of its two components.
bool isAcross(const kinematics::Joint& joint, const Component& component) {
  Eigen::Index axis = 0;
  joint.direction.cwiseAbs().maxCoeff(&axis);
  return component.row % 3 != static_cast<int>(axis);
}

bool needsRange(const EffectSpec& spec, const Placement& placement) {
  return spec.find("shape") != nullptr || spec.id == "workpiece_bending" ||
         (!placement.sensor_2.empty() && spec.find("q_fixed") != nullptr);
}

Result<void> checkConditions(const kinematics::Machine& machine, const EffectSpec& spec,
                             const Placement& placement) {
  if (spec.sensors > 0 && placement.sensor.empty()) {
    return placementFault(fmt::format("'{}' needs the column that it follows ('sensor').", spec.id));
  }
  if (placement.range && !(placement.range->low < placement.range->high)) {
    return placementFault(fmt::format("the range of '{}' is empty.", spec.id));
  }
  if (needsRange(spec, placement) && !placement.range && !machine.joint(placement.joint).travel) {
    return placementFault(fmt::format("'{}' needs the travel of axis {} or a range.", spec.id,
                                      machine.joint(placement.joint).axis.text()));
  }
  if (placement.along >= machine.jointCount()) return placementFault("there is no such joint.");
  return {};
}

/// Beyond this a value is a mistake of the unit (theory.md, 3.5).
double limitOf(std::string_view unit) {
  if (unit == "um") return kLargestError_um;
  if (unit == "arcsec") return kLargestError_arcsec;
  if (unit == "um/m") return kLargestRatio_um_m;
  if (unit == "um/m/C") return kLargestGrowth_um_m_C;
  return std::numeric_limits<double>::infinity();
}

bool mustBePositive(const ParameterSpec& rule) {
  static constexpr std::array<std::string_view, 7> kNames{"period", "length", "speed",    "passes",
                                                          "n",      "shape",  "frequency"};
  return std::find(kNames.begin(), kNames.end(), rule.name) != kNames.end();
}

}  // namespace

Result<void> checkPlacement(const kinematics::Machine& machine, const EffectSpec& spec,
                            const Placement& placement) {
  NL_EXPECTS(placement.joint >= 0 && placement.joint < machine.jointCount(), placement.joint);
  const kinematics::Joint& joint = machine.joint(placement.joint);
  const Component& component = placement.component;
  const bool rotary = joint.type == kinematics::JointType::Rotary;
  if (!(component.axis == joint.axis)) {
    return placementFault(fmt::format("component {} belongs to axis {}, but 'joint' is {}.", component.text(),
                                      component.axis.text(), joint.axis.text()));
  }
  const bool may_be_located = (spec.sites & kLocation) != 0;
  if ((component.location && !may_be_located) || (spec.id == "location" && !component.location)) {
    return placementFault(
        fmt::format("component {} does not fit the effect '{}'.", component.text(), spec.id));
  }
  if (spec.joints == JointChoice::Rotary && !rotary) {
    return placementFault(fmt::format("'{}' needs a rotary axis; {} is linear.", spec.id, joint.axis.text()));
  }
  if (placement.fixed_frame && !rotary) {
    return placementFault(fmt::format("'frame' has no meaning for the linear axis {}.", joint.axis.text()));
  }
  if (onlySites(spec, kRadialPair | kTiltPair) && !isAcross(joint, component)) {
    return placementFault(fmt::format("'{}' acts across the axis; {} is not.", spec.id, component.text()));
  }
  if (Result<void> units = checkUnits(spec, component, rotary); !units) return units;
  return checkConditions(machine, spec, placement);
}

std::string faultOf(const ParameterSpec& rule, const Parameter& parameter) {
  if (!std::isfinite(parameter.value)) {
    return fmt::format("parameter '{}' is {}, expected a number.", parameter.name, parameter.value);
  }
  // A search works with parts of an effect at 1 of the unit; the bound is for mistakes of the unit.
  if (std::abs(parameter.value) >= limitOf(parameter.unit)) {
    return fmt::format("parameter '{}' is {:.6g} {}, larger than any machine's (limit {}).", parameter.name,
                       parameter.value, parameter.unit, limitOf(parameter.unit));
  }
  if (mustBePositive(rule) && parameter.value <= 0.0) {
    return fmt::format("the {} is {}, expected a number above 0.", parameter.name, parameter.value);
  }
  if (rule.name == "tau" && rule.quantity == Quantity::Duration && parameter.value < 0.0) {
    return fmt::format("'tau' is {}, expected 0 or more.", parameter.value);
  }
  const bool any_number = rule.name == "n" && rule.starts.size() > 1;
  if (any_number && (parameter.value != std::round(parameter.value) || parameter.value < 2.0)) {
    return fmt::format("'n' is {}, expected a whole number from 2 on.", parameter.value);
  }
  if (rule.role == Role::Choice && !any_number &&
      std::find(rule.starts.begin(), rule.starts.end(), parameter.value) == rule.starts.end()) {
    return fmt::format("'{}' is {}, expected one of {}.", parameter.name, parameter.value,
                       fmt::join(rule.starts, ", "));
  }
  if (parameter.sigma && !(*parameter.sigma >= 0.0)) {
    return fmt::format("'sigma' is {}, expected 0 or more.", *parameter.sigma);
  }
  return {};
}

Result<std::shared_ptr<Effect>> assembleEffect(EffectParts parts) {
  const auto found = std::find_if(kMakers.begin(), kMakers.end(),
                                  [&parts](const MakerEntry& entry) { return entry.id == parts.spec.id; });
  if (found == kMakers.end()) {
    return placementFault(
        parts.spec.kind == EffectKind::Measurement
            ? fmt::format("'{}' is an error of a measurement, no motion of the machine.", parts.spec.id)
            : fmt::format("'{}' is not made of parameters.", parts.spec.id));
  }
  if (parts.spec.id == "encoder_subdivision" && parts.has("n") == parts.has("period")) {
    return placementFault("'encoder_subdivision' needs either 'n' or 'period'.");
  }
  if (parts.has("n") && parts.joint().type == kinematics::JointType::Linear) {
    return placementFault(
        fmt::format("'n' counts waves a turn; axis {} is linear.", parts.joint().axis.text()));
  }
  return found->make(parts);
}

}  // namespace nineline::errors
