#include "core/measurement/rtl_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/base/text.h"
#include "core/measurement/delimited_text.h"

namespace nineline::measurement {

std::vector<std::string_view> wordsOf(std::string_view line) {
  std::vector<std::string_view> words;
  std::size_t begin = 0;
  while ((begin = line.find_first_not_of(" \t,;", begin)) != std::string_view::npos) {
    const std::size_t end = std::min(line.find_first_of(" \t,;", begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    begin = end;
  }
  return words;
}

namespace {

class RtlReader {
 public:
  explicit RtlReader(Import& import) : import_(import) {}

  RtlText read(std::string_view text) {
    for (const TextLine& line : linesOf(text)) {
      if (import_.diagnostics.full()) break;
      readLine(line);
    }
    return std::move(out_);
  }

 private:
  enum class Block { None, Targets, Rows };

  void readLine(const TextLine& line) {
    const std::string_view text = trimmed(line.text);
    if (text.empty()) return;
    if (text.ends_with("::")) {
      block_ = Block::None;
      section_ = std::string(text.substr(0, text.size() - 2));
      return;
    }
    const std::size_t colon = text.find(':');
    if (colon != std::string_view::npos)
      return readKey(trimmed(text.substr(0, colon)), trimmed(text.substr(colon + 1)), line);
    if (block_ == Block::Targets) readTargets(text, line.number);
    if (block_ == Block::Rows) readRow(text, line.number);
  }

  void readKey(std::string_view key, std::string_view value, const TextLine& line) {
    block_ = Block::None;
    const std::string name = upper(key);
    if (name == "TARGETS") {
      block_ = Block::Targets;
      if (!value.empty()) readTargets(value, line.number);
    } else if (name == "RUN TARGET DATA") {
      block_ = Block::Rows;
      out_.rows_line = line.number;
      if (!value.empty()) readRow(value, line.number);
    } else if (name == "TARGET-COUNT") {
      out_.target_count = countOf(key, value, line.number);
    } else if (name == "RUN-COUNT") {
      out_.run_count = countOf(key, value, line.number);
    } else {
      if (name == "AXIS") out_.axis = std::string(value);
      if (name == "FILETYPE" || name == "FILE TYPE") out_.kind_text += upper(value) + " ";
      import_.head.emplace_back(std::string(key), std::string(value));
    }
  }

  std::optional<long long> countOf(std::string_view key, std::string_view value, std::size_t line) {
    const std::optional<long long> count = parseInteger(value);
    if (count && *count > 0 && *count < 100000) return count;
    import_.diagnostics.error(
        "rtl.count", fmt::format("'{}' is '{}', expected a whole number from 1.", key, printable(value)),
        line);
    return std::nullopt;
  }

  std::optional<double> numberOf(std::string_view word, std::string_view what, std::size_t line) {
    const std::optional<double> value = parseNumber(word);
    if (!value) {
      const bool comma = word.find(',') != std::string_view::npos;
      import_.diagnostics.error("rtl.number",
                                fmt::format("{} is '{}', expected a number{}.", what, printable(word),
                                            comma ? " with a decimal point" : ""),
                                line);
    }
    return value;
  }

  void readTargets(std::string_view text, std::size_t line) {
    for (const std::string_view word : wordsOf(text)) {
      if (const std::optional<double> value = numberOf(word, "A target", line))
        out_.targets.push_back(*value);
    }
  }

  void readRow(std::string_view text, std::size_t line) {
    const std::vector<std::string_view> words = wordsOf(text);
    if (words.size() != 3) {
      import_.diagnostics.error(
          "rtl.row",
          fmt::format("The row '{}' has {} numbers, expected run, target, deviation{}.", printable(text),
                      words.size(), words.size() == 4 ? "; is the decimal sign a comma?" : ""),
          line);
      return;
    }
    const std::optional<long long> run = parseInteger(words[0]);
    const std::optional<long long> target = parseInteger(words[1]);
    const std::optional<double> deviation = numberOf(words[2], "A deviation", line);
    if (!run || !target) {
      import_.diagnostics.error("rtl.row",
                                fmt::format("'{} {}' are no run and target, expected whole numbers from 1.",
                                            printable(words[0]), printable(words[1])),
                                line);
    } else if (deviation) {
      out_.rows.push_back({*run, *target, *deviation, line});
    }
  }

  Import& import_;
  RtlText out_;
  Block block_ = Block::None;
  std::string section_;
};

/// What is inconsistent in the text: counts, indices, doubles; half runs are said, not refused.
void check(const RtlText& text, Import& import) {
  Diagnostics& faults = import.diagnostics;
  if (text.targets.empty()) faults.error("rtl.targets", "The file has no 'Targets :' with positions.");
  if (text.rows.empty())
    faults.error("rtl.rows", "The file has no 'Run Target Data:' with readings.", text.rows_line);
  const auto targets = static_cast<long long>(text.targets.size());
  if (text.target_count && *text.target_count != targets) {
    faults.error("rtl.count", fmt::format("The file holds {} targets, 'Target-count' says {}.", targets,
                                          *text.target_count));
  }
  std::map<long long, std::set<long long>> seen;
  for (const DeviationRow& row : text.rows) {
    if (row.target < 1 || row.target > targets || row.run < 1) {
      faults.error("rtl.row",
                   fmt::format("Run {} target {} is not among {} targets.", row.run, row.target, targets),
                   row.line);
    } else if (!seen[row.run].insert(row.target).second) {
      faults.error("rtl.row", fmt::format("Target {} of run {} stands twice.", row.target, row.run),
                   row.line);
    }
  }
  for (const auto& [run, found] : seen) {
    if (static_cast<long long>(found.size()) < targets) {
      faults.warning("rtl.half_run",
                     fmt::format("Run {} holds {} of {} targets; the missing ones stay empty.", run,
                                 found.size(), targets));
    }
  }
  if (text.run_count && static_cast<long long>(seen.size()) != *text.run_count) {
    faults.warning("rtl.half_run",
                   fmt::format("The file holds {} runs, 'Run-count' says {}.", seen.size(), *text.run_count));
  }
}

}  // namespace

RtlText readRtlText(std::string_view text, Import& import) {
  RtlText rtl = RtlReader(import).read(text);
  check(rtl, import);
  return rtl;
}

}  // namespace nineline::measurement
