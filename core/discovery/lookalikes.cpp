#include "core/discovery/lookalikes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace nineline::discovery {

namespace {

constexpr std::size_t kSubstitutes = 8;
constexpr double kTemper = 2.0;
constexpr double kShown = 0.05;      // probability from which a look-alike is told
constexpr double kIdentical = 0.98;  // cosine from which columns count as the same
constexpr double kUndecided = 4.0;   // difference of the scores within which nothing is claimed
constexpr double kUndecidedMost = 0.49;

struct Substitute {
  std::size_t option = 0;
  double score = 0.0;
  double probability = 0.0;
};

bool sameName(const NamedEffect& a, const NamedEffect& b) {
  return a.effect.spec->id == b.effect.spec->id && a.effect.placement.joint == b.effect.placement.joint;
}

std::string whyOf(const NamedEffect& own, const NamedEffect& other, double likeness) {
  for (const errors::LookAlike& like : own.effect.spec->lookalikes) {
    if (like.id == other.effect.spec->id) return std::string(like.separated_by);
  }
  for (const errors::LookAlike& like : other.effect.spec->lookalikes) {
    if (like.id == own.effect.spec->id) return std::string(like.separated_by);
  }
  return likeness >= kIdentical
             ? "identical on these data"
             : fmt::format("their readings agree to {:.0f} % on these data", 100.0 * likeness);
}

/// An effect with more coefficients that contains the member is that member with a part that is not there.
bool isRicher(const Dictionary& dictionary, std::size_t member, std::size_t other) {
  constexpr double kContained = 0.995;
  return dictionary.whitenedColumns(other).cols() > dictionary.whitenedColumns(member).cols() &&
         dictionary.likeness(member, other) > kContained;
}

std::vector<Substitute> substitutesOf(Selection& selection, const Hypotheses& hypotheses,
                                      std::size_t member) {
  constexpr double kFar = 60.0;
  constexpr double kFarShare = 0.5;  // of the member's own gain: finer parameters may still catch up
  Dictionary& dictionary = selection.dictionary();
  const OptionSet rest = without(selection.set(), member);
  const VectorXd net = dictionary.netGains(rest);
  const double own = net[static_cast<Index>(member)];
  std::vector<Substitute> found{{member, hypotheses.score(dictionary, selection.set()), 0.0}};
  for (const std::size_t option : bestPerCandidate(dictionary, net, kSubstitutes + 1)) {
    if (net[static_cast<Index>(option)] < own - std::max(kFar, kFarShare * own)) break;
    if (hasCandidateOf(dictionary, selection.set(), option)) continue;
    OptionSet other = with(rest, option);
    other = refine(dictionary, other);
    if (!dictionary.isPlausible(other)) continue;
    if (isRicher(dictionary, member, other.back())) continue;
    found.push_back({other.back(), hypotheses.score(dictionary, other), 0.0});
  }
  return found;
}

}  // namespace

NameJudgement judgeName(Selection& selection, std::size_t member) {
  const Hypotheses hypotheses = selection.hypotheses();
  const EffectLibrary& library = selection.library();
  std::vector<Substitute> all = substitutesOf(selection, hypotheses, member);
  const double own_score = all.front().score;
  NameJudgement judgement;
  judgement.evidence = hypotheses.score(selection.dictionary(), without(selection.set(), member)) - own_score;
  double best = own_score, sum = 0.0;
  for (const Substitute& one : all) best = std::min(best, one.score);
  for (Substitute& one : all) {
    one.probability = std::exp(-0.5 * (one.score - best) / kTemper);
    sum += one.probability;
  }
  const NamedEffect& own = library.named[library.bank.options[member].candidate];
  double closest = std::numeric_limits<double>::infinity();
  for (const Substitute& one : all) {
    const double probability = one.probability / sum;
    const NamedEffect& other = library.named[library.bank.options[one.option].candidate];
    if (sameName(own, other)) {
      judgement.confidence += probability;
      continue;
    }
    const double likeness = selection.dictionary().likeness(member, one.option);
    if (probability >= kShown) closest = std::min(closest, one.score - own_score);
    if (probability < kShown) continue;
    const kinematics::Joint& joint =
        selection.campaign().model().machine().joint(other.effect.placement.joint);
    judgement.lookalikes.push_back({std::string(other.effect.spec->id), joint.axis.text(),
                                    other.effect.placement.component.text(), whyOf(own, other, likeness),
                                    probability, likeness});
  }
  judgement.confidence *= 1.0 - std::exp(-0.5 * std::max(judgement.evidence, 0.0) / kTemper);
  if (closest < kUndecided) judgement.confidence = std::min(judgement.confidence, kUndecidedMost);
  std::sort(judgement.lookalikes.begin(), judgement.lookalikes.end(),
            [](const LookAlikeFound& a, const LookAlikeFound& b) { return a.probability > b.probability; });
  return judgement;
}

}  // namespace nineline::discovery
