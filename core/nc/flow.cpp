#include <fmt/format.h>

#include <cmath>

#include "core/nc/execution.h"
#include "core/nc/nc_error.h"
#include "core/nc/scan.h"

namespace nineline::nc {
namespace {

constexpr std::size_t kDeepest = 100;

void jumpTo(Execution& e, const Place& place) {
  e.offset = place.offset;
  e.line = place.line - 1;
}

bool countJump(Execution& e) {
  if (++e.jumps <= e.options.most_jumps) return true;
  return fail(
      e, code::kEndless, 0,
      fmt::format("The program has jumped back {} times; it seems to be endless", e.options.most_jumps));
}

bool enterProgram(Execution& e, const Place& body, std::string name) {
  if (e.calls.size() >= kDeepest)
    return fail(e, code::kTooDeep, 0, "Subprograms are nested deeper than 100 levels");
  if (!countJump(e)) return false;
  CallLevel level;
  level.offset = e.offset;
  level.line = e.line;
  level.body = body.offset;
  level.body_line = body.line;
  level.repeats = e.jump.repeats;
  level.own_variables = e.jump.own_variables;
  level.name = std::move(name);
  level.loops = e.loops.size();
  if (level.own_variables) e.parameters->enter(e.jump.arguments);
  e.calls.push_back(std::move(level));
  jumpTo(e, body);
  return true;
}

bool callNumber(Execution& e) {
  if (!indexPrograms(e)) return false;
  const auto found = e.programs.find(e.jump.number);
  if (found == e.programs.end()) {
    return fail(e, code::kNoSuchLabel, e.jump.column,
                fmt::format("The subprogram O{} is not in this file", e.jump.number));
  }
  return enterProgram(e, {found->second.first, found->second.second}, fmt::format("O{}", e.jump.number));
}

bool callName(Execution& e) {
  if (!indexPrograms(e)) return false;
  const auto found = e.named_programs.find(e.jump.label);
  if (found == e.named_programs.end()) {
    return fail(e, code::kNoSuchLabel, e.jump.column,
                fmt::format("The subprogram '{}' is not in this file", e.jump.label));
  }
  // The line of `sub` itself would be taken as a definition: the body begins behind it.
  const Result<TextSource::Line> line = e.source.lineAt(found->second.first);
  if (!line) return e.failure = line.error(), false;
  return enterProgram(e, {line->next, found->second.second + 1}, e.jump.label);
}

bool goToLabel(Execution& e) {
  Place place;
  if (!findLabel(e, place)) return false;
  if (place.offset < e.offset && !countJump(e)) return false;
  jumpTo(e, place);
  return true;
}

bool callBlock(Execution& e) {
  Place place;
  return findLabel(e, place) && enterProgram(e, place, fmt::format("N{}", e.jump.number));
}

/// Skips to the ELSEIF, ELSE or ENDIF that belongs to the condition.
bool skipIf(Execution& e) {
  const bool to_end = e.jump.direction == 'E';
  Place place;
  Flow found = Flow::None;
  if (!findFlow(e, e.jump.label,
                to_end ? FlowSet{Flow::EndIf} : FlowSet{Flow::ElseIf, Flow::Else, Flow::EndIf}, place, found))
    return false;
  jumpTo(e, place);
  e.entered_branch = found != Flow::EndIf;
  return true;
}

bool skipLoop(Execution& e) {
  Place place;
  Flow found = Flow::None;
  const bool fanuc = e.dialect == Dialect::Fanuc;
  const FlowSet ends = fanuc                     ? FlowSet{Flow::End}
                       : e.jump.direction == 'C' ? FlowSet{Flow::While, Flow::EndRepeat}
                                                 : FlowSet{Flow::EndWhile, Flow::EndRepeat, Flow::While};
  if (!findFlow(e, e.jump.label, ends, place, found)) return false;
  jumpTo(e, place);
  e.skip_line = e.jump.direction != 'C';
  return true;
}

bool skipSub(Execution& e) {
  Place place;
  Flow found = Flow::None;
  if (!findFlow(e, e.jump.label, FlowSet{Flow::EndSub}, place, found)) return false;
  jumpTo(e, place);
  e.skip_line = true;
  return true;
}

void plan(Execution& e, JumpKind kind, char direction = 0) {
  e.jump.kind = kind;
  e.jump.label = e.statement.label;
  e.jump.number = e.statement.number;
  e.jump.direction = direction;
  e.jump.column = e.statement.flow_column;
  e.jump.repeats = 1;
  e.jump.own_variables = false;
}

bool misplaced(Execution& e, const char* what) {
  return fail(e, code::kBadFlow, e.statement.flow_column,
              fmt::format("{} stands without its beginning", what));
}

LoopLevel* openLoop(Execution& e, const std::string& label) {
  const std::size_t floor = e.calls.empty() ? 0 : e.calls.back().loops;
  while (e.loops.size() > floor) {
    if (e.loops.back().label == label) return &e.loops.back();
    e.loops.pop_back();
  }
  return nullptr;
}

bool backTo(Execution& e, const LoopLevel& loop) {
  if (!countJump(e)) return false;
  e.offset = loop.offset;
  e.line = loop.line;
  return true;
}

void pushLoop(Execution& e, const std::string& label, LoopKind kind, long repeats) {
  const bool again = kind == LoopKind::While;  // the line itself is executed again
  e.loops.push_back({label, again ? e.line_offset : e.offset, again ? e.line - 1 : e.line, repeats, kind});
}

bool whileLine(Execution& e) {
  const Statement& s = e.statement;
  LoopLevel* const open = openLoopHere(e, s.label);
  if (open && open->kind == LoopKind::Do) {
    if (s.truth) return backTo(e, *open);
    e.loops.pop_back();
    return true;
  }
  // Reached again by a jump; another WHILE inside (Siemens has no labels) is no repetition.
  if (open && open->offset == e.line_offset) e.loops.pop_back();
  if (s.truth) {
    pushLoop(e, s.label, LoopKind::While, -1);
  } else {
    plan(e, JumpKind::SkipLoop);
  }
  return true;
}

bool endLoopLine(Execution& e, const char* what) {
  LoopLevel* const open = openLoop(e, e.statement.label);
  if (!open) return misplaced(e, what);
  if (open->kind == LoopKind::Repeat && --open->repeats <= 0) {
    e.loops.pop_back();
    return true;
  }
  const LoopLevel loop = *open;
  if (loop.kind == LoopKind::While) e.loops.pop_back();
  return backTo(e, loop);
}

bool repeatLine(Execution& e) {
  const double count = e.statement.count;
  if (!(count < 1e9))
    return fail(e, code::kBadValue, e.statement.flow_column,
                fmt::format("{} is no number of repeats", count));
  if (count >= 1.0) {
    pushLoop(e, e.statement.label, LoopKind::Repeat, static_cast<long>(count));
  } else {
    plan(e, JumpKind::SkipLoop);
  }
  return true;
}

bool leaveLoopLine(Execution& e, bool go_on) {
  LoopLevel* const open = openLoop(e, e.statement.label);
  if (!open) return misplaced(e, go_on ? "CONTINUE" : "BREAK");
  if (go_on && open->kind == LoopKind::While) {
    const LoopLevel loop = *open;
    e.loops.pop_back();
    return backTo(e, loop);
  }
  if (!go_on) e.loops.pop_back();
  plan(e, JumpKind::SkipLoop, go_on ? 'C' : 0);
  return true;
}

bool callLine(Execution& e) {
  plan(e, JumpKind::CallName);
  e.jump.own_variables = true;
  e.jump.arguments.assign(1, Value{});
  e.jump.arguments.insert(e.jump.arguments.end(), e.statement.arguments.begin(), e.statement.arguments.end());
  return true;
}

bool returnLine(Execution& e) {
  if (e.calls.empty()) return misplaced(e, "ENDSUB or RETURN");
  const bool has_value = !e.statement.arguments.empty();
  e.parameters->define("_value", has_value ? e.statement.arguments.front() : Value{});
  e.parameters->define("_value_returned", {has_value ? 1.0 : 0.0, false});
  return returnFromCall(e);
}

/// Looks for what closes a loop, from the line behind the one that opens it. A fault names the opening line.
bool findEnd(Execution& e, const LoopLevel& loop) {
  Place next{loop.offset, loop.line + 1};
  if (loop.kind == LoopKind::While) {  // its place is the opening line itself
    const Result<TextSource::Line> line = e.source.lineAt(loop.offset);
    if (!line) return e.failure = line.error(), false;
    next = {line->next, loop.line + 2};
  }
  jumpTo(e, next);
  e.block.line = next.line - 1;
  e.jump.column = 0;
  const FlowSet ends = e.dialect == Dialect::Fanuc     ? FlowSet{Flow::End}
                       : loop.kind == LoopKind::Repeat ? FlowSet{Flow::EndRepeat}
                       : loop.kind == LoopKind::Do     ? FlowSet{Flow::While}
                                                       : FlowSet{Flow::EndWhile};
  Place place;
  Flow found = Flow::None;
  return findFlow(e, loop.label, ends, place, found);
}

void fanucLabel(Execution& e) {
  if (e.dialect == Dialect::Fanuc) e.statement.label = fmt::format("{}", e.statement.number);
}

}  // namespace

LoopLevel* openLoopHere(Execution& e, const std::string& label) {
  const std::size_t floor = e.calls.empty() ? 0 : e.calls.back().loops;
  return e.loops.size() > floor && e.loops.back().label == label ? &e.loops.back() : nullptr;
}

bool executeFlow(Execution& e) {
  const bool entered = e.entered_branch;
  e.entered_branch = false;
  switch (e.statement.flow) {
    case Flow::None:
      return true;
    case Flow::Goto:
      plan(e, JumpKind::Goto, e.statement.direction);
      return true;
    case Flow::WhileDo:
      fanucLabel(e);
      return whileLine(e);
    case Flow::End:
      fanucLabel(e);
      return endLoopLine(e, "END");
    case Flow::Sub:
      plan(e, JumpKind::SkipSub);
      return true;
    case Flow::EndSub:
    case Flow::Return:
      return returnLine(e);
    case Flow::Call:
      return callLine(e);
    case Flow::If:
      if (!e.statement.truth) plan(e, JumpKind::SkipIf);
      return true;
    case Flow::ElseIf:
      if (!entered) plan(e, JumpKind::SkipIf, 'E');
      if (entered && !e.statement.truth) plan(e, JumpKind::SkipIf);
      return true;
    case Flow::Else:
      if (!entered) plan(e, JumpKind::SkipIf, 'E');
      return true;
    case Flow::EndIf:
      return true;
    case Flow::While:
      return whileLine(e);
    case Flow::EndWhile:
      return endLoopLine(e, "ENDWHILE");
    case Flow::Do:
      pushLoop(e, e.statement.label, LoopKind::Do, -1);
      return true;
    case Flow::Repeat:
      return repeatLine(e);
    case Flow::EndRepeat:
      return endLoopLine(e, "ENDREPEAT");
    case Flow::Break:
      return leaveLoopLine(e, false);
    case Flow::Continue:
      return leaveLoopLine(e, true);
  }
  return true;
}

bool returnFromCall(Execution& e) {
  CallLevel& level = e.calls.back();
  e.loops.resize(std::min(e.loops.size(), level.loops));
  if (--level.repeats > 0) {
    jumpTo(e, {level.body, level.body_line});
    return countJump(e);
  }
  e.offset = level.offset;
  e.line = level.line;
  if (level.own_variables) e.parameters->leave();
  e.calls.pop_back();
  return true;
}

bool followJump(Execution& e) {
  const JumpKind kind = e.jump.kind;
  e.jump.kind = JumpKind::None;
  switch (kind) {
    case JumpKind::None:
      return true;
    case JumpKind::End:
      return endProgram(e);
    case JumpKind::CallNumber:
      return callNumber(e);
    case JumpKind::CallName:
      return callName(e);
    case JumpKind::CallBlock:
      return callBlock(e);
    case JumpKind::Goto:
      return goToLabel(e);
    case JumpKind::SkipIf:
      return skipIf(e);
    case JumpKind::SkipLoop:
      return skipLoop(e);
    case JumpKind::SkipSub:
      return skipSub(e);
  }
  return true;
}

bool endProgram(Execution& e) {
  const Place here{e.offset, e.line};
  const std::size_t block_line = e.block.line;
  for (const LoopLevel& loop : e.loops) {
    if (!findEnd(e, loop)) return false;
  }
  jumpTo(e, {here.offset, here.line + 1});
  e.block.line = block_line;
  e.ended = true;
  return true;
}

bool atEndOfText(Execution& e) {
  if (!e.calls.empty()) {
    return fail(e, code::kNoEnd, 0,
                fmt::format("The file ends inside the subprogram {}", e.calls.back().name));
  }
  if (!e.loops.empty())
    return fail(e, code::kBadFlow, 0, fmt::format("The file ends inside the loop {}", e.loops.back().label));
  e.ended = true;
  return true;
}

}  // namespace nineline::nc
