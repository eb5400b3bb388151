#include "tests/campaign/campaign.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/progress.h"
#include "core/errors/error_model_file.h"

namespace nineline::campaign {

namespace {

simulation::ProgramSetup setupOf(const Case& one) {
  simulation::ProgramSetup setup;
  setup.dialect = nc::Dialect::Fanuc;
  setup.tool_lengths[1] = one.program.tool_length;
  for (std::size_t i = 0; i < one.machine.joints.size(); ++i) {
    if (one.machine.joints[i].letter == 'X') setup.start[i] = 100.0;
    if (one.machine.joints[i].letter == 'A') setup.start[i] = 0.5;
  }
  for (const PlainEffect& effect : one.machine.effects) {
    if (effect.kind != PlainEffect::Kind::ThermalScrew) continue;
    const PlainJoint& joint = one.machine.joints[static_cast<std::size_t>(effect.joint)];
    setup.state.conditions.emplace_back(sensorOf(joint), 20.0 + effect.above_20_C);
  }
  return setup;
}

double removed(double before, double after, double rest) {
  const double correctable = std::max(before - rest, 1e-30);
  return 100.0 * (1.0 - std::sqrt(std::max(after - rest, 0.0) / correctable));
}

void askSecond(const Case& one, const SecondOpinion& opinion, Outcome& outcome) {
  const bool diameter = std::any_of(one.machine.joints.begin(), one.machine.joints.end(),
                                    [](const PlainJoint& joint) { return joint.diameter; });
  const std::string mode = diameter ? "G7\n" : "";  // on Fanuc controls a parameter, no word
  const std::string before = opinion.read(mode + one.program.text, one.program.tool_length);
  const std::string after = opinion.read(mode + outcome.corrected_text, one.program.tool_length);
  outcome.second_read = isComplete(before) && isComplete(after);
  if (outcome.second_read) {
    outcome.meaning = changedMeaning(before, after);
  } else if (isComplete(before)) {
    outcome.meaning = "rs274 refuses the corrected program: " + reasonOf(after);
  } else {
    outcome.fault = "rs274 refuses the original: " + reasonOf(before);
  }
}

std::size_t linesOf(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

}  // namespace

const std::vector<Writing>& writings() {
  static const std::vector<Writing> all = {{"3 decimals (inch 4)", 3, 4, 3, 1e-4},
                                           {"4 decimals (inch 5)", 4, 5, 4, 1e-4},
                                           {"6 decimals", 6, 6, 6, 1e-4}};
  return all;
}

Case drawCase(unsigned seed, int blocks) {
  Random random(seed);
  Case one;
  one.seed = seed;
  const auto structure = static_cast<Structure>(random.whole(0, 2));
  one.more_effects = random.whole(0, 1) == 1;
  one.machine = drawMachine(random, structure, one.more_effects);
  one.program = ProgramDrawer(random, one.machine, blocks).draw();
  return one;
}

Outcome run(const Case& one, const Writing& writing, const SecondOpinion* opinion) {
  Outcome outcome;
  const Result<errors::ErrorModel> model = errors::readErrorModel(modelText(one.machine), "campaign.json");
  if (!model) {
    outcome.fault = "model: " + model.error().message();
    return outcome;
  }
  const simulation::ProgramSetup setup = setupOf(one);
  compensation::CompensationOptions options;
  options.tolerance = writing.tolerance;
  options.angle_tolerance = 2e-6;
  options.linear_decimals = one.program.inch ? writing.linear_inch : writing.linear_mm;
  options.rotary_decimals = writing.rotary;
  NoProgress progress;
  std::string& text = outcome.corrected_text;  // also of a program that is refused: to see why
  nc::MemoryText source("campaign.nc", one.program.text);
  const compensation::TextSink sink = [&](std::string_view piece) -> Result<void> {
    text += piece;
    return {};
  };
  const auto written = [&]() -> Result<std::unique_ptr<nc::TextSource>> {
    return std::unique_ptr<nc::TextSource>(std::make_unique<nc::MemoryText>("campaign.nc", text));
  };
  const Result<compensation::CompensationReport> done =
      compensation::compensateProgram(*model, source, setup, options, sink, written, progress);
  if (!done) {
    outcome.fault = "compensate: " + done.error().message();
    return outcome;
  }
  outcome.blocks = done->blocks;
  outcome.seconds = done->seconds;
  outcome.lines = linesOf(one.program.text);
  outcome.corrected_lines = linesOf(text);
  outcome.reported_before = done->before.norm.rms;
  outcome.reported_after = done->after.norm.rms;
  const nc::InterpreterOptions reading = simulation::interpreterOptionsOf(model->machine(), setup);
  const Result<std::vector<PlainMotion>> original = motionsOf(one.program.text, reading);
  const Result<std::vector<PlainMotion>> corrected = motionsOf(text, reading);
  if (!original || !corrected) {
    outcome.fault = "reading: " + (original ? corrected.error() : original.error()).message();
    return outcome;
  }
  const PlainPhysics physics(one.machine);
  outcome.paths = comparePaths(physics, one.program.text, *original, text, *corrected, setup.start);
  outcome.fault = outcome.paths.fault;
  if (opinion != nullptr) askSecond(one, *opinion, outcome);
  return outcome;
}

double removedPercent(const PathFigures& before, const PathFigures& after) {
  return removed(before.square, after.square, before.rest_square);
}

double removedTiltPercent(const PathFigures& before, const PathFigures& after) {
  return removed(before.tilt_square, after.tilt_square, before.rest_tilt_square);
}

}  // namespace nineline::campaign
