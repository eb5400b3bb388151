#include <fmt/format.h>

#include <filesystem>

#include "tests/campaign/real_programs.h"

namespace fs = std::filesystem;
using nineline::campaign::RealProgram;

/// nineline_real_programs SCRATCH: the table of resources/docs/reports/real-programs.md on standard output.
int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: nineline_real_programs SCRATCH_FOLDER\n");
    return 2;
  }
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
  for (const RealProgram& row : nineline::campaign::runRealPrograms(data, argv[1])) {
    std::string figures = " | | ";
    if (row.compensated) {
      figures = fmt::format("{:.3f} | {:.3f} | {:.2f}", row.rms_before_um, row.rms_after_um,
                            100.0 * row.rms_after_um / row.rms_before_um);
    }
    fmt::print("| {} | {} | {} | {} | {} | {} | {} | {} |\n", row.file, row.dialect, row.structure,
               row.blocks, row.motions, figures, row.second_opinion, row.remark);
    compensated += row.compensated ? 1 : 0;
    refused += row.remark.starts_with("refused") ? 1 : 0;
    agreed += row.second_opinion.starts_with("same") ? 1 : 0;
    differ += row.second_opinion.starts_with("OTHER") || row.second_opinion.starts_with("DOES") ? 1 : 0;
  }
  fmt::print("\n{} compensated, {} refused; rs274 agrees on {}, differs on {}.\n", compensated, refused,
             agreed, differ);
  return differ == 0 ? 0 : 1;
}
