#include "core/compensation/line_assembler.h"

#include <fmt/format.h>

#include <functional>

namespace nineline::compensation {

namespace {

std::uint64_t hashOf(std::string_view text) { return std::hash<std::string_view>{}(text); }

Error differs(std::size_t line, const std::string& source) {
  return badInput("compensation.repeat",
                  "This line is executed more than once and would need a different correction each time. "
                  "Write the subprogram or loop out.",
                  source, line);
}

}  // namespace

Result<void> LineAssembler::write(std::string_view text) {
  written_.push_back(hashOf(text));
  return sink_(text);
}

Result<void> LineAssembler::copyLine() {
  const Result<nc::TextSource::Line> line = source_.lineAt(next_offset_);
  if (!line) return line.error();
  next_offset_ = line->next;
  ++next_line_;
  written_.push_back(0);
  if (Result<void> text = sink_(line->text); !text) return text;
  return sink_(line->line_end);
}

Result<void> LineAssembler::put(std::size_t line, std::string_view text) {
  if (line < next_line_)
    return written_[line - 1] == hashOf(text) ? Result<void>() : differs(line, source_.name());
  if (line == next_line_) {
    // The text belongs to the interpreter's line buffer at most until the source is asked for another line.
    std::string kept(text);
    const Result<nc::TextSource::Line> old = source_.lineAt(next_offset_);
    if (!old) return old.error();
    next_offset_ = old->next;
    ++next_line_;
    if (Result<void> written = write(kept); !written) return written;
    return writeWaiting();
  }
  const auto [place, is_new] = waiting_.try_emplace(line, text);
  return is_new || place->second == text ? Result<void>() : differs(line, source_.name());
}

Result<void> LineAssembler::writeWaiting() {
  while (!waiting_.empty() && waiting_.begin()->first == next_line_) {
    const std::string text = std::move(waiting_.begin()->second);
    waiting_.erase(waiting_.begin());
    const Result<nc::TextSource::Line> old = source_.lineAt(next_offset_);
    if (!old) return old.error();
    next_offset_ = old->next;
    ++next_line_;
    if (Result<void> written = write(text); !written) return written;
  }
  return {};
}

Result<void> LineAssembler::finish() {
  while (next_offset_ < source_.size()) {
    if (!waiting_.empty() && waiting_.begin()->first == next_line_) {
      if (Result<void> written = writeWaiting(); !written) return written;
      continue;
    }
    if (Result<void> copied = copyLine(); !copied) return copied;
  }
  return {};
}

}  // namespace nineline::compensation
