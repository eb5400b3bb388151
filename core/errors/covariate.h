#pragma once

#include <optional>
#include <string>

#include "core/errors/machine_state.h"

namespace nineline::errors {

/// A quantity of a state by its column name in contract.md: a joint's position ("Z_mm", "C_deg"), approach
/// ("approach_Z_1") or speed ("v_Z_mm_min"), or any condition ("temp_screw_Z_C", "t_s", "pass_1").
class Covariate {
 public:
  /// A name that begins like a joint's column but names no joint of the machine is taken as a condition.
  Covariate(const kinematics::Machine& machine, std::string name);

  [[nodiscard]] const std::string& name() const { return name_; }
  /// In the unit that the name ends in; absent where the state does not know it.
  [[nodiscard]] std::optional<double> value(const MachineState& state) const;
  /// Index of the joint whose position this is, −1 otherwise.
  [[nodiscard]] int positionOf() const { return kind_ == Kind::Position ? joint_ : -1; }
  [[nodiscard]] bool isApproach() const { return kind_ == Kind::Approach; }
  /// One mm or rad of that position in the unit of the name.
  [[nodiscard]] double unitsPerPosition() const { return rotary_ ? degFromRad(1.0) : 1.0; }
  /// True where a state may lack it because nobody stated it; joints' own quantities follow from the motion.
  [[nodiscard]] bool isCondition() const { return kind_ == Kind::Condition; }

 private:
  enum class Kind { Position, Approach, Velocity, Condition };
  Kind kind_ = Kind::Condition;
  int joint_ = -1;
  bool rotary_ = false;
  std::string name_;
};

}  // namespace nineline::errors
