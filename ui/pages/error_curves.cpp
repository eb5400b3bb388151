#include "ui/pages/error_curves.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "ui/models/path_curves.h"
#include "ui/views/chart_view.h"

namespace nineline::pages {

namespace {

constexpr int kTip = -1;

QLabel* legend(views::Role role, const QString& text, QWidget* parent) {
  return new QLabel(QStringLiteral("<span style='color:%1;font-weight:600'>━━</span> %2")
                        .arg(views::ChartView::colourOf(role), text.toHtmlEscaped()),
                    parent);
}

}  // namespace

ErrorCurves::ErrorCurves(QWidget* parent) : QWidget(parent) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* row = new QHBoxLayout;
  axis_ = new QComboBox(this);
  axis_->setObjectName(QStringLiteral("curveAxis"));
  over_ = new QComboBox(this);
  over_->addItem(tr("path length"), static_cast<int>(models::Abscissa::Length));
  over_->addItem(tr("time"), static_cast<int>(models::Abscissa::Time));
  over_->addItem(tr("axis position"), static_cast<int>(models::Abscissa::Position));
  auto* save = new QPushButton(tr("Save picture…"), this);
  connect(save, &QPushButton::clicked, this, &ErrorCurves::pictureWanted);
  row->addWidget(new QLabel(tr("Error of"), this));
  row->addWidget(axis_);
  row->addWidget(new QLabel(tr("over"), this));
  row->addWidget(over_);
  row->addStretch(1);
  row->addWidget(legend(views::Role::Before, tr("before"), this));
  row->addWidget(legend(views::Role::After, tr("after"), this));
  row->addWidget(save);
  layout->addLayout(row);
  chart_ = new views::ChartView(this);
  layout->addWidget(chart_, 1);
  connect(axis_, qOverload<int>(&QComboBox::currentIndexChanged), this, &ErrorCurves::draw);
  connect(over_, qOverload<int>(&QComboBox::currentIndexChanged), this, &ErrorCurves::draw);
}

void ErrorCurves::setOutcome(const kinematics::Machine& machine, const jobs::OutcomePtr& outcome) {
  machine_ = machine;
  outcome_ = outcome;
  {
    const QSignalBlocker blocker(axis_);
    const int index = axis_->currentIndex();
    axis_->clear();
    for (int joint = 0; joint < machine.jointCount(); ++joint) {
      axis_->addItem(tr("Axis %1").arg(QString::fromStdString(machine.joint(joint).axis.text())), joint);
    }
    axis_->addItem(tr("Tool tip"), kTip);
    axis_->setCurrentIndex(index >= 0 && index < axis_->count() ? index : 0);
  }
  draw();
}

void ErrorCurves::draw() {
  if (outcome_ == nullptr || !machine_) return;
  const int joint = axis_->currentData().toInt();
  const auto over = static_cast<models::Abscissa>(over_->currentData().toInt());
  const int at = joint < 0 ? 0 : joint;
  const QString axis = QString::fromStdString(machine_->joint(at).axis.text());
  const auto before = models::pathCurve(*machine_, outcome_->before, outcome_->before, joint, over);
  const auto after = models::pathCurve(*machine_, outcome_->after, outcome_->before, joint, over);
  QString x_title = QStringLiteral("s / mm");
  if (over == models::Abscissa::Time) x_title = QStringLiteral("t / s");
  if (over == models::Abscissa::Position) {
    x_title = axis + (machine_->isRotary(at) ? QStringLiteral(" / deg") : QStringLiteral(" / mm"));
  }
  const bool rotary = joint >= 0 && machine_->isRotary(joint);
  const QString y_title = (joint < 0 ? QStringLiteral("|d|") : QStringLiteral("E(%1)").arg(axis)) +
                          (rotary ? QStringLiteral(" / arcsec") : QStringLiteral(" / µm"));
  chart_->show(x_title, y_title,
               {{views::Role::Before, before.x, before.y}, {views::Role::After, after.x, after.y}});
}

void ErrorCurves::savePicture(const QString& path) const {
  if (!path.isEmpty()) chart_->picture().save(path, "PNG");
}

}  // namespace nineline::pages
