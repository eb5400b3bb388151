#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/errors/component.h"
#include "core/errors/effect_spec.h"
#include "core/kinematics/machine.h"

namespace nineline::errors {

/// Where an effect sits on a machine and which columns it follows.
struct Placement {
  int joint = 0;                              ///< index in the machine
  Component component{};                      ///< the error that it adds to
  bool fixed_frame = false;                   ///< rotary joint: in the frame that does not turn
  std::string sensor{};                       ///< column that it follows ("temp_screw_Z_C"); empty: none
  std::string sensor_2{};                     ///< the second one of a difference or a gradient
  std::optional<kinematics::Travel> range{};  ///< of the joint, where it has no travel or only a part counts
  int along = -1;                             ///< another joint whose position counts (clamping); −1: none
  friend bool operator==(const Placement& a, const Placement& b) {
    const bool same_range = a.range.has_value() == b.range.has_value() &&
                            (!a.range || (a.range->low == b.range->low && a.range->high == b.range->high));
    return a.joint == b.joint && a.component == b.component && a.fixed_frame == b.fixed_frame &&
           a.sensor == b.sensor && a.sensor_2 == b.sensor_2 && same_range && a.along == b.along;
  }
};

/// What decides the units of an effect's parameters at a place.
[[nodiscard]] UnitChoice unitChoice(const kinematics::Machine& machine, const Placement& placement);

/// The components of a joint at which a kind of effect is looked for; where it acts on several at once, the
/// first names them.
[[nodiscard]] std::vector<Component> componentsOf(const kinematics::Machine& machine, int joint,
                                                  const EffectSpec& spec);

/// A non-linear parameter of a candidate, in the units of the placement (mm or deg, not travels).
struct SearchRange {
  std::string name{};
  std::string unit{};
  Bounds plausible{};
  std::vector<double> starts{};
  bool choice = false;  ///< only the starts count
};

/// An effect that a set of data may show.
struct Candidate {
  const EffectSpec* spec = nullptr;
  Placement placement;
  std::vector<SearchRange> nonlinear{};
  std::size_t columns = 1;  ///< linear coefficients
};

/// What stands beside the readings: column names as in contract.md ("temp_bed_C", "t_s", "pass_1").
struct AvailableData {
  std::vector<std::string> columns{};
  bool grinder = true;  ///< which of the plausible ranges count
};

/// Every effect that may sit on the machine and that the columns let judge: id, joint, component, sensor.
/// Effects that act alike at several places are listed once. Measurement effects: reading_effect.h.
[[nodiscard]] std::vector<Candidate> candidatesFor(const kinematics::Machine& machine,
                                                   const AvailableData& data);

}  // namespace nineline::errors
