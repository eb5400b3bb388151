#include "core/discovery/existing_parameters.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/errors/effect_catalogue.h"
#include "core/errors/table_effects.h"

namespace nineline::discovery {

namespace {

// A model that does not say how sure its numbers are is taken to be as sure as a campaign of about ten
// readings for each of them.
constexpr double kUnstatedShare = 0.3;  // of the repeatability
constexpr double kUnstatedArm = 200.0;  // mm: angles cause as much at this arm
constexpr double kLeastInfluence = 0.02;

struct Typical {
  double length = 4e-4;  // mm
  double angle = 2e-6;   // rad
};

double medianSigma(const Campaign& campaign, bool angular, double otherwise) {
  std::vector<double> all;
  for (std::size_t i = 0; i < campaign.readings().size(); ++i) {
    if (campaign.isAngular(static_cast<Index>(i)) == angular) all.push_back(campaign.readings()[i].sigma);
  }
  if (all.empty()) return otherwise;
  const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
  std::nth_element(all.begin(), middle, all.end());
  return *middle;
}

Typical typicalSigmas(const Campaign& campaign) {
  Typical typical;
  typical.length = kUnstatedShare * medianSigma(campaign, false, 4e-4);
  typical.angle = std::max(typical.length / kUnstatedArm,
                           kUnstatedShare * medianSigma(campaign, true, typical.length / kUnstatedArm));
  return typical;
}

/// Columns of one effect's parameters, each for a change of one prior standard deviation.
class Collector {
 public:
  Collector(const Campaign& campaign, ExistingPart& part, std::vector<VectorXd>& columns)
      : campaign_(&campaign), part_(&part), columns_(&columns), typical_(typicalSigmas(campaign)) {}

  void addTable(std::size_t index, const errors::TableEffect& table) {
    const errors::ErrorTable& values = *table.table();
    for (std::size_t node = 0; node < values.values().size(); ++node) {
      const bool stated = node < table.sigmas().size();
      const double otherwise = table.component().isAngular() ? typical_.angle : typical_.length;
      const double sigma = stated ? table.sigmas()[node] : otherwise;
      std::vector<double> unit(values.values().size(), 0.0);
      unit[node] = sigma;
      Result<errors::ErrorTable> basis = errors::ErrorTable::make(values.grid(), unit);
      if (!basis || sigma <= 0.0) continue;
      auto effect = std::make_shared<errors::TableEffect>(table.joint(), table.component(), std::move(*basis),
                                                          table.slot() == errors::Slot::Standing);
      effect->setReference(table.reference());
      keep(campaign_->effectColumn(effect), {index, "", node, sigma});
    }
  }

  void addLocation(std::size_t index, const errors::LocationEffect& location) {
    const std::vector<errors::Parameter> parameters = location.parameters();
    const bool angular = location.component().isAngular();
    const double unit = angular ? radFromArcsec(1.0) : mmFromUm(1.0);
    const double sigma = parameters[0].sigma
                             ? *parameters[0].sigma
                             : (angular ? typical_.length / kUnstatedArm : typical_.length) / unit;
    if (sigma <= 0.0) return;
    const auto effect = std::make_shared<errors::LocationEffect>(location.joint(), location.component(),
                                                                 sigma * unit, std::nullopt);
    keep(campaign_->effectColumn(effect), {index, parameters[0].name, 0, sigma});
  }

  void addOther(std::size_t index, const errors::EffectPtr& effect) {
    constexpr double kUnstatedRelative = 0.05;
    const VectorXd present = campaign_->effectColumn(effect);
    for (const errors::Parameter& parameter : effect->parameters()) {
      const double sigma = parameter.sigma.value_or(kUnstatedRelative * std::abs(parameter.value));
      if (!(sigma > 0.0)) continue;
      const errors::EffectPtr moved = withParameter(effect, parameter.name, parameter.value + sigma);
      if (moved) keep(campaign_->effectColumn(moved) - present, {index, parameter.name, 0, sigma});
    }
  }

  /// The effect with one parameter changed; nullptr where its file form has no such parameter.
  [[nodiscard]] errors::EffectPtr withParameter(const errors::EffectPtr& effect, const std::string& name,
                                                double value) const {
    Json json = effect->toJson(campaign_->model().machine());
    for (auto& [key, member] : *json.members()) {
      if (key != "parameters" || member.members() == nullptr) continue;
      for (auto& [parameter, entry] : *member.members()) {
        if (parameter == name && entry.find("value") != nullptr) entry.set("value", value);
      }
    }
    Result<errors::EffectPtr> made =
        errors::effectFromJson(json, "the present model", 0, campaign_->model().machine());
    return made ? *made : nullptr;
  }

 private:
  void keep(const VectorXd& column, ExistingParameter parameter) {
    if (!column.allFinite() || column.squaredNorm() < kLeastInfluence) return;
    columns_->push_back(column);
    part_->parameters.push_back(std::move(parameter));
  }

  const Campaign* campaign_;
  ExistingPart* part_;
  std::vector<VectorXd>* columns_;
  Typical typical_;
};

struct Directions {
  Eigen::MatrixXd columns;
  Eigen::MatrixXd mix;
};

/// The directions in which the readings know more than a fifth of what the prior does, effect by effect.
Directions tellingDirections(const std::vector<ExistingParameter>& parameters,
                             const std::vector<VectorXd>& columns) {
  constexpr double kTelling = 0.2;
  Directions all;
  const auto total = static_cast<Index>(columns.size());
  const Index samples = columns.empty() ? 0 : columns[0].size();
  if (total == 0) return all;
  std::vector<VectorXd> kept, mixes;
  for (Index first = 0; first < total;) {
    Index last = first;
    while (last < total && parameters[static_cast<std::size_t>(last)].effect ==
                               parameters[static_cast<std::size_t>(first)].effect) {
      ++last;
    }
    Eigen::MatrixXd block(samples, last - first);
    for (Index c = first; c < last; ++c) block.col(c - first) = columns[static_cast<std::size_t>(c)];
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(block.transpose() * block);
    for (Index k = 0; k < last - first; ++k) {
      if (solver.eigenvalues()[k] < kTelling) continue;
      VectorXd mix = VectorXd::Zero(total);
      mix.segment(first, last - first) = solver.eigenvectors().col(k);
      kept.emplace_back(block * solver.eigenvectors().col(k));
      mixes.push_back(std::move(mix));
    }
    first = last;
  }
  all.columns.resize(samples, static_cast<Index>(kept.size()));
  all.mix.resize(total, static_cast<Index>(kept.size()));
  for (std::size_t k = 0; k < kept.size(); ++k) {
    all.columns.col(static_cast<Index>(k)) = kept[k];
    all.mix.col(static_cast<Index>(k)) = mixes[k];
  }
  return all;
}

}  // namespace

ExistingPart existingPart(const Campaign& campaign) {
  ExistingPart part;
  std::vector<VectorXd> columns;
  Collector collector(campaign, part, columns);
  const std::vector<errors::EffectPtr>& effects = campaign.model().effects();
  for (std::size_t e = 0; e < effects.size(); ++e) {
    if (const auto* table = dynamic_cast<const errors::TableEffect*>(effects[e].get())) {
      collector.addTable(e, *table);
    } else if (const auto* location = dynamic_cast<const errors::LocationEffect*>(effects[e].get())) {
      collector.addLocation(e, *location);
    } else {
      collector.addOther(e, effects[e]);
    }
  }
  const RowMatrix zeros = campaign.zeroColumns();
  const Directions directions = tellingDirections(part.parameters, columns);
  const Index count = directions.columns.cols();
  part.directions = directions.mix;
  part.fixed.columns.resize(campaign.residual().size(), count + zeros.cols());
  if (count != 0) part.fixed.columns.leftCols(count) = directions.columns;
  part.fixed.columns.rightCols(zeros.cols()) = zeros;
  part.fixed.precision = VectorXd::Zero(part.fixed.columns.cols());
  part.fixed.precision.head(count).setOnes();
  return part;
}

namespace {

/// The file form of an effect with its parameters moved.
void moveTable(Json& json, const std::vector<std::pair<std::size_t, double>>& moves, bool angular) {
  Json* values = nullptr;
  for (auto& [key, member] : *json.members()) {
    if (key.starts_with("values_")) values = &member;
  }
  if (values == nullptr || values->items() == nullptr) return;
  for (const auto& [node, change] : moves) {
    Json& value = (*values->items())[node];
    const double shown = angular ? arcsecFromRad(change) : umFromMm(change);
    value = Json(*value.number() + shown);
  }
}

void moveParameter(Json& json, const std::string& name, double change) {
  for (auto& [key, member] : *json.members()) {
    if (key.starts_with("value_") && member.number() != nullptr) member = Json(*member.number() + change);
    if (key != "parameters" || member.members() == nullptr) continue;
    for (auto& [parameter, entry] : *member.members()) {
      const Json* value = entry.find("value");
      if (parameter == name && value != nullptr) entry.set("value", *value->number() + change);
    }
  }
}

}  // namespace

Result<ErrorModel> movedModel(const ErrorModel& model, const ExistingPart& part,
                              const VectorXd& coefficients) {
  const VectorXd moves = part.directions * coefficients.head(part.directions.cols());
  std::vector<errors::EffectPtr> effects = model.effects();
  for (std::size_t e = 0; e < effects.size(); ++e) {
    Json json = effects[e]->toJson(model.machine());
    std::vector<std::pair<std::size_t, double>> nodes;
    bool moved = false;
    for (std::size_t p = 0; p < part.parameters.size(); ++p) {
      const ExistingParameter& parameter = part.parameters[p];
      if (parameter.effect != e) continue;
      const double change = moves[static_cast<Index>(p)] * parameter.sigma;
      moved = true;
      if (parameter.name.empty()) {
        nodes.emplace_back(parameter.node, change);
      } else {
        moveParameter(json, parameter.name, change);
      }
    }
    if (!moved) continue;
    moveTable(json, nodes, effects[e]->component().isAngular());
    Result<errors::EffectPtr> made =
        errors::effectFromJson(json, "the re-estimated model", e, model.machine());
    if (!made) return made.error();
    effects[e] = *made;
  }
  return ErrorModel::make(model.machine(), std::move(effects));
}

}  // namespace nineline::discovery
