#pragma once

#include <functional>
#include <memory>

#include "core/discovery/dictionary.h"
#include "core/measurement/reading_gradients.h"

namespace nineline::discovery {

using errors::ErrorModel;
using measurement::Measurement;

/// A file as the search sees it.
struct CampaignFile {
  Measurement measurement;  ///< single empty cells of conditions filled from their neighbours in time
  std::vector<errors::MachineState> states;
  std::vector<measurement::ReadingRow> rows;
  measurement::ReadingGradients gradients;
  VectorXd predicted;                 ///< by row, by the present model, without the zero
  std::vector<bool> complete;         ///< by row: the present model knew all its conditions there
  std::vector<Index> reading_of_row;  ///< index among the campaign's readings, −1: not used
};

/// One reading that takes part.
struct Reading {
  std::size_t file = 0;
  std::size_t row = 0;
  std::size_t sample = 0;
  std::size_t channel = 0;
  double sigma = 1.0;  ///< mm, rad
};

/// Measurements against the present model, sorted by file, channel and run: residuals in units of each
/// reading's repeatability.
class Campaign {
 public:
  /// Leaves a sample out: file, sample.
  using Use = std::function<bool(std::size_t, std::size_t)>;
  [[nodiscard]] static Result<Campaign> make(const ErrorModel& model,
                                             const std::vector<Measurement>& measurements, const Use& use);

  [[nodiscard]] const ErrorModel& model() const { return model_; }
  [[nodiscard]] const std::vector<CampaignFile>& files() const { return files_; }
  [[nodiscard]] const std::vector<Reading>& readings() const { return readings_; }
  [[nodiscard]] const VectorXd& residual() const { return residual_; }
  [[nodiscard]] const NoiseLayout& layout() const { return layout_; }
  /// Repeatability of a channel that states none, from its repeats; 0 where it states one. mm, rad.
  [[nodiscard]] double estimatedSigma(std::size_t file, std::size_t channel) const {
    return estimates_[file][channel];
  }
  /// True where the level of noise had to be estimated from repeats.
  [[nodiscard]] bool isEstimated() const { return estimated_; }
  /// Name of each group of the layout: "laser-linear Z".
  [[nodiscard]] const std::vector<std::string>& groupNames() const { return group_names_; }
  /// Group of the layout that a channel belongs to; absent where no reading of its kind takes part.
  [[nodiscard]] std::optional<int> groupOf(std::size_t file, std::size_t channel) const;
  /// Free columns for the zeros of files, in units of the repeatability.
  [[nodiscard]] RowMatrix zeroColumns() const;

  /// Column of what a caller computes by file and row (mm, rad), in units of the repeatability.
  [[nodiscard]] VectorXd column(const std::function<VectorXd(const CampaignFile&)>& by_rows) const;
  [[nodiscard]] VectorXd effectColumn(const errors::EffectPtr& effect) const;
  /// State of a reading's sample.
  [[nodiscard]] const errors::MachineState& stateOf(Index reading) const;
  [[nodiscard]] bool isAngular(Index reading) const;
  /// Value in µm (lengths) or arcsec (angles) of a quantity in repeatabilities.
  [[nodiscard]] double shown(Index reading, double in_sigma) const;

 private:
  explicit Campaign(ErrorModel model) : model_(std::move(model)) {}
  [[nodiscard]] Result<void> addFile(const Measurement& measurement);
  void estimateSigmas();
  void collectReadings(const Use& use);
  void collectRuns();
  void addPlaces(const NoiseRun& run);

  ErrorModel model_;
  std::vector<CampaignFile> files_;
  std::vector<Reading> readings_;
  VectorXd residual_;
  NoiseLayout layout_;
  std::vector<std::string> group_names_;
  bool estimated_ = false;
  std::vector<std::vector<double>> estimates_;  // by file, channel
};

/// Standard deviation of a channel from repeats: readings at equal positions and approach in several runs;
/// without any, from second differences along each run. mm or rad; absent where neither is possible.
[[nodiscard]] std::optional<double> repeatabilityFromRepeats(const Measurement& measurement,
                                                             const std::vector<errors::MachineState>& states,
                                                             std::size_t channel);

/// Fills single empty cells of conditions between known ones of the same file, in proportion to time (to the
/// row without `t_s`).
[[nodiscard]] Measurement withFilledConditions(Measurement measurement);

}  // namespace nineline::discovery
