#pragma once

#include <QString>
#include <string>

#include "core/errors/effect_spec.h"

namespace nineline::models {

/// The catalogue's texts in the user's language; English where a translation is missing.
[[nodiscard]] QString catalogueText(std::string_view text);

/// Cause, usual size and remedy of an effect as paragraphs (rich text), and what it is often taken for.
[[nodiscard]] QString shopFloorText(const errors::EffectSpec& spec);

}  // namespace nineline::models
