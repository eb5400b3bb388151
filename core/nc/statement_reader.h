#pragma once

#include "core/nc/cursor.h"
#include "core/nc/dialect.h"
#include "core/nc/statement.h"

namespace nineline::nc {

/// What the readers of one line share.
struct LineReader {
  Block& block;
  Dialect dialect;
  const Parameters& parameters;
  Statement& out;
  Fault& fault;
  Cursor at;

  void fail(const char* code, std::string text) { fault.set(code, at.column(), std::move(text)); }
};

/// Blanks, comments, '/' and '%' are passed over; false at the end of the line.
bool skipToItem(LineReader& reader);
/// `letter` was taken at column `begin`: reads the number there, or nothing. True when a plain number stood
/// there.
bool readPlainValue(LineReader& reader, Word& word);

void readMacroStatement(LineReader& reader);  ///< Fanuc, LinuxCNC
void readOWord(LineReader& reader);           ///< LinuxCNC `o… keyword`; the letter is taken
void readSiemensStatement(LineReader& reader);

}  // namespace nineline::nc
