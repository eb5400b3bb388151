#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/nc/dialect.h"

namespace nineline::nc {

/// A variable's value; `null` is Fanuc's <vacant>: zero in sums, and a word with it does not exist.
struct Value {
  double number = 0.0;
  bool null = false;
};

/// What an assignment names.
struct Variable {
  int number = -1;   ///< #number or Rnumber; −1: named
  std::string name;  ///< lower case (LinuxCNC) or upper case (Siemens), no blanks
};

/// What the machine itself knows under a number or name (#5021, #<_x>); nothing where it is decided at run
/// time.
class SystemVariables {
 public:
  virtual ~SystemVariables() = default;
  [[nodiscard]] virtual std::optional<double> number(int id) const = 0;
  [[nodiscard]] virtual std::optional<double> named(std::string_view name) const = 0;
};

/// The variables of a program: # of Fanuc and LinuxCNC, R and names of Siemens. Call levels have their own
/// locals.
class Parameters {
 public:
  Parameters(Dialect dialect, const SystemVariables& system);

  /// Nothing where the value is not known from the program; `why` then says so.
  [[nodiscard]] std::optional<Value> get(const Variable& variable, std::string& why) const;
  /// False where it may not be written; `why` says so.
  [[nodiscard]] bool set(const Variable& variable, Value value, std::string& why);
  [[nodiscard]] bool exists(const Variable& variable) const;
  void define(const std::string& name, Value value);

  void enter(const std::vector<Value>& arguments);
  void leave();

 private:
  struct Level {
    std::array<Value, 34> locals{};
    std::map<std::string, Value> named;
  };
  [[nodiscard]] int localCount() const;
  [[nodiscard]] std::optional<Value> numbered(int id, std::string& why) const;
  [[nodiscard]] std::optional<Value> unassigned(int id, std::string& why) const;

  Dialect dialect_;
  const SystemVariables* system_;
  std::vector<Level> levels_;
  std::unordered_map<int, Value> numbers_;
  std::map<std::string, Value> names_;
};

}  // namespace nineline::nc
