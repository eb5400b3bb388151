#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace nineline::campaign {

/// One of LinuxCNC's sample programs, read by `rs274` and by us: row NC-2 of performance.md.
struct SampleProgram {
  std::string file;
  std::string fault;       ///< why rs274 does not read it (without an INI file); empty where it does
  std::string difference;  ///< our refusal or the first motion that differs; empty where all are the same
};

[[nodiscard]] std::vector<SampleProgram> runSamplePrograms(const std::filesystem::path& folder,
                                                           const std::filesystem::path& scratch);

}  // namespace nineline::campaign
