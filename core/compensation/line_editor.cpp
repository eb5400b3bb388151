#include "core/compensation/line_editor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace nineline::compensation {

namespace {

constexpr std::size_t kLinesToLearnFrom = 20000;

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

bool belongsToMotion(const nc::Word& word) {
  return isAxisLetter(word.letter) || word.letter == 'G' || word.letter == 'I' || word.letter == 'J' ||
         word.letter == 'K' || word.letter == 'R';
}

/// Counts digits after the points of a line's axis words, comments left out.
void countDecimals(std::string_view line, const nc::AxisLayout& layout, NumberStyle& style) {
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == ';') return;
    if (line[i] == '(') {
      i = std::min(line.find(')', i), line.size());
      continue;
    }
    const char letter = static_cast<char>(line[i] & ~0x20);
    if (letter == 'G' && (line.substr(i + 1, 2) == "20" || line.substr(i + 1, 2) == "70")) style.inch = true;
    if (!isAxisLetter(letter)) continue;
    AxisId axis{letter, 0};
    std::size_t k = i + 1;
    if (k + 1 < line.size() && line[k + 1] == '=' && line[k] >= '1' && line[k] <= '9')
      axis.digit = static_cast<std::uint8_t>(line[k++] - '0');
    while (k < line.size() && (line[k] == '=' || line[k] == ' ' || line[k] == '-' || line[k] == '+')) ++k;
    while (k < line.size() && line[k] >= '0' && line[k] <= '9') ++k;
    int decimals = 0;
    if (k < line.size() && line[k] == '.') {
      while (++k < line.size() && line[k] >= '0' && line[k] <= '9') ++decimals;
    }
    const int index = layout.find(axis);
    if (index >= 0) {
      int& most =
          layout.axes[static_cast<std::size_t>(index)].rotary ? style.rotary_decimals : style.linear_decimals;
      most = std::max(most, std::min(decimals, 9));
    }
    i = k - 1;
  }
}

}  // namespace

Result<NumberStyle> learnNumberStyle(nc::TextSource& source, const nc::AxisLayout& layout) {
  NumberStyle style;
  std::uint64_t offset = 0;
  for (std::size_t line = 0; line < kLinesToLearnFrom && offset < source.size(); ++line) {
    const Result<nc::TextSource::Line> text = source.lineAt(offset);
    if (!text) return text.error();
    countDecimals(text->text, layout, style);
    offset = text->next;
  }
  if (style.inch) style.linear_decimals = std::max(style.linear_decimals, 4);
  return style;
}

bool appendDecimal(double value, int decimals, std::string& out) {
  static constexpr std::array<double, 10> kPowers = {1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};
  const double scaled = std::round(std::abs(value) * kPowers[static_cast<std::size_t>(decimals)]);
  if (!(scaled < 9e15)) return false;
  auto digits = static_cast<std::uint64_t>(scaled);
  std::array<char, 32> buffer;
  std::size_t at = buffer.size();
  int left = decimals;
  while (left > 0 && digits % 10 == 0) digits /= 10, --left;
  for (; left > 0; --left, digits /= 10) buffer[--at] = static_cast<char>('0' + digits % 10);
  buffer[--at] = '.';
  do {
    buffer[--at] = static_cast<char>('0' + digits % 10);
    digits /= 10;
  } while (digits != 0);
  if (value < 0.0 && scaled != 0.0) buffer[--at] = '-';
  out.append(&buffer[at], buffer.size() - at);
  return true;
}

void LineEditor::begin(const nc::Block& block) {
  block_ = &block;
  changes_.clear();
  codes_.clear();
  added_.clear();
  spaced_ = block.words.size() < 2;
  for (std::size_t i = 1; i < block.words.size(); ++i) {
    if (block.text[block.words[i].begin - 1] == ' ') spaced_ = true;
  }
}

void LineEditor::beginNew(const nc::Block& block) {
  begin(block);
  added_ = !block.text.empty() && block.text[0] == '/' ? "/" : "";
  block_ = nullptr;
}

bool LineEditor::setValue(const nc::Word& word, double value, int decimals) {
  if (!word.expression && word.value == value) return false;
  Change change{word.value_begin, word.end, {}};
  const std::string_view old = block_->text.substr(word.value_begin, word.end - word.value_begin);
  const bool wrapped = word.mode != nc::WordMode::Modal && old.find('(') != std::string_view::npos;
  if (wrapped) change.text = old.substr(0, old.find('(') + 1);
  NL_EXPECTS(appendDecimal(value, decimals, change.text), value);
  if (wrapped) change.text += ')';
  changes_.push_back(std::move(change));
  return true;
}

void LineEditor::add(std::string_view address, double value, int decimals) {
  if (spaced_ && !(block_ == nullptr && (added_.empty() || added_ == "/"))) added_ += ' ';
  added_ += address;
  NL_EXPECTS(appendDecimal(value, decimals, added_), value);
}

bool LineEditor::setAxis(AxisId axis, double value, int decimals) {
  if (block_ != nullptr) {
    const nc::Word* word = block_->find(axis.letter, axis.digit);
    if (word == nullptr && axis.digit == 0) word = block_->find(incrementAddress(axis.letter));
    if (word != nullptr) return setValue(*word, value, decimals);
  }
  std::string address = axis.text();
  if (axis.digit != 0) address += '=';
  add(address, value, decimals);
  return true;
}

bool LineEditor::setWord(char letter, double value, int decimals) {
  const nc::Word* word = block_ != nullptr ? block_->find(letter) : nullptr;
  if (word != nullptr) return setValue(*word, value, decimals);
  add(std::string_view(&letter, 1), value, decimals);
  return true;
}

void LineEditor::removeWord(char letter) {
  if (const nc::Word* word = block_ != nullptr ? block_->find(letter) : nullptr)
    changes_.push_back({word->begin, word->end, {}});
}

void LineEditor::addCode(int code) {
  codes_ = {'G', static_cast<char>('0' + code / 10), static_cast<char>('0' + code % 10)};
}

void LineEditor::finish(std::string& out) {
  if (block_ == nullptr) {
    const bool skip = !added_.empty() && added_[0] == '/';
    if (skip) out += '/';
    out += codes_;
    if (!codes_.empty() && spaced_) out += ' ';
    out += std::string_view(added_).substr(skip ? 1 : 0);
    return;
  }
  // A new code goes before the first word that is no N word, new words after the last word of the motion.
  std::size_t first = 0;
  std::size_t last = 0;
  for (const nc::Word& word : block_->words) {
    if (belongsToMotion(word)) last = word.end;
  }
  for (auto word = block_->words.rbegin(); word != block_->words.rend(); ++word) {
    if (word->letter != 'N') first = word->begin;
  }
  if (!codes_.empty()) changes_.push_back({first, first, spaced_ ? codes_ + " " : codes_});
  if (!added_.empty()) changes_.push_back({last, last, added_});
  std::stable_sort(changes_.begin(), changes_.end(),
                   [](const Change& a, const Change& b) { return a.begin < b.begin; });
  std::size_t copied = 0;
  for (const Change& change : changes_) {
    out += block_->text.substr(copied, change.begin - copied);
    out += change.text;
    copied = change.end;
  }
  out += block_->text.substr(copied);
}

}  // namespace nineline::compensation
