#pragma once

#include <filesystem>

#include "core/base/result.h"

namespace SQLite {
class Database;
}

namespace nineline::project {

/// The format that this program writes; a file's own stands in its `user_version`.
inline constexpr int kFormat = 1;

/// "NnLn" in the file's `application_id`: by it `file` and we tell a project from any other database.
inline constexpr int kApplicationId = 0x4e6e4c6e;

/// Fills an empty database, in one transaction. Throws SQLite::Exception.
void makeSchema(SQLite::Database& database);

/// Brings an older format up to ours, one step after the other in one transaction; does nothing to a file of
/// our own format. Throws SQLite::Exception.
void migrate(SQLite::Database& database);

/// Refuses what is no project (`project.foreign`) and a project of a newer Nineline (`project.newer`). Throws
/// SQLite::Exception.
[[nodiscard]] Result<void> checkOrigin(SQLite::Database& database, const std::filesystem::path& path);

/// Refuses a file (`project.damaged`) whose structure, tables or checksums are not what we wrote; reads all
/// of it. Throws SQLite::Exception.
[[nodiscard]] Result<void> checkIntegrity(SQLite::Database& database, const std::filesystem::path& path);

/// Recomputes what the state row says about all others. Part of every transaction that writes. Throws
/// SQLite::Exception.
void sealState(SQLite::Database& database);

}  // namespace nineline::project
