#pragma once

#include <optional>
#include <string>

#include "core/nc/block_writer.h"
#include "core/nc/motion.h"
#include "core/nc/text_source.h"

namespace nineline::compensation {

/// How the corrected words of a program are written: as the program writes its own (nc::learnNumberStyle),
/// but never coarser than controls resolve: 3 decimals, in inch programs 4.
[[nodiscard]] Result<nc::NumberStyle> styleOf(nc::TextSource& source, nc::Dialect dialect,
                                              const nc::AxisLayout& layout);

/// Changes the words of a block's own line, or writes a new line beside it; everything else stays byte for
/// byte.
class LineEditor {
 public:
  void setStyle(const nc::NumberStyle& style) { style_ = style; }

  /// Starts with a block's own line; the block must stay as it is until `finish`.
  void begin(const nc::Block& block);
  /// Starts a new line beside a block: empty, but for the block's skip sign.
  void beginNew(const nc::Block& block);

  /// States an axis word; true when the line changed. `value` is rounded to `decimals` already. `named`: the
  /// block names the axis, if need be by its increment address (U V W H of Fanuc lathes); elsewhere H is a
  /// length.
  bool setAxis(AxisId axis, double value, int decimals, bool named);
  /// States a word such as I, R or F; it is added where it is missing.
  bool setWord(char letter, double value, int decimals);
  void removeWord(char letter);
  void addCode(int code);  ///< G00…G99

  /// Appends the line without its end to `out`.
  void finish(std::string& out);

 private:
  bool setValue(const nc::Word& word, double value, int decimals);
  [[nodiscard]] const nc::Word* find(char letter, std::uint8_t digit) const;
  nc::NumberStyle style_;
  nc::Block blank_;  // the block of a new line
  const nc::Block* block_ = nullptr;
  std::optional<nc::BlockEditor> editor_;
};

}  // namespace nineline::compensation
