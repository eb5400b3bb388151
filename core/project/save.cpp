#include "core/project/save.h"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/Transaction.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sqlite3.h>

#include <chrono>
#include <limits>

#include "core/project/rows.h"
#include "core/project/schema.h"

namespace nineline::project {

namespace {

std::string utcNow() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now));
}

void bindBytes(SQLite::Statement& statement, int place, const std::string& bytes) {
  if (bytes.size() > std::size_t{std::numeric_limits<int>::max()})
    throw SQLite::Exception("too large", SQLITE_TOOBIG);
  statement.bindNoCopy(place, bytes.data(), static_cast<int>(bytes.size()));
}

void bindNumber(SQLite::Statement& statement, int place, std::optional<std::int64_t> number) {
  if (number) {
    statement.bind(place, *number);
  } else {
    statement.bind(place);
  }
}

/// One transaction's work. What it changes in `seen` is taken over by the caller after the commit.
class Saver {
 public:
  Saver(SQLite::Database& database, Seen seen)
      : database_(database), seen_(std::move(seen)), now_(utcNow()), next_revision_(fileRevision() + 1) {}

  Result<void> write(const Change& change) {
    for (const DocumentChange& document : change.documents()) writeDocument(document);
    if (!conflicts_.empty()) return changedByOther();
    for (const NewModel& model : change.models()) addModel(model);
    if (change.selectedModel()) {
      if (Result<void> selected = selectModel(*change.selectedModel()); !selected) return selected;
    }
    for (const std::int64_t id : change.removedResults()) removeResult(id);
    for (const NewResult& result : change.results()) addResult(result);
    if (wrote_) finish();
    return {};
  }

  [[nodiscard]] bool wrote() const { return wrote_; }
  [[nodiscard]] const Saved& saved() const { return saved_; }
  [[nodiscard]] const Seen& seen() const { return seen_; }

 private:
  std::int64_t fileRevision() { return database_.execAndGet("SELECT revision FROM state").getInt64(); }

  void writeDocument(const DocumentChange& change) {
    const auto key = std::pair(change.kind, change.name);
    SQLite::Statement query(database_,
                            "SELECT kind, name, revision, content FROM document WHERE kind = ? AND name = ?");
    query.bind(1, static_cast<int>(change.kind));
    query.bind(2, change.name);
    std::optional<DocumentRow> old;
    if (query.executeStep()) old = readDocumentRow(query);
    query.reset();
    if (old ? old->content == change.content : !change.content) {  // nothing to do, whoever wrote it
      noteSeen(key, old ? std::optional(old->revision) : std::nullopt);
      return;
    }
    const auto known = seen_.documents.find(key);
    const bool is_known = old ? known != seen_.documents.end() && known->second == old->revision
                              : known == seen_.documents.end();
    if (!is_known) {
      conflicts_.push_back(describe(change.kind, change.name));
      return;
    }
    wrote_ = true;
    change.content ? putDocument(change) : removeDocument(change);
    noteSeen(key, change.content ? std::optional(next_revision_) : std::nullopt);
  }

  void noteSeen(const std::pair<DocumentKind, std::string>& key, std::optional<std::int64_t> revision) {
    if (revision) {
      seen_.documents[key] = *revision;
    } else {
      seen_.documents.erase(key);
    }
  }

  void putDocument(const DocumentChange& change) {
    const DocumentRow row{change.kind, change.name, next_revision_, *change.content};
    SQLite::Statement put(
        database_,
        "INSERT INTO document (kind, name, revision, checksum, content) VALUES (?, ?, ?, ?, ?) "
        "ON CONFLICT (kind, name) DO UPDATE SET revision = excluded.revision, "
        "checksum = excluded.checksum, content = excluded.content");
    put.bind(1, static_cast<int>(row.kind));
    put.bind(2, row.name);
    put.bind(3, row.revision);
    put.bind(4, row.checksum());
    bindBytes(put, 5, row.content);
    put.exec();
  }

  void removeDocument(const DocumentChange& change) {
    SQLite::Statement remove(database_, "DELETE FROM document WHERE kind = ? AND name = ?");
    remove.bind(1, static_cast<int>(change.kind));
    remove.bind(2, change.name);
    remove.exec();
  }

  void addModel(const NewModel& model) {
    const std::int64_t id = database_.execAndGet("SELECT ifnull(max(id), 0) + 1 FROM model").getInt64();
    const ModelRow row{{id, seen_.current_model, now_, model.note}, model.text};
    SQLite::Statement add(database_, "INSERT INTO model VALUES (?, ?, ?, ?, ?, ?)");
    add.bind(1, id);
    bindNumber(add, 2, row.version.parent);
    add.bind(3, row.version.saved_at);
    add.bind(4, row.version.note);
    add.bind(5, row.checksum());
    bindBytes(add, 6, row.text);
    add.exec();
    wrote_ = true;
    saved_.models.push_back(id);
    seen_.models.insert(id);
    seen_.current_model = id;
  }

  Result<void> selectModel(std::int64_t id) {
    SQLite::Statement query(database_, "SELECT 1 FROM model WHERE id = ?");
    query.bind(1, id);
    if (!query.executeStep())
      return badInput("project.no_model", fmt::format("The error model has no version {}.", id));
    wrote_ = wrote_ || seen_.current_model != id;
    seen_.current_model = id;
    return {};
  }

  void removeResult(std::int64_t id) {
    SQLite::Statement remove(database_, "DELETE FROM result WHERE id = ?");
    remove.bind(1, id);
    wrote_ = remove.exec() != 0 || wrote_;
  }

  void addResult(const NewResult& result) {
    const std::int64_t id = database_.execAndGet("SELECT next_result FROM state").getInt64();
    database_.exec("UPDATE state SET next_result = next_result + 1");
    const ResultRow row{{id, seen_.current_model, now_, result.kind}, result.record, result.bytes};
    SQLite::Statement add(database_, "INSERT INTO result VALUES (?, ?, ?, ?, ?, ?, ?)");
    add.bind(1, id);
    bindNumber(add, 2, row.info.model);
    add.bind(3, row.info.saved_at);
    add.bind(4, row.info.kind);
    add.bind(5, row.checksum());
    bindBytes(add, 6, row.record);
    bindBytes(add, 7, row.bytes);
    add.exec();
    wrote_ = true;
    saved_.results.push_back(id);
  }

  void finish() {
    SQLite::Statement state(database_, "UPDATE state SET revision = ?, current_model = ?");
    state.bind(1, next_revision_);
    bindNumber(state, 2, seen_.current_model);
    state.exec();
    sealState(database_);
    saved_.revision = next_revision_;
    seen_.revision = next_revision_;
  }

  Error changedByOther() const {
    return badInput("project.changed",
                    fmt::format("Another window changed the {} in the meantime. Nothing was saved; read the "
                                "project again, or save yours under another name.",
                                fmt::join(conflicts_, ", the ")));
  }

  SQLite::Database& database_;
  Seen seen_;
  std::string now_;
  std::int64_t next_revision_;
  Saved saved_;
  std::vector<std::string> conflicts_;
  bool wrote_ = false;
};

}  // namespace

Seen readSeen(SQLite::Database& database) {
  Seen seen;
  SQLite::Statement state(database, "SELECT revision, current_model FROM state");
  if (state.executeStep()) {
    seen.revision = state.getColumn(0).getInt64();
    if (!state.isColumnNull(1)) seen.current_model = state.getColumn(1).getInt64();
  }
  SQLite::Statement documents(database, "SELECT kind, name, revision FROM document");
  while (documents.executeStep()) {
    const auto kind = static_cast<DocumentKind>(documents.getColumn(0).getInt());
    seen.documents[{kind, documents.getColumn(1).getString()}] = documents.getColumn(2).getInt64();
  }
  SQLite::Statement models(database, "SELECT id FROM model");
  while (models.executeStep()) seen.models.insert(models.getColumn(0).getInt64());
  return seen;
}

std::vector<std::string> differences(const Seen& seen, const Seen& now) {
  std::vector<std::string> words;
  for (const auto& [key, revision] : now.documents) {
    const auto known = seen.documents.find(key);
    if (known == seen.documents.end() || known->second != revision)
      words.push_back(describe(key.first, key.second));
  }
  for (const auto& [key, revision] : seen.documents) {
    if (now.documents.count(key) == 0) words.push_back(describe(key.first, key.second) + " (removed)");
  }
  for (const std::int64_t id : now.models) {
    if (seen.models.count(id) == 0) words.push_back(fmt::format("version {} of the error model", id));
  }
  return words;
}

Result<Saved> writeChange(SQLite::Database& database, const Change& change, Seen& seen) {
  SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
  Saver saver(database, seen);
  if (Result<void> written = saver.write(change); !written) return written.error();
  Saved saved = saver.saved();
  if (!saver.wrote()) saved.revision = seen.revision;
  transaction.commit();
  seen = saver.seen();
  return saved;
}

}  // namespace nineline::project
