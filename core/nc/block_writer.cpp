#include "core/nc/block_writer.h"

#include <algorithm>
#include <cstring>

#include "core/nc/characters.h"

namespace nineline::nc {
namespace {

bool isAxisWord(const Word& word) {
  return std::string_view("XYZUVWABC").find(word.letter) != std::string_view::npos && word.letter != 0;
}

}  // namespace

BlockEditor::Edit* BlockEditor::addEdit(std::uint32_t begin, std::uint32_t end) {
  if (count_ == kMostEdits) return nullptr;
  // Kept in the order of the line; what is added at one place keeps its order.
  std::size_t at = count_;
  while (at > 0 && edits_[at - 1].begin > begin) {
    edits_[at] = edits_[at - 1];
    --at;
  }
  ++count_;
  edits_[at].begin = begin;
  edits_[at].end = end;
  edits_[at].size = 0;
  return &edits_[at];
}

bool BlockEditor::setValue(const Word& word, double value, int decimals) {
  std::array<char, kLongestNumber> number;
  const std::size_t size = formatNumber(value, decimals, *style_, number);
  if (word.expression || size == 0) return false;
  Edit* const edit = addEdit(word.value_begin, word.end);
  if (!edit) return false;
  std::memcpy(edit->text.data(), number.data(), size);
  edit->size = static_cast<std::uint32_t>(size);
  return true;
}

bool BlockEditor::replace(const Word& word, std::string_view text) {
  if (text.size() > kLongestText) return false;
  Edit* const edit = addEdit(word.begin, word.end);
  if (!edit) return false;
  std::memcpy(edit->text.data(), text.data(), text.size());
  edit->size = static_cast<std::uint32_t>(text.size());
  return true;
}

std::uint32_t BlockEditor::placeForWords() const {
  const Word* place = nullptr;
  bool axis = false;
  for (const Word& word : block_->words) {
    const bool is_axis = isAxisWord(word);
    if (is_axis || (!axis && (word.letter == 'G' || word.letter == 'N'))) place = &word;
    axis = axis || is_axis;
  }
  if (place) return place->end;
  std::uint32_t start = block_->line == 1 && block_->text.starts_with("\xef\xbb\xbf") ? 3 : 0;
  const auto size = static_cast<std::uint32_t>(block_->text.size());
  while (start < size && (isBlank(block_->text[start]) || block_->text[start] == '/')) ++start;
  return start;
}

bool BlockEditor::isSpaced() const {
  const std::vector<Word>& words = block_->words;
  for (std::size_t i = 1; i < words.size(); ++i) {
    if (words[i].begin > words[i - 1].end) return true;
  }
  return words.size() < 2;
}

bool BlockEditor::addText(std::string_view text) {
  if (text.size() + 2 > kLongestText) return false;
  const std::uint32_t place = placeForWords();
  Edit* const edit = addEdit(place, place);
  if (!edit) return false;
  char* p = edit->text.data();
  const bool at_start = place == 0 || isBlank(block_->text[place - 1]) || block_->text[place - 1] == '/';
  const bool follows = at_start && place == block_->text.size() && count_ > 1;  // on a new line
  if ((!at_start && isSpaced()) || follows) *p++ = ' ';
  std::memcpy(p, text.data(), text.size());
  p += text.size();
  if (at_start && place < block_->text.size()) *p++ = ' ';
  edit->size = static_cast<std::uint32_t>(p - edit->text.data());
  return true;
}

bool BlockEditor::addWord(char letter, std::uint8_t digit, double value, int decimals, bool equal_sign) {
  std::array<char, kLongestNumber + 4> text;
  std::array<char, kLongestNumber> number;
  const std::size_t size = formatNumber(value, decimals, *style_, number);
  if (size == 0 || digit > 9) return false;
  char* p = text.data();
  *p++ = letter;
  if (digit != 0) *p++ = static_cast<char>('0' + digit);
  if (digit != 0 || equal_sign) *p++ = '=';
  std::memcpy(p, number.data(), size);
  return addText({text.data(), static_cast<std::size_t>(p - text.data()) + size});
}

bool BlockEditor::remove(const Word& word) {
  std::uint32_t begin = word.begin;
  while (begin > 0 && isBlank(block_->text[begin - 1])) --begin;
  std::uint32_t end = word.end;
  if (begin == 0) {
    begin = word.begin;
    while (end < block_->text.size() && isBlank(block_->text[end])) ++end;
  }
  return addEdit(begin, end) != nullptr;
}

void BlockEditor::appendTo(std::string& out) const {
  std::uint32_t done = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    const Edit& edit = edits_[i];
    if (edit.begin > done) out.append(block_->text.data() + done, edit.begin - done);
    out.append(edit.text.data(), edit.size);
    done = std::max(done, edit.end);
  }
  out.append(block_->text.data() + done, block_->text.size() - done);
}

}  // namespace nineline::nc
