#pragma once

#include <Eigen/Core>
#include <span>

#include "core/errors/effect.h"
#include "core/errors/effect_placement.h"

namespace nineline::errors {

/// An effect with its parameters in the units of contract.md; parameters that are not given take their
/// standard value. Fails with BadInput on a missing, unknown or absurd value and on a place where the effect
/// has no meaning.
[[nodiscard]] Result<EffectPtr> makeEffect(const kinematics::Machine& machine, const EffectSpec& spec,
                                           const Placement& placement, std::span<const Parameter> values);

/// The same, to be completed (provenance, active) before it is shared.
[[nodiscard]] Result<std::shared_ptr<Effect>> makeShared(const kinematics::Machine& machine,
                                                         const EffectSpec& spec, const Placement& placement,
                                                         std::span<const Parameter> values);

/// The effects whose weighted sum the effect is at given non-linear parameters: each linear parameter at 1 of
/// its unit and the others at 0; a wave once with phase 0 and once with phase 90 degrees, amplitude 1.
[[nodiscard]] Result<std::vector<EffectPtr>> linearBasis(const kinematics::Machine& machine,
                                                         const EffectSpec& spec, const Placement& placement,
                                                         std::span<const Parameter> nonlinear);

/// Parameters and their dependence on the coefficients of `linearBasis`.
struct FittedParameters {
  std::vector<Parameter> parameters;  ///< as contract.md names them, the non-linear ones included
  /// d parameter / d coefficient; rows as `parameters` (0 for non-linear ones), a column for each
  /// coefficient.
  Eigen::MatrixXd jacobian;
};

/// Turns fitted coefficients into amplitude and phase (−180 to 180 deg), or takes them over; with a
/// covariance of the coefficients the uncertainties follow to first order. Non-linear parameters keep the
/// uncertainty that they come with. The phase of a wave of amplitude 0 is 0, its uncertainty 180 deg.
[[nodiscard]] FittedParameters parametersOf(const EffectSpec& spec, const UnitChoice& units,
                                            std::span<const Parameter> nonlinear,
                                            const Eigen::VectorXd& coefficients,
                                            const Eigen::MatrixXd* covariance = nullptr);
[[nodiscard]] inline FittedParameters parametersOf(const kinematics::Machine& machine, const EffectSpec& spec,
                                                   const Placement& placement,
                                                   std::span<const Parameter> nonlinear,
                                                   const Eigen::VectorXd& coefficients,
                                                   const Eigen::MatrixXd* covariance = nullptr) {
  return parametersOf(spec, unitChoice(machine, placement), nonlinear, coefficients, covariance);
}

/// The parameter sets behind `linearBasis`, one for each coefficient.
[[nodiscard]] std::vector<std::vector<Parameter>> unitParameters(const EffectSpec& spec,
                                                                 const UnitChoice& units,
                                                                 std::span<const Parameter> nonlinear);

/// A full and checked set of parameters from those given: standard values filled in, units and sizes tested.
[[nodiscard]] Result<std::vector<Parameter>> completeParameters(const EffectSpec& spec,
                                                                const UnitChoice& units,
                                                                std::span<const Parameter> values);

}  // namespace nineline::errors
