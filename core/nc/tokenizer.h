#pragma once

#include "core/nc/block.h"
#include "core/nc/dialect.h"

namespace nineline::nc {

/// Reads a line of nothing but plain words (`N10 G1 X-.5 Y1. C2=12.5`), comments and blanks into
/// `block.words`. False where anything else stands in it, or where a word has no readable number: the line is
/// then for the StatementReader, which knows the whole language. `block.text` must be set; `semicolon` and
/// parentheses are comments as the dialect has them.
[[nodiscard]] bool readPlainWords(Block& block, Dialect dialect);

/// True where the first word of the line is '/' (block skip), whatever its number.
[[nodiscard]] bool startsWithSlash(std::string_view text);

}  // namespace nineline::nc
