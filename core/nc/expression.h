#pragma once

#include "core/nc/cursor.h"
#include "core/nc/fault.h"
#include "core/nc/parameters.h"

namespace nineline::nc {

/// Evaluates the expressions of Fanuc and LinuxCNC: `[ ]`, #, functions, comparisons; angles in degrees.
class Expression {
 public:
  Expression(Dialect dialect, const Parameters& parameters, Fault& fault)
      : dialect_(dialect), parameters_(&parameters), fault_(&fault) {}

  /// A value as it may follow an address: number, sign, #variable, [ ], function.
  Value value(Cursor& at);
  /// `[ expression ]`; the cursor must stand at the bracket.
  Value bracketed(Cursor& at);
  /// An expression that needs no brackets (Fanuc `#1=#2+1`).
  Value whole(Cursor& at) { return chain(at, 0); }
  /// What follows '#': a number, a variable, an expression or <name>.
  Variable variable(Cursor& at);

 private:
  enum class Operator : std::uint8_t;
  Value chain(Cursor& at, int level);
  Value primary(Cursor& at);
  Value function(Cursor& at);
  [[nodiscard]] bool takeOperator(Cursor& at, int level, Operator& found) const;
  Value apply(Operator op, Value left, Value right, std::uint32_t column);
  Value fail(const Cursor& at, const char* code, std::string text);

  Dialect dialect_;
  const Parameters* parameters_;
  Fault* fault_;
  int depth_ = 0;
};

}  // namespace nineline::nc
