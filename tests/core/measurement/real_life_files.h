#pragma once

#include <string>
#include <vector>

namespace nineline::measurement {

/// One file as the shop floor hands it in, and what has to be said of it.
struct RealFile {
  std::string name;  ///< how it was spoilt
  std::string text;
  bool is_read = true;
  std::string said;          ///< part of a message; empty: read without a word, every reading right
  std::size_t line = 0;      ///< where, for refusals
  std::size_t samples = 52;  ///< found in the file, where it is read
};

/// A campaign of a laser on Z of the grinder, four runs of 13 targets there and back, without a fault.
[[nodiscard]] std::string soundFile();

/// The same with the faults of real life, one in each file.
[[nodiscard]] std::vector<RealFile> realFiles();

}  // namespace nineline::measurement
