#pragma once

#include <QWidget>

#include "ui/models/document.h"
#include "ui/models/readings_model.h"

class QTableView;
class QPushButton;

namespace nineline::pages {

/// The project's files of readings: add, remove, choose one.
class ReadingsList : public QWidget {
  Q_OBJECT

 public:
  explicit ReadingsList(models::Workspace& workspace, QWidget* parent = nullptr);
  /// Index of the chosen file; −1: none.
  [[nodiscard]] int current() const;

 signals:
  void currentChanged(int file);
  /// The person added or removed files; to be made a step of Undo.
  void readingsEdited(const QString& text, const std::vector<nineline::models::ReadingsFile>& readings);
  void failed(const nineline::Error& error);

 private:
  void addFiles();
  void removeCurrent();
  models::Workspace& workspace_;
  models::ReadingsModel* model_;
  QTableView* table_;
  QPushButton* remove_;
};

}  // namespace nineline::pages
