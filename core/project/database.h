#pragma once

#include <filesystem>

#include "core/base/result.h"

namespace SQLite {
class Database;
class Exception;
}  // namespace SQLite

namespace nineline::project {

/// What the user can do something about, said in his words: full disk, busy, damaged, read-only, too large.
[[nodiscard]] Error databaseError(const SQLite::Exception& fault, const std::filesystem::path& path);

/// Opens an existing database file with our settings: rollback journal, every commit on the disk, no trust in
/// what the schema of a foreign file may hold. Throws SQLite::Exception.
[[nodiscard]] SQLite::Database openDatabase(const std::filesystem::path& path, bool read_only);

}  // namespace nineline::project
