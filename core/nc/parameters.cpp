#include "core/nc/parameters.h"

#include <fmt/format.h>

#include "core/nc/dialect.h"

namespace nineline::nc {

Parameters::Parameters(Dialect dialect, const SystemVariables& system) : dialect_(dialect), system_(&system) {
  enter({});
}

int Parameters::localCount() const {
  return dialect_ == Dialect::LinuxCnc ? 30 : dialect_ == Dialect::Fanuc ? 33 : -1;
}

void Parameters::enter(const std::vector<Value>& arguments) {
  Level level;
  const Value initial{0.0, dialect_ == Dialect::Fanuc};
  level.locals.fill(initial);
  for (std::size_t i = 0; i < arguments.size() && i < level.locals.size(); ++i)
    level.locals[i] = arguments[i];
  levels_.push_back(std::move(level));
}

void Parameters::leave() {
  if (levels_.size() > 1) levels_.pop_back();
}

void Parameters::define(const std::string& name, Value value) { names_[name] = value; }

std::optional<Value> Parameters::unassigned(int id, std::string& why) const {
  if (dialect_ == Dialect::LinuxCnc && id >= 31 && id <= 5000) return Value{};
  if (dialect_ == Dialect::Siemens) {
    why = fmt::format("R{} has no value in this program", id);
  } else if (id >= 1000) {
    why = fmt::format("#{} is a system variable that the control sets at run time", id);
  } else {
    why = fmt::format("#{} has no value in this program", id);
  }
  return std::nullopt;
}

std::optional<Value> Parameters::numbered(int id, std::string& why) const {
  if (dialect_ != Dialect::Siemens) {
    if (id == 0) return Value{0.0, dialect_ == Dialect::Fanuc};
    if (id <= localCount()) return levels_.back().locals[static_cast<std::size_t>(id)];
    if (const std::optional<double> known = system_->number(id)) return Value{*known, false};
  }
  const auto found = numbers_.find(id);
  return found != numbers_.end() ? std::optional(found->second) : unassigned(id, why);
}

std::optional<Value> Parameters::get(const Variable& variable, std::string& why) const {
  if (variable.name.empty()) return numbered(variable.number, why);
  const auto local = levels_.back().named.find(variable.name);
  if (local != levels_.back().named.end()) return local->second;
  const auto global = names_.find(variable.name);
  if (global != names_.end()) return global->second;
  if (const std::optional<double> known = system_->named(variable.name)) return Value{*known, false};
  why = variable.name.starts_with("_ini[") || variable.name.starts_with("_hal[")
            ? fmt::format("'{}' is set in the control's configuration, not in this program", variable.name)
            : fmt::format("'{}' has no value in this program", variable.name);
  return std::nullopt;
}

bool Parameters::exists(const Variable& variable) const {
  std::string why;
  return get(variable, why).has_value();
}

bool Parameters::set(const Variable& variable, Value value, std::string& why) {
  if (!variable.name.empty()) {
    if (variable.name.starts_with("_ini[") || variable.name.starts_with("_hal[") ||
        system_->named(variable.name)) {
      why = fmt::format("'{}' cannot be assigned: it is read-only", variable.name);
      return false;
    }
    const bool global = dialect_ == Dialect::Siemens || variable.name.front() == '_';
    (global ? names_ : levels_.back().named)[variable.name] = value;
    return true;
  }
  if (dialect_ != Dialect::Siemens && variable.number <= localCount()) {
    if (variable.number <= 0) {
      why = fmt::format("#{} cannot be assigned", variable.number);
      return false;
    }
    levels_.back().locals[static_cast<std::size_t>(variable.number)] = value;
    return true;
  }
  const int first_system = dialect_ == Dialect::LinuxCnc ? 5001 : 1000;
  if (dialect_ != Dialect::Siemens && variable.number >= first_system) {
    why = fmt::format("#{} is a system variable; what an assignment to it does is decided by the control",
                      variable.number);
    return false;
  }
  numbers_[variable.number] = value;
  return true;
}

}  // namespace nineline::nc
