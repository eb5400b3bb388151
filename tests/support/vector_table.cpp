#include "tests/support/vector_table.h"

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "core/base/text.h"

namespace nineline::test_support {

double VectorRow::number(const std::string& column) const {
  const std::optional<double> value = parseNumber(cells.at(column));
  if (!value) throw std::runtime_error("no number in column " + column + ": " + cells.at(column));
  return *value;
}

Eigen::Vector3d VectorRow::vector(const std::string& stem, const std::string& end) const {
  return {number(stem + "x" + end), number(stem + "y" + end), number(stem + "z" + end)};
}

std::string vectorFolder() { return std::string(NINELINE_SOURCE_DIR) + "/../shared/vectors"; }

bool haveVectors() { return std::filesystem::exists(vectorFolder()); }

std::vector<VectorRow> readVectors(const std::string& name) {
  std::ifstream file(vectorFolder() + "/" + name);
  std::vector<VectorRow> rows;
  std::vector<std::string> columns;
  std::string line;
  while (std::getline(file, line)) {
    const std::vector<std::string_view> cells = split(trimmed(line), ',');
    if (columns.empty()) {
      columns.assign(cells.begin(), cells.end());
      continue;
    }
    VectorRow row;
    for (std::size_t i = 0; i < columns.size() && i < cells.size(); ++i)
      row.cells[columns[i]] = std::string(cells[i]);
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace nineline::test_support
