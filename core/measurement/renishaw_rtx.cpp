#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>

#include "core/base/text.h"
#include "core/base/units.h"
#include "core/measurement/import.h"

namespace nineline::measurement {

namespace {

constexpr std::size_t kNumberSize = 8;

/// A float64 whose least significant byte comes first, as a PC writes it.
double littleEndian(std::string_view bytes) {
  std::uint64_t bits = 0;
  for (std::size_t k = 0; k < kNumberSize; ++k) {
    bits |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes[k])) << (8 * k);
  }
  return std::bit_cast<double>(bits);
}

/// The head lines up to "Data:"; gives where the numbers begin, 0 when they do not.
std::size_t readHead(std::string_view bytes, Import& import) {
  std::size_t begin = 0;
  while (begin < bytes.size()) {
    const std::size_t end = bytes.find('\n', begin);
    if (end == std::string_view::npos) return 0;
    const std::string_view line = trimmed(bytes.substr(begin, end - begin));
    begin = end + 1;
    if (line == "Data:") return begin;
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos || line.ends_with("::")) continue;
    import.head.emplace_back(std::string(trimmed(line.substr(0, colon))),
                             std::string(trimmed(line.substr(colon + 1))));
  }
  return 0;
}

std::optional<std::string> headValue(const Import& import, std::string_view key) {
  for (const auto& [name, value] : import.head) {
    if (upper(name) == upper(key)) return value;
  }
  return std::nullopt;
}

/// A head value that must be a positive number; it may be followed by its unit.
std::optional<double> positive(Import& import, std::string_view key) {
  const std::optional<std::string> text = headValue(import, key);
  std::optional<double> value;
  if (text) value = parseNumber(trimmed(std::string_view(*text).substr(0, text->find(' '))));
  if (value && *value > 0.0) return value;
  import.diagnostics.error("rtx.head", fmt::format("'{}' is {}, expected a number above 0.", key,
                                                   text ? "'" + printable(*text) + "'" : "missing"));
  return std::nullopt;
}

}  // namespace

Import importRtx(std::string_view bytes, const Answers& answers) {
  Import import;
  import.format = "renishaw-rtx";
  const std::size_t begin = readHead(bytes, import);
  if (begin == 0) {
    import.diagnostics.error("rtx.data", "The line 'Data:' is missing; the file ends in its head.");
    return import;
  }
  const std::optional<double> rate = positive(import, "Actual sample rate");
  const std::optional<double> stated = positive(import, "Sample no");
  if (!rate || !stated) return import;
  const auto count = static_cast<std::size_t>(*stated);
  const std::size_t there = (bytes.size() - begin) / kNumberSize;
  if (there < count) {
    import.diagnostics.error("rtx.data",
                             fmt::format("The file holds {} samples, 'Sample no' says {}: it is cut off; "
                                         "copy it again from the instrument's computer.",
                                         there, count));
    return import;
  }
  const std::optional<std::string> unit =
      answerTo({"rtx-unit",
                "In which unit are the recorded samples? The file does not say it.",
                {{"mm", "mm"}, {"um", "µm"}},
                "",
                std::nullopt},
               answers, import);
  Recording recording{1.0 / *rate, {}, headValue(import, "Axis").value_or("")};
  recording.values.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double value = littleEndian(bytes.substr(begin + i * kNumberSize, kNumberSize));
    if (!std::isfinite(value)) {
      import.diagnostics.error("rtx.data", fmt::format("Sample {} is no finite number.", i + 1));
      return import;
    }
    recording.values.push_back(unit == "um" ? mmFromUm(value) : value);
  }
  if (bytes.substr(begin + count * kNumberSize).find("EOF::") == std::string_view::npos) {
    import.diagnostics.warning("rtx.end", "The closing 'EOF::' is missing; the file may be damaged.");
  }
  if (unit) import.recording = std::move(recording);
  return import;
}

}  // namespace nineline::measurement
