#include "core/thread_grinding/hand_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/thread_grinding/program_moves.h"

namespace nineline::thread_grinding {
namespace {

/// What rounding of the words to their decimals may do to a groove along wz.
struct Rounding {
  double depth = 0.0;  ///< mm
  double axial = 0.0;  ///< mm
};

Rounding roundingOf(const ThreadParameters& p, double lead) {
  const double step = std::pow(10.0, -p.decimals);
  return {step, 2.0 * step * (1.0 + lead / 360.0)};
}

const char* nameOf(Hand hand) { return hand == Hand::Right ? "right" : "left"; }

Error wrongThread(std::string text) {
  return noAnswer(
      "thread.hand_check",
      fmt::format("The virtual thread cut with this program is not the one asked for: {}. Nothing was "
                  "written; check hand, axis signs and diameter programming.",
                  text));
}

/// Distance along wz from the groove of a start, in (−lead/2, lead/2].
double missOf(const GrooveRun& run, const ThreadParameters& p, double lead, double phase) {
  const double expected = signOf(p.hand) * lead / kTurn * (run.middle_angle - phase);
  return std::remainder(run.middle_wz - expected, lead);
}

/// One cut against the hand, the lead, its depth and the place of its groove.
std::optional<Error> judgeRun(const GrooveRun& run, const ThreadParameters& p, const ThreadPlan& plan,
                              double depth, int start_index) {
  const double lead = plan.geometry.lead;
  const Rounding rounding = roundingOf(p, lead);
  const Hand hand = run.slope > 0.0 ? Hand::Right : Hand::Left;
  const double found_lead = std::abs(run.slope) * kTurn;
  if (run.slope == 0.0) return wrongThread(fmt::format("line {} cuts a ring", run.line));
  if (hand != p.hand)
    return wrongThread(fmt::format("line {} cuts a {}-hand groove, asked for {} hand", run.line, nameOf(hand),
                                   nameOf(p.hand)));
  if (std::abs(found_lead - lead) * p.length / lead > 2.0 * rounding.axial)
    return wrongThread(
        fmt::format("line {} cuts a lead of {:.6f} mm, asked for {:.6f} mm", run.line, found_lead, lead));
  if (run.residual > rounding.axial)
    return wrongThread(fmt::format("the groove cut from line {} leaves its screw line by {:.6f} mm", run.line,
                                   run.residual));
  if (std::abs(run.depth - depth) > rounding.depth || std::abs(run.least_depth - depth) > rounding.depth)
    return wrongThread(fmt::format("the pass at line {} is {:.6f} to {:.6f} mm deep, asked for {:.6f} mm",
                                   run.line, run.least_depth, run.depth, depth));
  if (std::abs(run.last_wz - run.first_wz) < p.length - 3.0 * rounding.axial)
    return wrongThread(fmt::format("the cut from line {} is {:.4f} mm long, asked for {:.4f} mm", run.line,
                                   std::abs(run.last_wz - run.first_wz), p.length));
  const double shift =
      p.infeed_mode == InfeedMode::Radial ? 0.0 : (plan.depth - depth) * std::tan(plan.geometry.half_angle);
  const double miss = missOf(run, p, lead, p.start_angle + startPhase(start_index, p.starts));
  if (std::abs(std::abs(miss) - shift) > rounding.axial)
    return wrongThread(fmt::format("the pass at line {} runs {:.6f} mm beside its groove", run.line,
                                   std::abs(miss) - shift));
  return std::nullopt;
}

/// How many different grooves there are at full depth.
int groovesOf(const std::vector<GrooveRun>& runs, const ThreadParameters& p, const ThreadPlan& plan,
              double depth_tolerance, double apart) {
  std::vector<const GrooveRun*> grooves;
  const double lead = plan.geometry.lead;
  for (const GrooveRun& run : runs) {
    if (run.depth < plan.depth - depth_tolerance) continue;
    const bool known = std::any_of(grooves.begin(), grooves.end(), [&](const GrooveRun* other) {
      const double along = signOf(p.hand) * lead / kTurn * (run.middle_angle - other->middle_angle);
      return std::abs(std::remainder(run.middle_wz - other->middle_wz - along, lead)) < apart;
    });
    if (!known) grooves.push_back(&run);
  }
  return static_cast<int>(grooves.size());
}

}  // namespace

VirtualBlank blankOf(const ThreadParameters& p, const ThreadPlan& plan) {
  VirtualBlank blank;
  blank.type = p.type;
  blank.crest_radius = plan.crest_radius;
  blank.taper = p.taper;
  blank.length = p.length;
  blank.z_at_zero = p.start_z;
  blank.contact_height = p.contact_height;
  blank.tolerance = 0.6 * std::pow(10.0, -p.decimals);
  return blank;
}

Result<CutThread> judgeCut(const VirtualCut& cut, const ThreadParameters& p, const ThreadPlan& plan) {
  if (cut.fault()) return wrongThread(*cut.fault());
  const std::vector<GrooveRun>& runs = cut.runs();
  const std::size_t starts = plan.start_indices.size();
  if (runs.size() != plan.passes.size() * starts)
    return wrongThread(
        fmt::format("{} cuts were made, asked for {}", runs.size(), plan.passes.size() * starts));
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const std::optional<Error> error =
        judgeRun(runs[i], p, plan, plan.passes[i / starts].depth, plan.start_indices[i % starts]);
    if (error) return *error;
  }
  const Rounding rounding = roundingOf(p, plan.geometry.lead);
  CutThread thread;
  thread.hand = runs.back().slope > 0.0 ? Hand::Right : Hand::Left;
  thread.lead = std::abs(runs.back().slope) * kTurn;
  thread.depth = runs.back().depth;
  thread.runs = runs.size();
  thread.starts = groovesOf(runs, p, plan, rounding.depth, 2.0 * rounding.axial);
  if (thread.starts != static_cast<int>(starts))
    return wrongThread(fmt::format("{} grooves were cut, asked for {}", thread.starts, starts));
  return thread;
}

Result<CutThread> checkHand(std::string_view program, const ThreadParameters& p, const ThreadPlan& plan,
                            const AxisConvention& axes) {
  VirtualCut cut(blankOf(p, plan));
  const Result<void> read = forEachMove(program, axes, [&](const VirtualMove& move) { cut.add(move); });
  if (!read) return read.error();
  cut.finish();
  return judgeCut(cut, p, plan);
}

}  // namespace nineline::thread_grinding
