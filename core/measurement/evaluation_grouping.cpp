#include "core/measurement/evaluation_grouping.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/text.h"
#include "core/base/units.h"
#include "core/kinematics/chain.h"

namespace nineline::measurement {

namespace {

constexpr double kSameTarget = 1e-4;    // mm
constexpr double kSameAngle = 1e-7;     // rad
constexpr double kStandstill = 1e-9;    // mm, rad
constexpr double kSmallestStep = 1e-9;  // rad, on a circle

int senseOf(double change, double least) { return change > least ? 1 : change < -least ? -1 : 0; }

/// The senses of travel at each of a run's positions, 0 where nothing moves.
std::vector<int> sensesOf(const std::vector<double>& steps, double least) {
  const std::size_t count = steps.size() + 1;  // steps[i] leads from i to i + 1
  std::vector<int> senses(count, 0);
  int next = 0;
  for (std::size_t i = count; i-- > 0;) {
    if (i < steps.size()) next = senseOf(steps[i], least) != 0 ? senseOf(steps[i], least) : next;
    const int before = i > 0 ? senseOf(steps[i - 1], least) : 0;
    senses[i] = before != 0 ? before : next;
  }
  for (std::size_t i = 1; i < count; ++i) {
    if (senses[i] == 0) senses[i] = senses[i - 1];
  }
  return senses;
}

/// One reading with the joint's position and direction.
struct Approach {
  double position = 0.0;
  double reading = 0.0;
  int sense = 0;
};

/// Channel that tells the positioning of the joint, and the sign that makes it positive along the joint.
struct ChannelChoice {
  std::size_t channel = 0;
  double sign = 1.0;
};

Result<ChannelChoice> channelFor(const EvaluationInput& input, int joint) {
  const Measurement& measurement = *input.measurement;
  if (measurement.instrument.kind != InstrumentKind::Deviation) return ChannelChoice{};
  const kinematics::Joint& moved = input.machine->joint(joint);
  Eigen::Index along = 0;
  const double part = moved.direction.cwiseAbs().maxCoeff(&along);
  const bool is_rotary = moved.type == kinematics::JointType::Rotary;
  const auto wanted = static_cast<Quantity>(static_cast<int>(is_rotary ? Quantity::RotX : Quantity::DevX) +
                                            static_cast<int>(along));
  for (std::size_t k = 0; k < measurement.channels.size(); ++k) {
    if (measurement.channels[k].quantity != wanted || part < 1.0 - 1e-9) continue;
    const double side = input.machine->side(joint) == kinematics::Side::Workpiece ? -1.0 : 1.0;
    return ChannelChoice{k, side * (moved.direction(along) > 0.0 ? 1.0 : -1.0)};
  }
  return badInput("evaluation.channel",
                  fmt::format("The readings have no deviation along axis {}.", moved.axis.text()),
                  measurement.source);
}

std::vector<Approach> approachesOf(const EvaluationInput& input, int joint, const ChannelChoice& choice) {
  const Measurement& measurement = *input.measurement;
  const auto axis = static_cast<std::size_t>(joint);
  const std::string column = "approach_" + input.machine->joint(joint).axis.text() + "_1";
  std::vector<Approach> approaches;
  for (const RunSpan& run : runsOf(measurement)) {
    std::vector<std::size_t> path;
    for (std::size_t i = run.first; i < run.last; ++i) {
      if (measurement.samples[i].has_positions) path.push_back(i);
    }
    if (path.empty()) continue;
    std::vector<double> steps;
    for (std::size_t i = 1; i < path.size(); ++i) {
      steps.push_back(measurement.samples[path[i]].q[axis] - measurement.samples[path[i - 1]].q[axis]);
    }
    const std::vector<int> senses = sensesOf(steps, kStandstill);
    for (std::size_t i = 0; i < path.size(); ++i) {
      const std::optional<double>& reading = measurement.reading(path[i], choice.channel);
      if (!reading) continue;
      const std::optional<double> told = measurement.value(column, path[i]);
      approaches.push_back({measurement.samples[path[i]].q[axis], choice.sign * *reading,
                            told ? senseOf(*told, 0.0) : senses[i]});
    }
  }
  return approaches;
}

struct Target {
  double position = 0.0;
  std::vector<double> forward, backward;
};

std::vector<Target> targetsOf(std::vector<Approach> approaches, double same) {
  std::stable_sort(approaches.begin(), approaches.end(),
                   [](const Approach& a, const Approach& b) { return a.position < b.position; });
  std::vector<Target> targets;
  for (const Approach& one : approaches) {
    if (targets.empty() || one.position - targets.back().position > same)
      targets.push_back({one.position, {}, {}});
    (one.sense > 0 ? targets.back().forward : targets.back().backward).push_back(one.reading);
  }
  return targets;
}

/// A direction counts as driven when at least half of the targets were read in it.
TargetRuns runsFrom(const std::vector<Target>& targets, bool is_rotary, Diagnostics& warnings) {
  std::size_t forward = 0, backward = 0;
  for (const Target& target : targets) {
    forward += target.forward.empty() ? 0U : 1U;
    backward += target.backward.empty() ? 0U : 1U;
  }
  const bool has_forward = 2 * forward >= targets.size(), has_backward = 2 * backward >= targets.size();
  TargetRuns runs;
  for (const Target& target : targets) {
    if ((has_forward && target.forward.empty()) || (has_backward && target.backward.empty())) {
      warnings.warning("evaluation.target",
                       fmt::format("Target {:g} was not read in the {} direction and is left out.",
                                   is_rotary ? degFromRad(target.position) : target.position,
                                   target.forward.empty() ? "forward" : "backward"));
      continue;
    }
    runs.targets.push_back(target.position);
    if (has_forward) runs.forward.push_back(target.forward);
    if (has_backward) runs.backward.push_back(target.backward);
  }
  return runs;
}

int onlyMovingJoint(const EvaluationInput& input) {
  int found = -1;
  for (int joint = 0; joint < input.machine->jointCount(); ++joint) {
    const auto axis = static_cast<std::size_t>(joint);
    double low = 0.0, high = 0.0;
    bool is_first = true;
    for (const Sample& sample : input.measurement->samples) {
      if (!sample.has_positions) continue;
      low = is_first ? sample.q[axis] : std::min(low, sample.q[axis]);
      high = is_first ? sample.q[axis] : std::max(high, sample.q[axis]);
      is_first = false;
    }
    if (high - low <= kStandstill) continue;
    if (found >= 0) return -1;
    found = joint;
  }
  return found;
}

}  // namespace

Result<int> positionedJoint(const EvaluationInput& input) {
  const Measurement& measurement = *input.measurement;
  const InstrumentKind kind = measurement.instrument.kind;
  const bool names_axis = kind == InstrumentKind::Joint || kind == InstrumentKind::LaserLinear;
  if (!names_axis && kind != InstrumentKind::Deviation) {
    return badInput("evaluation.instrument", fmt::format("'{}' is no positioning test.", nameOf(kind)),
                    measurement.source);
  }
  if (names_axis && !measurement.instrument.axis) {
    return badInput("evaluation.axis", "The head names no axis.", measurement.source);
  }
  const int joint = names_axis ? input.machine->find(*measurement.instrument.axis) : onlyMovingJoint(input);
  if (joint < 0) {
    return badInput("evaluation.axis",
                    names_axis ? fmt::format("Machine '{}' has no axis {}.", input.machine->id(),
                                             measurement.instrument.axis->text())
                               : "A positioning test moves exactly one axis.",
                    measurement.source);
  }
  return joint;
}

Result<TargetRuns> groupByTarget(std::span<const EvaluationInput> inputs, int joint, Diagnostics& warnings) {
  std::vector<Approach> approaches;
  std::size_t without_sense = 0;
  for (const EvaluationInput& input : inputs) {
    const Result<ChannelChoice> choice = channelFor(input, joint);
    if (!choice) return choice.error();
    for (const Approach& one : approachesOf(input, joint, *choice)) {
      one.sense == 0 ? void(++without_sense) : approaches.push_back(one);
    }
  }
  if (without_sense > 0) {
    warnings.warning("evaluation.approach",
                     fmt::format("{} readings are left out: from which side their target was "
                                 "approached is unknown.",
                                 without_sense));
  }
  const bool is_rotary = inputs.front().machine->isRotary(joint);
  TargetRuns runs =
      runsFrom(targetsOf(std::move(approaches), is_rotary ? kSameAngle : kSameTarget), is_rotary, warnings);
  if (const Result<void> checked = checkTargetRuns(runs); !checked) {
    Error error = checked.error();
    error.source = inputs.front().measurement->source;
    return error;
  }
  return runs;
}

namespace {

/// First and second axis of a plane; nothing for another text.
std::optional<std::pair<int, int>> axesOf(const std::string& plane) {
  if (plane == "XY") return std::pair{0, 1};
  if (plane == "YZ") return std::pair{1, 2};
  if (plane == "ZX") return std::pair{2, 0};
  return std::nullopt;
}

struct SidedPath {
  CircularPath clockwise, counterclockwise;
};

void addRun(const EvaluationInput& input, const RunSpan& run, std::pair<int, int> axes, SidedPath& paths) {
  const Measurement& measurement = *input.measurement;
  std::vector<double> angles, steps;
  std::vector<std::size_t> rows;
  for (std::size_t i = run.first; i < run.last; ++i) {
    if (!measurement.samples[i].has_positions) continue;
    const Eigen::Vector3d out =
        kinematics::forward(*input.machine, measurement.samples[i].q).tip - measurement.instrument.centre;
    const double angle = std::atan2(out(axes.second), out(axes.first));
    if (!angles.empty()) steps.push_back(std::remainder(angle - angles.back(), kTurn));
    angles.push_back(angle);
    rows.push_back(i);
  }
  if (rows.empty()) return;
  const std::vector<int> senses = sensesOf(steps, kSmallestStep);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::optional<double>& reading = measurement.reading(rows[i], 0);
    if (!reading || senses[i] == 0) continue;
    CircularPath& path = senses[i] > 0 ? paths.counterclockwise : paths.clockwise;
    path.angle.push_back(angles[i]);
    path.deviation.push_back(*reading);
  }
}

}  // namespace

Result<CircularTest> groupByPath(std::span<const EvaluationInput> inputs, Diagnostics& warnings) {
  SidedPath paths;
  const Measurement& first = *inputs.front().measurement;
  for (const EvaluationInput& input : inputs) {
    const std::optional<std::pair<int, int>> axes = axesOf(input.measurement->instrument.plane);
    if (!axes) {
      return badInput("evaluation.plane",
                      fmt::format("The plane of a circular test is XY, YZ or ZX, not '{}'.",
                                  printable(input.measurement->instrument.plane)),
                      input.measurement->source);
    }
    for (const RunSpan& run : runsOf(*input.measurement)) addRun(input, run, *axes, paths);
  }
  CircularTest test;
  test.radius = first.instrument.radius;
  // a lead-in or lead-out of a few points in the other sense is no path of its own
  constexpr std::size_t kFewest = 8;
  for (auto [path, side, name] :
       {std::tuple{&paths.clockwise, &test.clockwise, "clockwise"},
        std::tuple{&paths.counterclockwise, &test.counterclockwise, "counter-clockwise"}}) {
    if (path->angle.size() >= kFewest) {
      *side = std::move(*path);
    } else if (!path->angle.empty()) {
      warnings.warning("evaluation.path", fmt::format("{} points in the {} sense are too few for a path.",
                                                      path->angle.size(), name));
    }
  }
  if (!test.clockwise && !test.counterclockwise) {
    return badInput("evaluation.circle", "The commanded positions follow no circle about the centre.",
                    first.source);
  }
  return test;
}

}  // namespace nineline::measurement
