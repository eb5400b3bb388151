#pragma once

#include "ui/jobs/job_runner.h"
#include "ui/pages/page.h"

class QGridLayout;
class QLabel;
class QProgressBar;
class QPushButton;

namespace nineline::widgets {
class MessageList;
class ParameterForm;
}  // namespace nineline::widgets

namespace nineline::pages {

class SetupEditor;

/// Tolerance, limits, options and machine state; starts the compensation and tells how it went.
class CompensatePage : public Page {
  Q_OBJECT

 public:
  explicit CompensatePage(Context context, QWidget* parent = nullptr);
  /// As the button does.
  void start();

 private:
  QWidget* makeOptions();
  QWidget* makeRun();
  void changeOption(const QString& key, const Json& value);
  void show(const Result<jobs::OutcomePtr>& outcome, const models::Document& of);
  void showProgress(double fraction, const QString& what, double seconds_left);
  void refresh();
  void refreshOptions();
  void showFigures();

  jobs::JobRunner runner_;
  widgets::ParameterForm* form_;
  SetupEditor* setup_;
  QPushButton* start_;
  QPushButton* cancel_;
  QPushButton* results_;
  QProgressBar* progress_;
  QLabel* remaining_;
  QLabel* headline_;
  QGridLayout* figures_;
  widgets::MessageList* messages_;
};

}  // namespace nineline::pages
