#include "core/identification/found_effects.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/errors/effect_catalogue.h"
#include "core/errors/table_effects.h"

namespace nineline::identification {

using errors::EffectPtr;
using errors::ErrorTable;
using estimation::ReadingSet;

namespace {

std::shared_ptr<errors::Effect> withSource(std::shared_ptr<errors::Effect> effect, const std::string& when) {
  effect->setProvenance({"identified", when});
  return effect;
}

Result<EffectPtr> tableOf(const TableUnknown& table, const KnotSearch& search, const VectorXd& coefficients,
                          const std::string& when) {
  const Index n = table.basis->nodes();
  std::vector<double> values(static_cast<std::size_t>(n));
  std::vector<double> sigmas(static_cast<std::size_t>(n));
  const Eigen::SparseMatrix<double, Eigen::RowMajor> rows(search.map.middleRows(table.first, n));
  for (Index i = 0; i < n; ++i) {
    values[static_cast<std::size_t>(i)] = coefficients[table.first + i];
    const VectorXd row = rows.row(i).transpose();
    sigmas[static_cast<std::size_t>(i)] = std::sqrt(std::max(0.0, row.dot(search.fit.covariance * row)));
  }
  Result<ErrorTable> values_table = ErrorTable::make(table.basis->grid(), std::move(values));
  if (!values_table) return values_table.error();
  auto effect = std::make_shared<errors::TableEffect>(table.joint, table.component, std::move(*values_table),
                                                      table.fixed_frame);
  effect->setSigmas(std::move(sigmas));
  return EffectPtr(withSource(std::move(effect), when));
}

Result<EffectPtr> playOf(const ScalarUnknown& play, const Machine& machine, double width, double sigma) {
  const bool angular = play.component.isAngular();
  const auto shown = [angular](double value) { return angular ? arcsecFromRad(value) : umFromMm(value); };
  const bool is_own = play.component == errors::positioningOf(machine.joint(play.joint));
  Json parameter = Json::object();
  parameter.set("value", shown(width)).set("sigma", shown(sigma)).set("unit", angular ? "arcsec" : "um");
  Json parameters = Json::object();
  parameters.set("width", std::move(parameter));
  Json json = Json::object();
  json.set("effect", is_own    ? "backlash"
                     : angular ? "angular_play"
                               : "lateral_play")
      .set("joint", machine.joint(play.joint).axis.text())
      .set("component", play.component.text())
      .set("parameters", std::move(parameters));
  return errors::effectFromJson(json, "identification", 1, machine);
}

bool isTold(const KnotSearch& search, const TableUnknown& table) {
  for (Index i = table.first; i < table.first + table.basis->nodes(); ++i) {
    for (Index k = 0; k < search.map.cols(); ++k) {
      if (search.map.coeff(i, k) != 0.0) return true;
    }
  }
  return false;
}

TableCoverage coverageOf(const TableUnknown& table, const ReadingSet& readings) {
  const JointPositionsSeen seen = positionsSeen(readings, table.joint);
  return {table.component.text(), seen.low, seen.high, static_cast<std::size_t>(table.basis->nodes())};
}

}  // namespace

Result<errors::ErrorModel> modelOf(const ReadingSet& readings, const KnotSearch& search,
                                   const std::string& when, std::vector<TableCoverage>& coverage) {
  const VectorXd coefficients = search.map * search.fit.parameters;
  std::vector<EffectPtr> effects;
  for (const TableUnknown& table : search.parameters.tables) {
    if (!isTold(search, table)) continue;
    Result<EffectPtr> effect = tableOf(table, search, coefficients, when);
    if (!effect) return effect.error();
    effects.push_back(std::move(*effect));
    coverage.push_back(coverageOf(table, readings));
  }
  for (const ScalarUnknown& scalar : search.parameters.scalars) {
    const auto at = std::find(search.selection.begin(), search.selection.end(), scalar.parameter);
    if (at == search.selection.end()) continue;
    const Index k = at - search.selection.begin();
    const double value = search.fit.parameters[k];
    const double sigma = std::sqrt(std::max(0.0, search.fit.covariance(k, k)));
    if (scalar.part == Part::Location) {
      effects.push_back(withSource(
          std::make_shared<errors::LocationEffect>(scalar.joint, scalar.component, value, sigma), when));
      continue;
    }
    Result<EffectPtr> play = playOf(scalar, readings.machine(), value, sigma);
    if (!play) return play.error();
    effects.push_back(std::move(*play));
  }
  return errors::ErrorModel::make(readings.machine(), std::move(effects));
}

}  // namespace nineline::identification
