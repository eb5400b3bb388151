#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/nc/interpreter.h"

namespace nineline::nc::testing {

/// One motion in machine coordinates: mm and degrees.
struct CanonicalMove {
  bool rapid = false;
  bool locked = false;          ///< between DISABLE_FEED_OVERRIDE and ENABLE_FEED_OVERRIDE
  std::array<double, 6> end{};  ///< X Y Z A B C
  double sweep_turns = 0.0;     ///< signed whole turns as LinuxCNC counts them; 0: straight
  std::array<double, 2> centre{};
  double unit = 1.0;  ///< mm of the last digit's unit: 1 or 25.4
};

/// The motions that LinuxCNC's canonical calls describe (the output of `rs274`), offsets and rotation
/// applied. Straight moves that go nowhere are left out.
std::vector<CanonicalMove> readCanonicalCalls(std::string_view text);

/// What our interpreter makes of a program on a machine X Y Z A B C, in the same form.
struct OwnMoves {
  std::vector<CanonicalMove> moves;
  std::string error;  ///< empty: executed to its end
};
OwnMoves interpretMoves(const std::string& name, const std::string& program, InterpreterOptions options);

/// A machine with the axes X Y Z A B C.
AxisLayout sixAxes();

/// Empty where the moves agree within what four decimals tell, else the first difference.
std::string differenceOf(const std::vector<CanonicalMove>& own, const std::vector<CanonicalMove>& expected);

}  // namespace nineline::nc::testing
