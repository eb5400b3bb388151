#pragma once

#include <Eigen/Core>
#include <array>

#include "core/errors/covariate.h"
#include "core/errors/effect.h"
#include "core/errors/effect_placement.h"

namespace nineline::errors {

/// The form of a smooth function found in data: a cubic B-spline over one covariate, which may be multiplied
/// by a second one (approach_Z_1: another curve in each direction, of opposite sign; t_s: growing with time).
struct SmoothForm {
  std::vector<std::string> covariates{};  ///< one or two column names
  double start = 0.0;                     ///< of the data, in the covariate's unit
  double spacing = 1.0;                   ///< of the knots, above 0
  std::size_t intervals = 1;              ///< between knots; the spline has 3 more coefficients
  bool periodic = false;                  ///< the end joins the start; as many coefficients as intervals
  double centre = 0.0;                    ///< subtracted from the second covariate
  std::optional<Bounds> second{};         ///< range of the second covariate in the data

  [[nodiscard]] std::size_t coefficientCount() const { return periodic ? intervals : intervals + 3; }
};

/// `nonparametric`: structure without a name. Outside the range of its data each covariate is held at its end
/// value, and `covers` says so. Compensated only where the user turns it on.
class NonparametricEffect final : public Effect {
 public:
  /// Coefficients and their uncertainties (may be empty) in um or arcsec. Fails on a form without meaning or
  /// the wrong number of coefficients.
  [[nodiscard]] static Result<std::shared_ptr<Effect>> make(const kinematics::Machine& machine,
                                                            const Placement& placement, SmoothForm form,
                                                            std::vector<double> coefficients,
                                                            std::vector<double> sigmas = {});
  [[nodiscard]] static Result<std::shared_ptr<Effect>> fromJson(JsonReader& reader,
                                                                const kinematics::Machine& machine, int joint,
                                                                Component component);

  [[nodiscard]] std::string id() const override { return "nonparametric"; }
  void addMotion(const MachineState& state, std::span<const double> memory, SmallMotion& sum) const override;
  void addSlope(const MachineState& state, SmallMotion& sum) const override;
  [[nodiscard]] std::vector<std::string> needs() const override;
  [[nodiscard]] double featureLength() const override;
  [[nodiscard]] bool followsSense() const override;
  [[nodiscard]] bool covers(const MachineState& state) const override;
  [[nodiscard]] std::vector<Parameter> parameters() const override { return {}; }
  [[nodiscard]] Json toJson(const kinematics::Machine& machine) const override;

  [[nodiscard]] const SmoothForm& form() const { return form_; }
  [[nodiscard]] const std::vector<double>& coefficients() const { return coefficients_; }  ///< um, arcsec

 private:
  NonparametricEffect(const kinematics::Machine& machine, const Placement& placement, SmoothForm form);
  struct Place {
    std::size_t interval = 0;
    double t = 0.0;  // 0…1
    bool outside = false;
  };
  [[nodiscard]] Place placeOf(double value) const;
  [[nodiscard]] double sumAt(std::size_t interval, const std::array<double, 4>& weights) const;
  /// Value of the second factor, 1 without one, 0 where it is not known.
  [[nodiscard]] double factor(const MachineState& state) const;
  SmoothForm form_;
  std::vector<Covariate> covariates_;
  std::vector<double> coefficients_;
  std::vector<double> sigmas_;
  SmallMotion unit_;  // of a coefficient of 1 um or 1 arcsec
};

/// The form with each coefficient at 1 um (1 arcsec) and the others at 0.
[[nodiscard]] Result<std::vector<EffectPtr>> smoothBasis(const kinematics::Machine& machine,
                                                         const Placement& placement, const SmoothForm& form);

}  // namespace nineline::errors
