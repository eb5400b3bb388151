#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace nineline::campaign {

/// LinuxCNC's interpreter, `rs274 -g`, in a folder of its own.
class SecondOpinion {
 public:
  /// `folder` is made; programs and the tool table are written there.
  explicit SecondOpinion(std::filesystem::path folder);
  [[nodiscard]] static bool isInstalled();

  /// The canonical calls of a program; O numbers, which LinuxCNC reads as subprograms, are left out.
  /// `tool_length`: of tool 1, mm.
  [[nodiscard]] std::string read(const std::string& program, double tool_length) const;

 private:
  std::filesystem::path folder_;
};

/// Whether a program was read to its end.
[[nodiscard]] bool isComplete(const std::string& calls);
/// The last line that says why it was not.
[[nodiscard]] std::string reasonOf(const std::string& calls);

/// Empty where two programs ask for the same besides their motions (feeds, spindle, tools, planes, units,
/// comments, dwells, coolant, end), in the same order and at nearly the same places; otherwise the first
/// difference. Values of G92 follow the corrected position and may differ by as much.
[[nodiscard]] std::string changedMeaning(const std::string& original_calls,
                                         const std::string& corrected_calls);

}  // namespace nineline::campaign
