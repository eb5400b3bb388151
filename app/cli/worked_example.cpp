#include "app/cli/worked_example.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/cli/curve_svg.h"
#include "app/cli/example_texts.h"
#include "app/cli/figures_text.h"
#include "app/cli/pass_curves.h"
#include "app/cli/path_file.h"
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
using simulation::SimulationReport;
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
        turning_(model_.machine().find(AxisId{'C', 0})),
        along_(model_.machine().find(AxisId{'Z', 0})),
        pass_before_(turning_),
        pass_after_(turning_) {}

  Result<void> writeInputs();
  Result<void> grind();
  Result<void> correct();
  Result<void> simulateBoth();
  Result<void> draw();
  Result<WorkedExample> conclude();

 private:
  [[nodiscard]] fs::path file(const char* name) const { return folder_ / name; }
  Result<SimulationReport> simulate(const char* program, const char* path, FinalPass& pass);
  [[nodiscard]] Result<void> drawJoint(int joint, const std::vector<PathSample>& before,
                                       const std::vector<PathSample>& after);
  [[nodiscard]] std::string meansText() const;

  fs::path folder_;
  ErrorModel model_;
  Progress& progress_;
  int turning_;
  int along_;
  simulation::ProgramSetup setup_;
  double radius_ = 0.0;  // of the thread's outside, mm
  FinalPass pass_before_;
  FinalPass pass_after_;
  ThreadProgram thread_;
  SimulationReport simulated_;
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
  return writeFile(file("thread.nc"), thread_.text);
}

Result<void> Example::correct() {
  const std::string source = file("thread.nc").string();
  Result<CorrectionFiles> files = CorrectionFiles::create(file("corrected.nc").string(), "");
  if (!files) return files.error();
  Result<CompensationReport> report = correctProgram(model_, source, setup_, {}, *files, progress_);
  if (!report) return report.error();
  corrected_ = std::move(*report);
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

Result<SimulationReport> Example::simulate(const char* program, const char* path, FinalPass& pass) {
  const Result<std::unique_ptr<nc::TextSource>> text = nc::openTextFile(file(program));
  if (!text) return text.error();
  Result<AtomicFile> target = AtomicFile::create(file(path));
  if (!target) return target.error();
  Result<SimulationReport> report = simulateToFile(model_, **text, setup_, *target, progress_,
                                                   [&pass](const PathSample& sample) { pass.add(sample); });
  if (!report) return report;
  if (const Result<void> committed = target->commit(); !committed) return committed.error();
  return report;
}

Result<void> Example::simulateBoth() {
  Result<SimulationReport> before = simulate("thread.nc", "path-before.csv", pass_before_);
  if (!before) return before.error();
  simulated_ = std::move(*before);
  const Result<SimulationReport> after = simulate("corrected.nc", "path-after.csv", pass_after_);
  if (!after) return after.error();
  return {};
}

Result<void> Example::draw() {
  const std::vector<PathSample> before = pass_before_.samples();
  const std::vector<PathSample> after = pass_after_.samples();
  for (int joint = 0; joint < model_.machine().jointCount(); ++joint) {
    if (Result<void> drawn = drawJoint(joint, before, after); !drawn) return drawn;
  }
  return {};
}

Result<void> Example::drawJoint(int joint, const std::vector<PathSample>& before,
                                const std::vector<PathSample>& after) {
  const Machine& machine = model_.machine();
  const bool rotary = machine.isRotary(joint);
  const auto line = [rotary](std::string name, std::string colour, Curve curve) {
    for (double& error : curve.error) error = rotary ? arcsecFromRad(error) : umFromMm(error);
    return PlotLine{std::move(name), std::move(colour), std::move(curve.position), std::move(curve.error)};
  };
  const std::string axis = machine.joint(joint).axis.text();
  const std::string svg =
      plotSvg(fmt::format("Error of {} along the finished thread", axis), "Z in mm",
              rotary ? "error in arcsec" : "error in um",
              {line("before", "#c0392b", errorCurve(before, joint, along_)),
               line("after", "#1f618d", residualCurve(machine, before, after, joint, along_))});
  std::string letter = axis;
  std::transform(letter.begin(), letter.end(), letter.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return writeFile(folder_ / fmt::format("error-{}.svg", letter), svg);
}

std::string Example::meansText() const {
  const Machine& machine = model_.machine();
  std::string text = "Mean errors before and after, in mm (C as arc on the outside of the thread):\n";
  const auto row = [&](char letter, const char* published) {
    const int joint = machine.find(AxisId{letter, 0});
    const double arm = machine.isRotary(joint) ? radius_ : 1.0;
    const auto mean = [&](const CompensationReport& report, bool before) {
      const auto& joints = before ? report.before.joints : report.after.joints;
      return arm * joints[static_cast<std::size_t>(joint)].mean;
    };
    text += fmt::format(
        "  {}  before {:9.6f} (published {})   after {:10.7f}   after, words to 1 nm {:13.10f}\n", letter,
        mean(corrected_, true), published, mean(corrected_, false), mean(corrected_finely_, false));
  };
  row('X', "-0.096, left with -0.032");
  row('Z', "0.157, left with 0.052");
  row('C', "0.004, left with 0.001");
  return text;
}

Result<WorkedExample> Example::conclude() {
  const Machine& machine = model_.machine();
  WorkedExample example;
  example.record = Json::object();
  example.record.set("thread", thread_grinding::reportJson(thread_.report))
      .set("simulate", simulationToJson(simulated_, machine))
      .set("compensate", compensation::reportToJson(corrected_, machine))
      .set("compensate_nanometre", compensation::reportToJson(corrected_finely_, machine));
  example.summary = fmt::format(
      "The worked example: {}\n\n"
      "thread.nc: {} blocks, {} passes, {} hand thread of lead {:g} mm.\n"
      "corrected.nc: {} of {} blocks corrected, {} lines added.\n\n{}\n{}",
      machine.name(), thread_.report.motion_blocks, thread_.report.passes,
      thread_.report.cut.hand == thread_grinding::Hand::Left ? "left" : "right", thread_.report.cut.lead,
      corrected_.corrected, corrected_.blocks, corrected_.inserted,
      figuresText(corrected_.before, corrected_.after, machine), meansText());
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
       {&Example::writeInputs, &Example::grind, &Example::correct, &Example::simulateBoth, &Example::draw}) {
    if (progress.isCancelled()) return cancelled();
    if (Result<void> done = (example.*step)(); !done) return done.error();
  }
  return example.conclude();
}

}  // namespace nineline::cli
