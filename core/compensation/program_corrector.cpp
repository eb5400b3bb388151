#include "core/compensation/program_corrector.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/units.h"

namespace nineline::compensation {

using nc::AxisMask;
using nc::AxisValues;
using nc::ExecutedBlock;
using nc::Motion;
using nc::MotionKind;
using nc::MotionRole;

namespace {

constexpr std::size_t kBlocksBetweenReports = 4096;

}  // namespace

ProgramCorrector::ProgramCorrector(const ErrorModel& model, const ProgramSetup& setup,
                                   const CompensationOptions& options, nc::TextSource& source,
                                   const TextSink& sink)
    : model_(model),
      machine_(model.machine()),
      options_(options),
      stated_(setup.dialect),
      source_(source),
      interpreter_(source, simulation::interpreterOptionsOf(machine_, setup)),
      planner_(model, setup, options),
      assembler_(source, sink),
      emitted_(simulation::axisLayoutOf(machine_), setup.start),
      ideal_position_(setup.start),
      layout_(simulation::axisLayoutOf(machine_)) {}

Result<void> ProgramCorrector::learnStyle() {
  const Result<nc::NumberStyle> style = styleOf(source_, interpreter_.dialect(), layout_);
  if (!style) return style.error();
  editor_.setStyle(*style);
  double linear_resolution = 0.0;
  double rotary_resolution = 0.0;
  for (int i = 0; i < layout_.count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const bool rotary = layout_.axes[k].rotary;
    const std::optional<int>& chosen = rotary ? options_.rotary_decimals : options_.linear_decimals;
    decimals_[k] =
        std::clamp(chosen.value_or(rotary ? style->rotary_decimals : style->linear_decimals), 0, 9);
    const double increment = std::pow(10.0, -decimals_[k]);
    double& resolution = rotary ? rotary_resolution : linear_resolution;
    resolution = std::max(resolution, rotary        ? radFromDeg(increment)
                                      : style->inch ? mmFromInch(increment)
                                                    : increment);
  }
  planner_.setResolution(linear_resolution, rotary_resolution);
  return {};
}

Result<void> ProgramCorrector::run(Progress& progress) {
  if (Result<void> learnt = learnStyle(); !learnt) return learnt;
  for (;;) {
    const Result<const ExecutedBlock*> executed = interpreter_.next();
    if (!executed) return executed.error();
    if (*executed == nullptr) break;
    ++report_.blocks;
    Result<void> done = correct(**executed);
    active_code_ = (*executed)->motion_code;
    if (!done) {
      Error error = done.error();
      error.source = source_.name();
      if (error.line == 0) error.line = (*executed)->block->line;
      return error;
    }
    if (report_.blocks % kBlocksBetweenReports == 0) {
      if (progress.isCancelled()) return cancelled();
      progress.report(-1.0, "correct");
    }
  }
  if (interpreter_.diagnostics().hasErrors()) return interpreter_.diagnostics().firstError(source_.name());
  return assembler_.finish();
}

CompensationReport ProgramCorrector::takeReport() {
  report_.max_correction.assign(planner_.largestCorrections().begin(),
                                planner_.largestCorrections().begin() + machine_.jointCount());
  Diagnostics all = interpreter_.diagnostics();
  all.append(report_.diagnostics);
  report_.diagnostics = std::move(all);
  return std::move(report_);
}

Result<void> ProgramCorrector::keep(const ExecutedBlock& executed) {
  line_.assign(executed.block->text);
  line_ += executed.block->line_end;
  return assembler_.put(executed.block->line, line_);
}

/// G92 names the present place: in the corrected program that is the corrected place, so that its offset
/// differs.
void ProgramCorrector::followPositionOffsets(const ExecutedBlock& executed) {
  for (const nc::Word& word : executed.block->words) {
    if (word.letter != 'G') continue;
    if (word.value == 92.0) {
      for (int i = 0; i < layout_.count; ++i) {
        const auto k = static_cast<std::size_t>(i);
        if (nc::contains(executed.has_word, i))
          shift_change_[k] = emitted_.position()[k] - ideal_position_[k];
      }
    } else if (word.value > 92.05 && word.value < 92.25) {  // G92.1, G92.2
      shift_change_.fill(0.0);
    }
  }
}

nc::WordFrame ProgramCorrector::shiftedFrame(const nc::WordFrame& frame) const {
  nc::WordFrame shifted = frame;
  for (std::size_t k = 0; k < shifted.shift.size(); ++k) shifted.shift[k] += shift_change_[k];
  return shifted;
}

Result<void> ProgramCorrector::refuseComputed(const ExecutedBlock& executed) const {
  for (const nc::Word& word : executed.block->words) {
    if (!word.expression || !isAxisLetter(word.letter)) continue;
    const std::string_view text = executed.block->text.substr(word.begin, word.end - word.begin);
    return badInput("compensation.computed",
                    fmt::format("The word '{}' is computed; a correction needs a plain number there.", text),
                    source_.name(), executed.block->line, word.begin + 1);
  }
  return badInput("compensation.block", "This block moves the machine in a way that cannot be rewritten.",
                  source_.name(), executed.block->line, 1);
}

Result<void> ProgramCorrector::correct(const ExecutedBlock& executed) {
  if (interpreter_.diagnostics().hasErrors()) return interpreter_.diagnostics().firstError(source_.name());
  if (executed.motions.empty()) {
    followPositionOffsets(executed);
    return keep(executed);
  }
  for (const Motion& motion : executed.motions) commanded_ |= motion.commanded;
  const Motion last = executed.motions.back();
  if (executed.rewritable) {
    if (last.cutter_compensation != 0) {
      report_.diagnostics.countedWarning(
          "compensation.cutter",
          "Cutter radius compensation is on: the correction is that of the programmed contour.",
          executed.block->line);
    }
    if (Result<void> done = correctMotion(executed, last); !done) return done;
    ideal_position_ = last.end;
    warnOutsideTables(last);
    return {};
  }
  const bool computed =
      std::any_of(executed.motions.begin(), executed.motions.end(), [](const Motion& motion) {
        return motion.role == MotionRole::Block || motion.role == MotionRole::Thread;
      });
  if (computed) return refuseComputed(executed);
  return canCorrectCycle(executed) ? correctCycle(executed) : keepAsItIs(executed);
}

AxisMask ProgramCorrector::writableAxes(const ExecutedBlock& executed, const Motion& motion) {
  if (motion.kind == MotionKind::Rapid && !options_.correct_rapids) return 0;
  AxisMask free = motion.established;
  if (executed.frame->incremental != 0) {
    const auto assumed = static_cast<AxisMask>(commanded_ & executed.frame->incremental & ~free);
    if (assumed != 0) {
      report_.diagnostics.countedWarning(
          "compensation.start",
          "The program moves by increments before it states a position; the start position is assumed.",
          motion.line);
    }
    free |= assumed;
  }
  if (turning_ == TurnWriting::Alone) return static_cast<AxisMask>(free & ~linearAxes());
  for (int i = 0; i < layout_.count; ++i) {
    if (nc::contains(free, i) || nc::contains(commanded_, i) || motion.kind == MotionKind::Rapid) continue;
    report_.diagnostics.countedWarning(
        "compensation.unpositioned",
        fmt::format("Axis {} has no stated position yet; it is not corrected before that.",
                    layout_.axes[static_cast<std::size_t>(i)].id.text()),
        motion.line);
  }
  return free;
}

AxisMask ProgramCorrector::linearAxes() const {
  AxisMask linear = 0;
  for (int i = 0; i < layout_.count; ++i) {
    if (!layout_.axes[static_cast<std::size_t>(i)].rotary) linear |= nc::axisBit(i);
  }
  return linear;
}

void ProgramCorrector::warnTurning(std::size_t line) {
  static constexpr const char* kAlone =
      "A rotary axis moves alone: its feed is in degrees, so that the linear axes stay where they are and a "
      "deviation remains. State the control to have it corrected.";
  static constexpr const char* kKept =
      "A rotary axis moves alone and gets words of the linear axes beside it. F stays, because a Fanuc "
      "control "
      "counts a degree as a millimetre; on a control that counts the linear path alone the axis would race.";
  static constexpr const char* kRestated =
      "A rotary axis moves alone and gets words of the linear axes beside it. F is restated for their path, "
      "as "
      "LinuxCNC counts it, and put back behind the block; on another control the axis would crawl.";
  if (turning_ == TurnWriting::Alone)
    report_.diagnostics.countedWarning("compensation.turning", kAlone, line);
  if (turning_ == TurnWriting::KeepFeed)
    report_.diagnostics.countedWarning("compensation.turning.kept", kKept, line);
  if (turning_ == TurnWriting::RestateFeed)
    report_.diagnostics.countedWarning("compensation.turning.restated", kRestated, line);
}

void ProgramCorrector::warnOutsideTables(const Motion& motion) {
  if (motion.tool_centre_point) return;  // the values are no joint positions
  covered_.q = motion.end;
  const int effect = model_.firstUncovered(covered_);
  if (effect < 0) return;
  report_.diagnostics.countedWarning(
      "table.outside",
      fmt::format("Outside the range of {}; its end value is used.",
                  model_.effects()[static_cast<std::size_t>(effect)]->component().text()),
      motion.line);
}

void ProgramCorrector::warnExceeded(std::size_t line) {
  report_.diagnostics.countedWarning(
      "compensation.tolerance",
      "The deviation along the block exceeds the tolerance, because the block stays one block.", line);
}

}  // namespace nineline::compensation
