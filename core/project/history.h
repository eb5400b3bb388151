#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace nineline::project {

/// One version of the project's error model. Versions form a tree: two windows, or a step back followed by
/// another change, make two versions with the same parent.
struct ModelVersion {
  std::int64_t id = 0;
  std::optional<std::int64_t> parent;  ///< absent: the first one
  std::string saved_at;                ///< UTC, "2026-01-31T12:00:00Z"
  std::string note;                    ///< why it was made
};

/// What a list of results shows.
struct ResultInfo {
  std::int64_t id = 0;
  std::optional<std::int64_t> model;  ///< the version that was current when it was saved
  std::string saved_at;               ///< UTC, as above
  std::string kind;                   ///< the verb: "compensate", "identify", …
};

/// One result whole.
struct StoredResult {
  ResultInfo info;
  std::string record;  ///< JSON text
  std::string bytes;
};

}  // namespace nineline::project
