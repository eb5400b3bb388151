#pragma once

#include <vector>

#include "ui/widgets/parameter_form.h"

namespace nineline::pages {

/// The options of a compensation as the form shows them.
[[nodiscard]] std::vector<widgets::Field> optionFields();
/// What the control knows and the program does not say.
[[nodiscard]] std::vector<widgets::Field> controlFields();

}  // namespace nineline::pages
