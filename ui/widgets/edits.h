#pragma once

#include <QObject>
#include <QString>
#include <QUndoStack>

#include "ui/models/workspace.h"

namespace nineline::widgets {

/// Every change that a person makes to the document goes through here, so that it can be undone.
class Edits : public QObject {
  Q_OBJECT

 public:
  explicit Edits(models::Workspace* workspace, QObject* parent = nullptr);
  /// Replaces the document as one step called `text`. Steps that follow each other with the same key (the
  /// typing into one field) become one.
  void apply(const QString& text, models::Document next, const QString& key = {});
  [[nodiscard]] QUndoStack& stack() { return stack_; }
  [[nodiscard]] const models::Document& document() const { return workspace_->document(); }

 private:
  models::Workspace* workspace_;
  QUndoStack stack_;
};

}  // namespace nineline::widgets
