#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/project/change.h"

namespace SQLite {
class Database;
}

namespace nineline::project {

/// What one window knows of the file: it may write over what stands here, and over nothing else.
struct Seen {
  std::int64_t revision = 0;
  std::map<std::pair<DocumentKind, std::string>, std::int64_t> documents;  ///< revision of its last change
  std::set<std::int64_t> models;
  std::optional<std::int64_t> current_model;
};

/// What a save did. Without any difference to what stood there, nothing is written and the revision stays.
struct Saved {
  std::int64_t revision = 0;
  std::vector<std::int64_t> models;   ///< ids of the new versions, in the order of the change
  std::vector<std::int64_t> results;  ///< ids of the new results, likewise
};

/// All that stands in the file now. Throws SQLite::Exception.
[[nodiscard]] Seen readSeen(SQLite::Database& database);

/// What another window changed since, in words; empty when nothing.
[[nodiscard]] std::vector<std::string> differences(const Seen& seen, const Seen& now);

/// Writes the change in one transaction; `seen` follows once it is committed. Refused with `project.changed`
/// when a document that it writes was changed by another window. Throws SQLite::Exception.
[[nodiscard]] Result<Saved> writeChange(SQLite::Database& database, const Change& change, Seen& seen);

}  // namespace nineline::project
