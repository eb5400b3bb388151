#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <optional>
#include <vector>

#include "core/measurement/measurement_file.h"
#include "ui/jobs/compensation_job.h"
#include "ui/jobs/gap_job.h"
#include "ui/jobs/job_runner.h"
#include "ui/models/document.h"

namespace nineline::models {

/// The steps of the wizard, left to right.
enum class Step { Machine, Measurements, Program, Compensate, Results, ModelGap, Export };
inline constexpr int kStepCount = 7;

enum class StepState {
  Missing,  ///< something has to be done here first
  Ready,
  Stale,  ///< done, and what it was done with has changed since
  Faulty  ///< what stands here cannot be used; the step says why
};

/// A file of readings as this machine understands it. Usable where `diagnostics` has no errors.
struct LoadedReadings {
  std::string name;
  measurement::Measurement measurement;
  Diagnostics diagnostics;
  [[nodiscard]] bool isUsable() const { return !diagnostics.hasErrors(); }
};

/// The document that is open, what follows from it, and the last result. Pages read it and listen.
class Workspace : public QObject {
  Q_OBJECT

 public:
  explicit Workspace(QObject* parent = nullptr);

  [[nodiscard]] const Document& document() const { return document_; }
  /// Replaces the document; tells what changed. Undo commands and file commands call this, pages do not.
  void setDocument(Document document);

  [[nodiscard]] const Result<kinematics::Machine>& machine() const { return machine_; }
  [[nodiscard]] const Result<errors::ErrorModel>& model() const { return model_; }
  /// The files of readings, in the document's order.
  [[nodiscard]] const std::vector<LoadedReadings>& readings() const { return readings_; }
  [[nodiscard]] const jobs::ProgramPreview* preview() const { return preview_ ? &*preview_ : nullptr; }

  [[nodiscard]] jobs::OutcomePtr outcome() const { return outcome_; }
  /// The result of `of`; it is stale as soon as the document differs in what a result depends on.
  void setOutcome(jobs::OutcomePtr outcome, const Document& of);
  [[nodiscard]] bool isOutcomeStale() const;
  [[nodiscard]] const Document& outcomeDocument() const { return outcome_document_; }

  [[nodiscard]] jobs::GapOutcomePtr gap() const { return gap_; }
  void setGap(jobs::GapOutcomePtr gap, const Document& of);
  [[nodiscard]] bool isGapStale() const;

  [[nodiscard]] StepState state(Step step) const;
  /// What is wrong with a step, for people; empty when nothing is.
  [[nodiscard]] QString explanation(Step step) const;

  /// All that a compensation needs, or what prevents it.
  [[nodiscard]] Result<jobs::CompensationInput> compensationInput() const;
  /// The folder that file dialogs start in.
  QString folder;

 signals:
  void machineChanged();
  void effectsChanged();
  void readingsChanged();
  void programChanged();
  void threadChanged();
  void setupChanged();
  void optionsChanged();
  /// The ideal path of the program was computed anew (or is gone).
  void previewChanged();
  void outcomeChanged();
  void gapChanged();
  /// Any of the above: step states may differ.
  void changed();
  void failed(const QString& text);

 private:
  void refresh(const Changes& changes);
  void startPreview();
  void loadReadings();
  Document document_;
  Result<kinematics::Machine> machine_;
  Result<errors::ErrorModel> model_;
  std::optional<jobs::ProgramPreview> preview_;
  jobs::OutcomePtr outcome_;
  Document outcome_document_;
  std::vector<LoadedReadings> readings_;
  jobs::GapOutcomePtr gap_;
  Document gap_document_;
  jobs::JobRunner previewer_;
  QTimer preview_delay_;
};

}  // namespace nineline::models
