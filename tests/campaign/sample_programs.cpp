#include "tests/campaign/sample_programs.h"

#include <algorithm>

#include "core/base/file.h"
#include "tests/campaign/rs274_reader.h"

namespace nineline::campaign {

namespace fs = std::filesystem;

std::vector<SampleProgram> runSamplePrograms(const fs::path& folder, const fs::path& scratch) {
  fs::create_directories(scratch);
  std::vector<fs::path> files;
  for (const fs::directory_entry& file : fs::recursive_directory_iterator(folder)) {
    if (file.is_regular_file() && file.path().extension() == ".ngc") files.push_back(file.path());
  }
  std::sort(files.begin(), files.end());
  std::string tools;
  for (int tool = 1; tool <= 30; ++tool)
    tools += "T" + std::to_string(tool) + " P" + std::to_string(tool) + " D6.0 Z0.0\n";
  std::vector<SampleProgram> rows;
  for (const fs::path& file : files) {
    const std::string text = readFile(file).value();
    const Rs274 theirs = runRs274(scratch, text, tools);
    SampleProgram row{fs::relative(file, folder).generic_string(), withoutBars(theirs.fault), ""};
    nc::InterpreterOptions options;
    for (int tool = 1; tool <= 30; ++tool) options.tool_lengths[tool] = 0.0;
    row.difference = withoutBars(motionDifference(text, theirs, options));
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace nineline::campaign
