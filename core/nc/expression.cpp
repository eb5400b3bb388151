#include "core/nc/expression.h"

#include <fmt/format.h>

#include <cmath>

#include "core/base/text.h"
#include "core/base/units.h"
#include "core/nc/nc_error.h"

namespace nineline::nc {

enum class Expression::Operator : std::uint8_t {
  Add,
  Subtract,
  Or,
  Xor,
  And,
  Multiply,
  Divide,
  Modulo,
  Power,
  Equal,
  NotEqual,
  Greater,
  GreaterEqual,
  Less,
  LessEqual
};

namespace {

constexpr int kDeepest = 60;
constexpr double kLinuxCncEqual = 1e-4;  ///< LinuxCNC takes numbers as equal within this
constexpr int kLevels = 5;               ///< AND OR XOR < comparisons < + − < * / MOD < **

double moduloOf(double left, double right) {
  const double rest = std::fmod(left, right);
  return rest < 0.0 ? rest + std::fabs(right) : rest;
}

struct Function {
  std::string_view name;
  double (*of)(double);
};

constexpr double kIntegerSlack = 1e-9;

double roundHalfAway(double x) { return std::round(x); }

const Function kFunctions[] = {
    {"ABS", [](double x) { return std::fabs(x); }},
    {"ACOS", [](double x) { return degFromRad(std::acos(x)); }},
    {"ASIN", [](double x) { return degFromRad(std::asin(x)); }},
    {"COS", [](double x) { return std::cos(radFromDeg(x)); }},
    {"EXP", [](double x) { return std::exp(x); }},
    {"FIX", [](double x) { return std::floor(x); }},
    {"FUP", [](double x) { return std::ceil(x); }},
    {"LN", [](double x) { return std::log(x); }},
    {"ROUND", roundHalfAway},
    {"SIN", [](double x) { return std::sin(radFromDeg(x)); }},
    {"SQRT", [](double x) { return std::sqrt(x); }},
    {"TAN", [](double x) { return std::tan(radFromDeg(x)); }},
};

}  // namespace

Value Expression::fail(const Cursor& at, const char* code, std::string text) {
  fault_->set(code, at.column(), std::move(text));
  return {};
}

bool Expression::takeOperator(Cursor& at, int level, Operator& found) const {
  struct Entry {
    int level;
    std::string_view text;
    Operator op;
  };
  static constexpr Entry kEntries[] = {
      {4, "**", Operator::Power},        {3, "*", Operator::Multiply},  {3, "/", Operator::Divide},
      {3, "MOD", Operator::Modulo},      {2, "+", Operator::Add},       {2, "-", Operator::Subtract},
      {1, "EQ", Operator::Equal},        {1, "NE", Operator::NotEqual}, {1, "GT", Operator::Greater},
      {1, "GE", Operator::GreaterEqual}, {1, "LT", Operator::Less},     {1, "LE", Operator::LessEqual},
      {0, "AND", Operator::And},         {0, "OR", Operator::Or},       {0, "XOR", Operator::Xor}};
  at.skipBlanks();
  for (const Entry& entry : kEntries) {
    if (entry.level != level) continue;
    if (entry.text == "*" && at.peek() == '*' && at.peek(1) == '*') continue;
    if (at.takeWord(entry.text)) {
      found = entry.op;
      return true;
    }
  }
  return false;
}

Value Expression::apply(Operator op, Value left, Value right, std::uint32_t column) {
  const double a = left.number;
  const double b = right.number;
  const bool linux_cnc = dialect_ == Dialect::LinuxCnc;
  const auto equal = [&] {
    if (left.null || right.null) return left.null && right.null;
    return linux_cnc ? std::fabs(a - b) < kLinuxCncEqual : a == b;
  };
  const auto truth = [](bool is) { return Value{is ? 1.0 : 0.0, false}; };
  switch (op) {
    case Operator::Add:
      return {a + b, false};
    case Operator::Subtract:
      return {a - b, false};
    case Operator::Multiply:
      return {a * b, false};
    case Operator::Divide:
      if (b == 0.0) fault_->set(code::kBadExpression, column, "Division by zero");
      return {b == 0.0 ? 0.0 : a / b, false};
    case Operator::Modulo:
      if (b == 0.0) fault_->set(code::kBadExpression, column, "Division by zero in MOD");
      return {b == 0.0 ? 0.0 : moduloOf(a, b), false};
    case Operator::Power:
      return {std::pow(a, b), false};
    case Operator::And:
      return truth(a != 0.0 && b != 0.0);
    case Operator::Or:
      return truth(a != 0.0 || b != 0.0);
    case Operator::Xor:
      return truth((a != 0.0) != (b != 0.0));
    case Operator::Equal:
      return truth(equal());
    case Operator::NotEqual:
      return truth(!equal());
    case Operator::Greater:
      return truth(a > b);
    case Operator::GreaterEqual:
      return truth(a >= b);
    case Operator::Less:
      return truth(a < b);
    case Operator::LessEqual:
      return truth(a <= b);
  }
  return {};
}

Value Expression::chain(Cursor& at, int level) {
  if (level == kLevels) return primary(at);
  Value left = chain(at, level + 1);
  Operator op{};
  while (!fault_->found()) {
    const std::uint32_t column = at.column();
    if (!takeOperator(at, level, op)) break;
    left = apply(op, left, chain(at, level + 1), column);
    if (!std::isfinite(left.number))
      return fail(at, code::kBadExpression, "The expression has no finite value");
  }
  return left;
}

Value Expression::bracketed(Cursor& at) {
  if (!at.take('[')) return fail(at, code::kBadExpression, "'[' expected before an expression");
  if (++depth_ > kDeepest) return fail(at, code::kBadExpression, "The expression is nested too deep");
  const Value value = chain(at, 0);
  --depth_;
  if (!fault_->found() && !at.take(']')) {
    return fail(at, code::kBadExpression,
                fmt::format("']' or an operator expected, found '{}'", printable(at.rest(), 12)));
  }
  return value;
}

Value Expression::primary(Cursor& at) { return value(at); }

Value Expression::value(Cursor& at) {
  at.skipBlanks();
  const char c = at.peek();
  if (c == '[') return bracketed(at);
  if (c == '#') {
    ++at.p;
    const std::uint32_t column = at.column() - 1;
    const Variable named = variable(at);
    if (fault_->found()) return {};
    std::string why;
    const std::optional<Value> known = parameters_->get(named, why);
    if (!known) fault_->set(code::kNotConstant, column, why);
    return known.value_or(Value{});
  }
  if (c == '-' || c == '+') {
    const char next = at.peek(1);
    if (!isDigit(next) && next != '.') {
      ++at.p;
      if (++depth_ > kDeepest) return fail(at, code::kBadExpression, "The expression is nested too deep");
      Value turned = value(at);
      --depth_;
      if (c == '-') turned.number = -turned.number;
      return turned;
    }
  }
  if (isLetter(c)) return function(at);
  Decimal number;
  const char* const end = readDecimal(at.p, at.last, number);
  if (!end || !std::isfinite(number.value)) {
    return fail(
        at, code::kBadNumber,
        fmt::format("A number, variable or expression expected, found '{}'", printable(at.rest(), 12)));
  }
  at.p = end;
  return {number.value, false};
}

Value Expression::function(Cursor& at) {
  const Cursor begin = at;
  if (at.takeWord("ATAN")) {
    const Value y = bracketed(at);
    if (!at.take('/')) {
      if (dialect_ == Dialect::LinuxCnc)
        return fail(at, code::kBadExpression, "ATAN needs '/[ ]' after its value");
      return {degFromRad(std::atan(y.number)), false};
    }
    const Value x = bracketed(at);
    return {degFromRad(std::atan2(y.number, x.number)), false};
  }
  if (at.takeWord("EXISTS")) {
    if (!at.take('[') || !at.take('#')) return fail(at, code::kBadExpression, "EXISTS needs [#<name>]");
    const Variable named = variable(at);
    if (!at.take(']')) return fail(at, code::kBadExpression, "']' expected after EXISTS[#<name>");
    return {parameters_->exists(named) ? 1.0 : 0.0, false};
  }
  for (const Function& known : kFunctions) {
    if (!at.takeWord(known.name)) continue;
    const double argument = bracketed(at).number;
    const bool integer = known.name == "FIX" || known.name == "FUP";
    const double near = std::round(argument);
    const double x = integer && std::fabs(argument - near) < kIntegerSlack ? near : argument;
    const double result = known.of(x);
    if (!std::isfinite(result)) {
      return fail(begin, code::kBadExpression, fmt::format("{}[{}] has no value", known.name, argument));
    }
    return {result, false};
  }
  return fail(
      begin, code::kBadExpression,
      fmt::format("A number, variable or function expected, found '{}'", printable(begin.rest(), 12)));
}

Variable Expression::variable(Cursor& at) {
  at.skipBlanks();
  Variable found;
  if (at.take('<')) {
    while (!at.atEnd() && *at.p != '>') {
      if (!isBlank(*at.p)) found.name += static_cast<char>(isLetter(*at.p) ? *at.p | 32 : *at.p);
      ++at.p;
    }
    if (!at.take('>') || found.name.empty())
      fail(at, code::kBadExpression, "'>' expected after the name of a variable");
    return found;
  }
  if (++depth_ > kDeepest) {
    fail(at, code::kBadExpression, "The expression is nested too deep");
    return found;
  }
  const Cursor begin = at;
  const double number = value(at).number;
  --depth_;
  if (fault_->found()) return found;
  if (!(number >= 0.0 && number <= 1e8) || std::fabs(number - std::round(number)) > 1e-3) {
    fail(begin, code::kBadExpression,
         fmt::format("#{} is no variable: a whole number from 0 expected", number));
    return found;
  }
  found.number = static_cast<int>(std::lround(number));
  return found;
}

}  // namespace nineline::nc
