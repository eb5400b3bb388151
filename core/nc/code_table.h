#pragma once

#include <array>
#include <cstdint>

#include "core/nc/dialect.h"

namespace nineline::nc {

/// What a G code does, one enumerator for each way of doing it.
enum class CodeAction : std::uint8_t {
  Unknown,
  Pass,
  PassWithAxes,
  Refuse,
  Motion,
  Thread,
  RigidTap,
  Cycle,
  CancelCycle,
  ThreadOrCycle76,
  Dwell,
  ReferenceReturn,
  Plane,
  Inch,
  Millimetre,
  CutterOff,
  CutterLeft,
  CutterRight,
  LengthPlus,
  LengthMinus,
  LengthDynamic,
  LengthAdd,
  LengthOff,
  TipControl,
  LocalOffset,
  MachineCoordinates,
  WorkOffset,
  WorkOffsetExtended,
  NoWorkOffset,
  Absolute,
  Incremental,
  ArcAbsolute,
  ArcIncremental,
  SetPosition,
  ClearPosition,
  SuspendPosition,
  RestorePosition,
  SpindleLimit,
  InverseTime,
  PerMinute,
  PerRevolution,
  SurfaceSpeed,
  SpindleSpeed,
  ReturnInitial,
  ReturnPlane,
  Rotate,
  RotateOff,
  Data,
  DiameterOn,
  DiameterOff,
  MacroCall,
  MacroModalEnd,
  Polar
};

struct CodeEntry {
  CodeAction action = CodeAction::Unknown;
  std::uint8_t group = 0;  ///< modal group 1…31; 0: none
};

/// G codes in tenths: G54.1 is 541. The table covers G0 to G999.9.
using CodeTable = std::array<CodeEntry, 10000>;
[[nodiscard]] const CodeTable& codeTable(Dialect dialect);

}  // namespace nineline::nc
