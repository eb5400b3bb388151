#include "ui/models/document.h"

#include "core/errors/error_model_file.h"

namespace nineline::models {

namespace {

constexpr const char* kFormat = "nineline-document/1";

bool isSameText(const std::shared_ptr<const std::string>& one,
                const std::shared_ptr<const std::string>& other) {
  if (one == other) return true;
  return one != nullptr && other != nullptr && *one == *other;
}

Json memberOr(const Json& json, const char* key, Json otherwise) {
  const Json* found = json.find(key);
  return found != nullptr ? *found : otherwise;
}

Json readingsToJson(const std::vector<ReadingsFile>& readings) {
  Json files = Json::array();
  for (const ReadingsFile& file : readings) {
    Json entry = Json::object();
    entry.set("name", file.name);
    entry.set("text", *file.text);
    files.push(std::move(entry));
  }
  return files;
}

void readReadings(const Json& json, JsonReader& reader, Document& document) {
  const Json* files = json.find("readings");
  if (files == nullptr || files->items() == nullptr) return;
  for (const Json& entry : *files->items()) {
    const Json* name = entry.find("name");
    const Json* text = entry.find("text");
    if (name == nullptr || name->string() == nullptr || text == nullptr || text->string() == nullptr) {
      return reader.fail("readings", "document.parts", "A file of readings lacks its name or its text.");
    }
    document.readings.push_back({*name->string(), std::make_shared<const std::string>(*text->string())});
  }
}

}  // namespace

bool isSame(const Json& one, const Json& other) { return writeJson(one, -1) == writeJson(other, -1); }

bool isSame(const std::vector<ReadingsFile>& one, const std::vector<ReadingsFile>& other) {
  return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                    [](const ReadingsFile& left, const ReadingsFile& right) {
                      return left.name == right.name && isSameText(left.text, right.text);
                    });
}

Changes differences(const Document& one, const Document& other) {
  Changes changes;
  changes.machine = one.machine_text != other.machine_text;
  changes.effects = !isSame(one.effects, other.effects);
  changes.readings = !isSame(one.readings, other.readings);
  changes.program = one.program_name != other.program_name || !isSameText(one.program, other.program);
  changes.thread = !isSame(one.thread, other.thread);
  changes.setup = !isSame(one.setup, other.setup);
  changes.options = !isSame(one.options, other.options);
  return changes;
}

Json documentToJson(const Document& document) {
  Json json = Json::object();
  json.set("format", kFormat);
  json.set("machine", document.machine_text);
  json.set("effects", document.effects);
  json.set("readings", readingsToJson(document.readings));
  json.set("program_name", document.program_name);
  json.set("program", document.program ? Json(*document.program) : Json());
  json.set("thread", document.thread);
  json.set("setup", document.setup);
  json.set("options", document.options);
  return json;
}

Result<Document> documentFromJson(const Json& json) {
  JsonReader reader(json, "project", "document");
  const std::string format = reader.string("format");
  if (!reader.failed() && format != kFormat) {
    reader.fail("format", "document.format", "The document was written by a newer version.");
  }
  Document document;
  document.machine_text = reader.string("machine");
  if (reader.failed()) return reader.error();
  document.effects = memberOr(json, "effects", Json::array());
  readReadings(json, reader, document);
  document.program_name = reader.stringOr("program_name", "");
  if (const Json* text = json.find("program"); text != nullptr && text->string() != nullptr) {
    document.program = std::make_shared<const std::string>(*text->string());
  }
  document.thread = memberOr(json, "thread", Json::object());
  document.setup = memberOr(json, "setup", Json::object());
  document.options = memberOr(json, "options", Json::object());
  if (document.effects.items() == nullptr || document.setup.members() == nullptr ||
      document.options.members() == nullptr) {
    reader.fail("effects", "document.parts", "A part of the document is not what it should be.");
  }
  if (reader.failed()) return reader.error();
  return document;
}

Result<errors::ErrorModel> modelOf(const Document& document) {
  const Result<Json> machine = parseJson(document.machine_text, "machine");
  if (!machine) return machine.error();
  Json json = Json::object();
  json.set("format", "nineline-model/1");
  json.set("machine", *machine);
  json.set("effects", document.effects);
  return errors::errorModelFromJson(json, "");
}

}  // namespace nineline::models
