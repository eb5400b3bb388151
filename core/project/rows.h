#pragma once

#include <string>

#include "core/project/change.h"
#include "core/project/history.h"

namespace SQLite {
class Statement;
}

namespace nineline::project {

/// A row of each table as it stands in the file, and the checksum over its fields.
struct DocumentRow {
  DocumentKind kind = DocumentKind::Setting;
  std::string name;
  std::int64_t revision = 0;
  std::string content;
  [[nodiscard]] std::int64_t checksum() const;
};

struct ModelRow {
  ModelVersion version;
  std::string text;
  [[nodiscard]] std::int64_t checksum() const;
};

struct ResultRow {
  ResultInfo info;
  std::string record;
  std::string bytes;
  [[nodiscard]] std::int64_t checksum() const;
};

/// The current row of a query for the columns kind, name, revision, content.
[[nodiscard]] DocumentRow readDocumentRow(SQLite::Statement& query);
/// … id, parent, saved_at, note; and, where the query has a fifth column, content.
[[nodiscard]] ModelRow readModelRow(SQLite::Statement& query);
/// … id, model, saved_at, kind; and, where the query has them, record and content.
[[nodiscard]] ResultRow readResultRow(SQLite::Statement& query);

}  // namespace nineline::project
