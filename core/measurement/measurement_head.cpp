#include "core/measurement/measurement_head.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "core/base/text.h"
#include "core/base/units.h"

namespace nineline::measurement {

namespace {

constexpr std::array<std::string_view, 15> kKnownKeys = {"nineline-measurement",
                                                         "machine",
                                                         "instrument",
                                                         "repeatability_um",
                                                         "repeatability_arcsec",
                                                         "axis",
                                                         "point_mm",
                                                         "sensitive",
                                                         "about",
                                                         "centre_mm",
                                                         "radius_mm",
                                                         "plane",
                                                         "pitch_mm",
                                                         "starts",
                                                         "hand"};

/// Reads single values of the head and reports what is missing or wrong.
class Head {
 public:
  Head(const HeadLines& lines, Diagnostics& diagnostics) : lines_(lines), diagnostics_(diagnostics) {}

  const HeadEntry* find(const std::string& key) const {
    const auto found = lines_.entries.find(key);
    return found == lines_.entries.end() ? nullptr : &found->second;
  }

  const HeadEntry* require(const std::string& key, std::string_view expected) {
    const HeadEntry* entry = find(key);
    if (entry == nullptr) {
      diagnostics_.error("measurement.head", fmt::format("'#{}:' is missing, expected {}.", key, expected),
                         1);
    }
    return entry;
  }

  /// Null and a warning where the key is missing.
  const HeadEntry* findOrAssume(const std::string& key, std::string_view assumed) {
    const HeadEntry* entry = find(key);
    if (entry == nullptr) {
      diagnostics_.warning("measurement.assumed",
                           fmt::format("'#{}:' is missing, '{}' is assumed.", key, assumed), 1);
    }
    return entry;
  }

  void wrong(const std::string& key, const HeadEntry& entry, std::string_view expected) {
    diagnostics_.error("measurement.head",
                       fmt::format("'#{}' is '{}', expected {}.", key, printable(entry.value), expected),
                       entry.line, entry.column);
  }

  std::optional<double> positive(const std::string& key, const HeadEntry* entry, std::string_view expected) {
    if (entry == nullptr) return std::nullopt;
    const std::optional<double> value = parseNumber(entry->value);
    if (value && *value > 0.0) return value;
    wrong(key, *entry, expected);
    return std::nullopt;
  }

  void vector(const std::string& key, Eigen::Vector3d& target) {
    const HeadEntry* entry = require(key, "three numbers x y z in mm");
    if (entry == nullptr) return;
    std::string text = entry->value;
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == ',' || c == ';' || c == '\t'; }, ' ');
    std::vector<double> numbers;
    for (const std::string_view word : split(text, ' ')) {
      if (trimmed(word).empty()) continue;
      const std::optional<double> number = parseNumber(trimmed(word));
      if (!number) return wrong(key, *entry, "three numbers x y z in mm");
      numbers.push_back(*number);
    }
    if (numbers.size() != 3) return wrong(key, *entry, "three numbers x y z in mm");
    target = {numbers[0], numbers[1], numbers[2]};
  }

  void bedAxis(const std::string& key, int& target) {
    const HeadEntry* entry = require(key, "X, Y or Z");
    if (entry == nullptr) return;
    const std::string text = upper(entry->value);
    if (text != "X" && text != "Y" && text != "Z") return wrong(key, *entry, "X, Y or Z");
    target = text[0] - 'X';
  }

 private:
  const HeadLines& lines_;
  Diagnostics& diagnostics_;
};

std::string axesOf(const Machine& machine) {
  std::vector<std::string> names;
  for (const kinematics::Joint& joint : machine.joints()) names.push_back(joint.axis.text());
  return fmt::format("{}", fmt::join(names, ", "));
}

void fillAxis(Head& head, const Machine* machine, Instrument& instrument) {
  const HeadEntry* entry = head.require("axis", "the axis under test");
  if (entry == nullptr) return;
  const std::optional<AxisId> axis = parseAxisId(entry->value);
  if (!axis) return head.wrong("axis", *entry, "an axis letter such as X or C2");
  instrument.axis = axis;
  if (machine == nullptr) return;
  const int joint = machine->find(*axis);
  if (joint < 0) {
    return head.wrong("axis", *entry,
                      fmt::format("an axis of the machine '{}': {}", machine->id(), axesOf(*machine)));
  }
  if (instrument.kind == InstrumentKind::LaserLinear && machine->isRotary(joint)) {
    head.wrong("axis", *entry, "a linear axis");
  }
}

void fillBallbar(Head& head, Instrument& instrument) {
  head.vector("centre_mm", instrument.centre);
  const char* length = "a length above 0 in mm";
  instrument.radius = head.positive("radius_mm", head.require("radius_mm", length), length).value_or(0.0);
  const HeadEntry* plane = head.find("plane");
  if (plane == nullptr) return;
  instrument.plane = upper(plane->value);
  constexpr std::array<std::string_view, 6> kPlanes = {"XY", "YX", "YZ", "ZY", "ZX", "XZ"};
  if (std::find(kPlanes.begin(), kPlanes.end(), instrument.plane) == kPlanes.end()) {
    head.wrong("plane", *plane, "XY, YZ or ZX");
  }
}

void fillLead(Head& head, Instrument& instrument) {
  const char* length = "a length above 0 in mm";
  instrument.pitch = head.positive("pitch_mm", head.require("pitch_mm", length), length).value_or(0.0);
  if (const HeadEntry* starts = head.findOrAssume("starts", "1")) {
    const std::optional<long long> number = parseInteger(starts->value);
    if (!number || *number < 1 || *number > 1000) {
      head.wrong("starts", *starts, "a whole number from 1");
    } else {
      instrument.starts = static_cast<int>(*number);
    }
  }
  if (const HeadEntry* hand = head.findOrAssume("hand", "right")) {
    if (hand->value != "left" && hand->value != "right") head.wrong("hand", *hand, "left or right");
    instrument.left_hand = hand->value == "left";
  }
}

void fillInstrument(Head& head, const Machine* machine, Instrument& instrument) {
  const std::string names = fmt::format("one of {}", fmt::join(instrumentNames(), ", "));
  const HeadEntry* entry = head.require("instrument", names);
  if (entry == nullptr) return;
  const std::optional<InstrumentKind> kind = parseInstrumentKind(entry->value);
  if (!kind) return head.wrong("instrument", *entry, names);
  instrument.kind = *kind;
  if (instrument.needsAxis()) fillAxis(head, machine, instrument);
  switch (*kind) {
    case InstrumentKind::LaserLinear:
      return head.vector("point_mm", instrument.point);
    case InstrumentKind::LaserStraightness:
    case InstrumentKind::Dial:
      head.vector("point_mm", instrument.point);
      return head.bedAxis("sensitive", instrument.sensitive);
    case InstrumentKind::LaserAngular:
      return head.bedAxis("about", instrument.about);
    case InstrumentKind::Ballbar:
      return fillBallbar(head, instrument);
    case InstrumentKind::Lead:
      return fillLead(head, instrument);
    case InstrumentKind::Deviation:
    case InstrumentKind::Joint:
      return;
  }
}

}  // namespace

HeadLines readHeadLines(const std::vector<TextLine>& lines, Diagnostics& diagnostics) {
  HeadLines head;
  for (; head.used < lines.size(); ++head.used) {
    const TextLine& line = lines[head.used];
    std::string_view text = trimmed(line.text);
    if (isEmptyLine(text)) continue;
    if (text.front() == '"') text.remove_prefix(1);  // a spreadsheet quotes it and pads it with separators
    if (text.empty() || text.front() != '#') break;
    text = text.substr(1, text.find_last_not_of(" \t;,\""));
    const std::size_t colon = text.find(':');
    if (colon == std::string_view::npos) continue;  // a comment
    const std::string_view value = trimmed(text.substr(colon + 1));
    const std::size_t column =
        value.empty() ? 1 : static_cast<std::size_t>(value.data() - line.text.data()) + 1;
    const std::string key(trimmed(text.substr(0, colon)));
    const bool is_new =
        head.entries.try_emplace(key, HeadEntry{std::string(value), line.number, column}).second;
    if (!is_new) {
      diagnostics.error("measurement.head", fmt::format("'#{}' stands twice in the head.", printable(key)),
                        line.number, 1);
    }
  }
  return head;
}

void fillHead(const HeadLines& lines, const Machine* machine, Measurement& measurement,
              Diagnostics& diagnostics) {
  Head head(lines, diagnostics);
  const HeadEntry* version = head.require("nineline-measurement", "1 in the first line of the file");
  if (version != nullptr && version->value != "1") head.wrong("nineline-measurement", *version, "1");
  if (const HeadEntry* id = head.find("machine")) measurement.machine_id = id->value;
  fillInstrument(head, machine, measurement.instrument);
  const char* above = "a number above 0";
  if (const auto um = head.positive("repeatability_um", head.find("repeatability_um"), above)) {
    measurement.repeatability = mmFromUm(*um);
  }
  if (const auto arcsec = head.positive("repeatability_arcsec", head.find("repeatability_arcsec"), above)) {
    measurement.angular_repeatability = radFromArcsec(*arcsec);
  }
  for (const auto& [key, entry] : lines.entries) {
    if (std::find(kKnownKeys.begin(), kKnownKeys.end(), key) == kKnownKeys.end()) {
      measurement.other_head.emplace_back(key, entry.value);
    }
  }
}

}  // namespace nineline::measurement
