#include "core/discovery/search.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace nineline::discovery {

namespace {

constexpr double kGolden = 0.6180339887498949;
constexpr int kGoldenSteps = 15;
constexpr double kNoise = 1e-6;  // falls of the score below this are rounding

struct State {
  double score = 0.0;
  OptionSet set;
};

/// Best value of one non-linear parameter of a candidate within its step, the others held.
double bestAlong(const Dictionary& dictionary, const Dictionary::Profile& profile, const Option& option,
                 std::vector<double> shape, std::size_t parameter) {
  const Candidate& candidate = dictionary.bank().candidates[option.candidate];
  const Nonlinear& range = candidate.nonlinear[parameter];
  double low = std::max(range.low, shape[parameter] - option.step[parameter]);
  double high = std::min(range.high, shape[parameter] + option.step[parameter]);
  const double start = shape[parameter];
  const auto gain = [&](double value) {
    shape[parameter] = value;
    return dictionary.gainAt(profile, shape);
  };
  const double start_gain = gain(start);
  double a = high - kGolden * (high - low), b = low + kGolden * (high - low);
  double gain_a = gain(a), gain_b = gain(b);
  for (int i = 0; i < kGoldenSteps; ++i) {
    if (gain_a > gain_b) {
      high = b, b = a, gain_b = gain_a;
      a = high - kGolden * (high - low);
      gain_a = gain(a);
    } else {
      low = a, a = b, gain_a = gain_b;
      b = low + kGolden * (high - low);
      gain_b = gain(b);
    }
  }
  const double found = gain_a > gain_b ? a : b;
  return std::max(gain_a, gain_b) > start_gain + kNoise ? found : start;
}

std::size_t refineOption(Dictionary& dictionary, const OptionSet& rest, std::size_t option) {
  const Option original = dictionary.bank().options[option];
  const Candidate& candidate = dictionary.bank().candidates[original.candidate];
  const Dictionary::Profile profile = dictionary.profile(rest, option);
  std::vector<double> shape = original.shape;
  bool moved = false;
  const int rounds = candidate.nonlinear.size() > 1 ? 2 : 1;
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t p = 0; p < shape.size(); ++p) {
      if (original.step[p] <= 0.0) continue;
      const double value = bestAlong(dictionary, profile, original, shape, p);
      moved = moved || value != shape[p];
      shape[p] = value;
    }
  }
  if (!moved) return option;
  return dictionary.append(option, std::move(shape), original.step);
}

bool isNonlinear(const Dictionary& dictionary, std::size_t option) {
  const std::vector<double>& step = dictionary.bank().options[option].step;
  return std::any_of(step.begin(), step.end(), [](double s) { return s > 0.0; });
}

std::set<std::size_t> keyOf(const OptionSet& set) { return {set.begin(), set.end()}; }

/// One member less as long as the score does not rise by more than the margin.
bool dropWorst(const Dictionary& dictionary, OptionSet& set, double& score, double margin) {
  bool changed = false;
  while (!set.empty()) {
    double best = std::numeric_limits<double>::infinity();
    std::size_t worst = 0;
    for (const std::size_t member : set) {
      const double value = dictionary.score(without(set, member));
      if (value < best) best = value, worst = member;
    }
    if (best > score + margin) return changed;
    set = without(set, worst);
    score = best;
    changed = true;
  }
  return changed;
}

/// Puts the best of the few best options beside `rest`, when that scores below `score`.
bool takeBest(Dictionary& dictionary, const OptionSet& rest, const SearchOptions& options, std::size_t tries,
              double margin, OptionSet& set, double& score) {
  constexpr double kRefinement = 15.0;  // what finer non-linear parameters may add
  const VectorXd net = dictionary.netGains(rest, options.which);
  const double rest_score = dictionary.score(rest);
  for (const std::size_t option : bestPerCandidate(dictionary, net, tries)) {
    const double coarse = rest_score - net[static_cast<Index>(option)];
    if (coarse >= score - margin + kRefinement + 0.1 * net[static_cast<Index>(option)]) break;
    if (hasCandidateOf(dictionary, rest, option)) continue;
    OptionSet longer = with(rest, option);
    if (isNonlinear(dictionary, option)) longer.back() = refineOption(dictionary, rest, option);
    const double value = dictionary.score(longer);
    if (value >= score - margin - kNoise || !dictionary.isPlausible(longer)) continue;
    set = longer;
    score = value;
    return true;
  }
  return false;
}

bool swapOne(Dictionary& dictionary, OptionSet& set, double& score, const SearchOptions& options) {
  bool changed = false;
  for (const std::size_t member : OptionSet(set)) {
    if (dictionary.bank().candidateOf(member).generic != (options.which == Dictionary::Which::Generic) &&
        options.which != Dictionary::Which::Both) {
      continue;
    }
    const OptionSet rest = without(set, member);
    changed = takeBest(dictionary, rest, options, 3, 0.0, set, score) || changed;
  }
  return changed;
}

bool replaceTwo(Dictionary& dictionary, OptionSet& set, double& score, const SearchOptions& options) {
  for (std::size_t a = 0; a < set.size(); ++a) {
    for (std::size_t b = a + 1; b < set.size(); ++b) {
      const OptionSet rest = without(without(set, set[a]), set[b]);
      if (takeBest(dictionary, rest, options, 3, options.margin, set, score)) return true;
    }
  }
  return false;
}

}  // namespace

OptionSet without(const OptionSet& set, std::size_t option) {
  OptionSet rest;
  for (const std::size_t member : set) {
    if (member != option) rest.push_back(member);
  }
  return rest;
}

OptionSet with(const OptionSet& set, std::size_t option) {
  OptionSet longer = set;
  longer.push_back(option);
  return longer;
}

bool hasCandidateOf(const Dictionary& dictionary, const OptionSet& set, std::size_t option) {
  const std::vector<Option>& options = dictionary.bank().options;
  return std::any_of(set.begin(), set.end(), [&](std::size_t member) {
    return options[member].candidate == options[option].candidate;
  });
}

std::vector<std::size_t> bestPerCandidate(const Dictionary& dictionary, const VectorXd& value,
                                          std::size_t most) {
  std::vector<std::size_t> order(static_cast<std::size_t>(value.size()));
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return value[static_cast<Index>(a)] > value[static_cast<Index>(b)];
  });
  std::vector<std::size_t> best;
  std::set<std::size_t> seen;
  for (const std::size_t option : order) {
    if (best.size() >= most || !std::isfinite(value[static_cast<Index>(option)])) break;
    if (seen.insert(dictionary.bank().options[option].candidate).second) best.push_back(option);
  }
  return best;
}

OptionSet refine(Dictionary& dictionary, OptionSet set, int rounds) {
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < set.size(); ++i) {
      if (isNonlinear(dictionary, set[i])) {
        set[i] = refineOption(dictionary, without(set, set[i]), set[i]);
      }
    }
  }
  return set;
}

OptionSet search(Dictionary& dictionary, const SearchOptions& options) {
  State best{dictionary.score({}), {}};
  std::vector<State> beam{best};
  std::set<std::set<std::size_t>> seen;
  for (std::size_t depth = 0; depth < options.depth; ++depth) {
    std::vector<State> next;
    for (const State& state : beam) {
      const VectorXd net = dictionary.netGains(state.set, options.which);
      for (const std::size_t option : bestPerCandidate(dictionary, net, options.branch)) {
        if (net[static_cast<Index>(option)] <= options.margin - 15.0) break;
        if (hasCandidateOf(dictionary, state.set, option)) continue;
        const OptionSet longer = with(state.set, option);
        if (!seen.insert(keyOf(longer)).second) continue;
        const double score = dictionary.score(longer);
        if (score >= state.score - options.margin || !dictionary.isPlausible(longer)) continue;
        next.push_back({score, longer});
      }
    }
    if (next.empty()) break;
    std::stable_sort(next.begin(), next.end(),
                     [](const State& a, const State& b) { return a.score < b.score; });
    if (next.size() > options.width) next.resize(options.width);
    for (State& state : next) {
      const std::size_t newest = state.set.back();
      if (!isNonlinear(dictionary, newest)) continue;
      state.set.back() = refineOption(dictionary, without(state.set, newest), newest);
      state.score = dictionary.score(state.set);
    }
    beam = std::move(next);
    if (beam[0].score < best.score) best = beam[0];
  }
  return polish(dictionary, refine(dictionary, best.set, 2), options);
}

OptionSet polish(Dictionary& dictionary, OptionSet set, const SearchOptions& options) {
  constexpr int kMostRounds = 6;
  double score = dictionary.score(set);
  for (int round = 0; round < kMostRounds; ++round) {
    bool changed = dropWorst(dictionary, set, score, options.margin);
    changed = swapOne(dictionary, set, score, options) || changed;
    changed = replaceTwo(dictionary, set, score, options) || changed;
    changed = takeBest(dictionary, OptionSet(set), options, 5, options.margin, set, score) || changed;
    if (!changed) break;
    set = refine(dictionary, std::move(set));
    score = dictionary.score(set);
  }
  return set;
}

}  // namespace nineline::discovery
