#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/json.h"
#include "core/compensation/compensation.h"

namespace nineline::models {

/// A file of raw readings as it was opened or typed: nineline-measurement/1, kept byte for byte.
struct ReadingsFile {
  std::string name;
  std::shared_ptr<const std::string> text;  ///< never null
};

/// Everything that a person typed or opened. A value; what cannot be read yet is kept as it was typed.
/// `effects`, `thread`, `setup` and `options` are JSON, so that a half-typed value has a place.
struct Document {
  std::string machine_text;            ///< nineline-machine/1
  Json effects = Json::array();        ///< the entries of nineline-model/1
  std::vector<ReadingsFile> readings;  ///< no two of one name
  std::string program_name;
  std::shared_ptr<const std::string> program;  ///< null: none
  Json thread = Json::object();                ///< nineline-thread/1
  Json setup = Json::object();    ///< work_offsets, tool_lengths, conditions, start, dialect, block_skip
  Json options = Json::object();  ///< of the compensation, units in the keys' names
};

/// Which parts of two documents differ.
struct Changes {
  bool machine = false;
  bool effects = false;
  bool readings = false;
  bool program = false;
  bool thread = false;
  bool setup = false;
  bool options = false;
  [[nodiscard]] bool any() const {
    return machine || effects || readings || program || thread || setup || options;
  }
};
[[nodiscard]] Changes differences(const Document& one, const Document& other);
[[nodiscard]] bool isSame(const Json& one, const Json& other);
[[nodiscard]] bool isSame(const std::vector<ReadingsFile>& one, const std::vector<ReadingsFile>& other);

[[nodiscard]] Json documentToJson(const Document& document);
[[nodiscard]] Result<Document> documentFromJson(const Json& json);

/// The machine's effects as a whole model file, for the checks of core.
[[nodiscard]] Result<errors::ErrorModel> modelOf(const Document& document);
[[nodiscard]] Result<simulation::ProgramSetup> setupOf(const Document& document,
                                                       const kinematics::Machine& machine);
[[nodiscard]] Result<compensation::CompensationOptions> optionsOf(const Document& document);

}  // namespace nineline::models
