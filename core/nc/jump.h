#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/nc/parameters.h"

namespace nineline::nc {

/// Where a call came from.
struct CallLevel {
  std::uint64_t offset = 0;  ///< of the line after the call
  std::size_t line = 0;      ///< its number
  std::uint64_t body = 0;    ///< of the subprogram's first line, for repeats
  std::size_t body_line = 0;
  long repeats = 1;  ///< left, this one included
  bool own_variables = false;
  std::string name;
  std::size_t loops = 0;  ///< loops open when it began
};

enum class LoopKind : std::uint8_t { While, Do, Repeat };

/// A loop that is open: WHILE…DO, o while, o do, o repeat.
struct LoopLevel {
  std::string label;
  std::uint64_t offset = 0;  ///< of the line that opens it
  std::size_t line = 0;
  long repeats = -1;  ///< left; −1: by condition
  LoopKind kind = LoopKind::While;
};

/// What the next call of `next` does before it reads.
enum class JumpKind : std::uint8_t {
  None,
  CallNumber,
  CallName,
  CallBlock,
  Goto,
  SkipIf,
  SkipLoop,
  SkipSub,
  End
};

struct Jump {
  JumpKind kind = JumpKind::None;
  long number = 0;
  std::string label;
  char direction = 0;  ///< GOTOF +, GOTOB −
  long repeats = 1;
  bool own_variables = false;
  std::vector<Value> arguments;
  std::uint32_t column = 0;
};

}  // namespace nineline::nc
