#pragma once

#include <Eigen/Core>
#include <map>
#include <string>
#include <vector>

namespace nineline::test_support {

/// One line of a table with a head of column names.
struct VectorRow {
  std::map<std::string, std::string> cells;
  [[nodiscard]] const std::string& text(const std::string& column) const { return cells.at(column); }
  [[nodiscard]] double number(const std::string& column) const;
  /// The columns `stem` + x, y, z + `end`.
  [[nodiscard]] Eigen::Vector3d vector(const std::string& stem, const std::string& end = "") const;
};

/// Folder of the shared acceptance vectors beside the repository; it may be absent.
[[nodiscard]] std::string vectorFolder();
[[nodiscard]] bool haveVectors();

/// All rows of one file there, empty when it cannot be read.
[[nodiscard]] std::vector<VectorRow> readVectors(const std::string& name);

}  // namespace nineline::test_support
