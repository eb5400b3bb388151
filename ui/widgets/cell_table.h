#pragma once

#include <QAbstractItemDelegate>
#include <QString>
#include <QTableView>

namespace nineline::widgets {

/// A table for typing: Return goes down, a key starts editing, copy and paste speak the language of
/// spreadsheets. Cells whose Qt::UserRole is true are marked.
class CellTable : public QTableView {
  Q_OBJECT

 public:
  explicit CellTable(QWidget* parent = nullptr);

 signals:
  /// Text from the clipboard, for the row of the cursor.
  void pasted(const QString& text, int row);
  void cleared(int first_row, int last_row);

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void closeEditor(QWidget* editor, QAbstractItemDelegate::EndEditHint hint) override;

 private:
  void copy() const;
  void goDown();
};

}  // namespace nineline::widgets
