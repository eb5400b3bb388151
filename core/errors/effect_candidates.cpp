#include <algorithm>
#include <cmath>

#include "core/errors/effect_makers.h"
#include "core/errors/effect_placement.h"
#include "core/errors/sensor_names.h"

namespace nineline::errors {

namespace {

using kinematics::Machine;

bool isRotary(const kinematics::Joint& joint) { return joint.type == kinematics::JointType::Rotary; }

int rowAlong(const kinematics::Joint& joint) { return positioningOf(joint).row % 3; }

/// Where a shift along each direction of the bed is looked for: at the linear joint of that direction, else
/// at the place of the first rotary joint.
std::vector<Placement> eachWay(const Machine& machine) {
  std::vector<Placement> found;
  for (int row = 0; row < 3; ++row) {
    Placement placement;
    bool done = false;
    for (int i = 0; i < machine.jointCount() && !done; ++i) {
      const kinematics::Joint& joint = machine.joint(i);
      if (isRotary(joint) || rowAlong(joint) != row) continue;
      placement.joint = i;
      placement.component = positioningOf(joint);
      done = true;
    }
    for (int i = 0; i < machine.jointCount() && !done; ++i) {
      if (!isRotary(machine.joint(i))) continue;
      placement.joint = i;
      placement.component = {machine.joint(i).axis, row, true};
      done = true;
    }
    if (done) found.push_back(placement);
  }
  return found;
}

/// Squareness, once for each pair of linear joints, on the later one; tilts and offsets of rotary joints.
std::vector<Placement> locations(const Machine& machine) {
  std::vector<Placement> found;
  const auto add = [&](int joint, int row) {
    found.push_back({.joint = joint, .component = {machine.joint(joint).axis, row, true}});
  };
  for (int i = 0; i < machine.jointCount(); ++i) {
    const kinematics::Joint& joint = machine.joint(i);
    const int own = rowAlong(joint);
    if (isRotary(joint)) {
      for (int row = 0; row < 3; ++row) {
        if (row != own) add(i, row + 3);
      }
      for (int row = 0; row < 3; ++row) {
        if (row != own) add(i, row);
      }
      continue;
    }
    for (int j = 0; j < i; ++j) {
      const kinematics::Joint& other = machine.joint(j);
      if (!isRotary(other) && rowAlong(other) != own) add(i, 3 + (3 - own - rowAlong(other)));
    }
  }
  return found;
}

bool suits(JointChoice choice, const kinematics::Joint& joint) {
  return choice == JointChoice::Any || (choice == JointChoice::Rotary) == isRotary(joint);
}

std::vector<Placement> placementsOf(const Machine& machine, const EffectSpec& spec) {
  if (spec.id == "location") return locations(machine);
  std::vector<Placement> found;
  if ((spec.sites & kEachWay) != 0) found = eachWay(machine);
  for (int i = 0; i < machine.jointCount(); ++i) {
    if (!suits(spec.joints, machine.joint(i))) continue;
    for (const Component& component : componentsOf(machine, i, spec)) {
      found.push_back({.joint = i, .component = component});
      // A rotating error may stand in either frame: they differ by one wave a turn.
      if ((spec.sites & (kRadialPair | kTiltPair)) == 0) continue;
      found.push_back({.joint = i, .component = component, .fixed_frame = true});
    }
  }
  return found;
}

/// What the columns tell about the states.
class Columns {
 public:
  explicit Columns(const AvailableData& data) : data_(data) {}

  [[nodiscard]] bool has(std::string_view name) const {
    return std::find(data_.columns.begin(), data_.columns.end(), name) != data_.columns.end();
  }
  [[nodiscard]] bool knows(unsigned covariates, const kinematics::Joint& joint) const {
    const std::string unit = isRotary(joint) ? "deg" : "mm";
    const bool time = has("t_s");
    const bool speed = time || has("v_" + joint.axis.text() + "_" + unit + "_min");
    const bool acceleration = time || has("a_" + joint.axis.text() + "_" + unit + "_s2");
    return ((covariates & kVelocity) == 0 || speed) && ((covariates & kAcceleration) == 0 || acceleration) &&
           ((covariates & kTime) == 0 || time) && ((covariates & kPass) == 0 || has("pass_1")) &&
           ((covariates & kLoad) == 0 || has("load_kg")) && ((covariates & kFeed) == 0 || has("feed_mm_min"));
  }
  /// Columns that the effect may follow at an axis.
  [[nodiscard]] std::vector<std::string> sensors(const EffectSpec& spec, const AxisId& axis) const {
    if (spec.standard_sensor == "feed_mm_min") {
      return has("feed_mm_min") ? std::vector<std::string>{"feed_mm_min"} : std::vector<std::string>();
    }
    std::vector<std::string> found;
    for (const std::string& name : data_.columns) {
      if (suitsSensor(spec, axis, name)) found.push_back(name);
    }
    return found;
  }

 private:
  const AvailableData& data_;
};

/// Bounds and starts of a parameter in the units of its place.
SearchRange searchRange(const Machine& machine, const Placement& placement, const ParameterSpec& rule,
                        const AvailableData& data) {
  const kinematics::Joint& joint = machine.joint(placement.joint);
  const bool rotary = isRotary(joint);
  SearchRange range{.name = std::string(rule.name),
                    .unit = std::string(unitOf(rule.quantity, unitChoice(machine, placement))),
                    .plausible = {},
                    .starts = rule.starts,
                    .choice = rule.role == Role::Choice};
  const bool angle = range.unit.starts_with("arcsec") || range.unit.starts_with("deg");
  const Plausible& plausible = rule.arc && angle ? *rule.arc : rule.linear;
  range.plausible = data.grinder ? plausible.grinder : plausible.mill;
  if (rule.name == "tau" && !Columns(data).has("t_s")) {  // without time nothing lags
    range.plausible = {};
    range.starts = {0.0};
  }
  if (!rule.of_travel) return range;
  const std::optional<kinematics::Travel>& travel = placement.range ? placement.range : joint.travel;
  const double low = travel ? travel->low : 0.0;
  const double length = travel ? travel->high - travel->low : 0.0;
  const auto placed = [&](double fraction) {
    const double position = low + fraction * length;
    return rotary ? degFromRad(position) : position;
  };
  range.plausible = {placed(range.plausible.low), placed(range.plausible.high)};
  for (double& start : range.starts) start = placed(start);
  return range;
}

/// Completes a placement with what follows from the machine.
void complete(const Machine& machine, const EffectSpec& spec, Placement& placement) {
  if (spec.id != "clamping") return;
  const int own = rowAlong(machine.joint(placement.joint));
  for (int i = 0; i < machine.jointCount(); ++i) {
    if (!isRotary(machine.joint(i)) && rowAlong(machine.joint(i)) == own) placement.along = i;
  }
}

/// Whether a search varies a parameter: always, or as the form `variant` of the effect.
bool isSearched(const Machine& machine, const Placement& placement, const ParameterSpec& rule,
                std::string_view variant) {
  if (rule.role != Role::NonLinear && rule.role != Role::Choice) return false;
  if (rule.role == Role::Choice && rule.starts.size() == 1) return false;
  if (rule.joints != JointChoice::Any) return suits(rule.joints, machine.joint(placement.joint));
  return !rule.optional || rule.name == variant;
}

void addAt(const Machine& machine, const EffectSpec& spec, Placement placement, const AvailableData& data,
           std::vector<Candidate>& found) {
  complete(machine, spec, placement);
  if (!checkPlacement(machine, spec, placement)) return;
  std::vector<std::string_view> variants{""};
  for (const ParameterSpec& rule : spec.parameters) {
    if (rule.optional && rule.joints == JointChoice::Any) variants.push_back(rule.name);
  }
  for (const std::string_view variant : variants) {
    Candidate candidate{.spec = &spec, .placement = placement, .columns = 0};
    for (const ParameterSpec& rule : spec.parameters) {
      candidate.columns += rule.role == Role::Linear ? 1U : rule.role == Role::Amplitude ? 2U : 0U;
      if (isSearched(machine, placement, rule, variant)) {
        candidate.nonlinear.push_back(searchRange(machine, placement, rule, data));
      }
    }
    found.push_back(std::move(candidate));
  }
}

void addWithSensors(const Machine& machine, const EffectSpec& spec, const Placement& place,
                    const std::vector<std::string>& sensors, const AvailableData& data,
                    std::vector<Candidate>& found) {
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    Placement placement = place;
    placement.sensor = sensors[i];
    if (spec.sensors < 2) addAt(machine, spec, placement, data, found);
    for (std::size_t j = i + 1; j < sensors.size() && spec.sensors == 2; ++j) {
      placement.sensor_2 = sensors[j];
      addAt(machine, spec, placement, data, found);
    }
  }
}

}  // namespace

std::vector<Component> componentsOf(const Machine& machine, int index, const EffectSpec& spec) {
  const kinematics::Joint& joint = machine.joint(index);
  const bool rotary = isRotary(joint);
  const int own = rowAlong(joint);
  const int second = (own + 1) % 3;
  std::vector<Component> found;
  const auto add = [&](int row, bool location = false) { found.push_back({joint.axis, row, location}); };
  if ((spec.sites & kOwn) != 0) found.push_back(positioningOf(joint));
  if ((spec.sites & kLateral) != 0 && !rotary) {
    for (int row = 0; row < 3; ++row) {
      if (row != own) add(row);
    }
  }
  if ((spec.sites & kTilt) != 0) {
    for (int row = 0; row < 3; ++row) {
      if (!rotary || row != own) add(row + 3);
    }
  }
  if ((spec.sites & kRadialPair) != 0 && rotary) add(second);
  if ((spec.sites & kTiltPair) != 0 && rotary) add(second + 3);
  if ((spec.sites & kAxial) != 0 && rotary) add(own);
  return found;
}

UnitChoice unitChoice(const Machine& machine, const Placement& placement) {
  return {.angular = placement.component.isAngular(),
          .rotary = machine.isRotary(placement.joint),
          .of_other_than_feed = !placement.sensor.empty() && !placement.sensor.ends_with("_mm_min")};
}

std::vector<Candidate> candidatesFor(const Machine& machine, const AvailableData& data) {
  const Columns columns(data);
  std::vector<Candidate> found;
  for (const EffectSpec& spec : effectCatalogue()) {
    if (spec.kind == EffectKind::Measurement || spec.id == "table" || spec.id == "nonparametric") continue;
    for (const Placement& place : placementsOf(machine, spec)) {
      const kinematics::Joint& joint = machine.joint(place.joint);
      if (!columns.knows(spec.covariates, joint)) continue;
      if (spec.sensors > 0) {
        addWithSensors(machine, spec, place, columns.sensors(spec, joint.axis), data, found);
      } else {
        addAt(machine, spec, place, data, found);
      }
    }
  }
  return found;
}

}  // namespace nineline::errors
