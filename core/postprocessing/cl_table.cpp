#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/text.h"
#include "core/base/units.h"
#include "core/postprocessing/cl_apt.h"

namespace nineline::postprocessing {

namespace {

enum Column { kX, kY, kZ, kI, kJ, kK, kFeed, kRapid, kColumns };
constexpr std::array<std::array<std::string_view, 3>, kColumns> kNames = {{{"X_MM", "X", "TIP_X_MM"},
                                                                           {"Y_MM", "Y", "TIP_Y_MM"},
                                                                           {"Z_MM", "Z", "TIP_Z_MM"},
                                                                           {"I_1", "I", "AXIS_X_1"},
                                                                           {"J_1", "J", "AXIS_Y_1"},
                                                                           {"K_1", "K", "AXIS_Z_1"},
                                                                           {"FEED_MM_MIN", "F", "FEED"},
                                                                           {"RAPID_1", "RAPID", "R"}}};

/// The line up to `\n`, taken off the text, without `\r`.
std::string_view takeLine(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

char separatorOf(std::string_view head) {
  for (const char c : {';', '\t', ','}) {
    if (head.find(c) != std::string_view::npos) return c;
  }
  return ',';
}

/// Place of each column in the head, −1 where it is absent.
std::array<int, kColumns> findColumns(std::string_view head) {
  std::array<int, kColumns> places;
  places.fill(-1);
  int place = 0;
  for (const std::string_view cell : split(head, separatorOf(head))) {
    const std::string name = upper(trimmed(cell));
    for (std::size_t c = 0; c < kColumns; ++c) {
      if (places[c] < 0 && std::ranges::find(kNames[c], name) != kNames[c].end()) places[c] = place;
    }
    ++place;
  }
  return places;
}

struct Table {
  std::array<int, kColumns> places{};
  char separator = ',';
  std::size_t line = 0;
  Diagnostics* faults = nullptr;

  /// The values of a row, absent where the column or the cell is; false after a fault.
  bool values(std::string_view row, std::array<std::optional<double>, kColumns>& out) const {
    const std::vector<std::string_view> cells = split(row, separator);
    bool good = true;
    for (std::size_t c = 0; c < kColumns; ++c) {
      out[c].reset();
      if (places[c] < 0 || places[c] >= static_cast<int>(cells.size())) continue;
      const std::string_view cell = cells[static_cast<std::size_t>(places[c])];
      const std::string_view text = trimmed(cell);
      if (text.empty()) continue;
      out[c] = parseNumber(text);
      if (out[c]) continue;
      good = false;
      faults->error("post.cl-number",
                    fmt::format("The column {} needs a number, found '{}'.", kNames[c][0], printable(text)),
                    line, static_cast<std::size_t>(text.data() - row.data()) + 1);
    }
    return good;
  }
};

bool addRow(const std::array<std::optional<double>, kColumns>& v, std::size_t line, ClProgram& program,
            Diagnostics& faults) {
  const auto fail = [&](const char* text) {
    faults.error("post.cl-row", text, line, 1);
    return false;
  };
  if (!v[kX] || !v[kY] || !v[kZ]) return fail("The row lacks a coordinate of the tip, expected x, y and z.");
  ClPoint point;
  if (!program.points.empty()) point = program.points.back();
  point.line = line;
  point.tip = {*v[kX], *v[kY], *v[kZ]};
  point.rapid = v[kRapid].value_or(0.0) != 0.0;
  if (v[kI] || v[kJ] || v[kK]) {
    if (!v[kI] || !v[kJ] || !v[kK])
      return fail("The row lacks a component of the tool axis, expected i, j and k.");
    const Vector3d axis(*v[kI], *v[kJ], *v[kK]);
    if (!(std::abs(axis.norm() - 1.0) <= 1e-3)) return fail("The tool axis i, j, k is no unit vector.");
    point.axis = axis.normalized();
  }
  if (v[kFeed] && !(*v[kFeed] > 0.0)) return fail("The feed must be above 0.");
  if (v[kFeed]) point.feed = perSecondFromPerMinute(*v[kFeed]);
  program.points.push_back(point);
  ++program.goto_count;
  return true;
}

}  // namespace

bool isClTable(std::string_view text) {
  while (!text.empty()) {
    const std::string_view line = takeLine(text);
    if (trimmed(line).empty() || line.starts_with('#')) continue;
    const std::array<int, kColumns> places = findColumns(line);
    return places[kX] >= 0 && places[kY] >= 0 && places[kZ] >= 0;
  }
  return false;
}

void readClTable(std::string_view text, ClProgram& program, Diagnostics& faults) {
  Table table;
  table.faults = &faults;
  bool has_head = false;
  while (!text.empty() && !faults.full()) {
    const std::string_view line = takeLine(text);
    ++table.line;
    if (trimmed(line).empty() || line.starts_with('#')) continue;
    if (!has_head) {
      table.places = findColumns(line);
      table.separator = separatorOf(line);
      has_head = true;
      continue;
    }
    std::array<std::optional<double>, kColumns> values;
    if (table.values(line, values)) addRow(values, table.line, program, faults);
  }
}

}  // namespace nineline::postprocessing
