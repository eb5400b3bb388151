#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/base/axis_id.h"
#include "core/base/result.h"

namespace nineline::kinematics {

using Eigen::Vector3d;

/// Joint positions in the machine's joint order, as the control shows them: mm (linear), rad (rotary).
using JointPositions = std::array<double, kMaxAxes>;

enum class JointType { Linear, Rotary };
enum class Side { Workpiece, Tool };

struct Travel {
  double low = 0.0;  ///< mm, rad
  double high = 0.0;
};

/// One joint: F is its fixed side, N the nominally moved side. At position q its body stands at
/// T_FN = Trans(offset) · (Trans(q direction) or Rot(direction, q)).
struct Joint {
  AxisId axis;
  JointType type = JointType::Linear;
  Vector3d direction = Vector3d::UnitX();  ///< unit vector in F, whose axes are parallel to the bed's at zero
  Vector3d offset = Vector3d::Zero();      ///< mm, in the frame of the body before
  std::optional<Travel> travel;            ///< absent: not limited
  bool continuous = false;                 ///< rotary only: turns without end
  bool diameter = false;                   ///< NC words of this linear joint are diameters
  std::optional<double> rapid_speed;       ///< mm/s, rad/s
};

/// What a machine is: two serial chains from the bed M, one to the workpiece W, one to the tool point P.
/// Joint order: the workpiece chain from the bed outward, then the tool chain from the bed outward. A value.
class Machine {
 public:
  struct Description {
    std::string id;
    std::string name;
    std::vector<Joint> workpiece_chain;
    std::vector<Joint> tool_chain;
    Vector3d tool_tip = Vector3d::Zero();  ///< mm, in the frame of the last tool body
    Vector3d tool_axis =
        Vector3d::UnitZ();  ///< unit vector from the tip towards the holder, in the same frame
  };

  /// Checks the description: 1 to 9 joints, distinct axis names, unit directions (they are normalised),
  /// ordered travel, finite numbers. Fails with BadInput.
  [[nodiscard]] static Result<Machine> make(Description description);

  [[nodiscard]] const std::string& id() const { return id_; }
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] int jointCount() const { return static_cast<int>(joints_.size()); }
  [[nodiscard]] int workpieceJointCount() const { return workpiece_joints_; }
  [[nodiscard]] const std::vector<Joint>& joints() const { return joints_; }
  [[nodiscard]] const Joint& joint(int index) const { return joints_[static_cast<std::size_t>(index)]; }
  [[nodiscard]] Side side(int index) const {
    return index < workpiece_joints_ ? Side::Workpiece : Side::Tool;
  }
  [[nodiscard]] bool isRotary(int index) const { return joint(index).type == JointType::Rotary; }
  [[nodiscard]] const Vector3d& toolTip() const { return tool_tip_; }
  [[nodiscard]] const Vector3d& toolAxis() const { return tool_axis_; }

  /// Index of the joint with this name, −1 where there is none.
  [[nodiscard]] int find(AxisId axis) const;
  /// The first joint whose position lies outside its travel by more than 1 nm (1e-9 rad), −1 when all are
  /// inside.
  [[nodiscard]] int firstOutsideTravel(const JointPositions& q) const;
  [[nodiscard]] Description description() const;

 private:
  Machine() = default;
  std::string id_;
  std::string name_;
  std::vector<Joint> joints_;
  int workpiece_joints_ = 0;
  Vector3d tool_tip_ = Vector3d::Zero();
  Vector3d tool_axis_ = Vector3d::UnitZ();
};

}  // namespace nineline::kinematics
