#pragma once

#include <string>
#include <string_view>

#include "core/base/diagnostics.h"
#include "core/errors/error_model.h"

namespace nineline::errors {

/// Reads a model in the format `nineline-model/1`; `machine` there is an id or a whole machine.
[[nodiscard]] Result<ErrorModel> errorModelFromJson(const Json& json, const std::string& source);
[[nodiscard]] Result<ErrorModel> readErrorModel(std::string_view text, const std::string& source);
[[nodiscard]] Result<ErrorModel> loadErrorModel(const std::string& path);

/// The same format. A built-in machine is written as its id, any other one whole.
[[nodiscard]] Json errorModelToJson(const ErrorModel& model);

}  // namespace nineline::errors
