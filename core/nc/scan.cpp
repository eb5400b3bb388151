#include "core/nc/scan.h"

#include <fmt/format.h>

#include "core/nc/nc_error.h"

namespace nineline::nc {
namespace {

/// Calls `visit(mark, place)` for each line from `place` up to `end`, until it returns false. False on a read
/// fault.
template <typename Visit>
bool scanLines(Execution& e, Place place, std::uint64_t end, Visit visit) {
  while (place.offset < end) {
    const Result<TextSource::Line> line = e.source.lineAt(place.offset);
    if (!line) {
      e.failure = line.error();
      return false;
    }
    LineMark mark;
    if (mayBeMark(line->text)) mark = markOf(line->text, e.dialect);
    if (!visit(mark, place)) return true;
    place = {line->next, place.line + 1};
  }
  return true;
}

bool matches(const Execution& e, const LineMark& mark) {
  if (e.dialect == Dialect::Siemens && !e.jump.label.empty()) return mark.block_label == e.jump.label;
  return mark.block_number == e.jump.number;
}

std::string nameOf(const Jump& jump) {
  return jump.label.empty() ? fmt::format("N{}", jump.number) : jump.label;
}

}  // namespace

bool indexPrograms(Execution& e) {
  if (e.indexed) return true;
  e.indexed = true;
  return scanLines(e, {0, 1}, e.source.size(), [&](const LineMark& mark, const Place& place) {
    if (!mark.is_o_word) return true;
    if (mark.flow == Flow::Sub) e.named_programs.emplace(mark.label, std::pair(place.offset, place.line));
    if (mark.flow == Flow::None && mark.number >= 0)
      e.programs.emplace(mark.number, std::pair(place.offset, place.line));
    return true;
  });
}

bool findLabel(Execution& e, Place& place) {
  const bool forward = e.jump.direction != '-';
  const bool backward = e.jump.direction != '+';
  bool found = false;
  const auto first_match = [&](const LineMark& mark, const Place& at) {
    if (mark.is_o_word && e.dialect == Dialect::Fanuc && at.offset != e.offset)
      return false;  // another program begins
    if (!matches(e, mark)) return true;
    place = at;
    found = true;
    return false;
  };
  if (forward && !scanLines(e, {e.offset, e.line + 1}, e.source.size(), first_match)) return false;
  const Place begin = e.calls.empty() ? Place{} : Place{e.calls.back().body, e.calls.back().body_line};
  const auto last_match = [&](const LineMark& mark, const Place& at) {
    if (!matches(e, mark)) return true;
    place = at;
    found = true;
    return e.dialect == Dialect::Siemens;
  };
  if (!found && backward && !scanLines(e, begin, e.offset, last_match)) return false;
  if (found) return true;
  return fail(e, code::kNoSuchLabel, e.jump.column,
              fmt::format("The jump target {} is not in this program", nameOf(e.jump)));
}

bool findFlow(Execution& e, const std::string& label, FlowSet flows, Place& place, Flow& found) {
  found = Flow::None;
  int depth = 0;  // Siemens has no labels: IF inside IF is counted
  const bool done =
      scanLines(e, {e.offset, e.line + 1}, e.source.size(), [&](const LineMark& mark, const Place& at) {
        if (e.dialect == Dialect::Siemens) {
          const bool opens = mark.flow == (flows.contains(Flow::EndIf) ? Flow::If : Flow::While);
          if (opens) ++depth;
          const bool closes = mark.flow == (flows.contains(Flow::EndIf) ? Flow::EndIf : Flow::EndWhile);
          if (depth > 0) {
            if (closes) --depth;
            return true;
          }
          if (opens || !flows.contains(mark.flow)) return true;
        } else {
          const std::string own = e.dialect == Dialect::Fanuc ? fmt::format("{}", mark.number) : mark.label;
          if (!flows.contains(mark.flow) || own != label) return true;
        }
        place = at;
        found = mark.flow;
        return false;
      });
  if (!done) return false;
  if (found != Flow::None) return true;
  return fail(e, code::kBadFlow, e.jump.column,
              fmt::format("What begins here ({}) has no end in this file", label));
}

}  // namespace nineline::nc
