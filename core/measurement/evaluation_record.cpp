#include "core/measurement/evaluation_record.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/units.h"

namespace nineline::measurement {

namespace {

bool isSameTest(const EvaluationInput& one, const EvaluationInput& other) {
  const Instrument& a = one.measurement->instrument;
  const Instrument& b = other.measurement->instrument;
  if (a.hasZero()) return false;  // each file has a zero of its own
  return a.kind == b.kind && a.axis == b.axis && a.point == b.point && a.sensitive == b.sensitive &&
         a.about == b.about && a.centre == b.centre && a.radius == b.radius && a.plane == b.plane &&
         one.machine->id() == other.machine->id() && one.measurement->channels == other.measurement->channels;
}

Result<void> addPositioning(std::span<const EvaluationInput> inputs, Evaluation& evaluation) {
  const Result<int> joint = positionedJoint(inputs.front());
  if (!joint) return joint.error();
  for (const EvaluationInput& input : inputs.subspan(1)) {
    const Result<int> other = positionedJoint(input);
    if (!other) return other.error();
    if (*other == *joint) continue;
    return badInput("evaluation.axis", "The files move different axes.", input.measurement->source);
  }
  evaluation.axis = inputs.front().machine->joint(*joint).axis.text();
  evaluation.is_rotary = evaluation.is_angular = inputs.front().machine->isRotary(*joint);
  if (inputs.front().measurement->instrument.kind == InstrumentKind::LaserLinear)
    evaluation.is_angular = false;
  const Result<TargetRuns> runs = groupByTarget(inputs, *joint, evaluation.warnings);
  if (!runs) return runs.error();
  evaluation.runs = *runs;
  const Result<Iso2302> letters = evaluateIso2302(*runs);
  if (!letters) return letters.error();
  evaluation.iso_230_2 = *letters;
  if (letters->fewest_approaches < 5) {
    evaluation.warnings.warning("evaluation.runs",
                                fmt::format("ISO 230-2 asks for 5 approaches to each target in each "
                                            "direction; the fewest here are {}.",
                                            letters->fewest_approaches));
  }
  if (const Result<Vdi3441> vdi = evaluateVdi3441(*runs); vdi) evaluation.vdi_3441 = *vdi;
  return {};
}

Result<void> addCircle(std::span<const EvaluationInput> inputs, Evaluation& evaluation) {
  evaluation.axis = inputs.front().measurement->instrument.plane;
  const Result<CircularTest> test = groupByPath(inputs, evaluation.warnings);
  if (!test) return test.error();
  const Result<Iso2304> figures = evaluateIso2304(*test);
  if (!figures) {
    Error error = figures.error();
    error.source = inputs.front().measurement->source;
    return error;
  }
  evaluation.iso_230_4 = *figures;
  if (const Result<BallbarShares> shares = ballbarShares(*test, evaluation.axis[0], evaluation.axis[1]);
      shares) {
    evaluation.ballbar = *shares;
  }
  if (!figures->is_full_circle) {
    evaluation.warnings.warning("evaluation.arc",
                                "The path is no full circle: F refers to the centre as set up.");
  }
  return {};
}

Result<void> addRunOut(std::span<const EvaluationInput> inputs, Evaluation& evaluation) {
  std::vector<double> angles, readings;
  for (const EvaluationInput& input : inputs) {
    const Measurement& measurement = *input.measurement;
    const int joint = measurement.instrument.axis ? input.machine->find(*measurement.instrument.axis) : -1;
    if (joint < 0 || !input.machine->isRotary(joint)) {
      return badInput("evaluation.axis", "A run-out needs a rotary axis.", measurement.source);
    }
    evaluation.axis = measurement.instrument.axis->text();
    for (std::size_t i = 0; i < measurement.samples.size(); ++i) {
      const std::optional<double>& reading = measurement.reading(i, 0);
      if (!measurement.samples[i].has_positions || !reading) continue;
      angles.push_back(measurement.samples[i].q[static_cast<std::size_t>(joint)]);
      readings.push_back(*reading);
    }
  }
  evaluation.is_rotary = true;
  const Result<RunOut> figures = evaluateRunOut(angles, readings);
  if (!figures) {
    Error error = figures.error();
    error.source = inputs.front().measurement->source;
    return error;
  }
  evaluation.run_out = *figures;
  return {};
}

Result<Evaluation> evaluateTest(std::span<const EvaluationInput> inputs) {
  Evaluation evaluation;
  const Measurement& first = *inputs.front().measurement;
  for (const EvaluationInput& input : inputs) evaluation.sources.push_back(input.measurement->source);
  evaluation.instrument = std::string(nameOf(first.instrument.kind));
  Result<void> done;
  switch (first.instrument.kind) {
    case InstrumentKind::Joint:
    case InstrumentKind::LaserLinear:
    case InstrumentKind::Deviation:
      done = addPositioning(inputs, evaluation);
      break;
    case InstrumentKind::Ballbar:
      done = addCircle(inputs, evaluation);
      break;
    case InstrumentKind::Dial:
      done = addRunOut(inputs, evaluation);
      break;
    case InstrumentKind::LaserStraightness:
    case InstrumentKind::LaserAngular:
    case InstrumentKind::Lead:
      done = badInput(
          "evaluation.instrument",
          fmt::format("Readings of '{}' have no figures of ISO 230-2, ISO 230-4 or ISO 230-7; 'identify' "
                      "makes error tables of them.",
                      evaluation.instrument),
          first.source);
  }
  if (!done) return done.error();
  return evaluation;
}

}  // namespace

Result<std::vector<Evaluation>> evaluateMeasurements(std::span<const EvaluationInput> inputs) {
  std::vector<std::vector<EvaluationInput>> tests;
  for (const EvaluationInput& input : inputs) {
    const auto same = std::find_if(tests.begin(), tests.end(), [&](const std::vector<EvaluationInput>& test) {
      return isSameTest(test.front(), input);
    });
    same == tests.end() ? tests.push_back({input}) : same->push_back(input);
  }
  std::vector<Evaluation> evaluations;
  for (const std::vector<EvaluationInput>& test : tests) {
    Result<Evaluation> evaluation = evaluateTest(test);
    if (!evaluation) return evaluation.error();
    evaluations.push_back(*std::move(evaluation));
  }
  return evaluations;
}

}  // namespace nineline::measurement
