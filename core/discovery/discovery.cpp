#include "core/discovery/discovery.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/discovery/final_fit.h"
#include "core/discovery/holdout.h"
#include "core/discovery/hygiene.h"
#include "core/discovery/leftover.h"
#include "core/discovery/lookalikes.h"
#include "core/discovery/next_experiment.h"
#include "core/discovery/where.h"

namespace nineline::discovery {

namespace {

constexpr double kDetail = 0.2;  // smaller than this share of another on its axis: a shape detail

/// Figures over the readings that are lengths (angles where there are none).
class Figures {
 public:
  explicit Figures(const Campaign& campaign) : campaign_(&campaign) {
    for (std::size_t i = 0; i < campaign.readings().size(); ++i) {
      const auto at = static_cast<Index>(i);
      (campaign.isAngular(at) ? angles_ : lengths_).push_back(at);
    }
  }
  [[nodiscard]] double rms(const VectorXd& in_sigma, const std::vector<bool>& outliers) const {
    double sum = 0.0, count = 0.0;
    for (const Index i : lengths_.empty() ? angles_ : lengths_) {
      if (outliers[static_cast<std::size_t>(i)]) continue;
      const double value = campaign_->shown(i, in_sigma[i]);
      sum += value * value, count += 1.0;
    }
    return count > 0.0 ? std::sqrt(sum / count) : 0.0;
  }

 private:
  const Campaign* campaign_;
  std::vector<Index> lengths_, angles_;
};

/// Residual of the present model with the zeros of the files taken out.
VectorXd withoutZeros(const Selection& selection) {
  const Campaign& campaign = selection.campaign();
  VectorXd residual = campaign.residual();
  const RowMatrix zeros = campaign.zeroColumns();
  for (Index c = 0; c < zeros.cols(); ++c) {
    double sum = 0.0, weight = 0.0;
    for (Index i = 0; i < residual.size(); ++i) {
      if (selection.noiseModel().outliers()[static_cast<std::size_t>(i)]) continue;
      sum += zeros(i, c) * residual[i], weight += zeros(i, c) * zeros(i, c);
    }
    if (weight > 0.0) residual -= zeros.col(c) * (sum / weight);
  }
  return residual;
}

VectorXd levels(const Selection& selection, const Noise& noise) {
  VectorXd level(selection.campaign().residual().size());
  for (const NoiseRun& run : selection.campaign().layout().runs) {
    level.segment(run.first, run.count)
        .setConstant(std::sqrt(noise.level[static_cast<std::size_t>(run.group)]));
  }
  return level;
}

/// Chance, over everything that was looked for, of a gain as large as the best one found.
double chanceOf(const Selection& selection, double gain, double degrees) {
  const double tried = static_cast<double>(selection.library().bank.options.size());
  const double half = 0.5 * std::max(gain, 0.0);
  const double log_p = std::log(tried) - half + (0.5 * degrees) * std::log(std::max(half, 1.0));
  return std::clamp(std::exp(std::min(log_p, 0.0)), 1e-300, 1.0);
}

void describeNoise(const Selection& selection, const Noise& noise, DiscoveryReport& report) {
  for (std::size_t g = 0; g < noise.shape.size(); ++g) {
    const NoiseShape& shape = noiseShapes()[noise.shape[g]];
    report.noise.push_back({selection.campaign().groupNames()[g], std::sqrt(noise.level[g]), shape.correlated,
                            shape.length, shape.offset});
  }
}

/// Effects of the report in order of their share, each with its name judged.
void describeEffects(Selection& selection, const FinalFit& fit, DiscoveryReport& report,
                     const std::string& when) {
  const EffectLibrary& library = selection.library();
  const Gates gates = selection.gates();
  double total = 0.0;
  for (const VectorXd& part : fit.contributions) total += part.squaredNorm();
  for (std::size_t i = 0; i < selection.set().size(); ++i) {
    const std::size_t member = selection.set()[i];
    if (library.bank.candidateOf(member).generic) continue;
    const NamedEffect& named = library.named[library.bank.options[member].candidate];
    NameJudgement judgement = judgeName(selection, member);
    FoundEffect found;
    found.effect = std::string(named.effect.spec->id);
    found.joint = selection.campaign().model().machine().joint(named.effect.placement.joint).axis.text();
    found.component = named.effect.placement.component.text();
    found.sensor = named.effect.placement.sensor;
    found.confidence = judgement.confidence;
    found.parameters = fit.parameters[i];
    found.share_pct = total > 0.0 ? 100.0 * fit.contributions[i].squaredNorm() / total : 0.0;
    found.evidence = judgement.evidence;
    found.rms_in_sigma = gates.bestRms(selection.dictionary(), selection.set(), member);
    found.is_measurement = named.effect.spec->kind == errors::EffectKind::Measurement;
    found.lookalikes = std::move(judgement.lookalikes);
    if (Result<errors::EffectPtr> effect = effectOf(selection, member, fit.parameters[i], when); effect) {
      found.model = *effect;
    }
    report.effects.push_back(std::move(found));
    Place place = placeOf(selection.campaign(), fit.contributions[i]);
    place.share_pct *= report.effects.back().share_pct / 100.0;
    report.where.push_back(std::move(place));
  }
}

/// A small companion of a much larger effect on its axis is that effect's shape, not a second cause.
void markDetails(DiscoveryReport& report) {
  for (FoundEffect& small : report.effects) {
    for (const FoundEffect& large : report.effects) {
      if (small.joint != large.joint || small.rms_in_sigma >= kDetail * large.rms_in_sigma) continue;
      small.detail_of = large.effect;
      small.confidence = std::min(small.confidence, 0.45);
    }
  }
}

void describeSuspected(const Selection& selection, DiscoveryReport& report) {
  const EffectLibrary& library = selection.library();
  const auto add = [&](std::size_t option, const std::string& why, double worth) {
    const std::size_t candidate = library.bank.options[option].candidate;
    if (candidate >= library.named.size()) return;
    const NamedEffect& named = library.named[candidate];
    report.suspected.push_back(
        {std::string(named.effect.spec->id),
         selection.campaign().model().machine().joint(named.effect.placement.joint).axis.text(), why, worth});
  };
  for (const Evidence& one : selection.suspected()) add(one.option, "evidence too weak", one.worth);
  for (const Refusal& one : selection.refused()) add(one.option, "refused: " + one.gate, one.worth);
}

/// Structures without a name, each form as an effect of the model.
Result<void> describeStructures(const Selection& selection, const Leftover& leftover, const FinalFit& fit,
                                DiscoveryReport& report, const std::string& when) {
  double total = 0.0;
  Index at = 0;
  for (const VectorXd& part : fit.contributions) total += part.squaredNorm();
  for (std::size_t i = 0; i < selection.set().size(); ++i) {
    const std::size_t member = selection.set()[i];
    const Index count = selection.library().bank.options[member].raw.cols();
    const VectorXd own = fit.verdict.coefficients.segment(at, count);
    at += count;
    if (!selection.library().bank.candidateOf(member).generic) continue;
    const SmoothStructure& structure = leftover.of(selection.library().bank, member);
    const double share = total > 0.0 ? 100.0 * fit.contributions[i].squaredNorm() / total : 0.0;
    Index first = 0;
    for (const errors::SmoothForm& form : structure.forms) {
      std::vector<double> coefficients;
      for (std::size_t c = 0; c < form.coefficientCount(); ++c) {
        coefficients.push_back(structure.unit * own[first + static_cast<Index>(c)]);
      }
      first += static_cast<Index>(form.coefficientCount());
      Result<std::shared_ptr<errors::Effect>> effect = errors::NonparametricEffect::make(
          selection.campaign().model().machine(), structure.placement, form, std::move(coefficients));
      if (!effect) return effect.error();
      (*effect)->setProvenance({"discovered", when});
      FoundEffect found;
      found.effect = "nonparametric";
      found.joint = structure.placement.component.axis.text();
      found.component = structure.placement.component.text();
      found.covariates = form.covariates;
      found.confidence = 0.9;
      found.share_pct = share / static_cast<double>(structure.forms.size());
      found.model = *effect;
      report.effects.push_back(std::move(found));
    }
    Place place = placeOf(selection.campaign(), fit.contributions[i]);
    place.text = "unknown structured effect in " + structure.name + "; " + place.text;
    place.share_pct *= share / 100.0;
    report.where.push_back(std::move(place));
  }
  return {};
}

Result<ErrorModel> enlargedModel(const Selection& selection, const FinalFit& fit,
                                 const DiscoveryReport& report) {
  if (selection.set().empty()) return selection.campaign().model();
  const Result<ErrorModel> moved =
      movedModel(selection.campaign().model(), selection.existing(), fit.verdict.fixed);
  if (!moved) return moved;
  std::vector<errors::EffectPtr> effects = moved->effects();
  for (const FoundEffect& found : report.effects) {
    if (found.model && !found.is_measurement) effects.push_back(found.model);
  }
  return ErrorModel::make(moved->machine(), std::move(effects));
}

void describeGap(const Selection& selection, const FinalFit& fit, DiscoveryReport& report) {
  const Figures figures(selection.campaign());
  const std::vector<bool>& outliers = selection.noiseModel().outliers();
  Gap& gap = report.gap;
  gap.rms_before = figures.rms(withoutZeros(selection), outliers);
  gap.rms_after = figures.rms(fit.verdict.residual, outliers);
  gap.noise_floor = figures.rms(levels(selection, fit.verdict.noise), outliers);
  const Dictionary& dictionary = selection.dictionary();
  if (!selection.set().empty()) {
    const double gain = dictionary.sumOfSquares({}) - dictionary.sumOfSquares(selection.set());
    gap.p_value = chanceOf(selection, gain, static_cast<double>(selection.set().size()));
    gap.significant = true;
  } else {
    const VectorXd net = dictionary.gains({});
    gap.p_value = chanceOf(selection, net.size() != 0 ? net.maxCoeff() : 0.0, 1.0);
    gap.significant = false;
  }
}

Verdict verdictOf(const Selection& selection, const DiscoveryReport& report) {
  const bool named = std::any_of(report.effects.begin(), report.effects.end(),
                                 [](const FoundEffect& one) { return one.effect != "nonparametric"; });
  const bool structure = std::any_of(selection.set().begin(), selection.set().end(), [&](std::size_t member) {
    return selection.library().bank.candidateOf(member).generic;
  });
  if (named) return structure ? Verdict::Partly : Verdict::Explained;
  return structure ? Verdict::Unknown : Verdict::None;
}

/// No gain on unseen runs, no change: whatever the fit says, the model stays and nothing is claimed.
void withdrawIfUseless(const errors::ErrorModel& model, DiscoveryReport& report) {
  constexpr double kWorse = 1.02;
  constexpr double kNotClaimed = 0.4;
  const bool worse =
      report.gap.holdout_before > 0.0 && report.gap.holdout_after > kWorse * report.gap.holdout_before;
  if (report.effects.empty() || !worse) return;
  report.verdict = Verdict::Unknown;
  for (FoundEffect& found : report.effects) found.confidence = std::min(found.confidence, kNotClaimed);
  report.model = model;
  report.gap.holdout_after = report.gap.holdout_before;
  report.gap.closed_pct = 0.0;
}

}  // namespace

Result<DiscoveryReport> discover(const errors::ErrorModel& model,
                                 const std::vector<measurement::Measurement>& measurements,
                                 const DiscoveryOptions& options, Progress& progress) {
  progress.report(0.0, "predicting");
  const Holdout holdout(measurements, options.holdout_runs);
  const auto seen = [&](std::size_t file, std::size_t sample) { return !holdout.has(file, sample); };
  Result<Campaign> campaign = Campaign::make(model, measurements, seen);
  if (!campaign) return campaign.error();
  const std::vector<HygieneFinding> faults = checkData(*campaign);
  if (!faults.empty()) {
    campaign = Campaign::make(model, measurements, [&](std::size_t file, std::size_t sample) {
      return seen(file, sample) && !isFaulty(faults, file, sample);
    });
    if (!campaign) return campaign.error();
  }
  Selection selection(*campaign, {});
  if (Result<void> ran = selection.run(progress); !ran) return ran.error();
  progress.report(0.75, "looking for structure without a name");
  const Leftover leftover = findLeftover(selection);
  const FinalFit fit = finalFit(selection);
  DiscoveryReport report;
  for (const HygieneFinding& one : faults) report.data_quality.push_back(one.fault);
  report.samples = campaign->readings().size();
  report.outliers = static_cast<std::size_t>(
      std::count(selection.noiseModel().outliers().begin(), selection.noiseModel().outliers().end(), true));
  describeNoise(selection, fit.verdict.noise, report);
  describeEffects(selection, fit, report, options.when);
  markDetails(report);
  if (Result<void> told = describeStructures(selection, leftover, fit, report, options.when); !told) {
    return told.error();
  }
  describeSuspected(selection, report);
  describeGap(selection, fit, report);
  report.verdict = verdictOf(selection, report);
  Result<ErrorModel> enlarged = enlargedModel(selection, fit, report);
  if (!enlarged) return enlarged.error();
  if (Result<void> judged =
          holdout.judge(model, *enlarged, measurements, *campaign, fit.verdict.noise, report.gap);
      !judged) {
    return judged.error();
  }
  report.model = std::move(*enlarged);
  withdrawIfUseless(model, report);
  report.next_experiment = nextExperiment(report);
  report.message = "done";
  progress.report(1.0, "done");
  return report;
}

}  // namespace nineline::discovery
