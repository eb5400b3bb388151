#pragma once

#include <string>
#include <vector>

#include "core/nc/block.h"
#include "core/nc/motion.h"
#include "core/nc/text_source.h"

namespace nineline::compensation {

/// How many digits the words of a program carry, and whether its words stand apart.
struct NumberStyle {
  int linear_decimals = 3;
  int rotary_decimals = 3;
  bool inch = false;  ///< the program sets inches somewhere
};

/// Digits after the point that the axis words of a program use, from its first lines; never fewer than
/// controls resolve: 3, in inch programs 4.
[[nodiscard]] Result<NumberStyle> learnNumberStyle(nc::TextSource& source, const nc::AxisLayout& layout);

/// A decimal with at most `decimals` digits after the point, which is always there ("10.", "-0.5"), as every
/// control reads it alike; nothing where the value is not finite. Appends to `out`.
[[nodiscard]] bool appendDecimal(double value, int decimals, std::string& out);

/// Changes words of one line; everything else stays byte for byte. Reused from line to line.
class LineEditor {
 public:
  /// Starts with a block's own line.
  void begin(const nc::Block& block);
  /// Starts a new line beside a block: empty, but for the block's skip sign.
  void beginNew(const nc::Block& block);

  /// States an axis word; true when the line changed. `value` is rounded to `decimals` already.
  bool setAxis(AxisId axis, double value, int decimals);
  /// States a word such as I, R or F; it is added where it is missing.
  bool setWord(char letter, double value, int decimals);
  void removeWord(char letter);
  void addCode(int code);  ///< G00…G99

  /// Appends the line without its end to `out`.
  void finish(std::string& out);

 private:
  struct Change {
    std::size_t begin, end;
    std::string text;
  };
  bool setValue(const nc::Word& word, double value, int decimals);
  void add(std::string_view address, double value, int decimals);
  const nc::Block* block_ = nullptr;  // nullptr: a new line
  bool spaced_ = true;
  std::vector<Change> changes_;
  std::string codes_;
  std::string added_;
};

}  // namespace nineline::compensation
