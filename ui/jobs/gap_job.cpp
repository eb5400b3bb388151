#include "ui/jobs/gap_job.h"

#include <cmath>

#include "core/measurement/prediction.h"

namespace nineline::jobs {

namespace {

using measurement::Measurement;
using measurement::Prediction;

/// Where nothing states how well a reading repeats.
constexpr double kAssumedSigma = 1e-3;           // mm
constexpr double kAssumedAngularSigma = 4.8e-6;  // rad, one arc second

Result<std::vector<Prediction>> predictAll(const errors::ErrorModel& model,
                                           const std::vector<Measurement>& measurements) {
  std::vector<Prediction> predictions;
  for (const Measurement& measurement : measurements) {
    Result<Prediction> prediction = measurement::predict(model, measurement);
    if (!prediction) return prediction.error();
    predictions.push_back(std::move(*prediction));
  }
  return predictions;
}

Residuals residualsOf(const Prediction& before, const Prediction& after) {
  Residuals residuals;
  std::vector<double> first;
  std::vector<double> last;
  for (std::size_t i = 0; i < before.rows.size(); ++i) {
    const measurement::ReadingRow& row = before.rows[i];
    if (!row.value || before.is_complete[i] == 0 || after.is_complete[i] == 0) continue;
    residuals.rows.push_back(row);
    first.push_back(*row.value - before.shown(i));
    last.push_back(*row.value - after.shown(i));
  }
  const auto size = static_cast<Eigen::Index>(first.size());
  residuals.before = Eigen::Map<Eigen::VectorXd>(first.data(), size);
  residuals.after = Eigen::Map<Eigen::VectorXd>(last.data(), size);
  return residuals;
}

double rmsInSigma(const std::vector<Measurement>& measurements, const std::vector<Prediction>& predictions) {
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t m = 0; m < predictions.size(); ++m) {
    for (std::size_t i = 0; i < predictions[m].rows.size(); ++i) {
      const measurement::ReadingRow& row = predictions[m].rows[i];
      if (!row.value || predictions[m].is_complete[i] == 0) continue;
      const bool angular = measurements[m].channels[row.channel].isAngular();
      const double sigma = row.sigma.value_or(angular ? kAssumedAngularSigma : kAssumedSigma);
      sum += std::pow((*row.value - predictions[m].shown(i)) / sigma, 2);
      ++count;
    }
  }
  return count == 0 ? 0.0 : std::sqrt(sum / static_cast<double>(count));
}

/// The waterfall: the present model, then one found effect after the other; the last stage is the new model
/// with everything estimated together.
Result<std::vector<GapStage>> stagesOf(const GapInput& input, const discovery::DiscoveryReport& report,
                                       const std::vector<Prediction>& before,
                                       const std::vector<Prediction>& after) {
  std::vector<GapStage> stages = {{{}, {}, rmsInSigma(input.measurements, before)}};
  std::vector<errors::EffectPtr> effects = input.model.effects();
  for (std::size_t i = 0; i < report.effects.size(); ++i) {
    const discovery::FoundEffect& found = report.effects[i];
    if (found.model == nullptr) continue;
    effects.push_back(found.model);
    Result<errors::ErrorModel> model = errors::ErrorModel::make(input.model.machine(), effects);
    if (!model) return model.error();
    const Result<std::vector<Prediction>> predictions = predictAll(*model, input.measurements);
    if (!predictions) return predictions.error();
    stages.push_back({found.effect, found.joint, rmsInSigma(input.measurements, *predictions)});
  }
  if (stages.size() > 1) stages.back().rms_in_sigma = rmsInSigma(input.measurements, after);
  return stages;
}

}  // namespace

Result<GapOutcomePtr> findGap(const GapInput& input, Progress& progress) {
  auto outcome = std::make_shared<GapOutcome>();
  Result<discovery::DiscoveryReport> report =
      discovery::discover(input.model, input.measurements, input.options, progress);
  if (!report) return report.error();
  const Result<std::vector<Prediction>> before = predictAll(input.model, input.measurements);
  if (!before) return before.error();
  const Result<std::vector<Prediction>> after =
      predictAll(report->model ? *report->model : input.model, input.measurements);
  if (!after) return after.error();
  for (std::size_t i = 0; i < before->size(); ++i) {
    outcome->residuals.push_back(residualsOf((*before)[i], (*after)[i]));
  }
  Result<std::vector<GapStage>> stages = stagesOf(input, *report, *before, *after);
  if (!stages) return stages.error();
  outcome->stages = std::move(*stages);
  outcome->report = std::move(*report);
  return GapOutcomePtr(outcome);
}

}  // namespace nineline::jobs
