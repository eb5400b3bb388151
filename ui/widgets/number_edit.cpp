#include "ui/widgets/number_edit.h"

#include <QStyle>

#include "ui/models/spreadsheet.h"

namespace nineline::widgets {

NumberEdit::NumberEdit(QWidget* parent) : QLineEdit(parent) {
  setAlignment(Qt::AlignRight);
  connect(this, &QLineEdit::textChanged, this, &NumberEdit::mark);
  connect(this, &QLineEdit::editingFinished, this, [this]() {
    if (text() == last_) return;
    last_ = text();
    emit edited(cell());
  });
}

void NumberEdit::setCell(const Json& cell) {
  const QString text_of_cell = models::typedFromCell(cell);
  last_ = text_of_cell;
  if (text() != text_of_cell) setText(text_of_cell);
  mark();
}

Json NumberEdit::cell() const { return models::cellFromTyped(text()); }

std::optional<double> NumberEdit::number() const { return models::numberFromTyped(text()); }

void NumberEdit::setFault(const QString& fault) {
  fault_ = fault;
  mark();
}

void NumberEdit::mark() {
  QString fault = fault_;
  if (text().trimmed().isEmpty()) {
    if (!optional_) fault = tr("A number is missing here.");
  } else if (!number()) {
    fault = tr("'%1' is no number. Type digits, with a point or a comma.").arg(text());
  }
  setToolTip(fault);
  if (property("bad").toBool() == !fault.isEmpty()) return;
  setProperty("bad", !fault.isEmpty());
  style()->unpolish(this);
  style()->polish(this);
}

}  // namespace nineline::widgets
