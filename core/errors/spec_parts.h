#pragma once

#include <utility>

#include "core/errors/effect_spec.h"

namespace nineline::errors {

// The words in which the catalogue's files are written.

[[nodiscard]] inline Plausible both(double low, double high) { return {{low, high}, {low, high}}; }

[[nodiscard]] inline ParameterSpec linear(std::string_view name, Quantity quantity, const Plausible& length,
                                          std::optional<Plausible> arc = {}) {
  return {.name = name, .quantity = quantity, .linear = length, .arc = arc};
}

[[nodiscard]] inline ParameterSpec amplitude(const Plausible& length, std::optional<Plausible> arc = {}) {
  return {.name = "amplitude", .role = Role::Amplitude, .linear = length, .arc = arc};
}

[[nodiscard]] inline ParameterSpec phase() {
  return {.name = "phase",
          .quantity = Quantity::Phase,
          .role = Role::Phase,
          .linear = both(-180.0, 180.0),
          .otherwise = 0.0};
}

[[nodiscard]] inline ParameterSpec searched(std::string_view name, Quantity quantity, const Plausible& range,
                                            std::vector<double> starts, std::optional<Plausible> arc = {}) {
  return {.name = name,
          .quantity = quantity,
          .role = Role::NonLinear,
          .linear = range,
          .arc = arc,
          .starts = std::move(starts)};
}

[[nodiscard]] inline ParameterSpec choice(std::string_view name, std::vector<double> values,
                                          std::optional<double> otherwise = {}) {
  const Plausible range = both(values.front(), values.back());
  return {.name = name,
          .quantity = Quantity::Number,
          .role = Role::Choice,
          .linear = range,
          .starts = std::move(values),
          .otherwise = otherwise};
}

/// A position in travels from the lower end.
[[nodiscard]] inline ParameterSpec place(std::string_view name, std::vector<double> starts,
                                         double otherwise) {
  ParameterSpec one = searched(name, Quantity::Position, both(-0.3, 1.3), std::move(starts));
  one.of_travel = true;
  one.otherwise = otherwise;
  return one;
}

/// A parameter whose presence makes another form of the effect.
[[nodiscard]] inline ParameterSpec optional(ParameterSpec one) {
  one.optional = true;
  return one;
}

}  // namespace nineline::errors
