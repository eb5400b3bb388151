#include "core/project/rows.h"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Statement.h>

#include "core/project/checksum.h"

namespace nineline::project {

namespace {
std::optional<std::int64_t> numberOrNothing(SQLite::Statement& query, int column) {
  if (query.isColumnNull(column)) return std::nullopt;
  return query.getColumn(column).getInt64();
}
}  // namespace

std::int64_t DocumentRow::checksum() const {
  return Checksum().add(static_cast<std::int64_t>(kind)).add(name).add(revision).add(content).value();
}

std::int64_t ModelRow::checksum() const {
  return Checksum()
      .add(version.id)
      .add(version.parent.value_or(0))
      .add(version.saved_at)
      .add(version.note)
      .add(text)
      .value();
}

std::int64_t ResultRow::checksum() const {
  return Checksum()
      .add(info.id)
      .add(info.model.value_or(0))
      .add(info.saved_at)
      .add(info.kind)
      .add(record)
      .add(bytes)
      .value();
}

DocumentRow readDocumentRow(SQLite::Statement& query) {
  return {static_cast<DocumentKind>(query.getColumn(0).getInt()), query.getColumn(1).getString(),
          query.getColumn(2).getInt64(), query.getColumn(3).getString()};
}

ModelRow readModelRow(SQLite::Statement& query) {
  return {{query.getColumn(0).getInt64(), numberOrNothing(query, 1), query.getColumn(2).getString(),
           query.getColumn(3).getString()},
          query.getColumnCount() > 4 ? query.getColumn(4).getString() : std::string()};
}

ResultRow readResultRow(SQLite::Statement& query) {
  const bool whole = query.getColumnCount() > 5;
  return {{query.getColumn(0).getInt64(), numberOrNothing(query, 1), query.getColumn(2).getString(),
           query.getColumn(3).getString()},
          whole ? query.getColumn(4).getString() : std::string(),
          whole ? query.getColumn(5).getString() : std::string()};
}

}  // namespace nineline::project
