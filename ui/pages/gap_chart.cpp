#include "ui/pages/gap_chart.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "core/base/units.h"
#include "ui/models/reading_columns.h"
#include "ui/views/chart_view.h"

namespace nineline::pages {

namespace {

constexpr double kBandSigmas = 2.0;

QLabel* legend(views::Role role, const QString& text, QWidget* parent) {
  return new QLabel(QStringLiteral("<span style='color:%1;font-weight:600'>●</span> %2")
                        .arg(views::ChartView::colourOf(role), text.toHtmlEscaped()),
                    parent);
}

}  // namespace

/// The residuals of one channel over one column, in µm or arcsec.
struct GapChart::Plot {
  views::Curve before{views::Role::DotsBefore, {}, {}};
  views::Curve after{views::Role::DotsAfter, {}, {}};
  double sigma = 0.0;
  double x_low = 0.0, x_high = 0.0, y_low = 0.0, y_high = 0.0;

  void add(double x, double first, double last) {
    before.x.push_back(x);
    before.y.push_back(first);
    after.x.push_back(x);
    after.y.push_back(last);
  }
  void measure() {
    if (before.x.empty()) return;
    std::tie(x_low, x_high) = rangeOf(before.x);
    const auto [low, high] = rangeOf(before.y);
    const auto [low_after, high_after] = rangeOf(after.y);
    y_low = std::min({low, low_after, -kBandSigmas * sigma});
    y_high = std::max({high, high_after, kBandSigmas * sigma});
  }
  static std::pair<double, double> rangeOf(const std::vector<double>& values) {
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    return {*low, *high};
  }
};

GapChart::GapChart(QWidget* parent) : QWidget(parent) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* row = new QHBoxLayout;
  file_ = new QComboBox(this);
  file_->setObjectName(QStringLiteral("gapFile"));
  file_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  channel_ = new QComboBox(this);
  channel_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  over_ = new QComboBox(this);
  over_->setObjectName(QStringLiteral("gapOver"));
  over_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  auto* save = new QPushButton(tr("Save picture…"), this);
  connect(save, &QPushButton::clicked, this, &GapChart::pictureWanted);
  row->addWidget(new QLabel(tr("Reading − model:"), this));
  row->addWidget(file_);
  row->addWidget(channel_);
  row->addWidget(new QLabel(tr("over"), this));
  row->addWidget(over_);
  row->addStretch(1);
  row->addWidget(legend(views::Role::DotsBefore, tr("before"), this));
  row->addWidget(legend(views::Role::DotsAfter, tr("after"), this));
  row->addWidget(save);
  layout->addLayout(row);
  chart_ = new views::ChartView(this);
  layout->addWidget(chart_, 1);
  connect(file_, qOverload<int>(&QComboBox::currentIndexChanged), this, &GapChart::refillColumns);
  connect(channel_, qOverload<int>(&QComboBox::currentIndexChanged), this, &GapChart::draw);
  connect(over_, qOverload<int>(&QComboBox::currentIndexChanged), this, &GapChart::draw);
}

void GapChart::show(const models::Workspace& workspace) {
  workspace_ = &workspace;
  {
    const QSignalBlocker blocker(file_);
    const QString chosen = file_->currentText();
    file_->clear();
    for (const models::LoadedReadings& readings : workspace.readings()) {
      if (readings.isUsable()) file_->addItem(QString::fromStdString(readings.name));
    }
    file_->setCurrentIndex(std::max(0, file_->findText(chosen)));
  }
  refillColumns();
}

const measurement::Measurement* GapChart::measurement() const {
  if (workspace_ == nullptr) return nullptr;
  for (const models::LoadedReadings& readings : workspace_->readings()) {
    if (readings.isUsable() && QString::fromStdString(readings.name) == file_->currentText()) {
      return &readings.measurement;
    }
  }
  return nullptr;
}

void GapChart::refillColumns() {
  const measurement::Measurement* shown = measurement();
  const QSignalBlocker block_over(over_);
  const QSignalBlocker block_channel(channel_);
  const QString column = over_->currentData().toString();
  over_->clear();
  channel_->clear();
  if (shown != nullptr && workspace_->machine()) {
    for (const std::string& name : models::variableColumns(*workspace_->machine(), *shown)) {
      over_->addItem(QString::fromStdString(models::columnTitle(name)), QString::fromStdString(name));
    }
    for (const measurement::Channel& channel : shown->channels) {
      channel_->addItem(QString::fromStdString(channel.column()));
    }
  }
  channel_->setVisible(channel_->count() > 1);
  over_->setCurrentIndex(std::max(0, over_->findData(column)));
  draw();
}

void GapChart::draw() {
  const measurement::Measurement* shown = measurement();
  const jobs::GapOutcomePtr gap = workspace_ == nullptr ? nullptr : workspace_->gap();
  if (shown == nullptr || gap == nullptr || workspace_->isGapStale() ||
      static_cast<std::size_t>(file_->currentIndex()) >= gap->residuals.size()) {
    return chart_->show({}, {}, {});
  }
  const jobs::Residuals& residuals = gap->residuals[static_cast<std::size_t>(file_->currentIndex())];
  const auto channel = static_cast<std::size_t>(std::max(0, channel_->currentIndex()));
  const std::string column = over_->currentData().toString().toStdString();
  const bool angular = shown->channels[channel].isAngular();
  const double unit = angular ? arcsecFromRad(1.0) : umFromMm(1.0);
  Plot plot;
  for (std::size_t i = 0; i < residuals.rows.size(); ++i) {
    if (residuals.rows[i].channel != channel) continue;
    const auto x = models::columnValue(*workspace_->machine(), *shown, column, residuals.rows[i].sample);
    const auto row = static_cast<Eigen::Index>(i);
    if (x) plot.add(*x, residuals.before[row] * unit, residuals.after[row] * unit);
    plot.sigma = std::max(plot.sigma, residuals.rows[i].sigma.value_or(0.0) * unit);
  }
  plot.measure();
  std::vector<views::Frame> frames = {{views::Frame::Meaning::Repeatability, plot.x_low, plot.x_high,
                                       -kBandSigmas * plot.sigma, kBandSigmas * plot.sigma}};
  for (const discovery::Place& place : gap->report.where) {
    for (const discovery::Condition& condition : place.conditions) {
      if (condition.variable != column) continue;
      frames.push_back({views::Frame::Meaning::Place, std::max(condition.low, plot.x_low),
                        std::min(condition.high, plot.x_high), plot.y_low, plot.y_high});
    }
  }
  chart_->show(QString::fromStdString(models::columnTitle(column)),
               angular ? QStringLiteral("d / arcsec") : QStringLiteral("d / µm"),
               {std::move(plot.before), std::move(plot.after)}, frames);
}

void GapChart::savePicture(const QString& path) const {
  if (!path.isEmpty()) chart_->picture().save(path, "PNG");
}

}  // namespace nineline::pages
