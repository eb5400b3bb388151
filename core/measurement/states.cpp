#include "core/measurement/states.h"

#include <fmt/format.h>

#include <cmath>

#include "core/base/units.h"

namespace nineline::measurement {

namespace {

constexpr double kStandstill = 1e-9;  // mm, rad: a smaller change of a command is none

int senseOf(double change) { return change > kStandstill ? 1 : change < -kStandstill ? -1 : 0; }

/// The neighbouring samples of one run whose positions are known.
std::vector<std::vector<std::size_t>> pathsOf(const Measurement& measurement) {
  std::vector<std::vector<std::size_t>> paths;
  for (const RunSpan& run : runsOf(measurement)) {
    std::vector<std::size_t> path;
    for (std::size_t i = run.first; i < run.last; ++i) {
      if (measurement.samples[i].has_positions) path.push_back(i);
    }
    if (!path.empty()) paths.push_back(std::move(path));
  }
  return paths;
}

void fillConditions(const Measurement& measurement, std::vector<MachineState>& states) {
  for (const Covariate& covariate : measurement.covariates) {
    for (std::size_t i = 0; i < states.size(); ++i) {
      const std::optional<double>& value = covariate.values[i];
      if (!value) continue;
      MachineState& state = states[i];
      if (covariate.column == "t_s") {
        state.time = *value;
      } else if (covariate.column == "feed_mm_min") {
        state.feed = perSecondFromPerMinute(*value);
      } else if (covariate.column == "pass_1") {
        state.pass = *value;
      } else if (covariate.column == "load_kg") {
        state.load = *value;
      } else {
        state.conditions.emplace_back(covariate.column, *value);
      }
    }
  }
}

/// Approach of one joint along the samples of one run, from the order of the positions.
void deriveApproach(const std::vector<std::size_t>& path, std::size_t joint,
                    std::vector<MachineState>& states) {
  int sense = 0;
  for (std::size_t n = 1; n < path.size() && sense == 0; ++n) {
    sense = senseOf(states[path[n]].q[joint] - states[path[n - 1]].q[joint]);
  }
  for (std::size_t n = 0; n < path.size(); ++n) {
    if (n > 0) {
      const int change = senseOf(states[path[n]].q[joint] - states[path[n - 1]].q[joint]);
      if (change != 0) sense = change;
    }
    states[path[n]].approach[joint] = static_cast<std::int8_t>(sense);
  }
}

void applyApproachColumn(const Covariate& column, std::size_t joint, std::vector<MachineState>& states) {
  for (std::size_t i = 0; i < states.size(); ++i) {
    const std::optional<double>& value = column.values[i];
    if (value) states[i].approach[joint] = static_cast<std::int8_t>(*value > 0.0 ? 1 : *value < 0.0 ? -1 : 0);
  }
}

/// First and second derivative at the middle of the parabola through three instants; `at` = 0 1 2 chooses the
/// instant of the first derivative.
struct Derivatives {
  double first = 0.0;
  double second = 0.0;
};

Derivatives parabola(const std::array<double, 3>& t, const std::array<double, 3>& x, std::size_t at) {
  const double slope01 = (x[1] - x[0]) / (t[1] - t[0]);
  const double slope12 = (x[2] - x[1]) / (t[2] - t[1]);
  const double bend = (slope12 - slope01) / (t[2] - t[0]);
  return {slope01 + bend * (2.0 * t[at] - t[0] - t[1]), 2.0 * bend};
}

/// Derivatives of one joint's command at sample n of a run; nothing without usable time stamps.
std::optional<Derivatives> derivativesAt(const std::vector<std::size_t>& path, std::size_t n,
                                         std::size_t joint, const std::vector<MachineState>& states) {
  const std::size_t count = path.size();
  if (count < 2) return std::nullopt;
  const std::size_t width = std::min<std::size_t>(count, 3);
  const std::size_t first = std::min(n > 0 ? n - 1 : 0, count - width);
  std::array<double, 3> t{};
  std::array<double, 3> x{};
  for (std::size_t k = 0; k < width; ++k) {
    const MachineState& state = states[path[first + k]];
    if (!state.time || (k > 0 && !(*state.time > t[k - 1]))) return std::nullopt;
    t[k] = *state.time;
    x[k] = state.q[joint];
  }
  if (width == 2) return Derivatives{(x[1] - x[0]) / (t[1] - t[0]), 0.0};
  return parabola(t, x, n - first);
}

/// Columns of one joint's speed and acceleration, and their factor to mm/s or rad/s.
struct MotionColumns {
  const Covariate* velocity = nullptr;
  const Covariate* acceleration = nullptr;
  bool rotary = false;

  [[nodiscard]] std::optional<double> velocityAt(std::size_t sample) const {
    if (velocity == nullptr || !velocity->values[sample]) return std::nullopt;
    const double value = perSecondFromPerMinute(*velocity->values[sample]);
    return rotary ? radFromDeg(value) : value;
  }
  [[nodiscard]] std::optional<double> accelerationAt(std::size_t sample) const {
    if (acceleration == nullptr || !acceleration->values[sample]) return std::nullopt;
    return rotary ? radFromDeg(*acceleration->values[sample]) : *acceleration->values[sample];
  }
};

MotionColumns motionColumns(const Measurement& measurement, const Machine& machine, int joint) {
  const std::string axis = machine.joint(joint).axis.text();
  const bool rotary = machine.isRotary(joint);
  return {measurement.covariate(fmt::format("v_{}_{}", axis, rotary ? "deg_min" : "mm_min")),
          measurement.covariate(fmt::format("a_{}_{}", axis, rotary ? "deg_s2" : "mm_s2")), rotary};
}

/// True where the joint stands still in the whole run.
bool standsStill(const std::vector<std::size_t>& path, std::size_t joint,
                 const std::vector<MachineState>& states) {
  for (const std::size_t i : path) {
    if (senseOf(states[i].q[joint] - states[path.front()].q[joint]) != 0) return false;
  }
  return true;
}

void fillMotion(const std::vector<std::size_t>& path, const std::vector<MotionColumns>& columns,
                std::vector<MachineState>& states) {
  std::vector<bool> still(columns.size());
  for (std::size_t j = 0; j < columns.size(); ++j) still[j] = standsStill(path, j, states);
  for (std::size_t n = 0; n < path.size(); ++n) {
    MachineState& state = states[path[n]];
    JointPositions velocity{};
    JointPositions acceleration{};
    bool knows_velocity = true;
    bool knows_acceleration = true;
    for (std::size_t j = 0; j < columns.size(); ++j) {
      const std::optional<double> given = columns[j].velocityAt(path[n]);
      const std::optional<double> given_a = columns[j].accelerationAt(path[n]);
      std::optional<Derivatives> derived;
      if (!given || !given_a) derived = still[j] ? Derivatives{} : derivativesAt(path, n, j, states);
      if (given && *given == 0.0) derived = Derivatives{};
      knows_velocity = knows_velocity && (given || derived);
      knows_acceleration = knows_acceleration && (given_a || derived);
      if (given || derived) velocity[j] = given ? *given : derived->first;
      if (given_a || derived) acceleration[j] = given_a ? *given_a : derived->second;
    }
    if (knows_velocity) state.velocity = velocity;
    if (knows_acceleration) state.acceleration = acceleration;
  }
}

void fillSinceReversal(const std::vector<std::vector<std::size_t>>& paths, std::size_t joints,
                       std::vector<MachineState>& states) {
  JointPositions travel{};
  travel.fill(kNoReversal);
  const MachineState* before = nullptr;
  for (const std::vector<std::size_t>& path : paths) {
    for (const std::size_t i : path) {
      MachineState& state = states[i];
      for (std::size_t j = 0; j < joints && before != nullptr; ++j) {
        const double change = state.q[j] - before->q[j];
        const bool reversed = state.approach[j] * before->approach[j] < 0;
        if (!reversed) {
          travel[j] += std::abs(change);
        } else {  // the joint turned at the sample before, or at this one
          travel[j] = senseOf(change) == state.approach[j] ? std::abs(change) : 0.0;
        }
      }
      state.since_reversal = travel;
      before = &state;
    }
  }
}

}  // namespace

std::vector<MachineState> statesOf(const Measurement& measurement, const Machine& machine) {
  std::vector<MachineState> states(measurement.samples.size());
  for (std::size_t i = 0; i < states.size(); ++i) states[i].q = measurement.samples[i].q;
  fillConditions(measurement, states);
  const std::vector<std::vector<std::size_t>> paths = pathsOf(measurement);
  const auto joints = static_cast<std::size_t>(machine.jointCount());
  std::vector<MotionColumns> columns;
  for (std::size_t j = 0; j < joints; ++j) {
    for (const std::vector<std::size_t>& path : paths) deriveApproach(path, j, states);
    const int joint = static_cast<int>(j);
    const std::string name = fmt::format("approach_{}_1", machine.joint(joint).axis.text());
    if (const Covariate* column = measurement.covariate(name)) applyApproachColumn(*column, j, states);
    columns.push_back(motionColumns(measurement, machine, joint));
  }
  for (const std::vector<std::size_t>& path : paths) fillMotion(path, columns, states);
  fillSinceReversal(paths, joints, states);
  return states;
}

}  // namespace nineline::measurement
