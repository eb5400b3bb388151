#pragma once

#include "ui/jobs/job_runner.h"
#include "ui/models/found_effects_model.h"
#include "ui/pages/page.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QTableView;
class QTextBrowser;

namespace nineline::pages {

class GapChart;
class ReadingsList;

/// Where simulation and measurement disagree, what the model lacks, and the step that adds it.
class GapPage : public Page {
  Q_OBJECT

 public:
  explicit GapPage(Context context, QWidget* parent = nullptr);
  /// As the button does.
  void start();
  /// Puts the found effects into the model; one step for Undo.
  void addToModel();

 private:
  QWidget* makeLeft();
  QWidget* makeFindings();
  void show(const Result<jobs::GapOutcomePtr>& outcome, const models::Document& of);
  void refresh();
  void refreshFindings();
  void describe();

  jobs::JobRunner runner_;
  models::FoundEffectsModel* effects_;
  ReadingsList* readings_;
  GapChart* chart_;
  QTableView* table_;
  QTextBrowser* details_;
  QPushButton* start_;
  QPushButton* cancel_;
  QPushButton* add_;
  QProgressBar* progress_;
  QLabel* headline_;
  QLabel* shrink_;
};

}  // namespace nineline::pages
