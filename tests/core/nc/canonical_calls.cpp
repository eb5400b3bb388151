#include "tests/core/nc/canonical_calls.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "core/base/text.h"
#include "core/base/units.h"

namespace nineline::nc::testing {
namespace {

std::vector<double> numbersIn(std::string_view text) {
  std::vector<double> numbers;
  const std::string copy(text);
  for (const char* p = copy.c_str(); *p != '\0';) {
    char* end = nullptr;
    const double value = std::strtod(p, &end);
    if (end == p) {
      ++p;
    } else {
      numbers.push_back(value);
      p = end;
    }
  }
  return numbers;
}

class CanonicalReader {
 public:
  void take(std::string_view line) {
    const std::size_t open = line.find('(');
    if (open == std::string_view::npos) return;
    const std::string_view head = line.substr(0, open);
    const std::string_view name = head.substr(head.find_last_of(" \t") + 1);
    const std::string_view arguments = line.substr(open + 1);
    const std::vector<double> n = numbersIn(arguments);
    if (name == "USE_LENGTH_UNITS")
      unit_ = arguments.find("INCH") != std::string_view::npos ? kMillimetresPerInch : 1.0;
    if (name == "SELECT_PLANE")
      plane_ = arguments.find("XZ") != std::string_view::npos   ? 18
               : arguments.find("YZ") != std::string_view::npos ? 19
                                                                : 17;
    if (name == "SET_XY_ROTATION") rotation_ = radFromDeg(n.at(0));
    if (name == "SET_G5X_OFFSET") setOffset(g5x_, n, 1);
    if (name == "SET_G92_OFFSET") setOffset(g92_, n, 0);
    if (name == "USE_TOOL_LENGTH_OFFSET") setOffset(tool_, n, 0);
    if (name == "STRAIGHT_TRAVERSE" || name == "STRAIGHT_FEED") straight(n, name == "STRAIGHT_TRAVERSE");
    if (name == "ARC_FEED") arc(n);
    if (name == "RIGID_TAP") rigidTap(n);
    if (name == "DISABLE_FEED_OVERRIDE") locked_ = true;
    if (name == "ENABLE_FEED_OVERRIDE") locked_ = false;
  }

  std::vector<CanonicalMove> moves;

 private:
  void setOffset(std::array<double, 6>& offset, const std::vector<double>& n, std::size_t first) const {
    for (std::size_t i = 0; i < 6; ++i) offset[i] = n.at(first + i) * (i < 3 ? unit_ : 1.0);
  }

  [[nodiscard]] std::array<double, 6> machine(std::array<double, 6> p) const {
    for (std::size_t i = 0; i < 6; ++i) p[i] += g92_[i];
    const double x = std::cos(rotation_) * p[0] - std::sin(rotation_) * p[1];
    p[1] = std::sin(rotation_) * p[0] + std::cos(rotation_) * p[1];
    p[0] = x;
    for (std::size_t i = 0; i < 6; ++i) p[i] += g5x_[i] + tool_[i];
    return p;
  }

  void add(const std::array<double, 6>& program, CanonicalMove move) {
    program_ = program;
    move.end = machine(program);
    coarsest_ = std::fmax(coarsest_, unit_);  // offsets were rounded when they were printed
    move.unit = coarsest_;
    move.locked = locked_;
    moves.push_back(move);
  }

  void straight(const std::vector<double>& n, bool rapid) {
    std::array<double, 6> p{};
    for (std::size_t i = 0; i < 6; ++i) p[i] = n.at(i) * (i < 3 ? unit_ : 1.0);
    CanonicalMove move;
    move.rapid = rapid;
    add(p, move);
  }

  void arc(const std::vector<double>& n) {
    const std::size_t u = plane_ == 17 ? 0 : plane_ == 18 ? 2 : 1;
    const std::size_t v = plane_ == 17 ? 1 : plane_ == 18 ? 0 : 2;
    std::array<double, 6> p{};
    p[u] = n.at(0) * unit_;
    p[v] = n.at(1) * unit_;
    p[3 - u - v] = n.at(5) * unit_;
    for (std::size_t i = 3; i < 6; ++i) p[i] = n.at(3 + i);
    std::array<double, 6> centre = p;
    centre[u] = n.at(2) * unit_;
    centre[v] = n.at(3) * unit_;
    centre = machine(centre);
    CanonicalMove move;
    move.sweep_turns = n.at(4);
    move.centre = {centre[u], centre[v]};
    add(p, move);
  }

  void rigidTap(const std::vector<double>& n) {
    const std::array<double, 6> begin = program_;
    std::array<double, 6> p = begin;
    for (std::size_t i = 0; i < 3; ++i) p[i] = n.at(i) * unit_;
    add(p, {});
    add(begin, {});
  }

  bool locked_ = false;
  double unit_ = 1.0;
  double coarsest_ = 1.0;
  double rotation_ = 0.0;
  int plane_ = 17;
  std::array<double, 6> g5x_{}, g92_{}, tool_{}, program_{};
};

bool isNear(const std::array<double, 6>& a, const std::array<double, 6>& b, double tolerance) {
  for (std::size_t i = 0; i < 6; ++i) {
    if (!(std::fabs(a[i] - b[i]) <= tolerance)) return false;
  }
  return true;
}

std::vector<CanonicalMove> withoutStandstill(const std::vector<CanonicalMove>& moves) {
  std::vector<CanonicalMove> kept;
  std::array<double, 6> at{};
  for (const CanonicalMove& move : moves) {
    const bool stands = move.sweep_turns == 0.0 && isNear(at, move.end, 1.5e-4 * move.unit);
    if (!stands) kept.push_back(move);
    if (!stands) at = move.end;
  }
  return kept;
}

std::string textOf(const CanonicalMove& m) {
  return fmt::format("{}{:.4f} {:.4f} {:.4f} {:.4f} {:.4f} {:.4f} turns {} centre {:.4f} {:.4f}",
                     m.rapid ? "rapid " : "feed ", m.end[0], m.end[1], m.end[2], m.end[3], m.end[4], m.end[5],
                     m.sweep_turns, m.centre[0], m.centre[1]);
}

}  // namespace

AxisLayout sixAxes() {
  AxisLayout layout;
  for (const char letter : {'X', 'Y', 'Z', 'A', 'B', 'C'}) {
    layout.axes[static_cast<std::size_t>(layout.count++)] = {{letter, 0}, letter <= 'C', false};
  }
  return layout;
}

std::vector<CanonicalMove> readCanonicalCalls(std::string_view text) {
  CanonicalReader reader;
  for (const std::string_view line : split(text, '\n')) reader.take(line);
  return reader.moves;
}

OwnMoves interpretMoves(const std::string& name, const std::string& program, InterpreterOptions options) {
  OwnMoves own;
  MemoryText text(name, program);
  options.axes = sixAxes();
  Interpreter interpreter(text, std::move(options));
  for (;;) {
    const Result<const ExecutedBlock*> block = interpreter.next();
    if (!block) own.error = block.error().message();
    if (!block || !*block) break;
    for (const Motion& motion : (*block)->motions) {
      CanonicalMove move;
      move.rapid = motion.kind == MotionKind::Rapid;
      for (std::size_t i = 0; i < 6; ++i) move.end[i] = i < 3 ? motion.end[i] : degFromRad(motion.end[i]);
      if (motion.kind == MotionKind::Arc) {
        const double turns = std::ceil(std::fabs(motion.sweep) / kTurn - 1e-6);
        move.sweep_turns = std::copysign(std::fmax(1.0, turns), motion.sweep);
        move.centre = motion.centre;
      }
      own.moves.push_back(move);
    }
  }
  if (own.error.empty() && interpreter.diagnostics().hasErrors())
    own.error = interpreter.diagnostics().firstError(name).message();
  return own;
}

std::string differenceOf(const std::vector<CanonicalMove>& own_moves,
                         const std::vector<CanonicalMove>& expected_moves) {
  const std::vector<CanonicalMove> own = withoutStandstill(own_moves);
  const std::vector<CanonicalMove> expected = withoutStandstill(expected_moves);
  for (std::size_t i = 0; i < own.size() && i < expected.size(); ++i) {
    const CanonicalMove& a = own[i];
    const CanonicalMove& b = expected[i];
    // Four decimals of the program's unit, in the point and in each of three offsets.
    const double tolerance = 2.2e-4 * b.unit;
    const bool arc_agrees = a.sweep_turns == b.sweep_turns &&
                            std::fabs(a.centre[0] - b.centre[0]) <= tolerance &&
                            std::fabs(a.centre[1] - b.centre[1]) <= tolerance;
    if (a.rapid != b.rapid || !isNear(a.end, b.end, tolerance) || !arc_agrees) {
      return fmt::format("move {}: ours {}; expected {}", i + 1, textOf(a), textOf(b));
    }
  }
  if (own.size() != expected.size()) return fmt::format("{} moves, expected {}", own.size(), expected.size());
  return {};
}

}  // namespace nineline::nc::testing
