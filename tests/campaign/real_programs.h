#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace nineline::campaign {

/// What became of one real program: a row of resources/docs/reports/real-programs.md.
struct RealProgram {
  std::string file;  ///< relative to the data folder
  std::string dialect;
  std::string structure;  ///< built-in machine whose axes it uses
  std::size_t blocks = 0;
  std::size_t motions = 0;
  bool compensated = false;
  double rms_before_um = 0.0;  ///< of the corrected program as it is read again
  double rms_after_um = 0.0;
  std::string second_opinion;  ///< what `rs274` says
  std::string remark;          ///< the refusal with line and reason, or warnings
};

/// Reads, compensates and reads again every program below `data`/nc-*. `scratch`: a folder for `rs274`.
[[nodiscard]] std::vector<RealProgram> runRealPrograms(const std::filesystem::path& data,
                                                       const std::filesystem::path& scratch);

}  // namespace nineline::campaign
