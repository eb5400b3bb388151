#include "tests/identification_campaign/campaign.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/errors/table_effects.h"

namespace nineline::identification_campaign {

void Coverage::add(double deviation, double sigma) {
  const double size = std::abs(deviation) / sigma;
  ++values;
  if (size <= 2.0) ++inside;
  square += size * size;
  largest = std::max(largest, size);
}

void Coverage::add(const Coverage& other) {
  values += other.values;
  inside += other.inside;
  square += other.square;
  largest = std::max(largest, other.largest);
}

double Coverage::percent() const {
  return values == 0 ? 0.0 : 100.0 * static_cast<double>(inside) / static_cast<double>(values);
}

namespace {

using errors::EffectPtr;

const errors::Effect* counterpart(const errors::Effect& effect, const errors::ErrorModel& model) {
  for (const EffectPtr& other : model.effects()) {
    if (other->component() == effect.component() && other->id() == effect.id()) return other.get();
  }
  return nullptr;
}

void addValue(const std::string& part, bool angular, double deviation, double sigma, Comparison& comparison) {
  double& largest = angular ? comparison.largest_angle : comparison.largest_length;
  largest = std::max(largest, std::abs(deviation));
  if (sigma <= 0.0) return;
  comparison.by_part[part].add(deviation, sigma);
  comparison.all.add(deviation, sigma);
}

void compareTables(const errors::TableEffect& found, const errors::TableEffect& planted,
                   Comparison& comparison) {
  const errors::ErrorTable& table = *found.table();
  for (std::size_t i = 0; i < table.values().size(); ++i) {
    const double position = table.grid().start + table.grid().spacing * static_cast<double>(i);
    const double deviation = table.values()[i] - planted.table()->value(position);
    const double sigma = found.sigmas()[i];
    const double least = found.component().isAngular() ? 1e-15 : 1e-12;
    addValue("table", found.component().isAngular(), deviation, sigma > least ? sigma : 0.0, comparison);
  }
}

void compareParameters(const errors::Effect& found, const errors::Effect& planted, Comparison& comparison) {
  const errors::Parameter one = found.parameters().front();
  const errors::Parameter two = planted.parameters().front();
  const bool angular = found.component().isAngular();
  const double unit = angular ? radFromArcsec(1.0) : mmFromUm(1.0);
  addValue(found.id() == "location" ? "location" : "play", angular, unit * (one.value - two.value),
           unit * one.sigma.value_or(0.0), comparison);
}

}  // namespace

Comparison compare(const errors::ErrorModel& found, const errors::ErrorModel& planted) {
  Comparison comparison;
  for (const EffectPtr& effect : planted.effects()) {
    if (counterpart(*effect, found) == nullptr) comparison.missing.push_back(effect->component().text());
  }
  for (const EffectPtr& effect : found.effects()) {
    const errors::Effect* other = counterpart(*effect, planted);
    if (other == nullptr) {
      comparison.invented.push_back(effect->component().text());
      continue;
    }
    const auto* table = dynamic_cast<const errors::TableEffect*>(effect.get());
    if (table != nullptr) {
      compareTables(*table, dynamic_cast<const errors::TableEffect&>(*other), comparison);
    } else {
      compareParameters(*effect, *other, comparison);
    }
  }
  return comparison;
}

}  // namespace nineline::identification_campaign
