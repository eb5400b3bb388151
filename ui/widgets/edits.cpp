#include "ui/widgets/edits.h"

#include <QUndoCommand>

namespace nineline::widgets {

namespace {

constexpr int kMostSteps = 200;
constexpr int kMergeId = 1;

class DocumentCommand final : public QUndoCommand {
 public:
  DocumentCommand(models::Workspace* workspace, const QString& text, models::Document next, QString key)
      : QUndoCommand(text),
        workspace_(workspace),
        before_(workspace->document()),
        after_(std::move(next)),
        key_(std::move(key)) {}

  void undo() override { workspace_->setDocument(before_); }
  void redo() override { workspace_->setDocument(after_); }
  [[nodiscard]] int id() const override { return key_.isEmpty() ? -1 : kMergeId; }
  bool mergeWith(const QUndoCommand* other) override {
    const auto* next = static_cast<const DocumentCommand*>(other);
    if (next->key_ != key_) return false;
    after_ = next->after_;
    return true;
  }

 private:
  models::Workspace* workspace_;
  models::Document before_;
  models::Document after_;
  QString key_;
};

}  // namespace

Edits::Edits(models::Workspace* workspace, QObject* parent) : QObject(parent), workspace_(workspace) {
  stack_.setUndoLimit(kMostSteps);
}

void Edits::apply(const QString& text, models::Document next, const QString& key) {
  if (!models::differences(workspace_->document(), next).any()) return;
  stack_.push(new DocumentCommand(workspace_, text, std::move(next), key));
}

}  // namespace nineline::widgets
