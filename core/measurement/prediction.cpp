#include "core/measurement/prediction.h"

#include <fmt/format.h>

namespace nineline::measurement {

using errors::EffectPtr;
using kinematics::JointDisplacements;

namespace {

/// The motions of one joint's own effects in Standing and Moved, without the lever of a reference point.
void ownMotions(const ErrorModel& model, int joint, const MachineState& state, std::span<const double> memory,
                JointDisplacements& out) {
  auto& own = out[static_cast<std::size_t>(joint)];
  own = {};
  std::size_t used = 0;
  for (const EffectPtr& effect : model.effects()) {
    const std::size_t size = effect->table() != nullptr ? 0 : effect->memorySize();
    const std::span<const double> part = memory.subspan(used, size);
    used += size;
    if (effect->joint() != joint || effect->slot() == errors::Slot::Located) continue;
    effect->addMotion(state, part, effect->slot() == errors::Slot::Moved ? own.moved : own.standing);
  }
}

void warnOfPlace(const ErrorModel& model, const MachineState& state, std::size_t line,
                 Diagnostics& warnings) {
  const int uncovered = model.firstUncovered(state);
  if (uncovered < 0) return;
  const errors::Effect& effect = *model.effects()[static_cast<std::size_t>(uncovered)];
  warnings.countedWarning(
      "table.outside",
      fmt::format("A position lies outside the error table {}; its end value holds there.",
                  effect.component().text()),
      line);
}

/// False when the state lacks a condition of the model; which, is said once.
bool hasConditions(const ErrorModel& model, const MachineState& state, std::size_t line,
                   Diagnostics& warnings) {
  const std::vector<std::string> missing = model.missingConditions(state);
  for (const std::string& name : missing) {
    warnings.countedWarning(
        "measurement.condition",
        fmt::format("The model needs {}, which is missing here; the prediction leaves its effects out.",
                    name),
        line);
  }
  return missing.empty();
}

Result<void> requireColumns(const ErrorModel& model, const Measurement& measurement,
                            const std::vector<MachineState>& states) {
  for (const EffectPtr& effect : model.effects()) {
    for (const std::string& name : effect->needs()) {
      bool found = states.empty();
      for (const MachineState& state : states) found = found || state.condition(name).has_value();
      if (found) continue;
      return badInput("measurement.condition",
                      fmt::format("The effect '{}' of the model needs the column {}, which the file lacks.",
                                  effect->id(), name),
                      measurement.source);
    }
  }
  return {};
}

}  // namespace

MemoryWalk::MemoryWalk(const std::vector<EffectPtr>& effects) {
  std::size_t used = 0;
  for (const EffectPtr& effect : effects) {
    const std::size_t size = effect->table() != nullptr ? 0 : effect->memorySize();
    if (size > 0) parts_.push_back({effect.get(), used, size});
    used += size;
  }
  memory_.resize(used);
}

std::span<const double> MemoryWalk::to(const MachineState& state) {
  const std::span<double> all(memory_);
  for (const Part& part : parts_) {
    const std::span<double> own = all.subspan(part.first, part.size);
    if (before_ == nullptr) {
      part.effect->start(state, own);
    } else {
      part.effect->advanceSampled(*before_, state, own);
    }
  }
  before_ = &state;
  return memory_;
}

double Prediction::shown(std::size_t row) const {
  return readings[static_cast<Eigen::Index>(row)] + zeros[rows[row].channel].value_or(0.0);
}

Result<void> requireInstrument(const Machine& machine, const Measurement& measurement) {
  const Instrument& instrument = measurement.instrument;
  if (!instrument.needsAxis()) return {};
  const std::string_view kind = nameOf(instrument.kind);
  const auto refuse = [&](const std::string& text) {
    return badInput("measurement.axis", text, measurement.source);
  };
  if (!instrument.axis) return refuse(fmt::format("The instrument '{}' needs an axis.", kind));
  const int joint = machine.find(*instrument.axis);
  if (joint < 0) {
    return refuse(fmt::format("The machine '{}' has no axis {}, which the instrument '{}' looks at.",
                              machine.id(), instrument.axis->text(), kind));
  }
  if (instrument.kind == InstrumentKind::LaserLinear && machine.isRotary(joint)) {
    return refuse(fmt::format("'{}' measures a linear axis, but {} of the machine '{}' is rotary.", kind,
                              instrument.axis->text(), machine.id()));
  }
  return {};
}

std::vector<std::optional<double>> fitZeros(const Measurement& measurement,
                                            const std::vector<ReadingRow>& rows,
                                            const Eigen::VectorXd& predictions,
                                            std::span<const std::uint8_t> use) {
  std::vector<std::optional<double>> zeros(measurement.channels.size());
  if (!measurement.instrument.hasZero()) {
    std::fill(zeros.begin(), zeros.end(), 0.0);
    return zeros;
  }
  std::vector<double> sums(zeros.size());
  std::vector<double> weights(zeros.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const ReadingRow& row = rows[i];
    if (!row.value || (!use.empty() && use[i] == 0)) continue;
    const double weight = row.sigma && *row.sigma > 0.0 ? 1.0 / (*row.sigma * *row.sigma) : 1.0;
    sums[row.channel] += weight * (*row.value - predictions[static_cast<Eigen::Index>(i)]);
    weights[row.channel] += weight;
  }
  for (std::size_t k = 0; k < zeros.size(); ++k) {
    if (weights[k] > 0.0) zeros[k] = sums[k] / weights[k];
  }
  return zeros;
}

Result<Prediction> predict(const ErrorModel& model, const Measurement& measurement) {
  const Machine& machine = model.machine();
  if (Result<void> fits = requireInstrument(machine, measurement); !fits) return fits.error();
  const std::vector<MachineState> states = statesOf(measurement, machine);
  if (Result<void> known = requireColumns(model, measurement, states); !known) return known.error();
  Prediction prediction;
  prediction.rows = rowsOf(measurement);
  prediction.readings.resize(static_cast<Eigen::Index>(prediction.rows.size()));
  prediction.is_complete.assign(prediction.rows.size(), 1);
  const ReadingFunction reading(machine, measurement.instrument, measurement.channels);
  const bool own_only = measurement.instrument.kind == InstrumentKind::Joint;
  const int joint = own_only ? machine.find(*measurement.instrument.axis) : -1;
  MemoryWalk walk(model.effects());
  JointDisplacements displacements;
  std::vector<double> readings(measurement.channels.size());
  std::size_t row = 0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (!measurement.samples[i].has_positions) continue;
    const std::span<const double> memory = walk.to(states[i]);
    const std::size_t line = measurement.samples[i].line;
    const bool complete = hasConditions(model, states[i], line, prediction.warnings);
    warnOfPlace(model, states[i], line, prediction.warnings);
    model.displacements(states[i], memory, displacements);
    if (own_only) ownMotions(model, joint, states[i], memory, displacements);
    reading.read(states[i].q, displacements, readings);
    for (const double value : readings) {
      prediction.is_complete[row] = complete ? 1 : 0;
      prediction.readings[static_cast<Eigen::Index>(row++)] = value;
    }
  }
  prediction.zeros = fitZeros(measurement, prediction.rows, prediction.readings, prediction.is_complete);
  return prediction;
}

}  // namespace nineline::measurement
