#pragma once

#include "core/base/units.h"
#include "core/simulation/simulation.h"

namespace nineline::compensation {

using kinematics::JointPositions;
using simulation::DeviationSummary;
using simulation::ErrorModel;
using simulation::ProgramSetup;

/// Which errors the correction removes.
enum class Mode {
  Auto,     ///< tip and tool axis where the program moves enough joints; else the tip; else what the joints
            ///< reach
  TipOnly,  ///< the tool tip, rotary axes as programmed unless they are needed for it (grinder)
  Thread    ///< two-axis mode of a thread grinder: radius and lead with X and Z, C as programmed
            ///< (theory.md, 1.7)
};

/// What becomes of blocks that turn rotary axes alone, where F counts degrees.
enum class TurningFeed {
  Auto,  ///< linear words where the stated control keeps the turning speed; see resources/docs/adr/006
  Alone  ///< no linear words: their deviation remains
};

struct CompensationOptions {
  double tolerance = 1e-4;  ///< mm: largest deviation along a block before it is subdivided
  double angle_tolerance = radFromArcsec(0.1);  ///< rad: the same for the tool axis
  double largest_correction = 1.0;              ///< mm; beyond it compensation stops with the block's number
  double largest_angle_correction = radFromDeg(1.0);  ///< rad
  bool keep_block_count = false;                      ///< never insert lines
  bool correct_rapids = true;                         ///< ends of G00 motions; off: they stay as programmed
  Mode mode = Mode::Auto;
  TurningFeed turning = TurningFeed::Auto;
  std::optional<int> linear_decimals;  ///< digits after the point; absent: as in the program
  std::optional<int> rotary_decimals;
};

/// What a compensation did. The figures come from an independent simulation of the corrected text.
struct CompensationReport {
  std::size_t blocks = 0;              ///< executed blocks of the original program
  std::size_t corrected = 0;           ///< blocks whose words changed
  std::size_t inserted = 0;            ///< lines added
  std::vector<double> max_correction;  ///< of each joint, mm or rad
  DeviationSummary before;
  DeviationSummary after;
  Diagnostics diagnostics;  ///< warnings; what cannot be corrected is among them
  double seconds = 0.0;     ///< wall time of the correction without the check
};

/// Receives the corrected text in order, piece by piece; an error ends the work.
using TextSink = std::function<Result<void>(std::string_view)>;

/// Sees every place that the check compares: the original command as it is, and what the corrected one makes
/// of it (`deviation` from the original's ideal path, `line` of the original program).
using ComparisonSink =
    std::function<void(const simulation::PathSample& before, const simulation::PathSample& after)>;

/// Writes the program whose actual tool path is the ideal one (theory.md, 1.6 and 1.8). The corrected text is
/// read again by the interpreter and simulated apart from the solver; `before` and `after` are those figures.
/// `corrected_text` opens what the sink received, for that check. Fails with the block's line when a
/// correction is beyond its limit, a corrected command outside the travel, a point has no solution, or a
/// block cannot be rewritten. Effects that are not active take no part; those that no program removes (a
/// servo lag, a vibration) count in the check and are named in a warning.
[[nodiscard]] Result<CompensationReport> compensateProgram(
    const ErrorModel& model, nc::TextSource& program, const ProgramSetup& setup,
    const CompensationOptions& options, const TextSink& sink,
    const std::function<Result<std::unique_ptr<nc::TextSource>>()>& corrected_text, Progress& progress,
    const ComparisonSink& compared = {});

/// The same from text to text.
struct CompensatedText {
  std::string text;
  CompensationReport report;
};
[[nodiscard]] Result<CompensatedText> compensateText(const ErrorModel& model, const std::string& name,
                                                     std::string_view text, const ProgramSetup& setup,
                                                     const CompensationOptions& options, Progress& progress,
                                                     const ComparisonSink& compared = {});

/// The same from file to file: `target` appears whole or not at all.
[[nodiscard]] Result<CompensationReport> compensateFile(
    const ErrorModel& model, const std::filesystem::path& source, const std::filesystem::path& target,
    const ProgramSetup& setup, const CompensationOptions& options, Progress& progress);

/// The result record of contract.md.
[[nodiscard]] Json reportToJson(const CompensationReport& report, const kinematics::Machine& machine);

/// How much of the deviation is gone, per cent of the RMS: keys as in the record.
[[nodiscard]] double reductionPercent(double rms_before, double rms_after);

}  // namespace nineline::compensation
