#include "core/project/schema.h"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/Transaction.h>
#include <fmt/format.h>

#include <array>
#include <map>

#include "core/base/text.h"
#include "core/project/checksum.h"
#include "core/project/rows.h"

namespace nineline::project {

namespace {

struct Table {
  const char* name;
  const char* definition;
};

// The small columns stand first, so that listing them does not read the contents.
constexpr std::array<Table, 4> kTables = {{
    {"state",
     "CREATE TABLE state (id INTEGER PRIMARY KEY CHECK (id = 1), revision INTEGER NOT NULL, "
     "current_model INTEGER, next_result INTEGER NOT NULL, checksum INTEGER NOT NULL)"},
    {"document",
     "CREATE TABLE document (id INTEGER PRIMARY KEY, kind INTEGER NOT NULL, name TEXT NOT NULL, "
     "revision INTEGER NOT NULL, checksum INTEGER NOT NULL, content BLOB NOT NULL, UNIQUE (kind, name))"},
    {"model",
     "CREATE TABLE model (id INTEGER PRIMARY KEY, parent INTEGER, saved_at TEXT NOT NULL, note TEXT NOT "
     "NULL, "
     "checksum INTEGER NOT NULL, content BLOB NOT NULL)"},
    {"result",
     "CREATE TABLE result (id INTEGER PRIMARY KEY, model INTEGER, saved_at TEXT NOT NULL, kind TEXT NOT "
     "NULL, "
     "checksum INTEGER NOT NULL, record BLOB NOT NULL, content BLOB NOT NULL)"},
}};

/// What brings a file from format i to i + 1, at place i; format 0 is an empty file with our application id.
constexpr std::array<void (*)(SQLite::Database&), kFormat> kSteps = {
    [](SQLite::Database& database) {
      for (const Table& table : kTables) database.exec(table.definition);
      database.exec("INSERT INTO state VALUES (1, 0, NULL, 1, 0)");
      sealState(database);
    },
};

std::int64_t number(SQLite::Database& database, const std::string& query) {
  return database.execAndGet(query).getInt64();
}

/// All rows' checksums in one number; the order does not matter.
std::int64_t sumOfRows(SQLite::Database& database) {
  std::int64_t sum = 0;
  SQLite::Statement rows(database,
                         "SELECT checksum FROM document UNION ALL SELECT checksum FROM model "
                         "UNION ALL SELECT checksum FROM result");
  while (rows.executeStep()) sum ^= rows.getColumn(0).getInt64();
  return sum;
}

std::int64_t stateChecksum(SQLite::Database& database) {
  SQLite::Statement state(database, "SELECT revision, ifnull(current_model, -1), next_result FROM state");
  if (!state.executeStep()) return 0;
  return Checksum()
      .add(state.getColumn(0).getInt64())
      .add(state.getColumn(1).getInt64())
      .add(state.getColumn(2).getInt64())
      .add(sumOfRows(database))
      .value();
}

/// What does not fit in the tables; empty when all does. A foreign trigger or view would count as damage.
std::string faultOfTables(SQLite::Database& database) {
  std::map<std::string, std::string> expected;
  for (const Table& table : kTables) expected[table.name] = table.definition;
  SQLite::Statement found(database, "SELECT name, sql FROM sqlite_schema WHERE sql IS NOT NULL");
  while (found.executeStep()) {
    const std::string name = found.getColumn(0).getString();
    const auto known = expected.find(name);
    if (known == expected.end() || known->second != found.getColumn(1).getString())
      return fmt::format("its table '{}' is not as it was made", printable(name));
    expected.erase(known);
  }
  return expected.empty() ? "" : fmt::format("its table '{}' is missing", expected.begin()->first);
}

/// Recomputes the checksum of every row; says which one is wrong, or nothing.
std::string faultOfRows(SQLite::Database& database) {
  SQLite::Statement documents(database, "SELECT kind, name, revision, content, checksum FROM document");
  while (documents.executeStep()) {
    const DocumentRow row = readDocumentRow(documents);
    if (row.checksum() != documents.getColumn(4).getInt64())
      return fmt::format("the document '{}' is not as it was saved", printable(row.name));
  }
  SQLite::Statement models(database, "SELECT id, parent, saved_at, note, content, checksum FROM model");
  while (models.executeStep()) {
    const ModelRow row = readModelRow(models);
    if (row.checksum() != models.getColumn(5).getInt64())
      return fmt::format("version {} of the error model is not as it was saved", row.version.id);
  }
  SQLite::Statement results(database,
                            "SELECT id, model, saved_at, kind, record, content, checksum FROM result");
  while (results.executeStep()) {
    const ResultRow row = readResultRow(results);
    if (row.checksum() != results.getColumn(6).getInt64())
      return fmt::format("result {} is not as it was saved", row.info.id);
  }
  return {};
}

Error damaged(const std::string& what, const std::filesystem::path& path) {
  return badInput(
      "project.damaged",
      fmt::format("The project is damaged: {}. Nothing was changed; restore it from a copy.", what),
      path.string());
}

}  // namespace

void makeSchema(SQLite::Database& database) {
  database.exec("PRAGMA journal_mode = DELETE");
  SQLite::Transaction transaction(database);
  database.exec(fmt::format("PRAGMA application_id = {}", kApplicationId));
  for (const auto& step : kSteps) step(database);
  database.exec(fmt::format("PRAGMA user_version = {}", kFormat));
  transaction.commit();
}

void migrate(SQLite::Database& database) {
  if (number(database, "PRAGMA user_version") == kFormat) return;
  SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
  const auto format = static_cast<std::size_t>(number(database, "PRAGMA user_version"));
  for (std::size_t step = format; step < kSteps.size(); ++step) kSteps[step](database);
  database.exec(fmt::format("PRAGMA user_version = {}", kFormat));
  transaction.commit();
}

Result<void> checkOrigin(SQLite::Database& database, const std::filesystem::path& path) {
  const std::int64_t format = number(database, "PRAGMA user_version");
  if (number(database, "PRAGMA application_id") != kApplicationId || format < 0)
    return badInput("project.foreign", "This is not a Nineline project.", path.string());
  if (format > kFormat)
    return badInput(
        "project.newer",
        fmt::format("The project was saved by a newer Nineline (format {}; this one reads up to {}). "
                    "Open it with that one.",
                    format, kFormat),
        path.string());
  return {};
}

Result<void> checkIntegrity(SQLite::Database& database, const std::filesystem::path& path) {
  const std::string structure = database.execAndGet("PRAGMA integrity_check(1)").getString();
  if (structure != "ok") return damaged(printable(structure, 120), path);
  if (const std::string fault = faultOfTables(database); !fault.empty()) return damaged(fault, path);
  if (const std::string fault = faultOfRows(database); !fault.empty()) return damaged(fault, path);
  SQLite::Statement state(database, "SELECT checksum FROM state");
  if (!state.executeStep() || state.getColumn(0).getInt64() != stateChecksum(database))
    return damaged("its documents are not those that were saved", path);
  return {};
}

void sealState(SQLite::Database& database) {
  SQLite::Statement seal(database, "UPDATE state SET checksum = ?");
  seal.bind(1, stateChecksum(database));
  seal.exec();
}

}  // namespace nineline::project
