#pragma once

#include "ui/models/document.h"

namespace nineline::shell {

/// The worked example that comes with the program: machine, measured errors, thread and its program.
[[nodiscard]] Result<models::Document> workedExample();
/// What a new project holds: a machine and a thread to change.
[[nodiscard]] models::Document emptyProject();

}  // namespace nineline::shell
