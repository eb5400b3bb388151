#include "ui/shell/example.h"

#include <QFile>

#include "core/errors/error_model_file.h"
#include "core/kinematics/built_in_machine_texts.h"
#include "core/kinematics/machine_file.h"
#include "core/thread_grinding/thread_generator.h"

namespace nineline::shell {

namespace {

Result<std::string> resource(const QString& path) {
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) {
    return badInput("file.missing", "A resource of the program is missing: " + path.toStdString());
  }
  return file.readAll().toStdString();
}

}  // namespace

models::Document emptyProject() {
  models::Document document;
  document.machine_text = std::string(kinematics::builtInMachineTexts().front());
  const Result<std::string> thread = resource(QStringLiteral(":/examples/published-thread.json"));
  if (thread) {
    if (const Result<Json> json = parseJson(*thread, "example")) document.thread = *json;
  }
  return document;
}

Result<models::Document> workedExample() {
  const Result<std::string> model_text = resource(QStringLiteral(":/examples/b2-k3032-model.json"));
  if (!model_text) return model_text.error();
  const Result<errors::ErrorModel> model = errors::readErrorModel(*model_text, "example");
  if (!model) return model.error();
  models::Document document = emptyProject();
  // The file's own text, where it holds the machine: its numbers stay as they were written.
  const Result<Json> file = parseJson(*model_text, "example");
  if (!file) return file.error();
  const Json* machine = file->find("machine");
  const bool whole = machine != nullptr && machine->members() != nullptr;
  document.machine_text = writeJson(whole ? *machine : kinematics::machineToJson(model->machine()));
  document.effects = *errors::errorModelToJson(*model).find("effects");
  const auto job = thread_grinding::parseThreadJob(writeJson(document.thread), "example");
  if (!job) return job.error();
  auto program = thread_grinding::generateThread(job->parameters, job->limits);
  if (!program) return program.error();
  document.program_name = "thread.nc";
  document.program = std::make_shared<const std::string>(std::move(program->text));
  // What the instruments read on this machine: there is something that the model does not know.
  for (const char* name : {"gap-laser-z.csv", "gap-laser-x.csv", "gap-lead.csv"}) {
    Result<std::string> text = resource(QStringLiteral(":/examples/") + QLatin1String(name));
    if (!text) return text.error();
    document.readings.push_back({name, std::make_shared<const std::string>(std::move(*text))});
  }
  return document;
}

}  // namespace nineline::shell
