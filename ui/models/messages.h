#pragma once

#include <QString>

#include "core/base/diagnostics.h"
#include "core/base/result.h"

namespace nineline::models {

/// An error of core in the user's language: the sentence that belongs to its code, the place, and core's own
/// text with the values (English).
[[nodiscard]] QString messageOf(const Error& error);
[[nodiscard]] QString messageOf(const Diagnostic& diagnostic);

/// The sentence for a code of core ("machine.travel"); empty where there is none.
[[nodiscard]] QString sentenceFor(const std::string& code);

}  // namespace nineline::models
