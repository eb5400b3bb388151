#include "core/identification/knot_search.h"

#include <algorithm>
#include <cmath>

namespace nineline::identification {

using estimation::Linearisation;
using estimation::ReadingSet;

namespace {

/// The columns of the told parameters, and their priors.
struct Selected {
  Eigen::SparseMatrix<double> map;
  MatrixXd prior;
};

void collectSelection(KnotSearch& search) {
  search.selection.clear();
  for (std::size_t c = 0; c < search.tellings.size(); ++c) {
    if (!search.tellings[c].told) continue;
    const std::vector<Index>& chunk = search.parameters.chunks[c].parameters;
    search.selection.insert(search.selection.end(), chunk.begin(), chunk.end());
  }
}

Selected selectedOf(const KnotSearch& search) {
  const auto count = static_cast<Index>(search.selection.size());
  Selected selected{{}, MatrixXd::Zero(count, count)};
  std::vector<Eigen::Triplet<double>> entries;
  for (Index k = 0; k < count; ++k) {
    const Index parameter = search.selection[static_cast<std::size_t>(k)];
    for (Eigen::SparseMatrix<double>::InnerIterator it(search.parameters.map, parameter); it; ++it) {
      entries.emplace_back(static_cast<int>(it.row()), static_cast<int>(k), it.value());
    }
  }
  selected.map.resize(search.parameters.map.rows(), count);
  selected.map.setFromTriplets(entries.begin(), entries.end());
  Index at = 0;
  for (std::size_t c = 0; c < search.tellings.size(); ++c) {
    if (!search.tellings[c].told) continue;
    const estimation::ParameterChunk& chunk = search.parameters.chunks[c];
    const auto size = static_cast<Index>(chunk.parameters.size());
    if (chunk.prior.size() > 0) selected.prior.block(at, at, size, size) = chunk.prior;
    at += size;
  }
  return selected;
}

Result<void> fitSelected(Linearisation& linearisation, const IdentificationOptions& options,
                         KnotSearch& search, Progress& progress) {
  collectSelection(search);
  const Selected selected = selectedOf(search);
  search.map = selected.map;
  estimation::FitOptions fit_options;
  fit_options.robust = options.robust;
  Result<estimation::Fit> fit =
      estimation::fit(linearisation, search.map, selected.prior, fit_options, progress);
  if (!fit) return fit.error();
  search.fit = std::move(*fit);
  return {};
}

/// Drops plays that are not significant; true when there was one.
bool dropPlays(const IdentificationOptions& options, KnotSearch& search) {
  bool dropped = false;
  for (std::size_t c = 0; c < search.tellings.size(); ++c) {
    if (!search.tellings[c].told || search.parameters.names[c].part != Part::Play) continue;
    const Index parameter = search.parameters.chunks[c].parameters.front();
    const auto at = std::find(search.selection.begin(), search.selection.end(), parameter);
    const Index k = at - search.selection.begin();
    const double sigma = std::sqrt(search.fit.covariance(k, k));
    if (std::abs(search.fit.parameters[k]) >= options.play_significance * sigma) continue;
    search.tellings[c].told = false;
    dropped = true;
  }
  return dropped;
}

bool isStated(const Measurement& file) {
  if (file.repeatability || file.angular_repeatability) return true;
  return std::any_of(file.samples.begin(), file.samples.end(), [](const measurement::Sample& sample) {
    return sample.sigma.has_value() || sample.angular_sigma.has_value();
  });
}

/// Gives files without a stated repeatability their own; true when there was one.
bool adaptFiles(const KnotSearch& search, ReadingSet& readings) {
  const std::vector<double>& factors = search.fit.file_factors;
  bool changed = false;
  for (std::size_t file = 0; file < factors.size(); ++file) {
    if (isStated(readings.files()[file]) || factors[file] == 1.0) continue;
    readings.rescale(file, factors[file]);
    changed = true;
  }
  return changed;
}

Result<KnotSearch> fitAt(const ReadingSet& readings, const IdentificationOptions& options,
                         const std::vector<int>& levels, Progress& progress) {
  KnotSearch search;
  search.knot_levels = levels;
  search.parameters =
      makeParameters(readings, {levels, options.knot_spacings, options.play, options.lateral_play});
  Linearisation linearisation(search.parameters.unknowns, readings);
  const VectorXd start = VectorXd::Zero(search.parameters.unknowns.size());
  if (Result<void> done = linearisation.at(start, true, progress); !done) return done.error();
  const VectorXd weights = VectorXd::Ones(static_cast<Index>(readings.rows()));
  const estimation::NormalSums sums =
      estimation::normalSums(linearisation, weights).reduced(search.parameters.map);
  search.information = estimation::information(readings, sums, estimation::usualNoise(readings));
  search.tellings =
      estimation::tellApart(search.information, search.parameters.plausible, search.parameters.chunks);
  if (Result<void> done = fitSelected(linearisation, options, search, progress); !done) return done.error();
  if (dropPlays(options, search)) {
    if (Result<void> done = fitSelected(linearisation, options, search, progress); !done) return done.error();
  }
  return search;
}

/// Bayesian information criterion of a fit: n log of the noise variances plus log n for each parameter.
double criterionOf(const ReadingSet& readings, const KnotSearch& search) {
  std::vector<double> square(readings.classes().size(), 0.0);
  std::vector<double> count(readings.classes().size(), 0.0);
  for (std::size_t row = 0; row < readings.rows(); ++row) {
    const double rest = search.fit.rest[static_cast<Index>(row)] / readings.readings()[row].sigma;
    const std::size_t noise = readings.noiseOf(row);
    // An outlier counts as much at every level, however many of them a level makes.
    const double size = std::min(std::abs(rest), 4.0 * search.fit.noise.scale[noise]);
    square[noise] += size * size;
    count[noise] += 1.0;
  }
  double criterion = 0.0;
  double readings_count = 0.0;
  for (std::size_t c = 0; c < square.size(); ++c) {
    if (count[c] <= 0.0) continue;
    criterion += count[c] * std::log(std::max(square[c] / count[c], 1e-16));
    readings_count += count[c];
  }
  return criterion + static_cast<double>(search.selection.size()) * std::log(readings_count);
}

/// Joints whose tables have a free number of values.
std::vector<int> freeJoints(const ReadingSet& readings, const IdentificationOptions& options) {
  std::vector<int> joints;
  for (int joint = 0; joint < readings.machine().jointCount(); ++joint) {
    const auto j = static_cast<std::size_t>(joint);
    const bool given = j < options.knot_spacings.size() && options.knot_spacings[j];
    const std::optional<Knots> knots = chooseKnots(readings, joint, 0);
    if (knots && !knots->at_targets && !given) joints.push_back(joint);
  }
  return joints;
}

class Search {
 public:
  Search(ReadingSet& readings, const IdentificationOptions& options, Progress& progress)
      : readings_(readings), options_(options), progress_(progress) {}

  Result<KnotSearch> run() {
    const std::vector<int> joints = freeJoints(readings_, options_);
    std::vector<int> levels(static_cast<std::size_t>(readings_.machine().jointCount()), 0);
    if (Result<bool> done = tryAt(levels); !done) return done.error();
    if (joints.empty()) return withOwnScales();
    for (int level = 1; level < kKnotLevels; ++level) {  // all together first
      for (const int joint : joints) levels[static_cast<std::size_t>(joint)] = level;
      const Result<bool> better = tryAt(levels);
      if (!better) return better.error();
      if (!*better && level > best_level_ + 1) break;
      if (*better) best_level_ = level;
    }
    for (const int joint : joints) {  // then each joint by itself
      for (const int change : {1, -1}) {
        while (true) {
          levels = best_->knot_levels;
          int& level = levels[static_cast<std::size_t>(joint)];
          level += change;
          if (joints.size() == 1 || level < 0 || level >= kKnotLevels) break;
          const Result<bool> better = tryAt(levels);
          if (!better) return better.error();
          if (!*better) break;
        }
      }
    }
    return withOwnScales();
  }

 private:
  /// The best fit once more, each file with the noise that it shows.
  Result<KnotSearch> withOwnScales() {
    if (!adaptFiles(*best_, readings_)) return std::move(*best_);
    return fitAt(readings_, options_, best_->knot_levels, progress_);
  }
  Result<bool> tryAt(const std::vector<int>& levels) {
    progress_.report(std::min(0.8, 0.05 + 0.05 * tried_++), "Identify");
    if (progress_.isCancelled()) return cancelled();
    Result<KnotSearch> search = fitAt(readings_, options_, levels, progress_);
    if (!search) {
      if (!best_) return search.error();
      return false;
    }
    const double criterion = criterionOf(readings_, *search);
    if (best_ && criterion >= best_criterion_) return false;
    best_ = std::move(*search);
    best_criterion_ = criterion;
    return true;
  }
  ReadingSet& readings_;
  const IdentificationOptions& options_;
  Progress& progress_;
  std::optional<KnotSearch> best_;
  double best_criterion_ = 0.0;
  int best_level_ = 0;
  int tried_ = 0;
};

}  // namespace

Result<KnotSearch> searchKnots(ReadingSet& readings, const IdentificationOptions& options,
                               Progress& progress) {
  return Search(readings, options, progress).run();
}

}  // namespace nineline::identification
