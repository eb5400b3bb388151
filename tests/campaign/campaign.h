#pragma once

#include "core/compensation/compensation.h"
#include "tests/campaign/campaign_program.h"
#include "tests/campaign/path_measure.h"
#include "tests/campaign/second_opinion.h"

namespace nineline::campaign {

/// How finely the corrected programs are written.
struct Writing {
  const char* name = "";
  int linear_mm = 4;    ///< decimals of metric programs
  int linear_inch = 5;  ///< decimals of inch programs
  int rotary = 4;
  double tolerance = 1e-4;  ///< mm along a block
};
/// 3 decimals (inch 4), 4 (inch 5) and 6.
[[nodiscard]] const std::vector<Writing>& writings();

/// A machine with its errors, and a program.
struct Case {
  unsigned seed = 0;
  PlainMachine machine;
  bool more_effects = false;
  DrawnProgram program;
};
[[nodiscard]] Case drawCase(unsigned seed, int blocks);

struct Outcome {
  std::string fault;  ///< of drawing, compensating or matching; empty: measured
  PathComparison paths;
  std::string meaning;       ///< what rs274 says has changed; empty: nothing
  bool second_read = false;  ///< rs274 has read both programs
  std::size_t blocks = 0, lines = 0, corrected_lines = 0;
  double seconds = 0.0;
  double reported_before = 0.0, reported_after = 0.0;  ///< RMS that the program itself states
  std::string corrected_text;
};
/// Compensates and measures one case. `opinion`: nullptr leaves rs274 out.
[[nodiscard]] Outcome run(const Case& one, const Writing& writing, const SecondOpinion* opinion);

/// Per cent of the correctable RMS that is gone: of the tip, and of the tool axis.
[[nodiscard]] double removedPercent(const PathFigures& before, const PathFigures& after);
[[nodiscard]] double removedTiltPercent(const PathFigures& before, const PathFigures& after);

}  // namespace nineline::campaign
