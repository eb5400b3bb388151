#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/axis_id.h"

namespace nineline::errors {

/// One error component by its ISO 230-1 name: EZZ, EXZ, EAZ (motion errors of joint Z), B0Z, X0C (location
/// errors).
struct Component {
  AxisId axis;            ///< the joint
  int row = 0;            ///< 0 1 2: translation along x y z of the joint's frame; 3 4 5: rotation about them
  bool location = false;  ///< a constant of the joint's place (letter, 0, joint)

  friend bool operator==(const Component&, const Component&) = default;
  [[nodiscard]] bool isAngular() const { return row >= 3; }
  [[nodiscard]] std::string text() const;
};

/// Reads "EZZ", "EXC2", "B0Z" and "EB0Z"; nothing for any other text.
[[nodiscard]] std::optional<Component> parseComponent(std::string_view text);

}  // namespace nineline::errors
