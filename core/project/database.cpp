#include "core/project/database.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>
#include <fmt/format.h>
#include <sqlite3.h>

namespace nineline::project {

namespace {
constexpr int kPatience_ms = 5000;  // how long another window's save is waited for

Error faultOfStorage(int code, const SQLite::Exception& fault, const std::string& source) {
  if (code == SQLITE_FULL)
    return badInput("project.disk_full", "The disk is full. The project is as it was before this save.",
                    source);
  if (code == SQLITE_TOOBIG)
    return badInput("project.too_big", "A document is larger than a project can keep (1 GB).", source);
  if (code == SQLITE_IOERR)
    return badInput("project.io",
                    fmt::format("The disk does not read or write: {}. The project is as it was before.",
                                fault.getErrorStr()),
                    source);
  return badInput("project.database", fmt::format("The project cannot be used: {}.", fault.what()), source);
}
}  // namespace

Error databaseError(const SQLite::Exception& fault, const std::filesystem::path& path) {
  const std::string source = path.string();
  switch (const int code = fault.getErrorCode() & 0xff; code) {
    case SQLITE_NOTADB:
      return badInput("project.foreign", "This is not a Nineline project.", source);
    case SQLITE_CORRUPT:
      return badInput("project.damaged", fmt::format("The project is damaged: {}.", fault.what()), source);
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return badInput("project.busy", "Another window is saving this project. Try again.", source);
    case SQLITE_READONLY:
    case SQLITE_PERM:
      return badInput("project.read_only", "The project may be read only. Save it under another name.",
                      source);
    case SQLITE_CANTOPEN:
      return badInput("project.open", "The project, or its folder, cannot be opened.", source);
    default:
      return faultOfStorage(code, fault, source);
  }
}

SQLite::Database openDatabase(const std::filesystem::path& path, bool read_only) {
  SQLite::Database database(path.string(), read_only ? SQLite::OPEN_READONLY : SQLite::OPEN_READWRITE,
                            kPatience_ms);
  sqlite3_db_config(database.getHandle(), SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  database.exec("PRAGMA trusted_schema = OFF; PRAGMA cell_size_check = ON; PRAGMA synchronous = FULL");
  return database;
}

}  // namespace nineline::project
