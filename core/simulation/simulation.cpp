#include "core/simulation/simulation.h"

#include <fmt/format.h>

#include <cmath>

#include "core/base/text.h"
#include "core/base/units.h"
#include "core/errors/component.h"
#include "core/simulation/command_path.h"

namespace nineline::simulation {

namespace {

constexpr double kChord = 0.002;  // mm, contract.md, convention 9
constexpr std::size_t kBlocksBetweenReports = 4096;

/// One run of a program through the machine.
class ProgramRun {
 public:
  ProgramRun(const ErrorModel& model, const ProgramSetup& setup, const SampleSink& sink)
      : model_(model),
        machine_(model.machine()),
        sink_(sink),
        feed_meaning_(feedMeaningOf(setup.dialect)),
        path_(model, setup.state, setup.start),
        cutting_(machine_.jointCount()),
        all_(machine_.jointCount()) {}

  /// The sample of the position before the first motion.
  bool begin() {
    sample_.q = path_.state().q;
    evaluate();
    return sink_(sample_);
  }

  Result<bool> run(const nc::Motion& motion) {
    const Result<JointPositions> start = jointsOf(machine_, motion.start, motion.tool_centre_point);
    const Result<JointPositions> end = jointsOf(machine_, motion.end, motion.tool_centre_point);
    if (!start) return placed(start.error(), motion.line);
    if (!end) return placed(end.error(), motion.line);
    sampleFractions(model_, motion, *start, *end, path_.state().approach, kChord, fractions_);
    const double duration = durationOf(machine_, motion, feed_meaning_);
    double before = 0.0;
    for (const double fraction : fractions_) {
      const nc::AxisValues values = positionAt(motion, machine_.jointCount(), fraction);
      const Result<JointPositions> q = jointsOf(machine_, values, motion.tool_centre_point);
      if (!q) return placed(q.error(), motion.line);
      if (const int joint = machine_.firstOutsideTravel(*q); joint >= 0)
        return outside(joint, *q, motion.line);
      path_.moveTo(*q, duration * (fraction - before));
      before = fraction;
      if (!take(motion, fraction == 1.0)) return false;
    }
    ++report_.motions;
    return true;
  }

  SimulationReport finish(std::size_t blocks, const Diagnostics& diagnostics) {
    report_.blocks = blocks;
    report_.path_length = sample_.s;
    report_.time = sample_.t;
    report_.deviation = cutting_.empty() ? all_.summary() : cutting_.summary();
    Diagnostics warnings = diagnostics;
    warnings.append(report_.diagnostics);
    report_.diagnostics = std::move(warnings);
    return std::move(report_);
  }

 private:
  static Error placed(Error error, std::size_t line) {
    error.line = line;
    return error;
  }

  Error outside(int joint, const JointPositions& q, std::size_t line) const {
    const bool rotary = machine_.isRotary(joint);
    const Travel& travel = *machine_.joint(joint).travel;
    const auto shown = [rotary](double value) { return rotary ? degFromRad(value) : value; };
    return placed(
        noAnswer("travel",
                 fmt::format("The command {}{:.4f} lies outside the travel {:g} to {:g} {}.",
                             machine_.joint(joint).axis.text(), shown(q[static_cast<std::size_t>(joint)]),
                             shown(travel.low), shown(travel.high), rotary ? "deg" : "mm")),
        line);
  }

  void evaluate() {
    sample_.ideal = forward(machine_, sample_.q);
    sample_.actual = path_.actualPose();
    sample_.deviation = deviationOf(machine_, sample_.q, sample_.ideal, sample_.actual);
  }

  bool take(const nc::Motion& motion, bool block_end) {
    const Vector3d before = sample_.ideal.tip;
    sample_.line = motion.line;
    sample_.rapid = motion.kind == nc::MotionKind::Rapid;
    sample_.block_end = block_end;
    sample_.q = path_.state().q;
    sample_.t = path_.elapsed();
    evaluate();
    const double step = (sample_.ideal.tip - before).norm();
    sample_.s += step;
    const double tilt = std::atan2(sample_.ideal.axis.cross(sample_.actual.axis).norm(),
                                   sample_.ideal.axis.dot(sample_.actual.axis));
    all_.add(sample_.deviation, tilt, step);
    if (!sample_.rapid && motion.role != nc::MotionRole::Machine) cutting_.add(sample_.deviation, tilt, step);
    warnOutsideTables(motion.line);
    ++report_.samples;
    return sink_(sample_);
  }

  void warnOutsideTables(std::size_t line) {
    const int effect = model_.firstUncovered(path_.state());
    if (effect < 0) return;
    report_.diagnostics.countedWarning(
        "table.outside",
        fmt::format("Outside the range of {}; its end value is used.",
                    model_.effects()[static_cast<std::size_t>(effect)]->component().text()),
        line);
  }

  using Travel = kinematics::Travel;
  const ErrorModel& model_;
  const Machine& machine_;
  const SampleSink& sink_;
  FeedMeaning feed_meaning_;
  PathState path_;
  PathSample sample_;
  std::vector<double> fractions_;
  DeviationStatistics cutting_;
  DeviationStatistics all_;
  SimulationReport report_;
};

}  // namespace

nc::AxisLayout axisLayoutOf(const Machine& machine) {
  nc::AxisLayout layout;
  layout.count = machine.jointCount();
  for (int i = 0; i < layout.count; ++i) {
    const kinematics::Joint& joint = machine.joint(i);
    layout.axes[static_cast<std::size_t>(i)] = {joint.axis, joint.type == kinematics::JointType::Rotary,
                                                joint.diameter};
  }
  return layout;
}

nc::InterpreterOptions interpreterOptionsOf(const Machine& machine, const ProgramSetup& setup) {
  nc::InterpreterOptions options;
  options.dialect = setup.dialect;
  options.axes = axisLayoutOf(machine);
  options.block_skip = setup.block_skip;
  options.start = setup.start;
  options.work_offsets = {setup.work_offsets.begin(), setup.work_offsets.end()};
  options.tool_lengths = setup.tool_lengths;
  return options;
}

Result<void> requireConditions(const ErrorModel& model, const ProgramSetup& setup) {
  const std::vector<std::string> missing = model.missingConditions(setup.state);
  if (missing.empty()) return {};
  return badInput("state.missing",
                  fmt::format("The error model needs {}; state its value, for example --state {}=21.5.",
                              missing.front(), missing.front()));
}

Result<SimulationReport> simulateProgram(const ErrorModel& model, nc::TextSource& program,
                                         const ProgramSetup& setup, const SampleSink& sink,
                                         Progress& progress) {
  if (Result<void> known = requireConditions(model, setup); !known) return known.error();
  nc::Interpreter interpreter(program, interpreterOptionsOf(model.machine(), setup));
  ProgramRun run(model, setup, sink);
  bool wanted = run.begin();
  std::size_t blocks = 0;
  while (wanted) {
    const Result<const nc::ExecutedBlock*> block = interpreter.next();
    if (!block) return block.error();
    if (*block == nullptr) break;
    for (const nc::Motion& motion : (*block)->motions) {
      const Result<bool> goes_on = run.run(motion);
      if (!goes_on) {
        Error error = goes_on.error();
        error.source = program.name();
        return error;
      }
      wanted = wanted && *goes_on;
    }
    if (++blocks % kBlocksBetweenReports == 0) {
      if (progress.isCancelled()) return cancelled();
      progress.report(-1.0, "simulate");
    }
  }
  return run.finish(blocks, interpreter.diagnostics());
}

}  // namespace nineline::simulation
