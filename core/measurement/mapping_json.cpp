#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/measurement/column_mapping.h"

namespace nineline::measurement {

namespace {

constexpr std::array<std::pair<Meaning, std::string_view>, 7> kMeanings = {
    {{Meaning::Unknown, "unknown"},
     {Meaning::Ignored, "ignored"},
     {Meaning::Position, "position"},
     {Meaning::Reading, "reading"},
     {Meaning::Actual, "actual"},
     {Meaning::Sigma, "sigma"},
     {Meaning::Covariate, "covariate"}}};

std::string_view nameOf(Meaning meaning) {
  for (const auto& [one, name] : kMeanings) {
    if (one == meaning) return name;
  }
  return "";
}

Json vectorJson(const Eigen::Vector3d& p) { return Json(Json::Array{Json(p.x()), Json(p.y()), Json(p.z())}); }

Json instrumentJson(const Instrument& instrument) {
  Json json = Json::object();
  json.set("kind", measurement::nameOf(instrument.kind));
  if (instrument.axis) json.set("axis", instrument.axis->text());
  json.set("point_mm", vectorJson(instrument.point)).set("centre_mm", vectorJson(instrument.centre));
  json.set("sensitive", instrument.sensitive).set("about", instrument.about);
  json.set("radius_mm", instrument.radius).set("plane", instrument.plane);
  json.set("pitch_mm", instrument.pitch)
      .set("starts", instrument.starts)
      .set("left_hand", instrument.left_hand);
  return json;
}

Eigen::Vector3d vectorOf(JsonReader& reader, std::string_view key) {
  const std::vector<double> numbers = reader.numbers(key, 3);
  return reader.failed() ? Eigen::Vector3d::Zero() : Eigen::Vector3d(numbers[0], numbers[1], numbers[2]);
}

int axisIndex(JsonReader& reader, std::string_view key) {
  const double index = reader.number(key);
  if (!reader.failed() && index != 0.0 && index != 1.0 && index != 2.0) {
    reader.fail(key, "mapping.axis", fmt::format("'{}' is {}, expected 0, 1 or 2.", key, index));
  }
  return reader.failed() ? 0 : static_cast<int>(index);
}

Result<Instrument> instrumentOf(const Json& json, const std::string& source) {
  JsonReader reader(json, source, "instrument");
  Instrument instrument;
  const std::string kind = reader.string("kind");
  if (const auto known = parseInstrumentKind(kind)) {
    instrument.kind = *known;
  } else {
    reader.fail("kind", "mapping.instrument", fmt::format("'{}' is no instrument.", kind));
  }
  if (reader.has("axis")) {
    instrument.axis = parseAxisId(reader.string("axis"));
    if (!instrument.axis) reader.fail("axis", "mapping.axis", "'axis' names no axis.");
  }
  instrument.point = vectorOf(reader, "point_mm");
  instrument.centre = vectorOf(reader, "centre_mm");
  instrument.sensitive = axisIndex(reader, "sensitive");
  instrument.about = axisIndex(reader, "about");
  instrument.radius = reader.number("radius_mm");
  instrument.plane = reader.stringOr("plane", "");
  instrument.pitch = reader.number("pitch_mm");
  instrument.starts = static_cast<int>(reader.numberOr("starts", 1.0));
  instrument.left_hand = reader.booleanOr("left_hand", false);
  if (reader.failed()) return reader.error();
  return instrument;
}

Result<MappedColumn> columnOf(const Json& json, const std::string& source) {
  JsonReader reader(json, source, "column");
  MappedColumn column;
  column.header = reader.string("header");
  const std::string meaning = reader.string("meaning");
  bool known = false;
  for (const auto& [one, name] : kMeanings) {
    if (name != meaning) continue;
    column.meaning = one;
    known = true;
  }
  if (!known)
    reader.fail("meaning", "mapping.meaning", fmt::format("'{}' is no meaning of a column.", meaning));
  if (reader.has("axis")) column.axis = parseAxisId(reader.string("axis"));
  const double quantity = reader.numberOr("quantity", static_cast<double>(Quantity::Length));
  if (quantity < 0.0 || quantity > static_cast<double>(Quantity::Radius)) {
    reader.fail("quantity", "mapping.quantity", "'quantity' is out of range.");
  } else {
    column.quantity = static_cast<Quantity>(static_cast<int>(quantity));
  }
  column.unit = reader.stringOr("unit", "");
  column.negative = reader.booleanOr("negative", false);
  column.name = reader.stringOr("name", "");
  if (reader.failed()) return reader.error();
  return column;
}

}  // namespace

Json mappingToJson(const ColumnMapping& mapping) {
  Json columns = Json::array();
  for (const MappedColumn& column : mapping.columns) {
    Json json = Json::object();
    json.set("header", column.header).set("meaning", nameOf(column.meaning));
    if (column.axis) json.set("axis", column.axis->text());
    json.set("quantity", static_cast<int>(column.quantity)).set("unit", column.unit);
    json.set("negative", column.negative).set("name", column.name);
    columns.push(std::move(json));
  }
  Json json = Json::object();
  json.set("separator", std::string(1, mapping.separator))
      .set("decimal_comma", mapping.decimal_comma)
      .set("header_line", mapping.header_line)
      .set("instrument", instrumentJson(mapping.instrument));
  if (mapping.repeatability) json.set("repeatability_mm", *mapping.repeatability);
  return json.set("columns", std::move(columns));
}

Result<ColumnMapping> mappingFromJson(const Json& json, const std::string& source) {
  JsonReader reader(json, source, "column mapping");
  ColumnMapping mapping;
  const std::string separator = reader.string("separator");
  mapping.separator = separator.size() == 1 ? separator[0] : ';';
  mapping.decimal_comma = reader.booleanOr("decimal_comma", false);
  mapping.header_line = static_cast<std::size_t>(std::max(0.0, reader.number("header_line")));
  if (reader.has("repeatability_mm")) mapping.repeatability = reader.number("repeatability_mm");
  const Json* instrument = json.find("instrument");
  if (instrument == nullptr) reader.fail("instrument", "json.missing", "'instrument' is missing.");
  const Json::Array& items = reader.items("columns");
  if (reader.failed()) return reader.error();
  Result<Instrument> read = instrumentOf(*instrument, source);
  if (!read) return read.error();
  mapping.instrument = *read;
  for (const Json& item : items) {
    Result<MappedColumn> column = columnOf(item, source);
    if (!column) return column.error();
    mapping.columns.push_back(std::move(*column));
  }
  return mapping;
}

}  // namespace nineline::measurement
