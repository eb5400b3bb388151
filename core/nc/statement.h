#pragma once

#include <string>
#include <vector>

#include "core/nc/block.h"
#include "core/nc/fault.h"
#include "core/nc/parameters.h"

namespace nineline::nc {

/// What decides where execution goes on.
enum class Flow : std::uint8_t {
  None,
  Goto,     ///< label or number; Siemens with a direction
  WhileDo,  ///< Fanuc WHILE [ ] DO n, condition in `truth`; DO n alone is always true
  End,      ///< Fanuc END n
  Sub,
  EndSub,
  Return,
  Call,  // LinuxCNC
  If,
  ElseIf,
  Else,
  EndIf,  // LinuxCNC and Siemens
  While,
  EndWhile,
  Do,
  Repeat,
  EndRepeat,
  Break,
  Continue  // LinuxCNC; While also Siemens
};

/// Words of Siemens that are no letter.
enum class Keyword : std::uint8_t {
  Supa,
  TipControlOn,
  TipControlOff,
  DiameterOn,
  DiameterOff,
  ThreePointArc,
  Return,
  TangentArc
};

struct Assignment {
  Variable variable;
  Value value;
  std::uint32_t column = 0;
};

/// What a line says beyond plain words. The words themselves go to the Block.
struct Statement {
  Flow flow = Flow::None;
  long number = 0;
  std::string label;
  char direction = 0;  ///< Siemens GOTOF '+', GOTOB '−'
  bool truth = true;
  double count = 0.0;  ///< of `repeat`
  std::uint32_t flow_column = 0;
  std::vector<Value> arguments;
  std::vector<Assignment> assignments;
  std::vector<Keyword> keywords;
  std::vector<Assignment> definitions;  ///< Siemens DEF
  std::vector<std::string> passed;      ///< words that are passed through with a warning

  void clear();
};

/// Reads any line of the language, with variables evaluated. A line that plain words make up is cheaper with
/// readPlainWords. `fault` holds the first fault; the block's words are then not complete.
void readStatement(Block& block, Dialect dialect, const Parameters& parameters, Statement& statement,
                   Fault& fault);

/// Only what a scan for jump targets needs: the label and keyword that a line starts with. Nothing is
/// evaluated.
struct LineMark {
  bool is_o_word = false;  ///< LinuxCNC `o<name> keyword`, or O1000
  std::string label;       ///< of the O word: digits or lower-case name
  long number = -1;        ///< of the O word or 0
  Flow flow = Flow::None;
  long block_number = -1;   ///< N word
  std::string block_label;  ///< Siemens `LABEL:`
};
/// False where the line surely has no mark: it begins with G, X and the like.
[[nodiscard]] bool mayBeMark(std::string_view text);
[[nodiscard]] LineMark markOf(std::string_view text, Dialect dialect);

}  // namespace nineline::nc
