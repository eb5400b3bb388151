#include "ui/widgets/message_list.h"

#include <QIcon>

#include "ui/models/messages.h"

namespace nineline::widgets {

MessageList::MessageList(QWidget* parent) : QListWidget(parent) {
  setWordWrap(true);
  setTextElideMode(Qt::ElideNone);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setResizeMode(QListView::Adjust);
  connect(this, &QListWidget::itemClicked, this, [this](const QListWidgetItem* item) {
    const auto line = item->data(Qt::UserRole).toULongLong();
    const auto column = item->data(Qt::UserRole + 1).toULongLong();
    if (line != 0) emit placeChosen(line, column);
  });
}

void MessageList::add(const QString& text, const QString& icon, std::size_t line, std::size_t column) {
  auto* item = new QListWidgetItem(QIcon(icon), text, this);
  item->setToolTip(text);
  item->setData(Qt::UserRole, static_cast<qulonglong>(line));
  item->setData(Qt::UserRole + 1, static_cast<qulonglong>(column));
}

void MessageList::setDiagnostics(const std::vector<Diagnostic>& diagnostics) {
  clear();
  for (const Severity severity : {Severity::Error, Severity::Warning}) {
    for (const Diagnostic& one : diagnostics) {
      if (one.severity != severity) continue;
      add(models::messageOf(one),
          severity == Severity::Error ? QStringLiteral(":/icons/state-faulty.svg")
                                      : QStringLiteral(":/icons/state-stale.svg"),
          one.line, one.column);
    }
  }
}

void MessageList::setError(const Error& error) {
  clear();
  add(models::messageOf(error), QStringLiteral(":/icons/state-faulty.svg"), error.line, error.column);
}

void MessageList::setFine(const QString& text) {
  clear();
  add(text, QStringLiteral(":/icons/state-ready.svg"), 0, 0);
}

}  // namespace nineline::widgets
