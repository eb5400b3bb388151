#include "app/cli/post_model.h"

#include <fmt/format.h>

#include <cmath>

#include "core/kinematics/inverse.h"

namespace nineline::cli {

namespace {

using kinematics::JointPositions;
using postprocessing::TipAxis;

constexpr int kMostSteps = 20;
constexpr double kTipTolerance = 1e-9;    // mm
constexpr double kAxisTolerance = 1e-11;  // rad

Result<JointPositions> solveActual(const errors::ErrorModel& model, errors::MachineState state,
                                   const TipAxis& wanted) {
  kinematics::PoseTarget target;
  target.tip = wanted.tip;
  target.axis = wanted.axis;
  target.rotation = kinematics::PoseTarget::Rotation::Axis;
  kinematics::PoseJacobian jacobian;
  for (int step = 0; step < kMostSteps; ++step) {
    const kinematics::ToolPose pose = model.actualPoseWithJacobian(state, {}, jacobian);
    const kinematics::PoseResidual r = residual(target, pose);
    if (r.head<3>().norm() < kTipTolerance && r.tail<3>().norm() < kAxisTolerance) return state.q;
    const JointPositions dq = leastSquaresStep(model.machine(), jacobian, r, target, {});
    for (std::size_t k = 0; k < dq.size(); ++k) state.q[k] += dq[k];
  }
  return noAnswer("post.correction", "The errors of the machine cannot be corrected at this point.");
}

}  // namespace

Result<postprocessing::AxisCorrection> axisCorrection(const errors::ErrorModel& model,
                                                      const errors::MachineState& conditions) {
  const errors::ErrorModel active = model.onlyActive();
  bool depends_on_past = active.memorySize() > 0;
  for (int j = 0; j < active.machine().jointCount(); ++j)
    depends_on_past = depends_on_past || active.followsSense(j);
  if (depends_on_past)
    return badInput("post.model",
                    "The model has effects that follow the sense or the past of a motion; post without "
                    "--model and run compensate on the program.");
  const std::vector<std::string> missing = active.missingConditions(conditions);
  if (!missing.empty())
    return badInput("post.model",
                    fmt::format("The model needs {}, which --state does not give.", missing.front()));
  return postprocessing::AxisCorrection(
      [active, conditions](const JointPositions& ideal, const TipAxis& target) {
        errors::MachineState state = conditions;
        state.q = ideal;
        return solveActual(active, std::move(state), target);
      });
}

}  // namespace nineline::cli
