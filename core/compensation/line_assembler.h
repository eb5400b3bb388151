#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/compensation/compensation.h"

namespace nineline::compensation {

/// Puts corrected lines back into the order of the file. Lines arrive in the order of execution; lines that
/// never execute are copied byte for byte. A line that executes again (a loop, a subprogram called twice)
/// must come out the same each time, because it stands in the file once.
class LineAssembler {
 public:
  LineAssembler(nc::TextSource& source, const TextSink& sink) : source_(source), sink_(sink) {}

  /// The text that replaces a line, line end included. Fails with BadInput when the line was given another
  /// text before.
  [[nodiscard]] Result<void> put(std::size_t line, std::string_view text);
  /// Writes what is left of the file.
  [[nodiscard]] Result<void> finish();

 private:
  [[nodiscard]] Result<void> write(std::string_view text);
  [[nodiscard]] Result<void> copyLine();
  [[nodiscard]] Result<void> writeWaiting();
  nc::TextSource& source_;
  const TextSink& sink_;
  std::size_t next_line_ = 1;                   // the first line that is not written yet
  std::uint64_t next_offset_ = 0;               // where it starts
  std::map<std::size_t, std::string> waiting_;  // lines given ahead of their turn
  std::vector<std::uint64_t> written_;          // hashes of written lines, by line − 1
};

}  // namespace nineline::compensation
