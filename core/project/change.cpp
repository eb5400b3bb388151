#include "core/project/change.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "core/base/text.h"

namespace nineline::project {

namespace {

bool namesASecret(const std::string& key) {
  constexpr std::array<std::string_view, 6> kWords = {"PASSWORD",   "PASSWD",     "SECRET",
                                                      "PASSPHRASE", "CREDENTIAL", "PRIVATE_KEY"};
  const std::string upper_key = upper(key);
  return std::any_of(kWords.begin(), kWords.end(),
                     [&](std::string_view word) { return upper_key.find(word) != std::string::npos; });
}

/// An address of the form scheme://user:password@host, anywhere in the text. Read by hand: a pattern of the
/// standard library recurses once a character and would exhaust the stack on a long setting.
bool holdsAPassword(std::string_view text) {
  constexpr std::string_view kAfterScheme = "://";
  for (std::size_t at = text.find(kAfterScheme); at != std::string_view::npos;
       at = text.find(kAfterScheme, at + 1)) {
    const std::string_view rest = text.substr(at + kAfterScheme.size());
    const std::string_view authority = rest.substr(0, rest.find_first_of("/?# \t\r\n\"'"));
    const std::size_t host = authority.rfind('@');
    if (host == std::string_view::npos) continue;
    const std::size_t colon = authority.substr(0, host).find(':');
    if (colon != std::string_view::npos && colon + 1 < host) return true;
  }
  return false;
}

bool isPlain(const std::string& name) {
  return isUtf8(name) && std::none_of(name.begin(), name.end(), [](char letter) {
           return static_cast<unsigned char>(letter) < 0x20 || letter == 0x7f;
         });
}

Result<void> checkDocument(const DocumentChange& document) {
  if (document.name.empty() != (document.kind == DocumentKind::Machine))
    return badInput("project.name", fmt::format("The {} needs a name.", describe(document.kind, {})));
  if (!isPlain(document.name))
    return badInput("project.name",
                    fmt::format("'{}' cannot be a name: it holds control characters or is no UTF-8.",
                                printable(document.name)));
  if (document.kind != DocumentKind::Setting || !document.content) return {};
  if (namesASecret(document.name) || holdsAPassword(*document.content))
    return badInput("project.secret", fmt::format("The setting '{}' looks like a password. A project may be "
                                                  "copied and sent, so it keeps no secrets.",
                                                  printable(document.name)));
  return {};
}

}  // namespace

std::string describe(DocumentKind kind, const std::string& name) {
  const std::array<const char*, 4> words = {"machine", "measurement", "program", "setting"};
  const char* word = words.at(static_cast<std::size_t>(kind));
  return name.empty() ? word : fmt::format("{} '{}'", word, printable(name));
}

Change& Change::put(DocumentKind kind, std::string name, std::string content) {
  documents_.push_back({kind, std::move(name), std::move(content)});
  return *this;
}

Change& Change::remove(DocumentKind kind, std::string name) {
  documents_.push_back({kind, std::move(name), std::nullopt});
  return *this;
}

Change& Change::addModel(std::string text, std::string note) {
  models_.push_back({std::move(text), std::move(note)});
  return *this;
}

Change& Change::selectModel(std::int64_t id) {
  selected_model_ = id;
  return *this;
}

Change& Change::addResult(std::string kind, std::string record, std::string bytes) {
  results_.push_back({std::move(kind), std::move(record), std::move(bytes)});
  return *this;
}

Change& Change::removeResult(std::int64_t id) {
  removed_results_.push_back(id);
  return *this;
}

Result<void> Change::check() const {
  for (const DocumentChange& document : documents_) {
    if (Result<void> checked = checkDocument(document); !checked) return checked;
  }
  for (const NewModel& model : models_) {
    if (!isUtf8(model.note)) return badInput("project.note", "The note of a model version is no UTF-8.");
  }
  for (const NewResult& result : results_) {
    if (result.kind.empty() || !isPlain(result.kind))
      return badInput("project.name",
                      fmt::format("'{}' cannot be a kind of result.", printable(result.kind)));
  }
  return {};
}

}  // namespace nineline::project
