#include "core/discovery/effect_library.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace nineline::discovery {

namespace {

using errors::EffectPtr;
using errors::ParameterSpec;

constexpr double kBeyondPlausible = 3.0;  // a coefficient may be this much larger than usual
constexpr double kHuge = 1e9;             // a period so long that the wave stands still

errors::AvailableData columnsOf(const Campaign& campaign) {
  std::set<std::string> names;
  for (const CampaignFile& file : campaign.files()) {
    for (const measurement::Covariate& covariate : file.measurement.covariates) {
      names.insert(covariate.column);
    }
  }
  return {.columns = {names.begin(), names.end()}, .grinder = false};
}

/// Plausible size of each coefficient of linearBasis, in its parameter's unit.
std::vector<double> scalesOf(const kinematics::Machine& machine, const errors::Candidate& effect) {
  std::vector<double> scales;
  const errors::UnitChoice choice = errors::unitChoice(machine, effect.placement);
  for (const ParameterSpec& rule : effect.spec->parameters) {
    if (rule.role != errors::Role::Linear && rule.role != errors::Role::Amplitude) continue;
    const std::string_view unit = errors::unitOf(rule.quantity, choice);
    const bool arc = unit.starts_with("arcsec") || unit.starts_with("deg");
    const errors::Bounds bounds = rule.arc && arc ? rule.arc->mill : rule.linear.mill;
    const double size = std::max({std::abs(bounds.low), std::abs(bounds.high), 1e-12});
    scales.push_back(size);
    if (rule.role == errors::Role::Amplitude) scales.push_back(size);
  }
  return scales;
}

std::string nameOf(const errors::Candidate& effect) {
  std::string name(effect.spec->id);
  name += ":" + effect.placement.component.text();
  if (!effect.placement.sensor.empty()) name += ":" + effect.placement.sensor;
  if (!effect.placement.sensor_2.empty()) name += ":" + effect.placement.sensor_2;
  return name;
}

RowMatrix columnsAt(const Campaign& campaign, const NamedEffect& named, std::span<const double> shape) {
  const std::vector<errors::Parameter> nonlinear = nonlinearOf(named, {shape.begin(), shape.end()});
  const Result<std::vector<EffectPtr>> basis =
      errors::linearBasis(campaign.model().machine(), *named.effect.spec, named.effect.placement, nonlinear);
  if (!basis) return {campaign.residual().size(), 0};
  RowMatrix columns(campaign.residual().size(), static_cast<Index>(basis->size()));
  for (std::size_t k = 0; k < basis->size(); ++k) {
    columns.col(static_cast<Index>(k)) = named.scales[k] * campaign.effectColumn((*basis)[k]);
  }
  return columns;
}

bool isWave(const errors::Candidate& effect) {
  return effect.nonlinear.size() == 1 && !effect.nonlinear[0].choice && effect.columns == 2 &&
         (effect.nonlinear[0].name == "period" || effect.nonlinear[0].name == "frequency");
}

WaveSite waveSite(const Campaign& campaign, const NamedEffect& named, std::size_t candidate) {
  const errors::SearchRange& range = named.effect.nonlinear[0];
  WaveSite site;
  site.candidate = candidate;
  site.in_time = range.name == "frequency";
  site.low = range.plausible.low;
  site.high = range.plausible.high;
  const std::vector<double> still{site.in_time ? 1.0 / kHuge : kHuge};
  const RowMatrix columns = columnsAt(campaign, named, still);
  site.response = columns.cols() == 2 ? VectorXd(columns.col(1)) : VectorXd::Zero(columns.rows());
  site.argument.resize(columns.rows());
  const auto joint = static_cast<std::size_t>(named.effect.placement.joint);
  const bool rotary = campaign.model().machine().isRotary(named.effect.placement.joint);
  for (Index i = 0; i < columns.rows(); ++i) {
    const errors::MachineState& state = campaign.stateOf(i);
    const double position = rotary ? degFromRad(state.q[joint]) : state.q[joint];
    site.argument[i] = site.in_time ? state.time.value_or(0.0) : position;
  }
  return site;
}

Candidate candidateOf(const Campaign& campaign, const NamedEffect& named) {
  Candidate candidate;
  candidate.name = nameOf(named.effect);
  candidate.group = campaign.model().machine().joint(named.effect.placement.joint).axis.text();
  candidate.largest = kBeyondPlausible;
  candidate.measurement = named.effect.spec->kind == errors::EffectKind::Measurement;
  for (const errors::SearchRange& range : named.effect.nonlinear) {
    Nonlinear parameter{range.name, range.plausible.low, range.plausible.high, range.starts, range.choice};
    if (isWave(named.effect)) parameter.grid.clear();
    candidate.nonlinear.push_back(std::move(parameter));
  }
  for (const ParameterSpec& rule : named.effect.spec->parameters) {
    if (rule.role == errors::Role::Linear && rule.sign != 0) candidate.sign = rule.sign;
  }
  // Both contain plain backlash: they are named only where their own part shows clearly.
  constexpr double kContainsBacklash = -5.0;
  const std::string_view id = named.effect.spec->id;
  if (id == "counterweight" || id == "friction_speed") candidate.log_prior = kContainsBacklash;
  candidate.columns = [&campaign, named](std::span<const double> shape) {
    return columnsAt(campaign, named, shape);
  };
  return candidate;
}

}  // namespace

std::vector<errors::Parameter> nonlinearOf(const NamedEffect& named, const std::vector<double>& shape) {
  std::vector<errors::Parameter> values;
  for (std::size_t p = 0; p < shape.size(); ++p) {
    const errors::SearchRange& range = named.effect.nonlinear[p];
    values.push_back({range.name, range.unit, shape[p], std::nullopt});
  }
  return values;
}

EffectLibrary makeLibrary(const Campaign& campaign) {
  EffectLibrary library;
  const kinematics::Machine& machine = campaign.model().machine();
  for (errors::Candidate& effect : errors::candidatesFor(machine, columnsOf(campaign))) {
    NamedEffect named{std::move(effect), {}};
    named.scales = scalesOf(machine, named.effect);
    const std::size_t index = library.bank.candidates.size();
    library.bank.add(candidateOf(campaign, named));
    if (isWave(named.effect)) library.waves.push_back(waveSite(campaign, named, index));
    library.named.push_back(std::move(named));
  }
  return library;
}

}  // namespace nineline::discovery
