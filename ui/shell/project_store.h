#pragma once

#include <QString>
#include <memory>

#include "core/project/project_file.h"
#include "ui/models/workspace.h"

namespace nineline::shell {

/// Keeps the document in a `.nineline` file: machine, every version of the error model, program, results and
/// the wizard's settings.
class ProjectStore {
 public:
  /// Opens a project and reads its document; refuses a damaged or newer one.
  [[nodiscard]] Result<models::Document> open(const QString& path);
  /// Writes the document to the open file.
  [[nodiscard]] Result<void> save(const models::Document& document, const jobs::OutcomePtr& outcome);
  /// Makes a new file (an existing one is replaced only when that succeeds) and stays with it.
  [[nodiscard]] Result<void> saveAs(const QString& path, const models::Document& document,
                                    const jobs::OutcomePtr& outcome);
  /// Lets the next save write over what another window saved in the meantime.
  [[nodiscard]] Result<void> takeNote() { return file_->reload(); }
  void close() { file_.reset(); }

  [[nodiscard]] bool isOpen() const { return file_ != nullptr; }
  [[nodiscard]] bool isReadOnly() const { return file_ != nullptr && file_->isReadOnly(); }
  [[nodiscard]] QString path() const;

 private:
  [[nodiscard]] Result<void> write(project::ProjectFile& file, const models::Document& document,
                                   const jobs::OutcomePtr& outcome);
  std::unique_ptr<project::ProjectFile> file_;
  models::Document saved_;
  jobs::OutcomePtr saved_outcome_;
};

}  // namespace nineline::shell
