#pragma once

#include <vector>

#include "core/base/json.h"
#include "core/kinematics/chain.h"

namespace nineline::simulation {

using kinematics::JointPositions;
using kinematics::Machine;
using kinematics::ToolPose;
using kinematics::Vector3d;

/// Mean, root mean square and largest magnitude of one signed quantity along a path, weighted by path length.
struct Figures {
  double mean = 0.0;
  double rms = 0.0;
  double max = 0.0;  ///< largest |value|
};

/// How far one pose lies from another, tool relative to workpiece, in W.
struct Deviation {
  Vector3d tip = Vector3d::Zero();       ///< actual − ideal, mm
  Vector3d rotation = Vector3d::Zero();  ///< rotation vector of R_actual R_idealᵀ, rad
  JointPositions joints{};               ///< the same as an error of each joint, mm or rad (theory.md, 1.5)
};

/// Deviation figures of a path, as tables, curves and JSON show them. mm and rad.
struct DeviationSummary {
  Figures norm, x, y, z;
  Figures axis_tilt;            ///< angle between actual and ideal tool axis, rad
  std::vector<Figures> joints;  ///< in joint order
  double length = 0.0;          ///< weight of all samples: mm of tool path (count, where nothing moves)
};

/// Collects a DeviationSummary.
class DeviationStatistics {
 public:
  explicit DeviationStatistics(int joints);
  /// `weight`: the path length that the sample stands for, mm.
  void add(const Deviation& deviation, double tilt, double weight);
  [[nodiscard]] DeviationSummary summary() const;
  [[nodiscard]] bool empty() const { return count_ == 0; }

 private:
  struct Sum {
    double weighted = 0.0, weighted_squares = 0.0, plain = 0.0, plain_squares = 0.0, max = 0.0;
    void add(double value, double weight);
    [[nodiscard]] Figures figures(double weight, double count) const;
  };
  std::vector<Sum> sums_;  // norm, x, y, z, tilt, joints
  double weight_ = 0.0;
  std::size_t count_ = 0;
};

/// The keys of the contract: norm, x, y, z and each joint letter; mm, rotary joints in deg.
[[nodiscard]] Json summaryToJson(const DeviationSummary& summary, const Machine& machine);

/// Joint motion that the ideal machine would need to stand at `actual` instead of at q: the error of each
/// joint (theory.md, 1.5, exact). Directions that no joint moves in do not appear.
[[nodiscard]] JointPositions jointErrors(const Machine& machine, const JointPositions& q,
                                         const ToolPose& actual);

/// Deviation of `actual` from the ideal machine's pose at q.
[[nodiscard]] Deviation deviationOf(const Machine& machine, const JointPositions& q, const ToolPose& ideal,
                                    const ToolPose& actual);

}  // namespace nineline::simulation
