#include "ui/widgets/cell_table.h"

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QStyledItemDelegate>
#include <algorithm>

namespace nineline::widgets {

namespace {

constexpr int kRowHeight = 32;

/// Marks bad cells and gives every cell a plain editor, so that what is typed is kept even where it is wrong.
class CellDelegate final : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem&, const QModelIndex&) const override {
    auto* edit = new QLineEdit(parent);
    edit->setFrame(false);
    edit->setAlignment(Qt::AlignRight);
    return edit;
  }

 protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
    QStyledItemDelegate::initStyleOption(option, index);
    if (index.data(Qt::UserRole).toBool()) {
      option->backgroundBrush = QColor(0xFB, 0xD5, 0xC9);
      option->palette.setColor(QPalette::Text, QColor(0x8C, 0x1D, 0x04));
    } else if ((index.flags() & Qt::ItemIsEditable) == 0) {
      option->palette.setColor(QPalette::Text, QColor(0x5B, 0x66, 0x70));
    }
  }
};

}  // namespace

CellTable::CellTable(QWidget* parent) : QTableView(parent) {
  setItemDelegate(new CellDelegate(this));
  setEditTriggers(QAbstractItemView::AnyKeyPressed | QAbstractItemView::EditKeyPressed |
                  QAbstractItemView::DoubleClicked);
  verticalHeader()->setDefaultSectionSize(kRowHeight);
  horizontalHeader()->setStretchLastSection(true);
  setAlternatingRowColors(true);
}

void CellTable::keyPressEvent(QKeyEvent* event) {
  if (state() == QAbstractItemView::EditingState) return QTableView::keyPressEvent(event);
  if (event->matches(QKeySequence::Paste)) {
    emit pasted(QApplication::clipboard()->text(), std::max(currentIndex().row(), 0));
    return;
  }
  if (event->matches(QKeySequence::Copy)) return copy();
  if (event->key() == Qt::Key_Delete || event->key() == Qt::Key_Backspace) {
    const QModelIndexList selected = selectedIndexes();
    if (selected.isEmpty()) return;
    const auto [first, last] = std::minmax_element(
        selected.begin(), selected.end(),
        [](const QModelIndex& one, const QModelIndex& other) { return one.row() < other.row(); });
    emit cleared(first->row(), last->row());
    return;
  }
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) return goDown();
  QTableView::keyPressEvent(event);
}

void CellTable::closeEditor(QWidget* editor, QAbstractItemDelegate::EndEditHint hint) {
  QTableView::closeEditor(editor, hint);
  if (hint == QAbstractItemDelegate::SubmitModelCache) goDown();
}

void CellTable::goDown() {
  const QModelIndex below = currentIndex().siblingAtColumn(currentIndex().column());
  if (below.isValid() && below.row() + 1 < model()->rowCount()) {
    setCurrentIndex(model()->index(below.row() + 1, below.column()));
  }
}

void CellTable::copy() const {
  QModelIndexList selected = selectedIndexes();
  if (selected.isEmpty()) return;
  std::sort(selected.begin(), selected.end());
  QString text;
  int row = selected.front().row();
  for (int i = 0; i < selected.size(); ++i) {
    if (i > 0) text += selected[i].row() == row ? QLatin1Char('\t') : QLatin1Char('\n');
    row = selected[i].row();
    text += selected[i].data().toString();
  }
  QApplication::clipboard()->setText(text);
}

}  // namespace nineline::widgets
