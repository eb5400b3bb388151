#pragma once

#include <string>

#include "core/postprocessing/nc_output.h"

namespace nineline::postprocessing {

/// The axis positions of one block as its words state them (mm, deg; diameters as such), and back in mm and
/// rad.
struct WrittenAxes {
  JointPositions words{};
  JointPositions positions{};
};
/// `tip` replaces X Y Z under tip control.
[[nodiscard]] WrittenAxes writtenAxes(const Machine& machine, const NcOptions& options,
                                      const JointPositions& q, const Vector3d& tip);

/// A number of an axis word, decimals cut to what is needed: `12.5`, `-3.`.
[[nodiscard]] std::string axisNumber(double value, int decimals);
/// A feed with six digits that count.
[[nodiscard]] std::string feedNumber(double value);

/// A comment's text with nothing in it that a control could take for something else.
[[nodiscard]] std::string harmless(std::string_view text, Control control);

}  // namespace nineline::postprocessing
