#include "core/discovery/selection.h"

#include <set>

#include "core/discovery/outliers.h"
#include "core/discovery/wave_scan.h"

namespace nineline::discovery {

namespace {

constexpr double kKeep = 10.0;        // −2 ln L that a member must be worth
constexpr double kFirstMargin = 8.0;  // in passes whose noise is not settled yet
constexpr int kPasses = 3;

std::set<std::size_t> causesOf(const OptionBank& bank, const OptionSet& set) {
  std::set<std::size_t> causes;
  for (const std::size_t option : set) causes.insert(bank.options[option].candidate);
  return causes;
}

}  // namespace

Selection::Selection(const Campaign& campaign, const GateOptions& gates)
    : campaign_(&campaign),
      gate_options_(gates),
      model_(campaign.layout()),
      noise_(model_.declared()),
      existing_(existingPart(campaign)),
      library_(makeLibrary(campaign)) {
  dictionary_ =
      std::make_unique<Dictionary>(model_, noise_, existing_.fixed, campaign.residual(), library_.bank);
}

Hypotheses Selection::hypotheses() const { return {model_, existing_.fixed, campaign_->residual()}; }

Gates Selection::gates() const { return {model_, existing_.fixed, campaign_->residual(), gate_options_}; }

void Selection::whitenAnew(bool optimistic) {
  const Hypotheses::Verdict verdict = hypotheses().judge(*dictionary_, set_);
  noise_ = optimistic ? model_.estimate(verdict.residual, true).noise : verdict.noise;
  dictionary_ =
      std::make_unique<Dictionary>(model_, noise_, existing_.fixed, campaign_->residual(), library_.bank);
}

void Selection::flagOutliers() {
  const Hypotheses::Verdict verdict = hypotheses().judge(*dictionary_, set_);
  model_.setOutliers(findOutliers(model_, noise_, verdict.residual));
}

void Selection::searchAndScan() {
  constexpr int kScans = 2;
  SearchOptions options;
  options.margin = kFirstMargin;
  if (scanWaves(library_, model_, noise_, dictionary_->whitenedResidual(set_)) > 0) dictionary_->update();
  const OptionSet before = polish(*dictionary_, set_, options);
  set_ = search(*dictionary_, options);
  if (dictionary_->score(before) < dictionary_->score(set_)) set_ = before;
  for (int scan = 1; scan < kScans; ++scan) {
    if (scanWaves(library_, model_, noise_, dictionary_->whitenedResidual(set_)) == 0) break;
    dictionary_->update();
    const std::set<std::size_t> causes = causesOf(library_.bank, set_);
    set_ = polish(*dictionary_, set_, options);
    if (causesOf(library_.bank, set_) == causes) break;
  }
}

void Selection::prune() {
  constexpr double kHopeless = 8.0;  // gain
  const VectorXd alone = dictionary_->gains({});
  const VectorXd beside = dictionary_->gains(set_);
  std::vector<bool> kept(library_.bank.options.size());
  for (std::size_t o = 0; o < kept.size(); ++o) {
    const auto at = static_cast<Index>(o);
    kept[o] = alone[at] > kHopeless || beside[at] > kHopeless;
  }
  for (const std::size_t member : set_) kept[member] = true;
  const std::vector<std::size_t> moved = library_.bank.keepOnly(kept);
  for (std::size_t& member : set_) member = moved[member];
}

Result<void> Selection::run(Progress& progress) {
  progress.report(0.1, "searching");
  searchAndScan();
  prune();
  dictionary_ =
      std::make_unique<Dictionary>(model_, noise_, existing_.fixed, campaign_->residual(), library_.bank);
  std::set<std::size_t> before;
  for (int pass = 1; pass < kPasses; ++pass) {
    if (progress.isCancelled()) return cancelled();
    progress.report(0.1 + 0.2 * pass, "searching");
    flagOutliers();
    whitenAnew(pass == 1);
    searchAndScan();
    const std::set<std::size_t> causes = causesOf(library_.bank, set_);
    if (causes == before) break;
    before = causes;
  }
  if (progress.isCancelled()) return cancelled();
  progress.report(0.6, "judging");
  whitenAnew();
  LikelihoodPolish polish;
  polish.keep = kKeep;
  set_ = polishByLikelihood(*dictionary_, hypotheses(), set_, polish);
  suspected_ = polish.suspected;
  whitenAnew();
  set_ = refine(*dictionary_, set_, 2);
  set_ = gates().admit(*dictionary_, set_, refused_);
  return {};
}

}  // namespace nineline::discovery
