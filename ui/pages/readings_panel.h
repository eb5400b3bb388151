#pragma once

#include <QWidget>

#include "ui/models/workspace.h"

class QComboBox;

namespace nineline::views {
class ChartView;
}
namespace nineline::widgets {
class MessageList;
}

namespace nineline::pages {

class ReadingsList;

/// Raw readings of the instruments: the files, what is in them as a curve, and what is doubtful about them.
class ReadingsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ReadingsPanel(models::Workspace& workspace, QWidget* parent = nullptr);

 signals:
  void readingsEdited(const QString& text, const std::vector<nineline::models::ReadingsFile>& readings);
  void failed(const nineline::Error& error);

 private:
  QWidget* makeChart();
  void showFile();
  void draw();
  [[nodiscard]] const models::LoadedReadings* current() const;

  models::Workspace& workspace_;
  ReadingsList* list_;
  QComboBox* channel_;
  QComboBox* over_;
  views::ChartView* chart_;
  widgets::MessageList* messages_;
};

}  // namespace nineline::pages
