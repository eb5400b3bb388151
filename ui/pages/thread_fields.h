#pragma once

#include <vector>

#include "ui/widgets/parameter_form.h"

namespace nineline::pages {

/// The fields of a thread job (`nineline-thread/1`) as the form shows them.
[[nodiscard]] std::vector<widgets::Field> threadFields();

}  // namespace nineline::pages
