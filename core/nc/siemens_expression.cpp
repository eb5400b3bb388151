#include "core/nc/siemens_expression.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "core/base/text.h"
#include "core/base/units.h"
#include "core/nc/nc_error.h"

namespace nineline::nc {
namespace {

constexpr int kDeepest = 60;
constexpr int kPrimaryLevel = 5;

enum class Operator : std::uint8_t {
  Or,
  And,
  Equal,
  NotEqual,
  LessEqual,
  GreaterEqual,
  Less,
  Greater,
  Add,
  Subtract,
  Multiply,
  Divide,
  Quotient,
  Modulo
};

struct OperatorEntry {
  int level;
  std::string_view text;
  Operator op;
};

constexpr OperatorEntry kOperators[] = {
    {0, "OR", Operator::Or},        {1, "AND", Operator::And},      {2, "==", Operator::Equal},
    {2, "<>", Operator::NotEqual},  {2, "<=", Operator::LessEqual}, {2, ">=", Operator::GreaterEqual},
    {2, "<", Operator::Less},       {2, ">", Operator::Greater},    {3, "+", Operator::Add},
    {3, "-", Operator::Subtract},   {4, "*", Operator::Multiply},   {4, "/", Operator::Divide},
    {4, "DIV", Operator::Quotient}, {4, "MOD", Operator::Modulo}};

double truth(bool is) { return is ? 1.0 : 0.0; }

class Evaluation {
 public:
  explicit Evaluation(LineReader& reader) : r_(reader) {}

  double chain(int level) {
    if (level == kPrimaryLevel) return primary();
    double left = chain(level + 1);
    while (!r_.fault.found()) {
      const std::optional<Operator> op = takeOperator(level);
      if (!op) break;
      left = apply(*op, left, chain(level + 1));
      if (!std::isfinite(left)) r_.fail(code::kBadExpression, "The expression has no finite value");
    }
    return r_.fault.found() ? 0.0 : left;
  }

 private:
  std::optional<Operator> takeOperator(int level) {
    r_.at.skipBlanks();
    for (const OperatorEntry& entry : kOperators) {
      if (entry.level != level) continue;
      const bool word = isLetter(entry.text.front());
      if (word && isLetter(r_.at.peek(static_cast<std::ptrdiff_t>(entry.text.size())))) continue;
      if (r_.at.takeWord(entry.text)) return entry.op;
    }
    return std::nullopt;
  }

  static double apply(Operator op, double a, double b) {
    switch (op) {
      case Operator::Or:
        return truth(a != 0.0 || b != 0.0);
      case Operator::And:
        return truth(a != 0.0 && b != 0.0);
      case Operator::Equal:
        return truth(a == b);
      case Operator::NotEqual:
        return truth(a != b);
      case Operator::LessEqual:
        return truth(a <= b);
      case Operator::GreaterEqual:
        return truth(a >= b);
      case Operator::Less:
        return truth(a < b);
      case Operator::Greater:
        return truth(a > b);
      case Operator::Add:
        return a + b;
      case Operator::Subtract:
        return a - b;
      case Operator::Multiply:
        return a * b;
      case Operator::Divide:
        return a / b;
      case Operator::Quotient:
        return std::trunc(a / b);
      case Operator::Modulo:
        return std::fmod(a, b);
    }
    return 0.0;
  }

  double primary() {
    Cursor& at = r_.at;
    at.skipBlanks();
    if (++depth_ > kDeepest) {
      r_.fail(code::kBadExpression, "The expression is nested too deep");
      return 0.0;
    }
    const double value = primaryInside();
    --depth_;
    return value;
  }

  double primaryInside() {
    Cursor& at = r_.at;
    if (at.take('(')) return closing(chain(0));
    if (at.take('-')) return -primary();
    if (at.take('+')) return primary();
    if (at.peek() == '$') {
      r_.fail(code::kNotConstant, fmt::format("'{}' is a system variable that the control knows at run time",
                                              printable(at.rest(), 16)));
      return 0.0;
    }
    if (isLetter(at.peek()) || at.peek() == '_') return nameOrFunction();
    Decimal number;
    const char* const end = readDecimal(at.p, at.last, number);
    if (!end || !std::isfinite(number.value)) {
      r_.fail(code::kBadNumber,
              fmt::format("A number or variable expected, found '{}'", printable(at.rest(), 16)));
      return 0.0;
    }
    at.p = end;
    return number.value;
  }

  double closing(double value) {
    if (!r_.fault.found() && !r_.at.take(')'))
      r_.fail(code::kBadExpression, fmt::format("')' expected, found '{}'", printable(r_.at.rest(), 16)));
    return value;
  }

  double nameOrFunction() {
    const Cursor begin = r_.at;
    const std::string name = takeName(r_.at);
    if (name == "TRUE") return 1.0;
    if (name == "FALSE") return 0.0;
    if (name == "NOT") return truth(primary() == 0.0);
    Variable variable;
    if (name == "R" && r_.at.take('[')) {
      const double number = chain(0);
      if (!r_.at.take(']')) r_.fail(code::kBadExpression, "']' expected after R[");
      variable.number = number >= 0.0 && number < 1e6 ? static_cast<int>(number) : 0;
      return valueOf(variable, begin);
    }
    if (name.size() > 1 && name[0] == 'R' && name.find_first_not_of("0123456789", 1) == std::string::npos &&
        name.size() < 8) {
      variable.number = std::atoi(name.c_str() + 1);
      return valueOf(variable, begin);
    }
    if (r_.at.take('(')) return function(name, begin);
    variable.name = name;
    return valueOf(variable, begin);
  }

  double valueOf(const Variable& variable, const Cursor& begin) {
    // Assignments of the same block act from left to right.
    for (auto one = r_.out.assignments.rbegin(); one != r_.out.assignments.rend(); ++one) {
      if (one->variable.number == variable.number && one->variable.name == variable.name)
        return one->value.number;
    }
    for (const Assignment& one : r_.out.definitions) {
      if (!variable.name.empty() && one.variable.name == variable.name) return one.value.number;
    }
    std::string why;
    const std::optional<Value> value = r_.parameters.get(variable, why);
    if (!value) r_.fault.set(code::kNotConstant, begin.column(), why);
    return value.value_or(Value{}).number;
  }

  double function(const std::string& name, const Cursor& begin) {
    const double a = chain(0);
    const bool two = name == "ATAN2" || name == "MINVAL" || name == "MAXVAL";
    double b = 0.0;
    if (two) {
      if (!r_.at.take(',')) r_.fail(code::kBadExpression, fmt::format("{} needs two values", name));
      b = chain(0);
    }
    closing(0.0);
    if (r_.fault.found()) return 0.0;
    double value = std::nan("");
    if (name == "SIN") value = std::sin(radFromDeg(a));
    if (name == "COS") value = std::cos(radFromDeg(a));
    if (name == "TAN") value = std::tan(radFromDeg(a));
    if (name == "ASIN") value = degFromRad(std::asin(a));
    if (name == "ACOS") value = degFromRad(std::acos(a));
    if (name == "ATAN2") value = degFromRad(std::atan2(a, b));
    if (name == "SQRT") value = std::sqrt(a);
    if (name == "ABS") value = std::fabs(a);
    if (name == "POT") value = a * a;
    if (name == "TRUNC") value = std::trunc(a);
    if (name == "ROUND") value = std::round(a);
    if (name == "LN") value = std::log(a);
    if (name == "EXP") value = std::exp(a);
    if (name == "MINVAL") value = std::fmin(a, b);
    if (name == "MAXVAL") value = std::fmax(a, b);
    if (!std::isfinite(value)) {
      r_.fault.set(code::kBadExpression, begin.column(),
                   fmt::format("{}( ) is no known function or has no value", name));
      return 0.0;
    }
    return value;
  }

  LineReader& r_;
  int depth_ = 0;
};

}  // namespace

std::string takeName(Cursor& at) {
  std::string name;
  while (!at.atEnd() && (isLetter(*at.p) || isDigit(*at.p) || *at.p == '_')) name += upperOf(*at.p++);
  return name;
}

double evaluateSiemens(LineReader& reader) { return Evaluation(reader).chain(0); }

}  // namespace nineline::nc
