#include "core/discovery/leftover.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace nineline::discovery {

namespace {

constexpr std::size_t kOffered = 28;     // structures that enter the dictionary
constexpr std::size_t kOfferedEach = 7;  // of one component
constexpr double kLeastRms = 0.25;       // repeatabilities
constexpr double kLeastGainToError = 1.3;
constexpr double kMustCarry = 9.0;     // −2 ln L of a named effect beside structures
constexpr double kNamedEnough = 0.85;  // share of the gain that keeps a name
constexpr int kMostStructures = 3;

struct Screened {
  double merit = 0.0;
  std::size_t structure = 0;
};

/// Gain of a structure on a whitened residual, less what its coefficients cost; nothing projected out.
double meritOf(const Selection& selection, const RowMatrix& raw, const VectorXd& residual) {
  if (raw.cols() == 0) return 0.0;
  const Eigen::MatrixXd white = selection.noiseModel().whiten(selection.noise(), raw);
  Eigen::MatrixXd normal = white.transpose() * white;
  normal.diagonal().array() += 1e-3 * normal.diagonal().mean() + 1e-9;
  const VectorXd right = white.transpose() * residual;
  return right.dot(Eigen::LDLT<Eigen::MatrixXd>(normal).solve(right)) - 6.5 * static_cast<double>(raw.cols());
}

/// The most promising structures for one residual, a few for each component.
void screen(const Selection& selection, const std::vector<SmoothStructure>& all, const VectorXd& residual,
            std::vector<std::size_t>& chosen) {
  std::vector<Screened> screened;
  for (std::size_t s = 0; s < all.size(); ++s) {
    const RowMatrix raw = columnsOf(selection.campaign(), all[s]);
    const double merit = meritOf(selection, raw, residual);
    if (merit > 0.0) screened.push_back({merit, s});
  }
  std::stable_sort(screened.begin(), screened.end(),
                   [](const Screened& a, const Screened& b) { return a.merit > b.merit; });
  std::vector<std::size_t> taken(all.size(), 0);
  for (const Screened& one : screened) {
    if (chosen.size() >= kOffered) return;
    const auto same = std::count_if(chosen.begin(), chosen.end(), [&](std::size_t c) {
      return all[c].placement.component == all[one.structure].placement.component;
    });
    if (static_cast<std::size_t>(same) >= kOfferedEach) continue;
    if (std::find(chosen.begin(), chosen.end(), one.structure) == chosen.end())
      chosen.push_back(one.structure);
  }
}

bool standsAsStructure(const Selection& selection, const Gates& gates, const OptionSet& set,
                       std::size_t option) {
  const Dictionary& dictionary = selection.dictionary();
  if (gates.bestRms(dictionary, set, option) < kLeastRms) return false;
  const HeldOut held_out = gates.heldOut(dictionary, set, option);
  if (held_out.gain <= 0.0 || held_out.gain < kLeastGainToError * held_out.error) return false;
  const double gain = dictionary.sumOfSquares(without(set, option)) - dictionary.sumOfSquares(set);
  const double discounted = gain / gates.clusterInflation(dictionary, set, option);
  return discounted > dictionary.penalty(option);
}

/// The set with the structure, less named effects that carry nothing beside it. The set without it, when
/// those effects alone explain nearly all that it does.
OptionSet competed(const Dictionary& dictionary, const OptionSet& set, std::size_t structure) {
  OptionSet longer = with(set, structure);
  OptionSet fallen;
  for (;;) {
    double least = kMustCarry;
    std::size_t weakest = 0;
    const double score = dictionary.score(longer);
    for (const std::size_t member : longer) {
      if (dictionary.bank().candidateOf(member).generic) continue;
      const double worth = dictionary.score(without(longer, member)) - score;
      if (worth < least) least = worth, weakest = member;
    }
    if (least >= kMustCarry) break;
    longer = without(longer, weakest);
    fallen.push_back(weakest);
  }
  if (fallen.empty()) return longer;
  OptionSet rest = longer;
  rest = without(rest, structure);
  OptionSet named = rest;
  named.insert(named.end(), fallen.begin(), fallen.end());
  const double nothing = dictionary.sumOfSquares(rest);
  const double by_names = nothing - dictionary.sumOfSquares(named);
  const double by_structure = nothing - dictionary.sumOfSquares(longer);
  return by_names >= kNamedEnough * by_structure && fallen.size() == 1 ? set : longer;
}

/// One structure in place of two or more named effects, where that scores clearly better.
OptionSet replacedByOne(const Dictionary& dictionary, const OptionSet& set) {
  constexpr double kClearly = 6.0;
  OptionSet best = set;
  double best_score = dictionary.score(set) - kClearly;
  for (std::size_t option = 0; option < dictionary.size(); ++option) {
    if (!dictionary.bank().candidateOf(option).generic) continue;
    const OptionSet other = competed(dictionary, set, option);
    if (other.size() + 1 > set.size()) continue;
    const double score = dictionary.score(other);
    if (score < best_score) best = other, best_score = score;
  }
  return best;
}

}  // namespace

Leftover findLeftover(Selection& selection) {
  Leftover leftover;
  const Hypotheses::Verdict verdict = selection.hypotheses().judge(selection.dictionary(), selection.set());
  double typical = 0.0;
  for (Index i = 0; i < verdict.residual.size(); ++i) {
    typical = std::max(typical, std::abs(selection.campaign().shown(i, 1.0)));
  }
  const std::vector<SmoothStructure> all = smoothStructures(selection.campaign(), 10.0 * typical);
  std::vector<std::size_t> chosen;
  screen(selection, all, selection.dictionary().whitenedResidual(selection.set()), chosen);
  if (!selection.set().empty()) {
    std::vector<std::size_t> from_scratch;
    screen(selection, all, selection.dictionary().whitenedResidual({}), from_scratch);
    chosen.insert(chosen.end(), from_scratch.begin(), from_scratch.end());
    std::sort(chosen.begin(), chosen.end());
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  }
  OptionBank& bank = selection.library().bank;
  leftover.first_candidate = bank.candidates.size();
  for (const std::size_t s : chosen) {
    leftover.structures.push_back(all[s]);
    Candidate candidate = candidateOf(selection.campaign(), all[s]);
    candidate.extra_penalty = 2.0 * std::log(static_cast<double>(all.size()));
    bank.add(std::move(candidate));
  }
  selection.dictionary().update();
  const Dictionary& dictionary = selection.dictionary();
  const Gates gates = selection.gates();
  OptionSet set = replacedByOne(dictionary, selection.set());
  for (int round = 0; round < kMostStructures; ++round) {
    const VectorXd net = dictionary.netGains(set, Dictionary::Which::Generic);
    bool added = false;
    for (const std::size_t option : bestPerCandidate(dictionary, net, 4)) {
      if (net[static_cast<Index>(option)] <= 0.0) break;
      if (hasCandidateOf(dictionary, set, option)) continue;
      if (!standsAsStructure(selection, gates, with(set, option), option)) continue;
      const OptionSet longer = competed(dictionary, set, option);
      if (longer == set) continue;
      set = longer;
      added = true;
      break;
    }
    if (!added) break;
  }
  selection.setSet(set);
  return leftover;
}

}  // namespace nineline::discovery
