#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace nineline::project {

/// What a project keeps by name, one content for each name. A machine has the empty name; a setting is the
/// state of the wizard or a preference of this project, never a secret.
enum class DocumentKind { Machine, Measurement, Program, Setting };

/// "machine", "measurement 'z.csv'": for messages and lists.
[[nodiscard]] std::string describe(DocumentKind kind, const std::string& name);

/// A document's new content; without content the document is removed.
struct DocumentChange {
  DocumentKind kind = DocumentKind::Setting;
  std::string name;
  std::optional<std::string> content;
};

/// A new version of the error model: JSON text, and why it was made.
struct NewModel {
  std::string text;
  std::string note;
};

/// What a verb found: its kind ("compensate", "identify"), the result record as JSON text, and bytes that
/// belong to it (a corrected program, a picture); both may be empty.
struct NewResult {
  std::string kind;
  std::string record;
  std::string bytes;
};

/// What one save writes, all of it or nothing. Contents come back byte for byte.
class Change {
 public:
  Change& setMachine(std::string text) { return put(DocumentKind::Machine, {}, std::move(text)); }
  Change& put(DocumentKind kind, std::string name, std::string content);
  Change& remove(DocumentKind kind, std::string name);
  /// The new version's parent is the one that is current in the window that saves; it becomes the current
  /// one.
  Change& addModel(std::string text, std::string note);
  /// Goes back (or forward) to a version of the history. No version is ever changed or removed.
  Change& selectModel(std::int64_t id);
  Change& addResult(std::string kind, std::string record, std::string bytes = {});
  Change& removeResult(std::int64_t id);

  [[nodiscard]] const std::vector<DocumentChange>& documents() const { return documents_; }
  [[nodiscard]] const std::vector<NewModel>& models() const { return models_; }
  [[nodiscard]] const std::vector<NewResult>& results() const { return results_; }
  [[nodiscard]] const std::vector<std::int64_t>& removedResults() const { return removed_results_; }
  [[nodiscard]] std::optional<std::int64_t> selectedModel() const { return selected_model_; }

  /// Refuses names that a list cannot show, and settings that look like a secret: a key that names a
  /// password, a token or the like, or an address with a password in it.
  [[nodiscard]] Result<void> check() const;

 private:
  std::vector<DocumentChange> documents_;
  std::vector<NewModel> models_;
  std::vector<NewResult> results_;
  std::vector<std::int64_t> removed_results_;
  std::optional<std::int64_t> selected_model_;
};

}  // namespace nineline::project
