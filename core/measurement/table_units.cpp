#include "core/measurement/table_units.h"

#include <array>
#include <utility>

#include "core/base/text.h"
#include "core/base/units.h"
#include "core/measurement/column_mapping.h"

namespace nineline::measurement {

namespace {

const std::array<std::pair<std::string_view, double>, 6> kLengths = {{{"mm", 1.0},
                                                                      {"um", mmFromUm(1.0)},
                                                                      {"nm", mmFromUm(1e-3)},
                                                                      {"m", 1000.0},
                                                                      {"inch", mmFromInch(1.0)},
                                                                      {"mil", mmFromInch(1e-3)}}};
const std::array<std::pair<std::string_view, double>, 6> kAngles = {{{"deg", radFromDeg(1.0)},
                                                                     {"arcmin", radFromDeg(1.0 / 60.0)},
                                                                     {"arcsec", radFromArcsec(1.0)},
                                                                     {"rad", 1.0},
                                                                     {"mrad", 1e-3},
                                                                     {"urad", 1e-6}}};

/// Other spellings, as instruments and spreadsheets write them.
constexpr std::array<std::pair<std::string_view, std::string_view>, 18> kSpellings = {{{"µm", "um"},
                                                                                       {"μm", "um"},
                                                                                       {"micron", "um"},
                                                                                       {"microns", "um"},
                                                                                       {"in", "inch"},
                                                                                       {"inches", "inch"},
                                                                                       {"°", "deg"},
                                                                                       {"degree", "deg"},
                                                                                       {"degrees", "deg"},
                                                                                       {"\"", "arcsec"},
                                                                                       {"″", "arcsec"},
                                                                                       {"sec", "arcsec"},
                                                                                       {"'", "arcmin"},
                                                                                       {"µrad", "urad"},
                                                                                       {"μrad", "urad"},
                                                                                       {"毫米", "mm"},
                                                                                       {"微米", "um"},
                                                                                       {"角秒", "arcsec"}}};

template <std::size_t N>
std::vector<std::string> namesOf(const std::array<std::pair<std::string_view, double>, N>& units) {
  std::vector<std::string> names;
  for (const auto& [name, factor] : units) names.emplace_back(name);
  return names;
}

std::optional<std::string> unitOfWord(std::string_view word) {
  word = trimmed(word);
  for (const auto& [spelling, unit] : kSpellings) {
    if (word == spelling) return std::string(unit);
  }
  return factorOf(word) ? std::optional(std::string(word)) : std::nullopt;
}

}  // namespace

const std::vector<std::string>& lengthUnits() {
  static const std::vector<std::string> kNames = namesOf(kLengths);
  return kNames;
}

const std::vector<std::string>& angleUnits() {
  static const std::vector<std::string> kNames = namesOf(kAngles);
  return kNames;
}

std::optional<double> factorOf(std::string_view unit) {
  for (const auto& [name, factor] : kLengths) {
    if (name == unit) return factor;
  }
  for (const auto& [name, factor] : kAngles) {
    if (name == unit) return factor;
  }
  return std::nullopt;
}

std::optional<std::string> unitInHeader(std::string_view header) {
  header = trimmed(header);
  constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kBrackets = {
      {{"(", ")"}, {"[", "]"}, {"（", "）"}, {"{", "}"}}};
  for (const auto& [open, close] : kBrackets) {
    const std::size_t begin = header.rfind(open);
    if (begin == std::string_view::npos) continue;
    const std::size_t end = header.find(close, begin);
    if (end == std::string_view::npos) continue;
    return unitOfWord(header.substr(begin + open.size(), end - begin - open.size()));
  }
  const std::size_t last = header.find_last_of("_ /");
  return last == std::string_view::npos ? std::nullopt : unitOfWord(header.substr(last + 1));
}

}  // namespace nineline::measurement
