#pragma once

#include "core/compensation/compensation.h"

namespace nineline::compensation {

/// What becomes of a block that turns rotary axes alone (resources/docs/adr/006).
enum class TurnWriting {
  NoTurn,      ///< no such block
  Alone,       ///< no linear words beside the rotary ones
  KeepFeed,    ///< linear words, F as it is: the control counts a degree as a millimetre
  RestateFeed  ///< linear words, F restated for the linear path on each line and put back behind the block
};

/// A feed motion that moves rotary axes and no linear one: F counts degrees there.
[[nodiscard]] bool turnsAlone(const nc::Motion& motion, const nc::AxisLayout& layout);

/// How such a block is written for a control. `stated`: the control that the user named; of one that was only
/// `recognised` from the text nothing is assumed about G94.
[[nodiscard]] TurnWriting turnWritingOf(const nc::Motion& motion, const nc::AxisLayout& layout,
                                        std::optional<nc::Dialect> stated, nc::Dialect recognised,
                                        TurningFeed wanted);

/// How far a line moves the linear axes (mm) and turns the rotary ones (rad), each as the root of squares.
struct Travel {
  double linear = 0.0;
  double turned = 0.0;
};
[[nodiscard]] Travel travelOf(const nc::AxisValues& from, const nc::AxisValues& to,
                              const nc::AxisLayout& layout);

/// Whether the linear part is so short against the turn that a control which adds the squares, a degree as a
/// unit of length, turns as fast as without it, to a part in a thousand.
[[nodiscard]] bool isSlight(const Travel& travel, double feed_unit);

/// The F word of a motion in per-minute feed as it stands in the program: degrees or lengths a minute.
[[nodiscard]] double feedWordOf(const nc::Motion& motion, bool degrees);

/// The F word that turns the rotary axes at `word` degrees a minute where F counts the linear path alone.
[[nodiscard]] double restatedFeed(double word, const Travel& travel, double feed_unit);

/// The fewest decimals, nine at most, that state a number to twelve digits.
[[nodiscard]] int decimalsOf(double value);

}  // namespace nineline::compensation
