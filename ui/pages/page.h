#pragma once

#include <QString>
#include <QWidget>

#include "ui/models/workspace.h"
#include "ui/widgets/edits.h"

class QLabel;

namespace nineline::pages {

/// What every page works on.
struct Context {
  models::Workspace* workspace = nullptr;
  widgets::Edits* edits = nullptr;
};

/// A page of the wizard: a title line with what to do, and its content below.
class Page : public QWidget {
  Q_OBJECT

 public:
  Page(Context context, const QString& advice, QWidget* parent);

 signals:
  /// The person wants to go to another step.
  void stepWanted(nineline::models::Step step);

 protected:
  [[nodiscard]] models::Workspace& workspace() const { return *context_.workspace; }
  [[nodiscard]] const models::Document& document() const { return context_.workspace->document(); }
  /// Replaces the document; one step for Undo.
  void edit(const QString& text, models::Document next, const QString& key = {}) const;
  /// The area that a page fills.
  [[nodiscard]] QWidget* body() const { return body_; }
  void setAdvice(const QString& text);

  /// Asks for a file to read; empty when the person gave up. Remembers the folder.
  [[nodiscard]] QString askOpen(const QString& title, const QString& filter);
  [[nodiscard]] QString askSave(const QString& title, const QString& name, const QString& filter);
  void showError(const QString& title, const Error& error);

 private:
  Context context_;
  QLabel* advice_;
  QWidget* body_;
};

}  // namespace nineline::pages
