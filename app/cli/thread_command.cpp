#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <memory>

#include "app/cli/commands.h"
#include "app/cli/output_files.h"
#include "app/cli/thread_machine.h"
#include "core/base/file.h"
#include "core/kinematics/machine_file.h"
#include "core/thread_grinding/thread_generator.h"

namespace nineline::cli {

namespace {

struct ThreadOptions {
  std::string parameters;
  std::string out;
  std::string machine;
};

std::string summaryOf(const thread_grinding::ThreadReport& report, const std::string& out) {
  return fmt::format(
      "{}: {} blocks, {} passes at {} start(s), depth {:.4f} mm, about {:.0f} s.\n"
      "The virtual thread cut with it: {} hand, lead {:g} mm.\n",
      out, report.motion_blocks, report.passes, report.starts, report.depth, report.duration,
      report.cut.hand == thread_grinding::Hand::Right ? "right" : "left", report.cut.lead);
}

/// The checks of a thread speak of "pitch_mm is -1.5"; this finds the place where that key stands.
template <typename Finding>
void locate(Finding& finding, const Json& parameters) {
  const Json* value = parameters.find(std::string_view(finding.text).substr(0, finding.text.find(' ')));
  if (value == nullptr || finding.line != 0) return;
  finding.line = value->line();
  finding.column = value->column();
}

/// The program of a job, its warnings and faults placed in the parameter file.
Result<thread_grinding::ThreadProgram> generatePlaced(const thread_grinding::ThreadJob& job,
                                                      const std::string& text, const std::string& source) {
  Result<thread_grinding::ThreadProgram> program =
      thread_grinding::generateThread(job.parameters, job.limits);
  const Result<Json> parameters = parseJson(text, source);
  if (!parameters) return parameters.error();
  if (program) {
    for (Diagnostic& warning : program->report.warnings) locate(warning, *parameters);
    return program;
  }
  Error error = program.error();
  if (error.line == 0) error.source = source;
  locate(error, *parameters);
  return error;
}

Result<void> runThread(const ThreadOptions& options, Console& console) {
  const std::array inputs{options.parameters};
  const std::array outputs{options.out};
  if (Result<void> distinct = requireDistinct(inputs, outputs); !distinct) return distinct;
  const Result<std::string> text = readFile(options.parameters);
  if (!text) return text.error();
  Result<thread_grinding::ThreadJob> job = thread_grinding::parseThreadJob(*text, options.parameters);
  if (!job) return job.error();
  console.diagnostics(job->warnings.all(), options.parameters);
  if (!options.machine.empty()) {
    const Result<kinematics::Machine> machine = kinematics::loadMachine(options.machine);
    if (!machine) return machine.error();
    if (Result<void> taken = takeLimits(*machine, *job); !taken) return taken;
  }
  const Result<thread_grinding::ThreadProgram> program = generatePlaced(*job, *text, options.parameters);
  if (!program) return program.error();
  console.diagnostics(program->report.warnings, options.parameters);
  if (console.isCancelled()) return cancelled();
  if (Result<void> written = writeFile(options.out, program->text); !written) return written;
  console.result(thread_grinding::reportJson(program->report), summaryOf(program->report, options.out));
  return {};
}

}  // namespace

Command addThreadCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand("thread", "Write a thread-grinding program from its parameters");
  auto options = std::make_shared<ThreadOptions>();
  command->add_option("--params", options->parameters, "The thread's parameters, nineline-thread/1")
      ->required()
      ->type_name("P.json");
  command->add_option("--out", options->out, "The program to write")->required()->type_name("OUT.nc");
  command->add_option("--machine", options->machine, "Check travel, speeds and senses of this machine too")
      ->type_name("M");
  return {command, [options](Console& console) { return runThread(*options, console); }};
}

}  // namespace nineline::cli
