#include "ui/widgets/code_view.h"

#include <QFontDatabase>
#include <QPaintEvent>
#include <QPainter>
#include <QScrollBar>
#include <QTextBlock>

namespace nineline::widgets {

namespace {

constexpr int kMargin = 8;

class NumberArea final : public QWidget {
 public:
  explicit NumberArea(CodeView* view) : QWidget(view), view_(view) {}
  [[nodiscard]] QSize sizeHint() const override { return {view_->numberAreaWidth(), 0}; }

 protected:
  void paintEvent(QPaintEvent* event) override { view_->paintNumbers(event); }

 private:
  CodeView* view_;
};

}  // namespace

CodeView::CodeView(QWidget* parent) : QPlainTextEdit(parent), numbers_(new NumberArea(this)) {
  QFont fixed = QFontDatabase::systemFont(QFontDatabase::FixedFont);
  // The application's font may name families of its own, which would win.
  fixed.setFamilies({fixed.family(), QStringLiteral("DejaVu Sans Mono"), QStringLiteral("monospace")});
  fixed.setPointSizeF(10.5);
  setFont(fixed);
  setObjectName(QStringLiteral("codeView"));
  setLineWrapMode(QPlainTextEdit::NoWrap);
  connect(this, &QPlainTextEdit::blockCountChanged, this, &CodeView::updateMargin);
  connect(this, &QPlainTextEdit::updateRequest, this, [this](const QRect& rect, int dy) {
    if (dy != 0) {
      numbers_->scroll(0, dy);
    } else {
      numbers_->update(0, rect.y(), numbers_->width(), rect.height());
    }
  });
  connect(this, &QPlainTextEdit::cursorPositionChanged, this, [this]() {
    highlight();
    if (currentLine() == last_line_) return;
    last_line_ = currentLine();
    emit currentLineChanged(last_line_);
  });
  updateMargin();
  highlight();
}

std::size_t CodeView::currentLine() const { return static_cast<std::size_t>(textCursor().blockNumber()) + 1; }

void CodeView::goTo(std::size_t line, std::size_t column) {
  if (line == 0) return;
  const QTextBlock block = document()->findBlockByNumber(static_cast<int>(line) - 1);
  if (!block.isValid()) return;
  QTextCursor cursor(block);
  if (column > 1) {
    cursor.setPosition(block.position() + qMin(static_cast<int>(column) - 1, qMax(block.length() - 1, 0)));
  }
  setTextCursor(cursor);
  centerCursor();
}

void CodeView::markFault(std::size_t line) {
  fault_ = line;
  highlight();
  numbers_->update();
}

void CodeView::setTextKeepingPlace(const QString& text) {
  if (toPlainText() == text) return;
  const int position = textCursor().position();
  const int scroll = verticalScrollBar()->value();
  setPlainText(text);
  QTextCursor cursor = textCursor();
  cursor.setPosition(qMin(position, qMax(document()->characterCount() - 1, 0)));
  setTextCursor(cursor);
  verticalScrollBar()->setValue(scroll);
}

int CodeView::numberAreaWidth() const {
  const int digits = static_cast<int>(QString::number(qMax(blockCount(), 999)).size());
  return 2 * kMargin + fontMetrics().horizontalAdvance(QLatin1Char('9')) * digits;
}

void CodeView::updateMargin() { setViewportMargins(numberAreaWidth(), 0, 0, 0); }

void CodeView::resizeEvent(QResizeEvent* event) {
  QPlainTextEdit::resizeEvent(event);
  const QRect area = contentsRect();
  numbers_->setGeometry(area.left(), area.top(), numberAreaWidth(), area.height());
}

void CodeView::highlight() {
  QList<QTextEdit::ExtraSelection> marks;
  const auto add = [&marks](const QTextCursor& cursor, const QColor& colour) {
    QTextEdit::ExtraSelection mark;
    mark.format.setBackground(colour);
    mark.format.setProperty(QTextFormat::FullWidthSelection, true);
    mark.cursor = cursor;
    mark.cursor.clearSelection();
    marks.append(mark);
  };
  add(textCursor(), QColor(0xF6, 0xDF, 0xEB));
  if (fault_ != 0) {
    const QTextBlock block = document()->findBlockByNumber(static_cast<int>(fault_) - 1);
    if (block.isValid()) add(QTextCursor(block), QColor(0xFB, 0xD5, 0xC9));
  }
  setExtraSelections(marks);
}

void CodeView::paintNumbers(QPaintEvent* event) {
  QPainter painter(numbers_);
  painter.fillRect(event->rect(), QColor(0xEC, 0xEF, 0xF2));
  painter.setFont(font());
  QTextBlock block = firstVisibleBlock();
  QRectF place = blockBoundingGeometry(block).translated(contentOffset());
  while (block.isValid() && place.top() <= event->rect().bottom()) {
    if (block.isVisible() && place.bottom() >= event->rect().top()) {
      const auto line = static_cast<std::size_t>(block.blockNumber()) + 1;
      painter.setPen(line == fault_ ? QColor(0xB3, 0x2D, 0x0E) : QColor(0x6B, 0x75, 0x80));
      painter.drawText(QRectF(0, place.top(), numbers_->width() - kMargin, place.height()),
                       Qt::AlignRight | Qt::AlignVCenter, QString::number(line));
    }
    block = block.next();
    place = block.isValid() ? blockBoundingGeometry(block).translated(contentOffset()) : place;
  }
}

}  // namespace nineline::widgets
