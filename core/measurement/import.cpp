#include "core/measurement/import.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/base/text.h"
#include "core/measurement/delimited_text.h"

namespace nineline::measurement {

namespace {

bool isIsgHeader(std::string_view line) {
  bool has_axis = false;
  bool has_error = false;
  std::string text(line);
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == ',' || c == ';' || c == '\t'; }, ' ');
  for (const std::string_view raw : split(text, ' ')) {
    const std::string_view word = trimmed(raw);
    if (word.empty()) continue;
    const bool axis = parseAxisId(word).has_value();
    const bool error = word.size() >= 3 && errors::parseComponent(word).has_value();
    if (!axis && !error) return false;
    has_axis = has_axis || axis;
    has_error = has_error || error;
  }
  return has_axis && has_error;
}

}  // namespace

std::string formatOf(std::string_view bytes) {
  const std::string_view start = bytes.substr(0, 4096);
  if (start.find("HEADER::") != std::string_view::npos) {
    const bool is_dynamic = start.find("Actual sample rate") != std::string_view::npos ||
                            start.find("\nData:") != std::string_view::npos;
    return is_dynamic ? "renishaw-rtx" : "renishaw-rtl";
  }
  const Result<DecodedText> decoded = decodeText(bytes, "");
  if (!decoded) return "";
  const std::string_view text = trimmed(decoded->text);
  if (text.starts_with("#nineline-measurement") || text.starts_with("\"#nineline-measurement"))
    return "nineline";
  if (text.starts_with("<") && text.find("TEST_SPEC") != std::string_view::npos) return "renishaw-b5r";
  if (text.find("Gridpoints") != std::string_view::npos || text.find("VALUE") != std::string_view::npos) {
    if (text.find('[') != std::string_view::npos) return "etalon";
  }
  const std::vector<TextLine> lines = linesOf(text);
  if (lines.empty()) return "";
  return isIsgHeader(lines.front().text) ? "isg-csv" : "table";
}

Import importFile(std::string_view bytes, const std::string& source, const Machine& machine,
                  const Answers& answers) {
  const std::string format = formatOf(bytes);
  if (format == "renishaw-rtl") return importRtl(bytes, source, machine, answers);
  if (format == "renishaw-rtx") return importRtx(bytes, answers);
  if (format == "renishaw-b5r") return importB5r(bytes, source);
  if (format == "etalon") return importEtalon(bytes, source, machine, answers);
  if (format == "isg-csv") return importIsg(bytes, source, machine, answers);
  Import import;
  import.format = format;
  import.diagnostics.error(
      "import.format",
      format == "nineline"
          ? "This is a measurement in Nineline's own format; open it as such."
          : "The file is none of .rtl, .rtx, .b5r, Etalon exchange and ISG CSV; name its columns "
            "to read it as a table.");
  return import;
}

std::optional<std::string> answerTo(Question question, const Answers& answers, Import& import) {
  const auto given = answers.find(question.id);
  if (given != answers.end()) {
    const bool fits =
        question.choices.empty() || std::any_of(question.choices.begin(), question.choices.end(),
                                                [&](const Choice& one) { return one.id == given->second; });
    if (fits) return given->second;
    std::vector<std::string> ids;
    for (const Choice& one : question.choices) ids.push_back(one.id);
    import.diagnostics.error("import.answer",
                             fmt::format("'{}' is no answer to '{}', expected one of {}.",
                                         printable(given->second), question.id, fmt::join(ids, ", ")));
  }
  import.questions.push_back(std::move(question));
  return std::nullopt;
}

}  // namespace nineline::measurement
