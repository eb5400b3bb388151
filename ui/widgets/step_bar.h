#pragma once

#include <QWidget>
#include <array>

#include "ui/models/workspace.h"

class QButtonGroup;
class QToolButton;

namespace nineline::widgets {

/// The wizard's steps, left to right, each with its state; any of them can be chosen at any time.
class StepBar : public QWidget {
  Q_OBJECT

 public:
  explicit StepBar(QWidget* parent = nullptr);
  /// The name of a step in the present language.
  [[nodiscard]] static QString nameOf(models::Step step);
  void setState(models::Step step, models::StepState state, const QString& explanation);
  void setCurrent(models::Step step);

 signals:
  void chosen(nineline::models::Step step);

 private:
  std::array<QToolButton*, models::kStepCount> buttons_{};
  QButtonGroup* group_;
};

}  // namespace nineline::widgets
