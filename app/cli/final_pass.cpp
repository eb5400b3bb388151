#include "app/cli/final_pass.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"

namespace nineline::cli {

namespace {

constexpr double kTurning = radFromDeg(0.1);

}  // namespace

void FinalPass::add(const simulation::PathSample& before, const simulation::PathSample& after) {
  if (before.rapid) {
    ended_ = true;
    return;
  }
  if (ended_) run_.clear();
  ended_ = false;
  run_.push_back({before, after});
}

std::vector<FinalPass::Place> FinalPass::places() const {
  if (run_.empty()) return {};
  const double standing = run_.front().before.q[turning_];
  const auto turned = std::find_if(run_.begin(), run_.end(), [&](const Place& place) {
    return std::abs(place.before.q[turning_] - standing) > kTurning;
  });
  if (turned == run_.begin() || turned == run_.end()) return {};
  return {turned - 1, run_.end()};
}

}  // namespace nineline::cli
