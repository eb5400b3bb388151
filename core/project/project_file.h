#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/diagnostics.h"
#include "core/base/result.h"
#include "core/project/change.h"
#include "core/project/history.h"
#include "core/project/save.h"

namespace nineline::project {

/// The open `.nineline` file of one window: a machine, measurements, every version of the error model,
/// programs, results and settings. It keeps texts and bytes; what they mean is for the readers of the nouns.
///
/// A save is on the disk, whole, when `save` returns; a crash at any moment leaves the last save. Several
/// windows may have one file open: each may write over what it has seen (at `open`, at `reload`, by its own
/// saves), never over what another wrote since. New model versions and results never collide.
///
/// Not for use by two threads at once. Every failure comes back as an Error of kind BadInput whose code
/// begins with `project.` or `file.`; after it, the file is as it was.
class ProjectFile {
 public:
  /// A new, empty project. Refused with `project.exists` where a file stands already.
  [[nodiscard]] static Result<ProjectFile> create(const std::filesystem::path& path);
  /// Reads the whole file once to prove it undamaged (`project.damaged`). Refuses what is no project
  /// (`project.foreign`) or comes from a newer Nineline (`project.newer`); brings an older one up to date.
  /// Where the file or its folder may not be written, it opens read-only, with the warning
  /// `project.read_only`.
  [[nodiscard]] static Result<ProjectFile> open(const std::filesystem::path& path);

  ProjectFile(ProjectFile&&) noexcept;
  ProjectFile& operator=(ProjectFile&&) noexcept;
  ~ProjectFile();

  [[nodiscard]] const std::filesystem::path& path() const;
  [[nodiscard]] bool isReadOnly() const;
  [[nodiscard]] const Diagnostics& warnings() const;
  /// Counts the saves of all windows, as far as this one has seen them; 0 for a new project.
  [[nodiscard]] std::int64_t revision() const;

  /// The names of one kind, in the order in which they were first saved.
  [[nodiscard]] Result<std::vector<std::string>> names(DocumentKind kind) const;
  /// A document's content as it stands in the file now; nothing where it was never saved.
  [[nodiscard]] Result<std::optional<std::string>> find(DocumentKind kind, const std::string& name) const;
  [[nodiscard]] Result<std::optional<std::string>> machine() const { return find(DocumentKind::Machine, {}); }

  /// All versions of the error model, oldest first.
  [[nodiscard]] Result<std::vector<ModelVersion>> modelHistory() const;
  /// The version that this window works on; nothing before the first one.
  [[nodiscard]] std::optional<std::int64_t> currentModel() const;
  /// The JSON text of a version. Fails with `project.no_model`.
  [[nodiscard]] Result<std::string> model(std::int64_t id) const;

  [[nodiscard]] Result<std::vector<ResultInfo>> results() const;
  /// Fails with `project.no_result`.
  [[nodiscard]] Result<StoredResult> result(std::int64_t id) const;

  /// Writes all of the change or nothing. `project.changed` names what another window wrote in the meantime;
  /// others: `project.read_only`, `project.busy`, `project.disk_full`, `project.replaced`, `project.secret`.
  [[nodiscard]] Result<Saved> save(const Change& change);

  /// What other windows saved since this one looked, in words.
  [[nodiscard]] Result<std::vector<std::string>> foreignChanges() const;
  /// Takes note of what other windows saved: from now on this one may write over it.
  [[nodiscard]] Result<void> reload();

  /// Writes the project, with its history, to another file, which appears whole or not at all. This window
  /// stays with its own file.
  [[nodiscard]] Result<void> saveCopy(const std::filesystem::path& target) const;

 private:
  struct Open;
  explicit ProjectFile(std::unique_ptr<Open> open);
  std::unique_ptr<Open> open_;
};

}  // namespace nineline::project
