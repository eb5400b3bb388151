#include "core/discovery/final_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace nineline::discovery {

namespace {

using Eigen::MatrixXd;

/// Where one member's numbers stand among all columns of the final fit.
struct Columns {
  Index linear = 0;
  Index linear_count = 0;
  Index nonlinear = 0;
  std::vector<std::size_t> free;  // non-linear parameters that are no choices
};

double stepFor(const Nonlinear& parameter, double value) {
  const double range = parameter.high - parameter.low;
  return 1e-4 * std::max({std::abs(value), 1e-3 * std::abs(range), 1e-9});
}

/// Derivative of a member's contribution with respect to one non-linear parameter.
VectorXd slopeOf(const Candidate& candidate, const Option& option, std::size_t parameter,
                 const VectorXd& coefficients) {
  const double step = stepFor(candidate.nonlinear[parameter], option.shape[parameter]);
  std::vector<double> above = option.shape, below = option.shape;
  above[parameter] += step;
  below[parameter] -= step;
  const RowMatrix up = candidate.columns(above), down = candidate.columns(below);
  if (up.cols() != coefficients.size() || down.cols() != coefficients.size()) {
    return VectorXd::Zero(option.raw.rows());
  }
  return (up - down) * coefficients / (2.0 * step);
}

/// Columns of the whole fit: existing parameters, linear coefficients, slopes of non-linear parameters.
RowMatrix designOf(const Selection& selection, const FinalFit& fit, std::vector<Columns>& places) {
  const OptionBank& bank = selection.library().bank;
  const RowMatrix& fixed = selection.existing().fixed.columns;
  std::vector<VectorXd> columns;
  Index at = 0;
  for (const std::size_t member : selection.set()) {
    const Option& option = bank.options[member];
    const Candidate& candidate = bank.candidateOf(member);
    Columns place{fixed.cols() + static_cast<Index>(columns.size()), option.raw.cols(), 0, {}};
    for (Index c = 0; c < option.raw.cols(); ++c) columns.emplace_back(option.raw.col(c));
    place.nonlinear = fixed.cols() + static_cast<Index>(columns.size());
    const VectorXd own = fit.verdict.coefficients.segment(at, option.raw.cols());
    for (std::size_t p = 0; p < option.shape.size(); ++p) {
      if (candidate.nonlinear[p].choice) continue;
      place.free.push_back(p);
      columns.push_back(slopeOf(candidate, option, p, own));
    }
    places.push_back(std::move(place));
    at += option.raw.cols();
  }
  RowMatrix design(fixed.rows(), fixed.cols() + static_cast<Index>(columns.size()));
  design.leftCols(fixed.cols()) = fixed;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    design.col(fixed.cols() + static_cast<Index>(c)) = columns[c];
  }
  return design;
}

MatrixXd covarianceOf(const Selection& selection, const Noise& noise, const RowMatrix& design) {
  const MatrixXd white = selection.noiseModel().whiten(noise, design);
  MatrixXd normal = white.transpose() * white;
  const VectorXd& precision = selection.existing().fixed.precision;
  normal.diagonal().head(precision.size()) += precision;
  // Columns of very different size: scaled before they are inverted.
  const VectorXd scale = (normal.diagonal().array() + 1e-30).sqrt().inverse();
  MatrixXd scaled = scale.asDiagonal() * normal * scale.asDiagonal();
  scaled.diagonal().array() += 1e-9;
  const MatrixXd inverse =
      Eigen::LDLT<MatrixXd>(scaled).solve(MatrixXd::Identity(scaled.rows(), scaled.cols()));
  return scale.asDiagonal() * inverse * scale.asDiagonal();
}

std::vector<errors::Parameter> parametersOfMember(const Selection& selection, std::size_t member,
                                                  const VectorXd& own, const Columns& place,
                                                  const MatrixXd& covariance, double inflation) {
  const NamedEffect& named = selection.library().named[selection.library().bank.options[member].candidate];
  const Option& option = selection.library().bank.options[member];
  std::vector<errors::Parameter> nonlinear = nonlinearOf(named, option.shape);
  for (std::size_t f = 0; f < place.free.size(); ++f) {
    const Index c = place.nonlinear + static_cast<Index>(f);
    nonlinear[place.free[f]].sigma = std::sqrt(std::max(covariance(c, c), 0.0) * inflation);
  }
  const VectorXd scale =
      Eigen::Map<const VectorXd>(named.scales.data(), static_cast<Index>(named.scales.size()));
  const MatrixXd linear =
      inflation * scale.asDiagonal() *
      covariance.block(place.linear, place.linear, place.linear_count, place.linear_count) *
      scale.asDiagonal();
  return errors::parametersOf(selection.campaign().model().machine(), *named.effect.spec,
                              named.effect.placement, nonlinear, scale.cwiseProduct(own), &linear)
      .parameters;
}

}  // namespace

FinalFit finalFit(const Selection& selection) {
  constexpr double kMostInflation = 9.0;
  FinalFit fit;
  fit.verdict = selection.hypotheses().judge(selection.dictionary(), selection.set());
  std::vector<Columns> places;
  const RowMatrix design = designOf(selection, fit, places);
  const MatrixXd covariance = covarianceOf(selection, fit.verdict.noise, design);
  const Gates gates = selection.gates();
  Index at = 0;
  for (std::size_t i = 0; i < selection.set().size(); ++i) {
    const std::size_t member = selection.set()[i];
    const Option& option = selection.library().bank.options[member];
    const VectorXd own = fit.verdict.coefficients.segment(at, option.raw.cols());
    at += option.raw.cols();
    fit.contributions.emplace_back(option.raw * own);
    if (selection.library().bank.candidateOf(member).generic) {
      fit.parameters.emplace_back();
      continue;
    }
    const double inflation =
        std::min(kMostInflation, gates.clusterInflation(selection.dictionary(), selection.set(), member));
    fit.parameters.push_back(parametersOfMember(selection, member, own, places[i], covariance, inflation));
  }
  return fit;
}

Result<errors::EffectPtr> effectOf(const Selection& selection, std::size_t option,
                                   const std::vector<errors::Parameter>& parameters,
                                   const std::string& when) {
  const NamedEffect& named = selection.library().named[selection.library().bank.options[option].candidate];
  Result<errors::EffectPtr> effect = errors::makeEffect(
      selection.campaign().model().machine(), *named.effect.spec, named.effect.placement, parameters);
  if (!effect) return effect;
  std::const_pointer_cast<errors::Effect>(*effect)->setProvenance({"discovered", when});
  return effect;
}

}  // namespace nineline::discovery
