#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "core/base/file.h"
#include "tests/core/nc/program_runner.h"

namespace nineline::nc::testing {
namespace {

namespace fs = std::filesystem;

const fs::path kFolder = fs::path(NINELINE_SOURCE_DIR) / "tests/data/nc/bad";

/// "(expect BadNumber 3:7)" → "BadNumber 3:7".
std::string expectationOf(const std::string& program) {
  const std::size_t begin = program.find("(expect ");
  const std::size_t end = program.find(')');
  return begin < program.find('\n') && end != std::string::npos ? program.substr(begin + 8, end - begin - 8)
                                                                : "";
}

std::string textOf(const std::string& code, std::size_t line, std::size_t column) {
  return fmt::format("{} {}:{}", code.starts_with("nc.") ? code.substr(3) : code, line, column);
}

TEST(BadPrograms, EachGivesTheFaultThatItsFirstLineStates) {
  int count = 0;
  for (const fs::directory_entry& file : fs::directory_iterator(kFolder)) {
    const std::string program = readFile(file.path()).value();
    InterpreterOptions options = optionsFor("XYZ", Dialect::Fanuc);
    options.dialect.reset();
    const ProgramRun result = run(program, options);
    std::string found = result.error.empty() ? "nothing" : textOf(result.code, result.line, result.column);
    for (const Diagnostic& one : result.diagnostics.all()) {
      if (one.severity != Severity::Error) continue;
      found = textOf(one.code, one.line, one.column);
      break;
    }
    EXPECT_EQ(found, expectationOf(program)) << file.path().filename() << ": " << result.error;
    ++count;
  }
  EXPECT_GE(count, 90);
}

}  // namespace
}  // namespace nineline::nc::testing
