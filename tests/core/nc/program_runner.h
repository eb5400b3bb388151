#pragma once

#include <string>
#include <vector>

#include "core/nc/interpreter.h"

namespace nineline::nc::testing {

/// A block as it was executed, kept.
struct RunBlock {
  std::size_t line = 0;
  std::string text;
  std::vector<Motion> motions;
  WordFrame frame;
  bool rewritable = false;
  bool feed_stated = false;
  bool skipped = false;
  bool repeated = false;
  AxisMask has_word = 0;
  int motion_code = 0;
  int depth = 0;
};

struct ProgramRun {
  std::vector<RunBlock> blocks;
  std::vector<Motion> motions;
  std::string error;  ///< message of the error that ended execution; empty: none
  std::string code;   ///< its code
  std::size_t line = 0, column = 0;
  Diagnostics diagnostics;
  Dialect dialect = Dialect::Fanuc;

  [[nodiscard]] bool warned(const std::string& text) const;
};

/// A layout of plain letters: `XYZ`, `XZC`; A B C are rotary.
AxisLayout axesOf(const std::string& letters);
InterpreterOptions optionsFor(const std::string& letters, Dialect dialect);

ProgramRun run(const std::string& program, InterpreterOptions options);
ProgramRun runFanuc(const std::string& program, const std::string& letters = "XYZ");
ProgramRun runSiemens(const std::string& program, const std::string& letters = "XYZ");
ProgramRun runLinuxCnc(const std::string& program, const std::string& letters = "XYZ");

}  // namespace nineline::nc::testing
