#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace nineline::nc {

/// How an axis word is meant where the word itself says so (Siemens `X=IC(10)`).
enum class WordMode : std::uint8_t { Modal, Absolute, Increment, ShortestWay };

/// One word of a block: an address and its value, with its place in the line.
struct Word {
  char letter = 0;          ///< upper case; 0 for an address longer than a letter (Siemens)
  std::uint8_t digit = 0;   ///< axis digit of `C2=12.5`, 0 where there is none
  bool expression = false;  ///< the value is no plain number (#1, [..], R1, function): rewriting is refused
  bool decimal_point = false;  ///< a '.' stands in the value
  std::uint8_t decimals = 0;   ///< digits after the point
  WordMode mode = WordMode::Modal;
  std::uint32_t begin = 0;  ///< column of the address, from 0
  std::uint32_t value_begin = 0;
  std::uint32_t end = 0;  ///< one past the last character
  double value = 0.0;
};

/// One line of a program. `text` excludes the line end and is valid until the next block is read.
struct Block {
  std::size_t line = 0;  ///< from 1
  std::string_view text;
  std::string_view line_end;  ///< "\n", "\r\n", or empty at the end of the file
  bool skipped = false;       ///< starts with '/' and block skip is on
  std::vector<Word> words;    ///< reused from block to block

  [[nodiscard]] const Word* find(char letter, std::uint8_t digit = 0) const {
    for (const Word& word : words) {
      if (word.letter == letter && word.digit == digit) return &word;
    }
    return nullptr;
  }
};

}  // namespace nineline::nc
