#include "core/compensation/line_editor.h"

#include <algorithm>
#include <array>

namespace nineline::compensation {

namespace {

/// The address that means an increment of an axis on Fanuc lathes.
char incrementAddress(char letter) {
  switch (letter) {
    case 'X':
      return 'U';
    case 'Y':
      return 'V';
    case 'Z':
      return 'W';
    case 'C':
      return 'H';
    default:
      return 0;
  }
}

}  // namespace

Result<nc::NumberStyle> styleOf(nc::TextSource& source, nc::Dialect dialect, const nc::AxisLayout& layout) {
  Result<nc::NumberStyle> style = nc::learnNumberStyle(source, dialect, layout);
  if (!style) return style;
  const int least = style->inch ? 4 : 3;
  if (style->linear_decimals < least || style->rotary_decimals < 3) style->trailing_zeros = false;
  style->linear_decimals = std::max(style->linear_decimals, least);
  style->rotary_decimals = std::max(style->rotary_decimals, 3);
  return style;
}

void LineEditor::begin(const nc::Block& block) {
  block_ = &block;
  editor_.emplace(block, style_);
}

void LineEditor::beginNew(const nc::Block& block) {
  blank_.text = block.text.starts_with('/') ? "/" : "";
  block_ = &blank_;
  editor_.emplace(blank_, style_);
}

const nc::Word* LineEditor::find(char letter, std::uint8_t digit) const {
  return block_->find(letter, digit);
}

bool LineEditor::setValue(const nc::Word& word, double value, int decimals) {
  if (!word.expression && word.value == value) return false;
  const std::string_view old = block_->text.substr(word.begin, word.end - word.begin);
  const std::size_t bracket = word.mode == nc::WordMode::Modal ? std::string_view::npos : old.find('(');
  if (bracket == std::string_view::npos) {
    NL_EXPECTS(editor_->setValue(word, value, decimals), value);
    return true;
  }
  std::array<char, nc::kLongestNumber> number;  // X=IC(10): the brackets stay
  const std::size_t size = nc::formatNumber(value, decimals, style_, number);
  NL_EXPECTS(size != 0, value);
  std::string text(old.substr(0, bracket + 1));
  text.append(number.data(), size);
  NL_EXPECTS(editor_->replace(word, text + ')'), value);
  return true;
}

bool LineEditor::setAxis(AxisId axis, double value, int decimals, bool named) {
  const nc::Word* word = find(axis.letter, axis.digit);
  if (word == nullptr && named && axis.digit == 0) word = find(incrementAddress(axis.letter), 0);
  if (word != nullptr) return setValue(*word, value, decimals);
  NL_EXPECTS(editor_->addWord(axis.letter, axis.digit, value, decimals), value);
  return true;
}

bool LineEditor::setWord(char letter, double value, int decimals) {
  if (const nc::Word* word = find(letter, 0)) return setValue(*word, value, decimals);
  NL_EXPECTS(editor_->addWord(letter, 0, value, decimals), value);
  return true;
}

void LineEditor::removeWord(char letter) {
  if (const nc::Word* word = find(letter, 0)) NL_EXPECTS(editor_->remove(*word));
}

void LineEditor::addCode(int code) {
  const std::array<char, 3> text = {'G', static_cast<char>('0' + code / 10),
                                    static_cast<char>('0' + code % 10)};
  NL_EXPECTS(editor_->addText({text.data(), text.size()}), code);
}

void LineEditor::finish(std::string& out) { editor_->appendTo(out); }

}  // namespace nineline::compensation
