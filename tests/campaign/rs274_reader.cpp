#include "tests/campaign/rs274_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <vector>

#include "core/base/file.h"
#include "core/base/text.h"
#include "tests/core/nc/canonical_calls.h"

namespace nineline::campaign {

namespace fs = std::filesystem;

namespace {

/// The line before the source line that rs274 repeats under its message.
std::string faultOf(const std::string& output) {
  std::vector<std::string> lines;
  for (const std::string_view line : split(output, '\n')) {
    const std::string text(trimmed(line));
    if (!text.empty() && text.find(" N..... ") == std::string::npos && text != "executing")
      lines.push_back(text);
  }
  if (lines.empty()) return "stopped without a message";
  return lines.size() > 1 ? lines[lines.size() - 2] : lines.back();
}

}  // namespace

std::string withoutBars(std::string text) {
  std::replace(text.begin(), text.end(), '|', '/');
  return text;
}

std::string toolTableBeside(const fs::path& file) {
  for (const fs::directory_entry& entry : fs::directory_iterator(file.parent_path())) {
    if (entry.path().extension() == ".tbl") return readFile(entry.path()).value();
  }
  std::string table;
  for (int tool = 1; tool <= 30; ++tool) table += fmt::format("T{0} P{0} Z0 D5\n", tool);
  return table;
}

Rs274 runRs274(const fs::path& folder, const std::string& program, const std::string& tools) {
  std::ofstream(folder / "program.ngc", std::ios::binary) << program;
  std::ofstream(folder / "tools.tbl") << tools;
  const std::string command = fmt::format(
      "cd '{0}' && rm -f rs274ngc.var && HOME='{0}' timeout 60 rs274 -t tools.tbl -g program.ngc 2>&1",
      folder.string());
  Rs274 result;
  std::FILE* const pipe = ::popen(command.c_str(), "r");
  if (pipe == nullptr) return {"", "cannot be started"};
  std::array<char, 4096> buffer;
  for (std::size_t got = 0; (got = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
    result.calls.append(buffer.data(), got);
  if (::pclose(pipe) != 0) result.fault = faultOf(result.calls);
  return result;
}

std::string motionDifference(const std::string& text, const Rs274& theirs, nc::InterpreterOptions options) {
  options.dialect = nc::Dialect::LinuxCnc;
  options.start = {};
  const nc::testing::OwnMoves own = nc::testing::interpretMoves("program", text, std::move(options));
  if (!own.error.empty()) return own.error;
  return nc::testing::differenceOf(own.moves, nc::testing::readCanonicalCalls(theirs.calls));
}

}  // namespace nineline::campaign
