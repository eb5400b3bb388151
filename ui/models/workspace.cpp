#include "ui/models/workspace.h"

#include "core/kinematics/machine_file.h"
#include "ui/models/messages.h"

namespace nineline::models {

namespace {

constexpr int kPreviewDelay_ms = 150;

Error nothingYet() { return badInput("workspace.empty", "There is nothing here yet."); }

}  // namespace

Workspace::Workspace(QObject* parent) : QObject(parent), machine_(nothingYet()), model_(nothingYet()) {
  preview_delay_.setSingleShot(true);
  preview_delay_.setInterval(kPreviewDelay_ms);
  connect(&preview_delay_, &QTimer::timeout, this, &Workspace::startPreview);
  connect(&previewer_, &jobs::JobRunner::failed, this, &Workspace::failed);
}

void Workspace::setDocument(Document document) {
  const Changes changes = differences(document_, document);
  document_ = std::move(document);
  if (changes.any()) refresh(changes);
}

void Workspace::refresh(const Changes& changes) {
  if (changes.machine) machine_ = kinematics::readMachine(document_.machine_text, "");
  if (changes.machine || changes.effects) model_ = modelOf(document_);
  if (changes.machine || changes.readings) loadReadings();
  if (changes.machine || changes.program || changes.setup) preview_delay_.start();
  if (changes.machine) emit machineChanged();
  if (changes.effects) emit effectsChanged();
  if (changes.machine || changes.readings) emit readingsChanged();
  if (changes.program) emit programChanged();
  if (changes.thread) emit threadChanged();
  if (changes.setup) emit setupChanged();
  if (changes.options) emit optionsChanged();
  emit changed();
}

void Workspace::loadReadings() {
  readings_.clear();
  for (const ReadingsFile& file : document_.readings) {
    measurement::MeasurementReadOptions options;
    options.machine = machine_ ? &*machine_ : nullptr;
    options.allow_stand_in = !machine_;
    measurement::MeasurementReading reading = measurement::readMeasurement(*file.text, file.name, options);
    readings_.push_back({file.name, std::move(reading.measurement), std::move(reading.diagnostics)});
  }
}

void Workspace::startPreview() {
  const bool possible = machine_.has_value() && document_.program != nullptr;
  const Result<simulation::ProgramSetup> setup =
      possible ? setupOf(document_, *machine_) : Result<simulation::ProgramSetup>(nothingYet());
  if (!setup) {
    previewer_.stop();
    preview_.reset();
    emit previewChanged();
    emit changed();
    return;
  }
  previewer_.run(
      [machine = *machine_, name = document_.program_name, text = document_.program, ready = *setup](
          Progress& progress) { return jobs::previewProgram(machine, name, text, ready, progress); },
      [this](jobs::ProgramPreview preview) {
        preview_ = std::move(preview);
        emit previewChanged();
        emit changed();
      });
}

void Workspace::setOutcome(jobs::OutcomePtr outcome, const Document& of) {
  outcome_ = std::move(outcome);
  outcome_document_ = of;
  emit outcomeChanged();
  emit changed();
}

bool Workspace::isOutcomeStale() const {
  const Changes changes = differences(outcome_document_, document_);
  return changes.machine || changes.effects || changes.program || changes.setup || changes.options;
}

void Workspace::setGap(jobs::GapOutcomePtr gap, const Document& of) {
  gap_ = std::move(gap);
  gap_document_ = of;
  emit gapChanged();
  emit changed();
}

bool Workspace::isGapStale() const {
  const Changes changes = differences(gap_document_, document_);
  return changes.machine || changes.effects || changes.readings;
}

StepState Workspace::state(Step step) const {
  switch (step) {
    case Step::Machine:
      if (machine_) return StepState::Ready;
      return document_.machine_text.empty() ? StepState::Missing : StepState::Faulty;
    case Step::Measurements:
      if (document_.effects.items() == nullptr || document_.effects.items()->empty()) {
        return StepState::Missing;
      }
      return model_ ? StepState::Ready : StepState::Faulty;
    case Step::Program:
      if (document_.program == nullptr) return StepState::Missing;
      return preview_ && preview_->error ? StepState::Faulty : StepState::Ready;
    case Step::ModelGap:
      if (gap_ == nullptr) return StepState::Missing;
      return isGapStale() ? StepState::Stale : StepState::Ready;
    case Step::Compensate:
    case Step::Results:
    case Step::Export:
      if (outcome_ == nullptr) return StepState::Missing;
      return isOutcomeStale() ? StepState::Stale : StepState::Ready;
  }
  return StepState::Missing;
}

QString Workspace::explanation(Step step) const {
  switch (step) {
    case Step::Machine:
      return machine_ ? QString() : messageOf(machine_.error());
    case Step::Measurements:
      if (state(step) == StepState::Missing) {
        return tr("No measured errors yet: type, paste or load them for at least one axis.");
      }
      return model_ ? QString() : messageOf(model_.error());
    case Step::Program:
      if (document_.program == nullptr) return tr("Open an NC program or generate a thread.");
      return preview_ && preview_->error ? messageOf(*preview_->error) : QString();
    case Step::ModelGap:
      if (readings_.empty()) return tr("Load readings of the corrected machine to compare with the model.");
      if (gap_ == nullptr) return tr("Start the search to see what the model lacks.");
      return isGapStale() ? tr("The model or the readings have changed since this search.") : QString();
    case Step::Compensate:
      if (state(step) == StepState::Stale) {
        return tr("Something has changed since this result was computed: start the compensation again.");
      }
      return outcome_ ? QString() : tr("Start the compensation to get the corrected program.");
    case Step::Results:
    case Step::Export:
      if (outcome_ == nullptr) return tr("There is no result yet: start the compensation first.");
      return explanation(Step::Compensate);
  }
  return {};
}

Result<jobs::CompensationInput> Workspace::compensationInput() const {
  if (!machine_) return machine_.error();
  if (!model_) return model_.error();
  if (document_.program == nullptr) return badInput("workspace.program", "There is no program yet.");
  const Result<simulation::ProgramSetup> setup = setupOf(document_, *machine_);
  if (!setup) return setup.error();
  const Result<compensation::CompensationOptions> options = optionsOf(document_);
  if (!options) return options.error();
  return jobs::CompensationInput{*model_, document_.program_name, document_.program, *setup, *options};
}

}  // namespace nineline::models
