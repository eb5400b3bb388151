#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "core/base/diagnostics.h"
#include "core/base/result.h"
#include "core/nc/block.h"
#include "core/nc/dialect.h"
#include "core/nc/motion.h"
#include "core/nc/text_source.h"

namespace nineline::nc {

/// What the control knows and the program does not say.
struct InterpreterOptions {
  std::optional<Dialect> dialect;  ///< absent: recognised from the text
  AxisLayout axes;
  bool block_skip = false;  ///< '/' blocks are left out
  AxisValues start{};       ///< machine position before the first block
  /// Work offsets by name ("G54", "G54.1P3"): mm, rad in layout order. Absent ones are zero until G10 sets
  /// them.
  std::map<std::string, AxisValues> work_offsets;
  std::map<int, double> tool_lengths;  ///< H number (LinuxCNC: tool number) → mm
  /// Reference points of G28 (1) and G30 (2, 3, 4) in machine coordinates. Absent ones are zero.
  std::map<int, AxisValues> reference_points;
  std::size_t most_jumps =
      10'000'000;  ///< jumps back and subprogram calls before the program counts as endless
};

/// What one block did. Pointers and spans are valid until the next call.
struct ExecutedBlock {
  const Block* block = nullptr;
  std::span<const Motion> motions;   ///< empty for blocks that move nothing; several for cycles
  const WordFrame* frame = nullptr;  ///< of the block's axis words
  bool rewritable = false;       ///< one motion of role Block or Thread whose plain axis words state its end
  bool centre_absolute = false;  ///< I J K state the centre itself (G90.1, AC), not the way to it
  bool centre_mixed = false;     ///< one of them states the centre, the other the way to it
  bool feed_stated = false;      ///< an F word stands in the block
  AxisMask has_word = 0;         ///< axes named by a plain number word in the block
  int motion_code = 0;           ///< active group 1 code: 0, 1, 2, 3, 33…; −1 cancelled (G80)
  int depth = 0;                 ///< 0 in the main program, more inside subprograms
  bool repeated = false;         ///< the line was executed before (a loop, a subprogram called again)
};

/// Executes a program block by block in constant memory. Unknown codes pass with a warning; what could be
/// motion and is not understood ends execution with an error.
class Interpreter {
 public:
  Interpreter(TextSource& source, InterpreterOptions options);
  ~Interpreter();
  Interpreter(const Interpreter&) = delete;
  Interpreter& operator=(const Interpreter&) = delete;

  /// The next block in the order of execution; nullptr after the last. An error (BadInput with file, line,
  /// column) ends execution: every later call returns the same error.
  [[nodiscard]] Result<const ExecutedBlock*> next();

  [[nodiscard]] const Diagnostics& diagnostics() const;
  [[nodiscard]] Dialect dialect() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace nineline::nc
