#include "ui/widgets/step_bar.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QIcon>
#include <QKeySequence>
#include <QToolButton>

namespace nineline::widgets {

namespace {

using models::Step;
using models::StepState;

constexpr int kIconSize = 18;

QString wordFor(StepState state) {
  switch (state) {
    case StepState::Missing:
      return StepBar::tr("missing");
    case StepState::Ready:
      return StepBar::tr("ready");
    case StepState::Stale:
      return StepBar::tr("stale");
    case StepState::Faulty:
      return StepBar::tr("check");
  }
  return {};
}

QIcon iconFor(StepState state) {
  switch (state) {
    case StepState::Missing:
      return QIcon(QStringLiteral(":/icons/state-missing.svg"));
    case StepState::Ready:
      return QIcon(QStringLiteral(":/icons/state-ready.svg"));
    case StepState::Stale:
      return QIcon(QStringLiteral(":/icons/state-stale.svg"));
    case StepState::Faulty:
      return QIcon(QStringLiteral(":/icons/state-faulty.svg"));
  }
  return {};
}

}  // namespace

QString StepBar::nameOf(Step step) {
  switch (step) {
    case Step::Machine:
      return tr("Machine");
    case Step::Measurements:
      return tr("Measurements");
    case Step::Program:
      return tr("Program");
    case Step::Compensate:
      return tr("Compensate");
    case Step::Results:
      return tr("Results");
    case Step::ModelGap:
      return tr("Model gap");
    case Step::Export:
      return tr("Export");
  }
  return {};
}

StepBar::StepBar(QWidget* parent) : QWidget(parent), group_(new QButtonGroup(this)) {
  setObjectName(QStringLiteral("stepBar"));
  setAttribute(Qt::WA_StyledBackground);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(4, 6, 4, 6);
  layout->setSpacing(2);
  group_->setExclusive(true);
  for (int i = 0; i < models::kStepCount; ++i) {
    auto* button = new QToolButton(this);
    button->setCheckable(true);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setIconSize(QSize(kIconSize, kIconSize));
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    button->setShortcut(QKeySequence(QStringLiteral("Ctrl+%1").arg(i + 1)));
    button->setFocusPolicy(Qt::StrongFocus);
    button->setObjectName(QStringLiteral("step%1").arg(i));
    layout->addWidget(button);
    group_->addButton(button, i);
    buttons_[static_cast<std::size_t>(i)] = button;
    connect(button, &QToolButton::clicked, this, [this, i]() { emit chosen(static_cast<Step>(i)); });
    setState(static_cast<Step>(i), StepState::Missing, {});
  }
}

void StepBar::setState(Step step, StepState state, const QString& explanation) {
  const int i = static_cast<int>(step);
  QToolButton* button = buttons_[static_cast<std::size_t>(i)];
  button->setIcon(iconFor(state));
  const QKeySequence shortcut = button->shortcut();
  button->setText(QStringLiteral(" %1  %2\n %3").arg(i + 1).arg(nameOf(step), wordFor(state)));
  button->setShortcut(shortcut);
  button->setToolTip(explanation.isEmpty() ? wordFor(state) : explanation);
  button->setAccessibleName(nameOf(step));
  button->setAccessibleDescription(wordFor(state));
}

void StepBar::setCurrent(Step step) { buttons_[static_cast<std::size_t>(step)]->setChecked(true); }

}  // namespace nineline::widgets
