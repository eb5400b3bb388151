#include "core/errors/nonparametric_effect.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/units.h"

namespace nineline::errors {

namespace {

constexpr double kPiecesOfAnInterval = 2.0;

/// Uniform cubic B-splines over one interval, t = 0…1, and their derivatives.
std::array<double, 4> weightsAt(double t) {
  const double u = 1.0 - t;
  return {u * u * u / 6.0, (3.0 * t * t * t - 6.0 * t * t + 4.0) / 6.0,
          (3.0 * u * u * u - 6.0 * u * u + 4.0) / 6.0, t * t * t / 6.0};
}

std::array<double, 4> slopesAt(double t) {
  const double u = 1.0 - t;
  return {-0.5 * u * u, 1.5 * t * t - 2.0 * t, -1.5 * u * u + 2.0 * u, 0.5 * t * t};
}

Result<void> checkForm(const SmoothForm& form, std::size_t coefficients, std::size_t sigmas) {
  const auto fault = [](std::string text) { return badInput("effect.form", std::move(text)); };
  if (form.covariates.empty() || form.covariates.size() > 2) {
    return fault(fmt::format("there are {} covariates, expected one or two.", form.covariates.size()));
  }
  if (!std::isfinite(form.start) || !(form.spacing > 0.0) || form.intervals == 0) {
    return fault("the knots need a start, a spacing above 0 and at least one interval.");
  }
  if (coefficients != form.coefficientCount()) {
    return fault(fmt::format("there are {} values, expected {}.", coefficients, form.coefficientCount()));
  }
  if (sigmas != 0 && sigmas != coefficients) {
    return fault(fmt::format("there are {} uncertainties for {} values.", sigmas, coefficients));
  }
  if (form.second && !(form.second->low <= form.second->high)) return fault("the second range is empty.");
  return {};
}

void readForm(JsonReader& reader, SmoothForm& form) {
  for (const Json& name : reader.items("covariates")) {
    if (name.string() == nullptr) {
      reader.fail("covariates", "json.type",
                  fmt::format("'covariates' holds {}, expected column names.", name.describe()));
      return;
    }
    form.covariates.push_back(*name.string());
  }
  form.start = reader.number("start");
  form.spacing = reader.number("spacing");
  form.periodic = reader.booleanOr("periodic", false);
  form.centre = reader.numberOr("centre", 0.0);
  if (!reader.has("range_second")) return;
  const std::vector<double> range = reader.numbers("range_second", 2);
  if (!reader.failed()) form.second = Bounds{range[0], range[1]};
}

}  // namespace

NonparametricEffect::NonparametricEffect(const kinematics::Machine& machine, const Placement& placement,
                                         SmoothForm form)
    : Effect(placement.joint, placement.component, placement.fixed_frame ? Slot::Standing : Slot::Moved),
      form_(std::move(form)),
      unit_(unitMotion(machine.joint(placement.joint), placement.component)) {
  const double scale = placement.component.isAngular() ? radFromArcsec(1.0) : mmFromUm(1.0);
  unit_.translation *= scale;
  unit_.rotation *= scale;
  for (const std::string& name : form_.covariates) covariates_.emplace_back(machine, name);
  setActive(false);
}

Result<std::shared_ptr<Effect>> NonparametricEffect::make(const kinematics::Machine& machine,
                                                          const Placement& placement, SmoothForm form,
                                                          std::vector<double> coefficients,
                                                          std::vector<double> sigmas) {
  if (Result<void> fine = checkForm(form, coefficients.size(), sigmas.size()); !fine) return fine.error();
  std::shared_ptr<NonparametricEffect> effect(new NonparametricEffect(machine, placement, std::move(form)));
  effect->coefficients_ = std::move(coefficients);
  effect->sigmas_ = std::move(sigmas);
  return std::shared_ptr<Effect>(std::move(effect));
}

NonparametricEffect::Place NonparametricEffect::placeOf(double value) const {
  const double count = static_cast<double>(form_.intervals);
  double x = (value - form_.start) / form_.spacing;
  Place place;
  if (form_.periodic) {
    x -= count * std::floor(x / count);
  } else {
    place.outside = x < 0.0 || x > count;
    x = std::clamp(x, 0.0, count);
  }
  place.interval = std::min(static_cast<std::size_t>(x), form_.intervals - 1);
  place.t = x - static_cast<double>(place.interval);
  return place;
}

double NonparametricEffect::sumAt(std::size_t interval, const std::array<double, 4>& weights) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < weights.size(); ++k) {
    sum += weights[k] * coefficients_[(interval + k) % coefficients_.size()];
  }
  return sum;
}

double NonparametricEffect::factor(const MachineState& state) const {
  if (covariates_.size() < 2) return 1.0;
  std::optional<double> value = covariates_[1].value(state);
  if (!value) return 0.0;
  if (form_.second) value = std::clamp(*value, form_.second->low, form_.second->high);
  return *value - form_.centre;
}

void NonparametricEffect::addMotion(const MachineState& state, std::span<const double>,
                                    SmallMotion& sum) const {
  const std::optional<double> value = covariates_[0].value(state);
  if (!value) return;
  const Place place = placeOf(*value);
  addScaled(factor(state) * sumAt(place.interval, weightsAt(place.t)), unit_, sum);
}

void NonparametricEffect::addSlope(const MachineState& state, SmallMotion& sum) const {
  const std::optional<double> value = covariates_[0].value(state);
  if (!value) return;
  const Place place = placeOf(*value);
  if (covariates_[0].positionOf() == joint() && !place.outside) {
    const double slope = sumAt(place.interval, slopesAt(place.t)) / form_.spacing;
    addScaled(factor(state) * slope * covariates_[0].unitsPerPosition(), unit_, sum);
  }
  if (covariates_.size() < 2 || covariates_[1].positionOf() != joint()) return;
  const double second = *covariates_[1].value(state);
  if (form_.second && (second < form_.second->low || second > form_.second->high)) return;
  addScaled(sumAt(place.interval, weightsAt(place.t)) * covariates_[1].unitsPerPosition(), unit_, sum);
}

std::vector<std::string> NonparametricEffect::needs() const {
  std::vector<std::string> names;
  for (const Covariate& one : covariates_) {
    if (one.isCondition()) names.push_back(one.name());
  }
  return names;
}

bool NonparametricEffect::followsSense() const {
  return std::any_of(covariates_.begin(), covariates_.end(),
                     [](const Covariate& one) { return one.isApproach(); });
}

double NonparametricEffect::featureLength() const {
  const bool own = covariates_[0].positionOf() == joint();
  return own ? form_.spacing / covariates_[0].unitsPerPosition() / kPiecesOfAnInterval
             : std::numeric_limits<double>::infinity();
}

bool NonparametricEffect::covers(const MachineState& state) const {
  const std::optional<double> value = covariates_[0].value(state);
  if (value && placeOf(*value).outside) return false;
  if (covariates_.size() < 2 || !form_.second) return true;
  const std::optional<double> second = covariates_[1].value(state);
  return !second || (*second >= form_.second->low && *second <= form_.second->high);
}

Json NonparametricEffect::toJson(const kinematics::Machine& machine) const {
  const bool angular = component().isAngular();
  Json json = Json::object();
  json.set("effect", id())
      .set("joint", machine.joint(joint()).axis.text())
      .set("component", component().text());
  if (slot() == Slot::Standing) json.set("frame", "fixed");
  Json names = Json::array();
  for (const std::string& name : form_.covariates) names.push(name);
  json.set("covariates", std::move(names)).set("start", form_.start).set("spacing", form_.spacing);
  if (form_.periodic) json.set("periodic", true);
  if (form_.centre != 0.0) json.set("centre", form_.centre);
  if (form_.second) {
    json.set("range_second", Json(Json::Array{Json(form_.second->low), Json(form_.second->high)}));
  }
  const auto list = [](const std::vector<double>& values) {
    Json all = Json::array();
    for (const double value : values) all.push(value);
    return all;
  };
  json.set(angular ? "values_arcsec" : "values_um", list(coefficients_));
  if (!sigmas_.empty()) json.set(angular ? "sigmas_arcsec" : "sigmas_um", list(sigmas_));
  return json;
}

Result<std::shared_ptr<Effect>> NonparametricEffect::fromJson(JsonReader& reader,
                                                              const kinematics::Machine& machine, int joint,
                                                              Component component) {
  const bool angular = component.isAngular();
  const char* key = angular ? "values_arcsec" : "values_um";
  const char* sigma_key = angular ? "sigmas_arcsec" : "sigmas_um";
  if (component.location) {
    reader.fail("component", "model.component",
                fmt::format("component {} does not fit the effect 'nonparametric'.", component.text()));
    return reader.error();
  }
  SmoothForm form;
  readForm(reader, form);
  std::vector<double> values = reader.failed() ? std::vector<double>() : reader.numbers(key);
  std::vector<double> sigmas =
      reader.failed() || !reader.has(sigma_key) ? std::vector<double>() : reader.numbers(sigma_key);
  if (reader.failed()) return reader.error();
  form.intervals = form.periodic ? values.size() : values.size() - std::min<std::size_t>(values.size(), 3);
  Placement placement{.joint = joint, .component = component};
  const std::string frame = reader.stringOr("frame", "moved");
  if (frame != "moved" && frame != "fixed") {
    reader.fail("frame", "model.frame", fmt::format("'frame' is '{}', expected 'moved' or 'fixed'.", frame));
    return reader.error();
  }
  placement.fixed_frame = frame == "fixed" && machine.isRotary(joint);
  auto effect = make(machine, placement, std::move(form), std::move(values), std::move(sigmas));
  if (effect) return effect;
  reader.fail(key, "model.form", effect.error().text);
  return reader.error();
}

Result<std::vector<EffectPtr>> smoothBasis(const kinematics::Machine& machine, const Placement& placement,
                                           const SmoothForm& form) {
  std::vector<EffectPtr> basis;
  for (std::size_t k = 0; k < form.coefficientCount(); ++k) {
    std::vector<double> coefficients(form.coefficientCount(), 0.0);
    coefficients[k] = 1.0;
    auto effect = NonparametricEffect::make(machine, placement, form, std::move(coefficients));
    if (!effect) return effect.error();
    basis.push_back(EffectPtr(std::move(*effect)));
  }
  return basis;
}

}  // namespace nineline::errors
