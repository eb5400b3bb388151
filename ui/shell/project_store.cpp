#include "ui/shell/project_store.h"

#include <algorithm>
#include <filesystem>

#include "core/compensation/compensation.h"
#include "core/errors/error_model_file.h"

namespace nineline::shell {

namespace {

using project::DocumentKind;

constexpr const char* kWizard = "wizard";
constexpr const char* kCompensate = "compensate";

/// The wizard's part of a document: what has no place of its own in a project.
Json wizardJson(const models::Document& document) {
  Json json = Json::object();
  json.set("effects", document.effects);
  json.set("program_name", document.program_name);
  json.set("thread", document.thread);
  json.set("setup", document.setup);
  json.set("options", document.options);
  return json;
}

Result<void> readReadings(const project::ProjectFile& file, models::Document& document) {
  const Result<std::vector<std::string>> names = file.names(DocumentKind::Measurement);
  if (!names) return names.error();
  for (const std::string& name : *names) {
    const Result<std::optional<std::string>> text = file.find(DocumentKind::Measurement, name);
    if (!text) return text.error();
    if (text->has_value()) document.readings.push_back({name, std::make_shared<const std::string>(**text)});
  }
  return {};
}

void putReadings(const models::Document& saved, const models::Document& document, project::Change& change) {
  for (const models::ReadingsFile& file : document.readings) {
    change.put(DocumentKind::Measurement, file.name, *file.text);
  }
  for (const models::ReadingsFile& file : saved.readings) {
    const bool gone = std::none_of(document.readings.begin(), document.readings.end(),
                                   [&](const models::ReadingsFile& now) { return now.name == file.name; });
    if (gone) change.remove(DocumentKind::Measurement, file.name);
  }
}

Result<models::Document> documentOf(const project::ProjectFile& file) {
  const Result<std::optional<std::string>> wizard = file.find(DocumentKind::Setting, kWizard);
  if (!wizard) return wizard.error();
  const Result<std::optional<std::string>> machine = file.machine();
  if (!machine) return machine.error();
  Json json = Json::object();
  if (wizard->has_value()) {
    Result<Json> read = parseJson(**wizard, "project");
    if (!read) return read.error();
    json = std::move(*read);
  }
  json.set("format", "nineline-document/1");
  json.set("machine", machine->value_or(""));
  Result<models::Document> document = models::documentFromJson(json);
  if (!document) return document;
  if (Result<void> readings = readReadings(file, *document); !readings) return readings.error();
  const Result<std::optional<std::string>> program = file.find(DocumentKind::Program, document->program_name);
  if (!program) return program.error();
  if (program->has_value()) document->program = std::make_shared<const std::string>(**program);
  return document;
}

}  // namespace

QString ProjectStore::path() const {
  return file_ == nullptr ? QString() : QString::fromStdString(file_->path().string());
}

Result<models::Document> ProjectStore::open(const QString& path) {
  Result<project::ProjectFile> file = project::ProjectFile::open(path.toStdString());
  if (!file) return file.error();
  Result<models::Document> document = documentOf(*file);
  if (!document) return document;
  file_ = std::make_unique<project::ProjectFile>(std::move(*file));
  saved_ = *document;
  saved_outcome_.reset();
  return document;
}

Result<void> ProjectStore::write(project::ProjectFile& file, const models::Document& document,
                                 const jobs::OutcomePtr& outcome) {
  project::Change change;
  change.setMachine(document.machine_text);
  change.put(DocumentKind::Setting, kWizard, writeJson(wizardJson(document)));
  putReadings(saved_, document, change);
  if (document.program != nullptr) {
    change.put(DocumentKind::Program, document.program_name, *document.program);
  }
  const Result<errors::ErrorModel> model = models::modelOf(document);
  const bool new_model = !file.currentModel() || !models::isSame(saved_.effects, document.effects) ||
                         saved_.machine_text != document.machine_text;
  if (model && new_model && !model->effects().empty()) {
    change.addModel(writeJson(errors::errorModelToJson(*model)), "measured");
  }
  if (outcome != nullptr && outcome != saved_outcome_ && model) {
    change.addResult(kCompensate, writeJson(compensation::reportToJson(outcome->report, model->machine())),
                     *outcome->text);
  }
  const Result<project::Saved> saved = file.save(change);
  if (!saved) return saved.error();
  saved_ = document;
  saved_outcome_ = outcome;
  return {};
}

Result<void> ProjectStore::save(const models::Document& document, const jobs::OutcomePtr& outcome) {
  NL_EXPECTS(file_ != nullptr);
  return write(*file_, document, outcome);
}

Result<void> ProjectStore::saveAs(const QString& path, const models::Document& document,
                                  const jobs::OutcomePtr& outcome) {
  const std::filesystem::path target = path.toStdString();
  std::filesystem::path beside = target;
  beside += ".new";
  std::error_code ignored;
  std::filesystem::remove(beside, ignored);
  Result<project::ProjectFile> file = project::ProjectFile::create(beside);
  if (!file) return file.error();
  saved_ = {};
  saved_outcome_.reset();
  if (Result<void> written = write(*file, document, outcome); !written) return written;
  if (Result<void> copied = file->saveCopy(target); !copied) return copied;
  { const project::ProjectFile done = std::move(*file); }
  std::filesystem::remove(beside, ignored);
  Result<project::ProjectFile> opened = project::ProjectFile::open(target);
  if (!opened) return opened.error();
  file_ = std::make_unique<project::ProjectFile>(std::move(*opened));
  return {};
}

}  // namespace nineline::shell
