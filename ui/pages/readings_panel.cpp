#include "ui/pages/readings_panel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSplitter>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/models/reading_columns.h"
#include "ui/pages/readings_list.h"
#include "ui/views/chart_view.h"
#include "ui/widgets/message_list.h"

namespace nineline::pages {

ReadingsPanel::ReadingsPanel(models::Workspace& workspace, QWidget* parent)
    : QWidget(parent), workspace_(workspace) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 4, 0, 0);
  auto* splitter = new QSplitter(this);
  auto* left = new QSplitter(Qt::Vertical, splitter);
  list_ = new ReadingsList(workspace, left);
  messages_ = new widgets::MessageList(left);
  left->addWidget(list_);
  left->addWidget(messages_);
  left->setSizes({420, 160});
  splitter->addWidget(left);
  splitter->addWidget(makeChart());
  splitter->setStretchFactor(1, 1);
  splitter->setSizes({520, 730});
  layout->addWidget(splitter);
  connect(list_, &ReadingsList::currentChanged, this, &ReadingsPanel::showFile);
  connect(list_, &ReadingsList::readingsEdited, this, &ReadingsPanel::readingsEdited);
  connect(list_, &ReadingsList::failed, this, &ReadingsPanel::failed);
  showFile();
}

QWidget* ReadingsPanel::makeChart() {
  auto* panel = new QWidget(this);
  auto* layout = new QVBoxLayout(panel);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* row = new QHBoxLayout;
  channel_ = new QComboBox(panel);
  channel_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  over_ = new QComboBox(panel);
  over_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  row->addWidget(new QLabel(tr("Readings"), panel));
  row->addWidget(channel_);
  row->addWidget(new QLabel(tr("over"), panel));
  row->addWidget(over_);
  row->addStretch(1);
  layout->addLayout(row);
  chart_ = new views::ChartView(panel);
  layout->addWidget(chart_, 1);
  connect(channel_, qOverload<int>(&QComboBox::currentIndexChanged), this, &ReadingsPanel::draw);
  connect(over_, qOverload<int>(&QComboBox::currentIndexChanged), this, &ReadingsPanel::draw);
  return panel;
}

const models::LoadedReadings* ReadingsPanel::current() const {
  const int file = list_->current();
  const auto& readings = workspace_.readings();
  return file >= 0 && file < static_cast<int>(readings.size()) ? &readings[static_cast<std::size_t>(file)]
                                                               : nullptr;
}

void ReadingsPanel::showFile() {
  const models::LoadedReadings* file = current();
  {
    const QSignalBlocker block_over(over_);
    const QSignalBlocker block_channel(channel_);
    over_->clear();
    channel_->clear();
    if (file != nullptr && file->isUsable() && workspace_.machine()) {
      for (const std::string& column : models::variableColumns(*workspace_.machine(), file->measurement)) {
        over_->addItem(QString::fromStdString(models::columnTitle(column)), QString::fromStdString(column));
      }
      for (const measurement::Channel& channel : file->measurement.channels) {
        channel_->addItem(QString::fromStdString(channel.column()));
      }
    }
  }
  if (file == nullptr) {
    messages_->clear();
  } else if (file->diagnostics.all().empty()) {
    messages_->setFine(tr("The file was read without a doubt."));
  } else {
    messages_->setDiagnostics(file->diagnostics.all());
  }
  draw();
}

void ReadingsPanel::draw() {
  const models::LoadedReadings* file = current();
  if (file == nullptr || !file->isUsable() || over_->count() == 0) return chart_->show({}, {}, {});
  const auto channel = static_cast<std::size_t>(std::max(0, channel_->currentIndex()));
  const std::string column = over_->currentData().toString().toStdString();
  const measurement::Measurement& measurement = file->measurement;
  views::Curve dots{views::Role::DotsAfter, {}, {}};
  for (std::size_t i = 0; i < measurement.samples.size(); ++i) {
    const std::optional<double> x = models::columnValue(*workspace_.machine(), measurement, column, i);
    const std::optional<double>& reading = measurement.reading(i, channel);
    if (!x || !reading) continue;
    dots.x.push_back(*x);
    dots.y.push_back(measurement::shownReading(measurement.channels[channel], *reading));
  }
  const bool angular = measurement.channels[channel].isAngular();
  chart_->show(QString::fromStdString(models::columnTitle(column)),
               angular ? QStringLiteral("d / arcsec") : QStringLiteral("d / µm"), {std::move(dots)});
}

}  // namespace nineline::pages
