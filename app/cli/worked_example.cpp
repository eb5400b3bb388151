#include "app/cli/worked_example.h"

#include <fmt/format.h>

#include "app/cli/curve_svg.h"
#include "app/cli/example_texts.h"
#include "app/cli/figures_text.h"
#include "app/cli/final_pass.h"
#include "app/cli/program_correction.h"
#include "app/cli/thread_machine.h"
#include "core/base/units.h"
#include "core/errors/error_model_file.h"
#include "core/kinematics/machine_file.h"
#include "core/thread_grinding/thread_generator.h"

namespace nineline::cli {

namespace {

namespace fs = std::filesystem;
using compensation::CompensationReport;
using errors::ErrorModel;
using kinematics::Machine;
using simulation::PathSample;
using thread_grinding::ThreadJob;
using thread_grinding::ThreadProgram;

constexpr int kNanometreDecimals = 6;

/// Runs the steps of the example one after the other; each one writes its files.
class Example {
 public:
  Example(fs::path folder, ErrorModel model, Progress& progress)
      : folder_(std::move(folder)),
        model_(std::move(model)),
        progress_(progress),
        along_(model_.machine().find(AxisId{'Z', 0})),
        final_pass_(model_.machine().find(AxisId{'C', 0})) {}

  Result<void> writeInputs();
  Result<void> grind();
  Result<void> correct();
  Result<void> writePaths();
  Result<void> draw();
  Result<WorkedExample> conclude();

 private:
  [[nodiscard]] fs::path file(const char* name) const { return folder_ / name; }
  [[nodiscard]] PlotLine lineOf(int joint, bool after) const;
  [[nodiscard]] Result<void> drawJoint(int joint) const;
  [[nodiscard]] double meanError(int joint, bool after) const;
  [[nodiscard]] std::string meansText() const;

  fs::path folder_;
  ErrorModel model_;
  Progress& progress_;
  int along_;
  simulation::ProgramSetup setup_;
  double radius_ = 0.0;  // of the thread's outside, mm
  double length_ = 0.0;  // of the thread, mm
  FinalPass final_pass_;
  std::vector<FinalPass::Place> places_;  // of the final pass
  ThreadProgram thread_;
  CompensationReport corrected_;
  CompensationReport corrected_finely_;
};

Result<void> Example::writeInputs() {
  std::error_code fault;
  fs::create_directories(folder_, fault);
  if (!fs::is_directory(folder_, fault)) {
    return badInput("demo.folder", "The folder cannot be made.", folder_.string());
  }
  const std::string machine = writeJson(kinematics::machineToJson(model_.machine())) + "\n";
  if (Result<void> written = writeFile(file("machine.json"), machine); !written) return written;
  if (Result<void> written = writeFile(file("model.json"), exampleModelText()); !written) return written;
  return writeFile(file("thread.json"), exampleThreadText());
}

Result<void> Example::grind() {
  Result<ThreadJob> job = thread_grinding::parseThreadJob(exampleThreadText(), "thread.json");
  if (!job) return job.error();
  if (Result<void> taken = takeLimits(model_.machine(), *job); !taken) return taken;
  Result<ThreadProgram> program = thread_grinding::generateThread(job->parameters, job->limits);
  if (!program) return program.error();
  thread_ = std::move(*program);
  radius_ = job->parameters.diameter / 2.0;
  length_ = job->parameters.length;
  return writeFile(file("thread.nc"), thread_.text);
}

Result<void> Example::correct() {
  const std::string source = file("thread.nc").string();
  Result<CorrectionFiles> files = CorrectionFiles::create(file("corrected.nc").string(), "");
  if (!files) return files.error();
  Result<CompensationReport> report = correctProgram(
      model_, source, setup_, {}, *files, progress_,
      [this](const PathSample& before, const PathSample& after) { final_pass_.add(before, after); });
  if (!report) return report.error();
  corrected_ = std::move(*report);
  places_ = final_pass_.places();
  compensation::CompensationOptions finely;
  finely.linear_decimals = kNanometreDecimals;
  finely.rotary_decimals = kNanometreDecimals;
  finely.tolerance = 0.01 * finely.tolerance;
  Result<compensation::CompensatedText> fine =
      compensation::compensateText(model_, source, thread_.text, setup_, finely, progress_);
  if (!fine) return fine.error();
  corrected_finely_ = std::move(fine->report);
  return files->commit();
}

Result<void> Example::writePaths() {
  std::string before = simulation::pathCsvHeader(model_.machine());
  std::string after = before;
  for (const FinalPass::Place& place : places_) {
    simulation::appendPathCsvRow(model_.machine(), place.before, before);
    simulation::appendPathCsvRow(model_.machine(), place.after, after);
  }
  if (Result<void> written = writeFile(file("path-before.csv"), before); !written) return written;
  return writeFile(file("path-after.csv"), after);
}

Result<void> Example::draw() {
  for (int joint = 0; joint < model_.machine().jointCount(); ++joint) {
    if (Result<void> drawn = drawJoint(joint); !drawn) return drawn;
  }
  return {};
}

PlotLine Example::lineOf(int joint, bool after) const {
  PlotLine line{after ? "after" : "before", after ? "#1f618d" : "#c0392b", {}, {}};
  for (const FinalPass::Place& place : places_) {
    const PathSample& sample = after ? place.after : place.before;
    const double error = sample.deviation.joints[static_cast<std::size_t>(joint)];
    line.x.push_back(place.before.q[static_cast<std::size_t>(along_)]);
    line.y.push_back(model_.machine().isRotary(joint) ? arcsecFromRad(error) : umFromMm(error));
  }
  return line;
}

Result<void> Example::drawJoint(int joint) const {
  const std::string axis = model_.machine().joint(joint).axis.text();
  const std::string svg = plotSvg(fmt::format("Error of {} along the finished thread", axis), "Z in mm",
                                  model_.machine().isRotary(joint) ? "error in arcsec" : "error in um",
                                  {lineOf(joint, false), lineOf(joint, true)});
  const char letter = static_cast<char>(axis.front() - 'A' + 'a');
  return writeFile(folder_ / fmt::format("error-{}.svg", letter), svg);
}

double Example::meanError(int joint, bool after) const {
  double sum = 0.0;
  double count = 0.0;
  for (const FinalPass::Place& place : places_) {
    const double z = place.before.q[static_cast<std::size_t>(along_)];
    if (z > 0.0 || z < -length_) continue;  // lead-in and run-out
    const PathSample& sample = after ? place.after : place.before;
    sum += sample.deviation.joints[static_cast<std::size_t>(joint)];
    count += 1.0;
  }
  return count > 0.0 ? sum / count : 0.0;
}

std::string Example::meansText() const {
  const Machine& machine = model_.machine();
  std::string text = "Mean errors over the finished thread in mm, C as arc on its outside:\n";
  const auto row = [&](char letter, const char* published) {
    const int joint = machine.find(AxisId{letter, 0});
    const double arm = machine.isRotary(joint) ? radius_ : 1.0;
    text += fmt::format("  {}   before {:9.6f}, after {:10.7f}   (published: {})\n", letter,
                        arm * meanError(joint, false), arm * meanError(joint, true), published);
  };
  row('X', "-0.096, left -0.032");
  row('Z', "0.157, left 0.052");
  row('C', "0.004, left 0.001");
  return text;
}

Result<WorkedExample> Example::conclude() {
  const Machine& machine = model_.machine();
  WorkedExample example;
  example.record = Json::object();
  example.record.set("thread", thread_grinding::reportJson(thread_.report))
      .set("compensate", compensation::reportToJson(corrected_, machine))
      .set("compensate_nanometre", compensation::reportToJson(corrected_finely_, machine));
  example.summary = fmt::format(
      "The worked example: {}\n\n"
      "thread.nc: {} blocks, {} passes, {} hand thread of lead {:g} mm.\n"
      "corrected.nc: {} of {} blocks corrected, {} lines added.\n\n{}\n"
      "The same with words to 1 nm:\n{}\n{}",
      machine.name(), thread_.report.motion_blocks, thread_.report.passes,
      thread_.report.cut.hand == thread_grinding::Hand::Left ? "left" : "right", thread_.report.cut.lead,
      corrected_.corrected, corrected_.blocks, corrected_.inserted,
      figuresText(corrected_.before, corrected_.after, machine),
      figuresText(corrected_finely_.before, corrected_finely_.after, machine), meansText());
  if (Result<void> done = writeFile(file("report.json"), writeJson(example.record) + "\n"); !done) {
    return done.error();
  }
  if (Result<void> done = writeFile(file("summary.txt"), example.summary); !done) return done.error();
  return example;
}

}  // namespace

Result<WorkedExample> writeWorkedExample(const fs::path& folder, Progress& progress) {
  Result<ErrorModel> model = errors::readErrorModel(exampleModelText(), "model.json");
  if (!model) return model.error();
  Example example(folder, std::move(*model), progress);
  for (const auto step :
       {&Example::writeInputs, &Example::grind, &Example::correct, &Example::writePaths, &Example::draw}) {
    if (progress.isCancelled()) return cancelled();
    if (Result<void> done = (example.*step)(); !done) return done.error();
  }
  return example.conclude();
}

}  // namespace nineline::cli
