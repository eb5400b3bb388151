#pragma once

#include "core/errors/error_model.h"
#include "core/postprocessing/post_processor.h"

namespace nineline::cli {

/// Axis positions at which the actual machine reaches the pose that the ideal one has: the total-differential
/// solver on the actual chain. Only for errors that depend on the place alone: a model with effects that
/// follow the sense or the past of a motion, or lack a condition, is refused.
[[nodiscard]] Result<postprocessing::AxisCorrection> axisCorrection(const errors::ErrorModel& model,
                                                                    const errors::MachineState& conditions);

}  // namespace nineline::cli
