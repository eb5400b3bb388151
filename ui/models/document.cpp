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

}  // namespace

bool isSame(const Json& one, const Json& other) { return writeJson(one, -1) == writeJson(other, -1); }

Changes differences(const Document& one, const Document& other) {
  Changes changes;
  changes.machine = one.machine_text != other.machine_text;
  changes.effects = !isSame(one.effects, other.effects);
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
