#include "core/discovery/campaign.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace nineline::discovery {

namespace {

using measurement::ReadingRow;

constexpr double kLeastSigma = 1e-9;    // mm, rad
constexpr double kUnknownSigma = 1e-4;  // where nothing repeats

std::string groupName(const Measurement& file, std::size_t channel) {
  const measurement::Instrument& instrument = file.instrument;
  std::string name(measurement::nameOf(instrument.kind));
  if (instrument.axis) name += " " + instrument.axis->text();
  if (instrument.kind == measurement::InstrumentKind::LaserStraightness ||
      instrument.kind == measurement::InstrumentKind::Dial) {
    name += fmt::format(" {}", "XYZ"[instrument.sensitive]);
  }
  if (instrument.kind == measurement::InstrumentKind::LaserAngular) {
    name += fmt::format(" {}", "XYZ"[instrument.about]);
  }
  return file.channels[channel].isAngular() ? name + " angle" : name;
}

/// The run of every sample: index of its span.
std::vector<int> spanOfSample(const Measurement& file) {
  std::vector<int> span(file.samples.size(), 0);
  int index = 0;
  for (const measurement::RunSpan& run : measurement::runsOf(file)) {
    for (std::size_t i = run.first; i < run.last; ++i) span[i] = index;
    ++index;
  }
  return span;
}

}  // namespace

Result<Campaign> Campaign::make(const ErrorModel& model, const std::vector<Measurement>& measurements,
                                const Use& use) {
  Campaign campaign(model);
  for (const Measurement& measurement : measurements) {
    if (Result<void> added = campaign.addFile(measurement); !added) return added.error();
  }
  campaign.estimateSigmas();
  campaign.collectReadings(use);
  if (campaign.readings_.size() < 8) {
    return badInput("discover.few", fmt::format("{} readings are too few to judge a model by; 8 at least",
                                                campaign.readings_.size()));
  }
  campaign.collectRuns();
  return campaign;
}

Result<void> Campaign::addFile(const Measurement& measurement) {
  if (Result<void> fits = measurement::requireInstrument(model_.machine(), measurement); !fits) return fits;
  Measurement filled = withFilledConditions(measurement);
  const Result<measurement::Prediction> prediction = measurement::predict(model_, filled);
  if (!prediction) return prediction.error();
  std::vector<errors::MachineState> states = measurement::statesOf(filled, model_.machine());
  measurement::ReadingGradients gradients = measurement::gradientsOf(model_, filled, states);
  std::vector<bool> complete(prediction->rows.size());
  for (std::size_t r = 0; r < complete.size(); ++r) complete[r] = prediction->is_complete[r] != 0;
  files_.push_back({std::move(filled),
                    std::move(states),
                    prediction->rows,
                    std::move(gradients),
                    prediction->readings,
                    std::move(complete),
                    {}});
  files_.back().reading_of_row.assign(files_.back().rows.size(), -1);
  return {};
}

void Campaign::estimateSigmas() {
  std::map<std::string, std::vector<double>> by_group;
  for (CampaignFile& file : files_) {
    const std::size_t channels = file.measurement.channels.size();
    estimates_.emplace_back(channels, 0.0);
    Measurement residuals = file.measurement;
    std::vector<bool> unstated(channels, false);
    for (std::size_t r = 0; r < file.rows.size(); ++r) {
      const ReadingRow& row = file.rows[r];
      if (!row.value) continue;
      unstated[row.channel] = unstated[row.channel] || !row.sigma;
      residuals.readings[row.sample * channels + row.channel] =
          *row.value - file.predicted[static_cast<Index>(r)];
    }
    for (std::size_t channel = 0; channel < channels; ++channel) {
      if (!unstated[channel]) continue;
      estimated_ = true;
      const double found = repeatabilityFromRepeats(residuals, file.states, channel).value_or(kUnknownSigma);
      estimates_.back()[channel] = found;
      by_group[groupName(file.measurement, channel)].push_back(found);
    }
  }
  // One instrument has one repeatability: the middle of what its files say.
  for (std::size_t f = 0; f < files_.size(); ++f) {
    for (std::size_t channel = 0; channel < estimates_[f].size(); ++channel) {
      if (estimates_[f][channel] == 0.0) continue;
      std::vector<double>& all = by_group[groupName(files_[f].measurement, channel)];
      const auto middle = all.begin() + static_cast<std::ptrdiff_t>((all.size() - 1) / 2);
      std::nth_element(all.begin(), middle, all.end());
      estimates_[f][channel] = *middle;
    }
  }
}

void Campaign::collectReadings(const Use& use) {
  std::vector<double> residual;
  for (std::size_t f = 0; f < files_.size(); ++f) {
    CampaignFile& file = files_[f];
    for (std::size_t channel = 0; channel < file.measurement.channels.size(); ++channel) {
      for (std::size_t r = 0; r < file.rows.size(); ++r) {
        const ReadingRow& row = file.rows[r];
        if (row.channel != channel || !row.value || !file.complete[r] || !use(f, row.sample)) continue;
        const double sigma = std::max(row.sigma.value_or(estimates_[f][channel]), kLeastSigma);
        file.reading_of_row[r] = static_cast<Index>(readings_.size());
        readings_.push_back({f, r, row.sample, channel, sigma});
        residual.push_back((*row.value - file.predicted[static_cast<Index>(r)]) / sigma);
      }
    }
  }
  residual_ = Eigen::Map<const VectorXd>(residual.data(), static_cast<Index>(residual.size()));
}

void Campaign::collectRuns() {
  layout_.place.resize(static_cast<Index>(readings_.size()));
  std::vector<std::vector<int>> spans;
  for (const CampaignFile& file : files_) spans.push_back(spanOfSample(file.measurement));
  for (std::size_t i = 0; i < readings_.size(); ++i) {
    const Reading& at = readings_[i];
    const bool same_run = i > 0 && readings_[i - 1].file == at.file &&
                          readings_[i - 1].channel == at.channel &&
                          spans[at.file][readings_[i - 1].sample] == spans[at.file][at.sample];
    if (same_run) {
      ++layout_.runs.back().count;
      continue;
    }
    const std::string name = groupName(files_[at.file].measurement, at.channel);
    auto group = std::find(group_names_.begin(), group_names_.end(), name);
    if (group == group_names_.end()) group = group_names_.insert(group_names_.end(), name);
    layout_.runs.push_back({static_cast<int>(group - group_names_.begin()), static_cast<Index>(i), 1});
  }
  layout_.groups = static_cast<int>(group_names_.size());
  for (const NoiseRun& run : layout_.runs) addPlaces(run);
}

void Campaign::addPlaces(const NoiseRun& run) {
  std::vector<double> times;
  for (Index i = 0; i < run.count; ++i) {
    const std::optional<double> time = stateOf(run.first + i).time;
    if (time) times.push_back(*time);
  }
  std::vector<double> steps;
  for (std::size_t i = 1; i < times.size(); ++i) steps.push_back(times[i] - times[i - 1]);
  double typical = 0.0;
  if (!steps.empty() && times.size() == static_cast<std::size_t>(run.count)) {
    std::nth_element(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2),
                     steps.end());
    typical = steps[steps.size() / 2];
  }
  for (Index i = 0; i < run.count; ++i) {
    const bool timed = typical > 0.0;
    layout_.place[run.first + i] =
        timed ? (times[static_cast<std::size_t>(i)] - times[0]) / typical : static_cast<double>(i);
  }
}

std::optional<int> Campaign::groupOf(std::size_t file, std::size_t channel) const {
  const auto found =
      std::find(group_names_.begin(), group_names_.end(), groupName(files_[file].measurement, channel));
  if (found == group_names_.end()) return std::nullopt;
  return static_cast<int>(found - group_names_.begin());
}

RowMatrix Campaign::zeroColumns() const {
  std::vector<std::pair<std::size_t, std::size_t>> zeros;  // file, channel
  std::vector<Index> column(readings_.size(), -1);
  for (std::size_t i = 0; i < readings_.size(); ++i) {
    const Reading& reading = readings_[i];
    if (!files_[reading.file].measurement.instrument.hasZero()) continue;
    const std::pair key(reading.file, reading.channel);
    if (zeros.empty() || zeros.back() != key) zeros.push_back(key);
    column[i] = static_cast<Index>(zeros.size()) - 1;
  }
  RowMatrix columns = RowMatrix::Zero(static_cast<Index>(readings_.size()), static_cast<Index>(zeros.size()));
  for (std::size_t i = 0; i < readings_.size(); ++i) {
    if (column[i] >= 0) columns(static_cast<Index>(i), column[i]) = mmFromUm(1.0) / readings_[i].sigma;
  }
  return columns;
}

VectorXd Campaign::column(const std::function<VectorXd(const CampaignFile&)>& by_rows) const {
  VectorXd result(static_cast<Index>(readings_.size()));
  for (const CampaignFile& file : files_) {
    const VectorXd values = by_rows(file);
    for (std::size_t r = 0; r < file.rows.size(); ++r) {
      const Index at = file.reading_of_row[r];
      if (at >= 0) result[at] = values[static_cast<Index>(r)] / readings_[static_cast<std::size_t>(at)].sigma;
    }
  }
  return result;
}

VectorXd Campaign::effectColumn(const errors::EffectPtr& effect) const {
  return column([&](const CampaignFile& file) {
    return measurement::effectColumn(model_, effect, file.measurement, file.states, file.gradients);
  });
}

const errors::MachineState& Campaign::stateOf(Index reading) const {
  const Reading& at = readings_[static_cast<std::size_t>(reading)];
  return files_[at.file].states[at.sample];
}

bool Campaign::isAngular(Index reading) const {
  const Reading& at = readings_[static_cast<std::size_t>(reading)];
  return files_[at.file].measurement.channels[at.channel].isAngular();
}

double Campaign::shown(Index reading, double in_sigma) const {
  const double value = in_sigma * readings_[static_cast<std::size_t>(reading)].sigma;
  return isAngular(reading) ? arcsecFromRad(value) : umFromMm(value);
}

}  // namespace nineline::discovery
