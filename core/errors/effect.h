#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/json.h"
#include "core/errors/component.h"
#include "core/errors/error_table.h"
#include "core/errors/machine_state.h"
#include "core/kinematics/chain.h"

namespace nineline::errors {

using kinematics::SmallMotion;

/// Where in T_FD = Trans(offset) · Located · Standing · Motion(q) · Moved an effect acts
/// (core/kinematics/chain.h).
enum class Slot { Located, Standing, Moved };

/// A parameter as screens and files show it.
struct Parameter {
  std::string name;             ///< as in contract.md, "k"
  std::string unit;             ///< "um/m"
  double value = 0.0;           ///< in `unit`
  std::optional<double> sigma;  ///< standard uncertainty, in `unit`
};

/// Where an effect came from: measured, identified, discovered or typed in; and when (ISO 8601, empty if
/// unknown).
struct Provenance {
  std::string source;
  std::string when;
};

/// One named cause: from a state, the small motion that it adds at one joint. Constant; shared between
/// threads.
///
/// An effect whose motion depends on the past (play, lag) keeps that past in `memory`, a few numbers owned by
/// the caller: `start` puts them into equilibrium, `advance` carries them from one state to the next along a
/// straight command. With an empty span an effect answers for a single instant, from the state's approach
/// directions.
class Effect {
 public:
  virtual ~Effect() = default;

  [[nodiscard]] virtual std::string id() const = 0;   ///< "table", "backlash"; contract.md
  [[nodiscard]] int joint() const { return joint_; }  ///< index in the machine
  [[nodiscard]] const Component& component() const { return component_; }
  [[nodiscard]] Slot slot() const { return slot_; }
  [[nodiscard]] const Provenance& provenance() const { return provenance_; }
  void setProvenance(Provenance provenance) { provenance_ = std::move(provenance); }
  /// Whether compensation counts with it: what the process causes (a wheel's wear) only when the user says
  /// so.
  [[nodiscard]] bool isActive() const { return active_; }
  void setActive(bool active) { active_ = active; }

  /// Adds the motion at this state: mm, rad, in the frame of `slot`.
  virtual void addMotion(const MachineState& state, std::span<const double> memory,
                         SmallMotion& sum) const = 0;
  /// Adds the derivative of the motion with respect to the joint's own position; nothing where it does not
  /// depend on it smoothly.
  virtual void addSlope(const MachineState&, SmallMotion&) const {}

  [[nodiscard]] virtual std::size_t memorySize() const { return 0; }
  virtual void start(const MachineState&, std::span<double>) const {}
  virtual void advance(const MachineState& /*from*/, const MachineState& /*to*/, std::span<double>) const {}
  /// The same between two samples of a measurement, where only the time between them is known: play is taken
  /// up in the sense that the second state names; what follows the time (a thermal lag) follows it.
  virtual void advanceSampled(const MachineState& /*from*/, const MachineState& to,
                              std::span<double> memory) const {
    start(to, memory);
  }

  /// Names of the conditions without which the motion is not known ("temp_screw_Z_C", "pass_1").
  [[nodiscard]] virtual std::vector<std::string> needs() const { return {}; }
  /// The shortest distance of the joint (mm, rad) over which the motion can bend; infinite for a straight
  /// line.
  [[nodiscard]] virtual double featureLength() const { return std::numeric_limits<double>::infinity(); }
  /// True where the effect's data cover the joint's position.
  [[nodiscard]] virtual bool covers(const MachineState&) const { return true; }
  /// The take-up at a reversal of the joint (mm, rad): 0 for effects without play.
  [[nodiscard]] virtual double play() const { return 0.0; }
  /// True where the motion differs by the sense in which the joint arrives.
  [[nodiscard]] virtual bool followsSense() const { return false; }
  /// The table behind the effect, for screens and for the fast path; nullptr where there is none.
  [[nodiscard]] virtual const ErrorTable* table() const { return nullptr; }

  [[nodiscard]] virtual std::vector<Parameter> parameters() const = 0;
  /// As in `nineline-model/1`.
  [[nodiscard]] virtual Json toJson(const kinematics::Machine& machine) const = 0;

 protected:
  Effect(int joint, Component component, Slot slot) : joint_(joint), component_(component), slot_(slot) {}

 private:
  int joint_;
  Component component_;
  Slot slot_;
  Provenance provenance_;
  bool active_ = true;
};

using EffectPtr = std::shared_ptr<const Effect>;

/// The unit vector of motion of a component, as a SmallMotion of size 1 (mm or rad): for the positioning of a
/// joint along its own `direction`, otherwise along or about an axis of the joint's frame.
[[nodiscard]] SmallMotion unitMotion(const kinematics::Joint& joint, const Component& component);

/// The component that states a joint's own positioning: EZZ of a linear Z, ECC of a rotary C.
[[nodiscard]] Component positioningOf(const kinematics::Joint& joint);

void addScaled(double factor, const SmallMotion& unit, SmallMotion& sum);

}  // namespace nineline::errors
