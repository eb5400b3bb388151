#include <gtest/gtest.h>

#include <filesystem>
#include <iostream>
#include <set>

#include "core/base/file.h"
#include "tests/core/nc/program_runner.h"

namespace nineline::nc::testing {
namespace {

namespace fs = std::filesystem;

const fs::path kData = fs::path(NINELINE_SOURCE_DIR) / "../shared/data";
const std::set<std::string> kLathes = {"FANUC0T.nc", "0100.nc", "TOKARKA.NC"};

InterpreterOptions machineFor(const fs::path& file) {
  const bool lathe = kLathes.contains(file.filename().string());
  InterpreterOptions options = optionsFor(lathe ? "XZC" : "XYZABC", Dialect::Fanuc);
  options.dialect.reset();
  options.axes.axes[0].diameter = lathe;
  return options;
}

TEST(RealPrograms, EachIsReadOrRefusedWithPlaceAndReason) {
  if (!fs::exists(kData)) GTEST_SKIP() << "needs the folder shared/data beside the repository";
  int read = 0;
  int files = 0;
  for (const char* const folder :
       {"nc-controllers", "nc-siemens", "nc-linuxcnc/5axis", "nc-linuxcnc/thread"}) {
    for (const fs::directory_entry& file : fs::directory_iterator(kData / folder)) {
      const std::string kind = file.path().extension().string();
      if (kind != ".nc" && kind != ".NC" && kind != ".mpf" && kind != ".ngc" && kind != ".txt") continue;
      Result<std::unique_ptr<TextSource>> source = openTextFile(file.path());
      ASSERT_TRUE(source) << source.error().message();
      const ProgramRun result = run(readFile(file.path()).value(), machineFor(file.path()));
      ++files;
      const bool good = result.error.empty() && !result.diagnostics.hasErrors();
      read += good ? 1 : 0;
      if (!result.error.empty()) {
        EXPECT_GT(result.line, 0U) << file.path();
        EXPECT_GT(result.error.size(), 20U) << file.path();
      }
      const std::string why = result.error.empty() && !good
                                  ? result.diagnostics.firstError(file.path().filename()).message()
                                  : result.error;
      std::cout << file.path().filename().string() << ": " << result.motions.size() << " motions"
                << (good ? "" : ", refused: ") << why << "\n";
    }
  }
  EXPECT_GE(files, 25);
  EXPECT_GE(read, 17);
}

}  // namespace
}  // namespace nineline::nc::testing
