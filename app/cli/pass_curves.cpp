#include "app/cli/pass_curves.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/simulation/joint_errors.h"

namespace nineline::cli {

namespace {

using kinematics::JointPositions;
using simulation::PathSample;

constexpr double kTurning = radFromDeg(1.0);

/// The command at a time after the beginning of a pass; its motions are straight.
JointPositions commandAt(const std::vector<PathSample>& pass, double t) {
  const auto later = std::lower_bound(pass.begin(), pass.end(), pass.front().t + t,
                                      [](const PathSample& sample, double time) { return sample.t < time; });
  if (later == pass.begin()) return pass.front().q;
  if (later == pass.end()) return pass.back().q;
  const PathSample& from = *(later - 1);
  const double part = (pass.front().t + t - from.t) / (later->t - from.t);
  JointPositions q{};
  for (std::size_t i = 0; i < q.size(); ++i) q[i] = std::lerp(from.q[i], later->q[i], part);
  return q;
}

}  // namespace

void FinalPass::add(const PathSample& sample) {
  if (sample.rapid) {
    ended_ = true;
    return;
  }
  if (ended_) run_.clear();
  ended_ = false;
  run_.push_back(sample);
}

std::vector<PathSample> FinalPass::samples() const {
  if (run_.empty()) return {};
  const double standing = run_.front().q[turning_];
  const auto turned = std::find_if(run_.begin(), run_.end(), [&](const PathSample& sample) {
    return std::abs(sample.q[turning_] - standing) > kTurning;
  });
  if (turned == run_.end()) return {};
  return {turned - 1, run_.end()};
}

Curve errorCurve(const std::vector<PathSample>& pass, int joint, int along) {
  Curve curve;
  for (const PathSample& sample : pass) {
    curve.position.push_back(sample.q[static_cast<std::size_t>(along)]);
    curve.error.push_back(sample.deviation.joints[static_cast<std::size_t>(joint)]);
  }
  return curve;
}

Curve residualCurve(const kinematics::Machine& machine, const std::vector<PathSample>& original,
                    const std::vector<PathSample>& corrected, int joint, int along) {
  Curve curve;
  if (original.empty()) return curve;
  for (const PathSample& sample : corrected) {
    const JointPositions command = commandAt(original, sample.t - corrected.front().t);
    const JointPositions left = simulation::jointErrors(machine, command, sample.actual);
    curve.position.push_back(command[static_cast<std::size_t>(along)]);
    curve.error.push_back(left[static_cast<std::size_t>(joint)]);
  }
  return curve;
}

}  // namespace nineline::cli
