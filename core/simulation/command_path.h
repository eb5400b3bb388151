#pragma once

#include <optional>
#include <vector>

#include "core/errors/error_model.h"
#include "core/nc/dialect.h"
#include "core/nc/motion.h"

namespace nineline::simulation {

using errors::ErrorModel;
using errors::MachineState;
using kinematics::JointPositions;
using kinematics::Machine;

/// Joint positions behind the axis values of a motion. They are the same, unless tool-centre-point control is
/// on: then the linear values X Y Z are the tip in W and the control moves the linear joints accordingly.
/// Fails where the machine's linear joints cannot hold the tip.
[[nodiscard]] Result<JointPositions> jointsOf(const Machine& machine, const nc::AxisValues& values,
                                              bool tool_centre_point);

/// The axis values whose `jointsOf` are q.
[[nodiscard]] nc::AxisValues valuesOf(const Machine& machine, const JointPositions& q,
                                      bool tool_centre_point);

/// What F counts in a straight motion of linear and rotary axes together (resources/docs/adr/006).
enum class FeedMeaning : std::uint8_t {
  LinearPath,  ///< the way of the linear axes; the rotary ones start and stop with it (LinuxCNC)
  VectorSum    ///< the root of the squares of all axes, a degree as one unit of length (Fanuc)
};

/// The meaning that the stated control gives F; LinearPath where none is stated.
[[nodiscard]] FeedMeaning feedMeaningOf(std::optional<nc::Dialect> stated);

/// Seconds that a motion takes at its programmed feed; rapids at the machine's rapid speeds. 0 where no feed
/// is known.
[[nodiscard]] double durationOf(const Machine& machine, const nc::Motion& motion,
                                FeedMeaning meaning = FeedMeaning::LinearPath);

/// Where along a motion samples must stand, as fractions above 0 up to 1: so close that chords leave the tool
/// path by `chord` mm at most and half a feature of every error is resolved; at every reversal of a joint
/// inside an arc; and where a joint that has reversed leaves its dead band. `approach`: senses before the
/// motion.
void sampleFractions(const ErrorModel& model, const nc::Motion& motion, const JointPositions& start,
                     const JointPositions& end, const std::array<std::int8_t, kMaxAxes>& approach,
                     double chord, std::vector<double>& fractions);

/// Fractions inside an arc at which one of its plane's axes reverses, ascending.
void reversalFractions(const nc::Motion& motion, std::vector<double>& fractions);

/// The state of a machine and of its error effects along a path.
class PathState {
 public:
  PathState(const ErrorModel& model, MachineState conditions, const JointPositions& start);
  /// Moves the commands to q, every joint in one sense.
  void moveTo(const JointPositions& q, double duration);
  [[nodiscard]] const MachineState& state() const { return state_; }
  /// Seconds since the start; the state's own time goes on from the one that its conditions name.
  [[nodiscard]] double elapsed() const { return *state_.time - start_time_; }
  [[nodiscard]] kinematics::ToolPose actualPose() const { return model_->actualPose(state_, memory_); }

 private:
  const ErrorModel* model_;
  MachineState state_;
  MachineState before_;
  double start_time_ = 0.0;
  errors::EffectMemory memory_;
};

}  // namespace nineline::simulation
