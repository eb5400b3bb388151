#pragma once

#include <functional>

#include "core/base/diagnostics.h"
#include "core/base/progress.h"
#include "core/errors/error_model.h"
#include "core/nc/interpreter.h"
#include "core/simulation/deviation_statistics.h"

namespace nineline::simulation {

using errors::ErrorModel;
using errors::MachineState;

/// What the control and the shop floor know and the program does not say.
struct ProgramSetup {
  std::optional<nc::Dialect> dialect;
  bool block_skip = false;
  JointPositions start{};                              ///< machine position before the first block: mm, rad
  std::map<std::string, JointPositions> work_offsets;  ///< "G54" → mm, rad in joint order
  std::map<int, double> tool_lengths;                  ///< H → mm
  MachineState state;  ///< temperatures, pass, load: constant over the program
};

/// The axes of a machine as a control names them, in joint order.
[[nodiscard]] nc::AxisLayout axisLayoutOf(const Machine& machine);
[[nodiscard]] nc::InterpreterOptions interpreterOptionsOf(const Machine& machine, const ProgramSetup& setup);

/// Fails when the model needs a temperature or another condition that the setup does not state.
[[nodiscard]] Result<void> requireConditions(const ErrorModel& model, const ProgramSetup& setup);

/// One place of a simulated tool path.
struct PathSample {
  std::size_t line = 0;  ///< of the program, from 1
  bool rapid = false;
  bool block_end = false;
  double s = 0.0;      ///< length of the ideal tool path from the start, mm
  double t = 0.0;      ///< time from the start, s
  JointPositions q{};  ///< command in machine coordinates, mm, rad
  ToolPose ideal;
  ToolPose actual;
  Deviation deviation;
};

struct SimulationReport {
  std::size_t blocks = 0;  ///< executed blocks
  std::size_t motions = 0;
  std::size_t samples = 0;
  double path_length = 0.0;    ///< mm, ideal tool path
  double time = 0.0;           ///< s at programmed feeds
  DeviationSummary deviation;  ///< over the cutting motions (over all, when nothing cuts)
  Diagnostics diagnostics;     ///< warnings
};

/// Called with each sample in order; returns false to stop.
using SampleSink = std::function<bool(const PathSample&)>;

/// Runs a program on the machine as it is: ideal and actual tool path, and the deviation between them. Every
/// block end is a sample; between them samples stand so close that chords leave an arc by 2 µm at most and
/// that no feature of an error table is skipped. Fails on an unreadable program (BadInput, line), a command
/// outside the travel (NoAnswer, line) and on a temperature or other condition that the model needs and
/// `setup` lacks.
[[nodiscard]] Result<SimulationReport> simulateProgram(const ErrorModel& model, nc::TextSource& program,
                                                       const ProgramSetup& setup, const SampleSink& sink,
                                                       Progress& progress);

/// The columns of contract.md, convention 9: the head line, and one line for each sample, each with its line
/// end.
[[nodiscard]] std::string pathCsvHeader(const Machine& machine);
void appendPathCsvRow(const Machine& machine, const PathSample& sample, std::string& out);

}  // namespace nineline::simulation
