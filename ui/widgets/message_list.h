#pragma once

#include <QListWidget>
#include <vector>

#include "core/base/diagnostics.h"

namespace nineline::widgets {

/// Findings of a check, errors first; choosing one with a place asks to go there.
class MessageList : public QListWidget {
  Q_OBJECT

 public:
  explicit MessageList(QWidget* parent = nullptr);
  void setDiagnostics(const std::vector<Diagnostic>& diagnostics);
  void setError(const Error& error);
  void setFine(const QString& text);

 signals:
  void placeChosen(std::size_t line, std::size_t column);

 private:
  void add(const QString& text, const QString& icon, std::size_t line, std::size_t column);
};

}  // namespace nineline::widgets
