#include "core/errors/effect_factory.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/errors/effect_makers.h"

namespace nineline::errors {

namespace {

using kinematics::Machine;

const Parameter* findParameter(std::span<const Parameter> values, std::string_view name) {
  const auto found =
      std::find_if(values.begin(), values.end(), [name](const Parameter& one) { return one.name == name; });
  return found == values.end() ? nullptr : &*found;
}

bool isLinear(const ParameterSpec& one) { return one.role == Role::Linear || one.role == Role::Amplitude; }

std::string unitText(const ParameterSpec& rule, const UnitChoice& units) {
  return std::string(unitOf(rule.quantity, units));
}

/// The values at which one column of the basis is taken: every linear parameter 0 save `one`.
std::vector<Parameter> unitValues(const EffectSpec& spec, const UnitChoice& units,
                                  std::span<const Parameter> nonlinear, std::string_view one, double phase) {
  std::vector<Parameter> values(nonlinear.begin(), nonlinear.end());
  for (const ParameterSpec& rule : spec.parameters) {
    if (!isLinear(rule) && rule.role != Role::Phase) continue;
    const double value = rule.role == Role::Phase ? phase : (rule.name == one ? 1.0 : 0.0);
    values.push_back({std::string(rule.name), unitText(rule, units), value, std::nullopt});
  }
  return values;
}

constexpr double kQuarter = 90.0;  // deg

/// Amplitude and phase of c₀ · (phase 0) + c₁ · (phase 90°), and their derivatives.
void addWave(const Eigen::VectorXd& c, Eigen::Index column, Eigen::Index row, Eigen::Index phase_row,
             FittedParameters& fitted) {
  const double sine = c[column];
  const double cosine = c[column + 1];
  const double amplitude = std::hypot(sine, cosine);
  fitted.parameters[static_cast<std::size_t>(row)].value = amplitude;
  if (amplitude == 0.0) return;
  const double square = amplitude * amplitude;
  fitted.parameters[static_cast<std::size_t>(phase_row)].value = degFromRad(std::atan2(cosine, sine));
  fitted.jacobian(row, column) = sine / amplitude;
  fitted.jacobian(row, column + 1) = cosine / amplitude;
  fitted.jacobian(phase_row, column) = degFromRad(-cosine / square);
  fitted.jacobian(phase_row, column + 1) = degFromRad(sine / square);
}

constexpr double kNoPhase = 180.0;  // deg: an uncertainty that says "not known"

void addSigmas(const Eigen::MatrixXd& covariance, FittedParameters& fitted) {
  for (std::size_t i = 0; i < fitted.parameters.size(); ++i) {
    const Eigen::RowVectorXd row = fitted.jacobian.row(static_cast<Eigen::Index>(i));
    if (row.isZero(0.0)) {
      if (fitted.parameters[i].name == "phase") fitted.parameters[i].sigma = kNoPhase;
      continue;  // non-linear parameters keep theirs
    }
    const double variance = row * covariance * row.transpose();
    fitted.parameters[i].sigma = std::sqrt(std::max(0.0, variance));
    if (fitted.parameters[i].name == "phase") {
      fitted.parameters[i].sigma = std::min(*fitted.parameters[i].sigma, kNoPhase);
    }
  }
}

}  // namespace

Result<std::vector<Parameter>> completeParameters(const EffectSpec& spec, const UnitChoice& units,
                                                  std::span<const Parameter> values) {
  std::vector<Parameter> all;
  for (const Parameter& value : values) {
    if (spec.find(value.name) != nullptr) continue;
    return badInput("effect.parameter", fmt::format("'{}' has no parameter '{}'.", spec.id, value.name));
  }
  for (const ParameterSpec& rule : spec.parameters) {
    Parameter one{std::string(rule.name), unitText(rule, units), rule.otherwise.value_or(0.0), std::nullopt};
    if (const Parameter* given = findParameter(values, rule.name)) {
      if (!given->unit.empty() && given->unit != one.unit) {
        return badInput("effect.unit", fmt::format("'{}' of '{}' is in {}, expected {}.", rule.name, spec.id,
                                                   given->unit, one.unit));
      }
      one.value = given->value;
      one.sigma = given->sigma;
    } else if (!rule.otherwise) {
      if (rule.optional) continue;
      return badInput("effect.parameter", fmt::format("'{}' of '{}' is missing, expected a number in {}.",
                                                      rule.name, spec.id, one.unit));
    }
    if (const std::string fault = faultOf(rule, one); !fault.empty()) return badInput("effect.value", fault);
    all.push_back(std::move(one));
  }
  return all;
}

Result<std::shared_ptr<Effect>> makeShared(const Machine& machine, const EffectSpec& spec,
                                           const Placement& placement, std::span<const Parameter> values) {
  if (Result<void> fits = checkPlacement(machine, spec, placement); !fits) return fits.error();
  auto parameters = completeParameters(spec, unitChoice(machine, placement), values);
  if (!parameters) return parameters.error();
  return assembleEffect({spec, machine, placement, std::move(*parameters)});
}

Result<EffectPtr> makeEffect(const Machine& machine, const EffectSpec& spec, const Placement& placement,
                             std::span<const Parameter> values) {
  Result<std::shared_ptr<Effect>> effect = makeShared(machine, spec, placement, values);
  if (!effect) return effect.error();
  return EffectPtr(std::move(*effect));
}

std::vector<std::vector<Parameter>> unitParameters(const EffectSpec& spec, const UnitChoice& units,
                                                   std::span<const Parameter> nonlinear) {
  std::vector<std::vector<Parameter>> sets;
  for (const ParameterSpec& rule : spec.parameters) {
    if (!isLinear(rule)) continue;
    sets.push_back(unitValues(spec, units, nonlinear, rule.name, 0.0));
    if (rule.role == Role::Amplitude) {
      sets.push_back(unitValues(spec, units, nonlinear, rule.name, kQuarter));
    }
  }
  return sets;
}

Result<std::vector<EffectPtr>> linearBasis(const Machine& machine, const EffectSpec& spec,
                                           const Placement& placement, std::span<const Parameter> nonlinear) {
  std::vector<EffectPtr> basis;
  for (const auto& values : unitParameters(spec, unitChoice(machine, placement), nonlinear)) {
    Result<EffectPtr> effect = makeEffect(machine, spec, placement, values);
    if (!effect) return effect.error();
    basis.push_back(std::move(*effect));
  }
  return basis;
}

FittedParameters parametersOf(const EffectSpec& spec, const UnitChoice& units,
                              std::span<const Parameter> nonlinear, const Eigen::VectorXd& coefficients,
                              const Eigen::MatrixXd* covariance) {
  FittedParameters fitted;
  std::vector<std::pair<Eigen::Index, const ParameterSpec*>> rows;
  Eigen::Index phase_row = -1;
  for (const ParameterSpec& rule : spec.parameters) {
    Parameter one{std::string(rule.name), unitText(rule, units), 0.0, std::nullopt};
    if (!isLinear(rule) && rule.role != Role::Phase) {
      const Parameter* given = findParameter(nonlinear, rule.name);
      if (given == nullptr && !rule.otherwise) continue;
      one.value = given != nullptr ? given->value : *rule.otherwise;
      if (given != nullptr) one.sigma = given->sigma;
    }
    const auto row = static_cast<Eigen::Index>(fitted.parameters.size());
    if (rule.role == Role::Phase) phase_row = row;
    rows.emplace_back(row, &rule);
    fitted.parameters.push_back(std::move(one));
  }
  fitted.jacobian.setZero(static_cast<Eigen::Index>(fitted.parameters.size()), coefficients.size());
  Eigen::Index column = 0;
  for (const auto& [row, rule] : rows) {
    if (!isLinear(*rule)) continue;
    const bool wave = rule->role == Role::Amplitude;
    NL_EXPECTS(column + (wave ? 1 : 0) < coefficients.size(), coefficients.size());
    if (wave) {
      addWave(coefficients, column, row, phase_row, fitted);
    } else {
      fitted.parameters[static_cast<std::size_t>(row)].value = coefficients[column];
      fitted.jacobian(row, column) = 1.0;
    }
    column += wave ? 2 : 1;
  }
  if (covariance != nullptr) addSigmas(*covariance, fitted);
  return fitted;
}

}  // namespace nineline::errors
