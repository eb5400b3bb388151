#include <fmt/format.h>

#include <filesystem>

#include "tests/campaign/real_programs.h"
#include "tests/campaign/sample_programs.h"

namespace fs = std::filesystem;
using nineline::campaign::RealProgram;
using nineline::campaign::SampleProgram;

namespace {

/// The table of real programs; how many of them differ.
int printRealPrograms(const fs::path& scratch) {
  const fs::path data = fs::path(NINELINE_SOURCE_DIR) / "../shared/data";
  if (!fs::exists(data)) {
    fmt::print("Skipped: the folder shared/data beside the repository is not there.\n");
    return 0;
  }
  fmt::print(
      "| file | dialect | structure | blocks | motions | before um | after um | left % | rs274 | remark |\n");
  fmt::print("|---|---|---|---:|---:|---:|---:|---:|---|---|\n");
  int compensated = 0;
  int refused = 0;
  int agreed = 0;
  int differ = 0;
  for (const RealProgram& row : nineline::campaign::runRealPrograms(data, scratch)) {
    std::string figures = " | | ";
    if (row.compensated) {
      figures = fmt::format("{:.3f} | {:.3f} | {:.2f}", row.rms_before_um, row.rms_after_um,
                            100.0 * row.rms_after_um / row.rms_before_um);
    }
    fmt::print("| {} | {} | {} | {} | {} | {} | {} | {} |\n", row.file, row.dialect, row.structure,
               row.blocks, row.motions, figures, row.second_opinion, row.remark);
    compensated += row.compensated ? 1 : 0;
    refused += row.remark.starts_with("refused") ? 1 : 0;
    const bool differs = row.second_opinion.find("OTHER") != std::string::npos ||
                         row.second_opinion.starts_with("DOES") || row.remark.starts_with("FAULT");
    agreed += !differs && row.second_opinion.starts_with("same") ? 1 : 0;
    differ += differs ? 1 : 0;
  }
  fmt::print("\n{} compensated, {} refused; rs274 agrees on {}, differs on {}.\n", compensated, refused,
             agreed, differ);
  return differ;
}

void printSamplePrograms(const fs::path& folder, const fs::path& scratch) {
  fmt::print("\n| file | rs274 | we |\n|---|---|---|\n");
  int read = 0;
  int same = 0;
  for (const SampleProgram& row : nineline::campaign::runSamplePrograms(folder, scratch)) {
    const bool theirs = row.fault.empty();
    read += theirs ? 1 : 0;
    same += theirs && row.difference.empty() ? 1 : 0;
    if (theirs && !row.difference.empty()) fmt::print("| {} | reads it | {} |\n", row.file, row.difference);
  }
  fmt::print("\nrs274 reads {}; the same motions in {}.\n", read, same);
}

}  // namespace

/// nineline_real_programs SCRATCH [SAMPLES]: the tables of resources/docs/reports/real-programs.md on
/// standard output. SAMPLES: the folder of LinuxCNC's sample programs.
int main(int argc, char** argv) {
  if (argc != 2 && argc != 3) {
    fmt::print(stderr, "usage: nineline_real_programs SCRATCH_FOLDER [SAMPLES_FOLDER]\n");
    return 2;
  }
  const int differ = printRealPrograms(argv[1]);
  if (argc == 3) printSamplePrograms(argv[2], argv[1]);
  return differ == 0 ? 0 : 1;
}
