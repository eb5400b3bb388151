#pragma once

#include <string>

#include "core/postprocessing/axis_moves.h"

namespace nineline::postprocessing {

enum class Control { Fanuc, Siemens, LinuxCnc, Heidenhain };
enum class FeedWriting { PerMinute, InverseTime };

struct NcOptions {
  Control control = Control::Fanuc;
  FeedWriting feed = FeedWriting::PerMinute;
  bool tip_control = false;  ///< G43.4, TRAORI, M128: linear words are the tool tip in the workpiece frame
  int linear_decimals = 4;
  int rotary_decimals = 5;
  int program_number = 1000;  ///< O word of Fanuc
};

struct NcText {
  std::string text;
  std::size_t blocks = 0;  ///< that move
  Diagnostics warnings;
};

/// Refuses, as wrong usage, what a control cannot be told: axis names with a digit on LinuxCNC and
/// Heidenhain, inverse time on Heidenhain, tip control on LinuxCNC or without axes X, Y and Z.
[[nodiscard]] Result<void> checkControl(const Machine& machine, const NcOptions& options);

/// The program. With plain axes a feed motion of the length ℓ in the time t (rounded words) gets
///   G94: F = √(Σ mm² + Σ deg²)/t on Fanuc, Siemens (with FGROUP over all axes) and Heidenhain,
///        F = √(Σ mm²)/t on LinuxCNC, degrees where no linear axis moves;  G93: F = 1/t;
/// with tip control F is the feed of the tip. Sources: resources/docs/postprocessing.md.
[[nodiscard]] Result<NcText> writeNc(const Machine& machine, const ClProgram& program, const AxisMoves& moves,
                                     const NcOptions& options);

/// The length that an F word per minute counts on a control, in mm or degrees, between two sets of axis
/// words.
[[nodiscard]] double feedLength(const Machine& machine, Control control, const JointPositions& from,
                                const JointPositions& to);

}  // namespace nineline::postprocessing
