#include "core/compensation/verification.h"

#include <fmt/format.h>

#include <cmath>

#include "core/base/units.h"
#include "core/simulation/command_path.h"
#include "core/simulation/joint_errors.h"

namespace nineline::compensation {

using kinematics::Machine;
using nc::Motion;
using nc::MotionKind;
using simulation::Deviation;
using simulation::DeviationStatistics;
using simulation::PathState;

namespace {

constexpr double kChord = 0.002;      // mm
constexpr double kStandstill = 1e-9;  // mm
constexpr std::size_t kMotionsBetweenReports = 4096;

/// Hands out the motions of a program one by one.
class MotionStream {
 public:
  MotionStream(const Machine& machine, const ProgramSetup& setup, nc::TextSource& text)
      : interpreter_(text, simulation::interpreterOptionsOf(machine, setup)) {}

  /// The next motion, nullptr after the last; valid until the next call.
  Result<const Motion*> next() {
    while (index_ >= motions_.size()) {
      const Result<const nc::ExecutedBlock*> block = interpreter_.next();
      if (!block) return block.error();
      if (*block == nullptr) return nullptr;
      motions_ = (*block)->motions;
      index_ = 0;
    }
    return &motions_[index_++];
  }

 private:
  nc::Interpreter interpreter_;
  std::span<const Motion> motions_;
  std::size_t index_ = 0;
};

/// Minutes that a motion takes by its F word, by a rule of its own: `degrees` of turning and `way` in units
/// of the program.
struct Timing {
  double word = 0.0;
  double way = 0.0;
  double degrees = 0.0;
};

Timing timingOf(const Machine& machine, const Motion& motion) {
  double way = 0.0;
  double turned = 0.0;
  for (int i = 0; i < machine.jointCount(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double moved = motion.end[k] - motion.start[k];
    (machine.isRotary(i) ? turned : way) += moved * moved;
  }
  Timing timing;
  timing.way = std::sqrt(way) / motion.feed_unit;
  if (timing.way < kStandstill) timing.way = 0.0;
  timing.degrees = degFromRad(std::sqrt(turned));
  const double per_minute = 60.0 * motion.feed;
  timing.word =
      timing.way > 0.0 || timing.degrees == 0.0 ? per_minute / motion.feed_unit : degFromRad(per_minute);
  return timing;
}

/// Rotary axes that turn alone at a feed in degrees must turn as fast in every line that stands for the
/// block, by the meaning that the control at hand gives F.
bool turnsAtItsSpeed(const Machine& machine, const Motion& a, const Motion& b,
                     simulation::FeedMeaning meaning) {
  constexpr double kSameSpeed = 2e-3;
  const Timing original = timingOf(machine, a);
  const Timing piece = timingOf(machine, b);
  if (piece.word == original.word && (piece.way == 0.0 || piece.degrees == 0.0)) return true;
  const bool vector = meaning == simulation::FeedMeaning::VectorSum;
  const double length = vector            ? std::hypot(piece.way, piece.degrees)
                        : piece.way > 0.0 ? piece.way
                                          : piece.degrees;
  const double wanted = piece.degrees / original.word;  // minutes
  return std::abs(length / piece.word - wanted) <= kSameSpeed * wanted;
}

bool turnsAlone(const Machine& machine, const Motion& motion) {
  if (motion.kind != MotionKind::Linear || motion.feed_mode != nc::FeedMode::PerMinute ||
      motion.tool_centre_point || motion.feed <= 0.0)
    return false;
  const Timing timing = timingOf(machine, motion);
  return timing.way == 0.0 && timing.degrees > 0.0;
}

/// F as its word says it, whatever the motion makes of it.
bool sameFeedWord(const Machine& machine, const Motion& a, const Motion& b) {
  if (a.feed == b.feed) return true;
  if (a.feed_mode != nc::FeedMode::PerMinute) return false;
  const double word = timingOf(machine, a).word;
  return std::abs(timingOf(machine, b).word - word) <= 1e-12 * word;
}

bool sameMeaning(const Machine& machine, const Motion& a, const Motion& b, bool whole,
                 simulation::FeedMeaning meaning) {
  const bool same_kind = a.kind == b.kind || (!whole && b.kind != MotionKind::Arc);
  const bool any_feed = a.feed_mode == nc::FeedMode::InverseTime || b.kind == MotionKind::Rapid;
  const bool same_feed = a.feed_mode == b.feed_mode &&
                         (any_feed || (turnsAlone(machine, a) ? turnsAtItsSpeed(machine, a, b, meaning)
                                                              : sameFeedWord(machine, a, b)));
  return same_kind && same_feed && a.role == b.role && a.spindle_speed == b.spindle_speed &&
         a.tool_centre_point == b.tool_centre_point && a.cutter_compensation == b.cutter_compensation;
}

double tiltBetween(const ToolPose& a, const ToolPose& b) {
  return std::atan2(a.axis.cross(b.axis).norm(), a.axis.dot(b.axis));
}

Deviation deviationOf(const ToolPose& ideal, const ToolPose& actual,
                      const simulation::JointErrorSolver& joint_errors) {
  return {actual.tip - ideal.tip, kinematics::logarithm(actual.R_WP * ideal.R_WP.transpose()),
          joint_errors.errorsOf(actual)};
}

class Comparison {
 public:
  Comparison(const ErrorModel& model, const ProgramSetup& setup, const ComparisonSink& sink)
      : model_(model),
        sink_(sink),
        machine_(model.machine()),
        meaning_(simulation::feedMeaningOf(setup.dialect)),
        path_before_(model, setup.state, setup.start),
        path_after_(model, setup.state, setup.start),
        cut_before_(machine_.jointCount()),
        cut_after_(machine_.jointCount()),
        all_before_(machine_.jointCount()),
        all_after_(machine_.jointCount()) {}

  Result<void> compare(const Motion& original, const Motion& corrected, double from, double to) {
    const Result<JointPositions> start =
        simulation::jointsOf(machine_, corrected.start, corrected.tool_centre_point);
    const Result<JointPositions> end =
        simulation::jointsOf(machine_, corrected.end, corrected.tool_centre_point);
    if (!start) return start.error();
    if (!end) return end.error();
    simulation::sampleFractions(model_, corrected, *start, *end, path_after_.state().approach, kChord,
                                fractions_);
    const double duration = sink_ ? simulation::durationOf(machine_, original, meaning_) * (to - from) : 0.0;
    double last = 0.0;
    for (const double u : fractions_) {
      const Result<JointPositions> q = jointsAt(corrected, u);
      const Result<JointPositions> ideal = jointsAt(original, from + u * (to - from));
      if (!q) return q.error();
      if (!ideal) return ideal.error();
      path_after_.moveTo(*q, 0.0);
      path_before_.moveTo(*ideal, 0.0);
      if (const int joint = machine_.firstOutsideTravel(*q); joint >= 0) {
        return noAnswer("travel",
                        fmt::format("The corrected command of axis {} lies outside its travel.",
                                    machine_.joint(joint).axis.text()),
                        {}, original.line);
      }
      time_ += duration * (u - last);
      last = u;
      take(original, *ideal, *q, from + u * (to - from) == 1.0);
    }
    return {};
  }

  Verification result() const {
    const bool cuts = !cut_before_.empty();
    return {cuts ? cut_before_.summary() : all_before_.summary(),
            cuts ? cut_after_.summary() : all_after_.summary(), worst_line_};
  }

 private:
  Result<JointPositions> jointsAt(const Motion& motion, double u) const {
    return simulation::jointsOf(machine_, positionAt(motion, machine_.jointCount(), u),
                                motion.tool_centre_point);
  }

  void take(const Motion& original, const JointPositions& ideal_q, const JointPositions& corrected_q,
            bool block_end) {
    kinematics::PoseJacobian jacobian;
    const ToolPose ideal = forwardWithJacobian(machine_, ideal_q, jacobian);
    const simulation::JointErrorSolver joint_errors(machine_, ideal_q, ideal, jacobian);
    const ToolPose before = path_before_.actualPose();
    const ToolPose after = path_after_.actualPose();
    const double step = first_ ? 0.0 : (ideal.tip - last_tip_).norm();
    first_ = false;
    last_tip_ = ideal.tip;
    const Deviation deviation_before = deviationOf(ideal, before, joint_errors);
    const Deviation deviation_after = deviationOf(ideal, after, joint_errors);
    length_ += step;
    if (const double off = deviation_after.tip.norm(); off > worst_) {
      worst_ = off;
      worst_line_ = original.line;
    }
    if (sink_) {
      const bool rapid = original.kind == MotionKind::Rapid;
      sink_({original.line, rapid, block_end, length_, time_, ideal_q, ideal, before, deviation_before},
            {original.line, rapid, block_end, length_, time_, corrected_q, ideal, after, deviation_after});
    }
    all_before_.add(deviation_before, tiltBetween(ideal, before), step);
    all_after_.add(deviation_after, tiltBetween(ideal, after), step);
    if (original.kind == MotionKind::Rapid || original.role == nc::MotionRole::Machine) return;
    cut_before_.add(deviation_before, tiltBetween(ideal, before), step);
    cut_after_.add(deviation_after, tiltBetween(ideal, after), step);
  }

  const ErrorModel& model_;
  const ComparisonSink& sink_;
  const Machine& machine_;
  simulation::FeedMeaning meaning_;
  PathState path_before_;
  PathState path_after_;
  std::vector<double> fractions_;
  DeviationStatistics cut_before_, cut_after_, all_before_, all_after_;
  Eigen::Vector3d last_tip_ = Eigen::Vector3d::Zero();
  double length_ = 0.0;
  double time_ = 0.0;
  double worst_ = 0.0;
  std::size_t worst_line_ = 0;
  bool first_ = true;
};

Error differs(std::size_t line, const char* what) {
  return noAnswer(
      "compensation.check",
      fmt::format(
          "The check of the corrected program failed at line {} of the original: {}. Nothing was written.",
          line, what),
      {}, line);
}

}  // namespace

Result<Verification> verifyCorrection(const ErrorModel& model, const ProgramSetup& setup,
                                      nc::TextSource& original, nc::TextSource& corrected,
                                      const PieceLog& log, Progress& progress, const ComparisonSink& sink) {
  MotionStream originals(model.machine(), setup, original);
  MotionStream correcteds(model.machine(), setup, corrected);
  Comparison comparison(model, setup, sink);
  const simulation::FeedMeaning meaning = simulation::feedMeaningOf(setup.dialect);
  std::size_t index = 0;
  std::size_t span = 0;
  for (;;) {
    const Result<const Motion*> motion = originals.next();
    if (!motion) return motion.error();
    if (*motion == nullptr) break;
    const Motion first = **motion;
    if (index >= log.counts().size()) return differs(first.line, "a motion is missing");
    const std::size_t count = log.counts()[index++];
    for (std::size_t i = 0; i < count; ++i) {
      const Result<const Motion*> piece = correcteds.next();
      if (!piece) return piece.error();
      if (*piece == nullptr) return differs(first.line, "a motion is missing");
      const PieceLog::Span part = count == 1 ? PieceLog::Span{} : log.spans()[span++];
      const bool take_up = count > 1 && part.from == part.to;
      if (!take_up && !sameMeaning(model.machine(), first, **piece, count == 1, meaning))
        return differs(first.line, "a motion means something else");
      if (Result<void> done = comparison.compare(first, **piece, static_cast<double>(part.from),
                                                 static_cast<double>(part.to));
          !done) {
        return done.error();
      }
    }
    if (index % kMotionsBetweenReports == 0) {
      if (progress.isCancelled()) return cancelled();
      progress.report(0.5 + 0.5 * static_cast<double>(index) / static_cast<double>(log.counts().size()),
                      "check");
    }
  }
  const Result<const Motion*> rest = correcteds.next();
  if (!rest) return rest.error();
  if (*rest != nullptr) return differs((*rest)->line, "a motion was added");
  return comparison.result();
}

}  // namespace nineline::compensation
