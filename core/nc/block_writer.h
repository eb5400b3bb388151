#pragma once

#include <array>
#include <string>
#include <string_view>

#include "core/nc/block.h"
#include "core/nc/number_style.h"

namespace nineline::nc {

/// Changes words of one block; every other character of the line stays as it is. Nothing is allocated.
class BlockEditor {
 public:
  /// `block` must stay as it is until `appendTo`.
  BlockEditor(const Block& block, const NumberStyle& style) : block_(&block), style_(&style) {}

  /// Writes another number into a word of the block. False where the word's value is an expression, the
  /// number cannot be written, or too many words are changed.
  [[nodiscard]] bool setValue(const Word& word, double value, int decimals);
  /// Replaces a whole word, its address included, by text (`G02` by `G01`).
  [[nodiscard]] bool replace(const Word& word, std::string_view text);
  /// Adds a word behind the last axis word (behind the last G word, the N word, at the start, where there is
  /// none). An axis with a digit, or `equal_sign`, is written `C2=12.5`.
  [[nodiscard]] bool addWord(char letter, std::uint8_t digit, double value, int decimals,
                             bool equal_sign = false);
  /// Adds text at the same place, for example a G code.
  [[nodiscard]] bool addText(std::string_view text);
  /// Takes a word out, with the blanks before it.
  [[nodiscard]] bool remove(const Word& word);

  /// Appends the new line, without line end, to `out`.
  void appendTo(std::string& out) const;

 private:
  static constexpr std::size_t kMostEdits = 32;
  static constexpr std::size_t kLongestText = kLongestNumber + 8;
  struct Edit {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    std::uint32_t size = 0;
    std::array<char, kLongestText> text;
  };
  Edit* addEdit(std::uint32_t begin, std::uint32_t end);
  [[nodiscard]] std::uint32_t placeForWords() const;
  [[nodiscard]] bool isSpaced() const;

  const Block* block_;
  const NumberStyle* style_;
  std::array<Edit, kMostEdits> edits_;
  std::size_t count_ = 0;
};

}  // namespace nineline::nc
