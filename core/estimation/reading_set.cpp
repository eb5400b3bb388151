#include "core/estimation/reading_set.h"

#include <algorithm>

#include "core/base/units.h"
#include "core/measurement/prediction.h"

namespace nineline::estimation {

using measurement::ReadingRow;

Result<ReadingSet> ReadingSet::make(const Machine& machine, std::span<const Measurement> files) {
  ReadingSet set;
  set.machine_ = &machine;
  set.files_ = files;
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (Result<void> fits = measurement::requireInstrument(machine, files[i]); !fits) return fits.error();
    set.states_.push_back(measurement::statesOf(files[i], machine));
    set.functions_.emplace_back(machine, files[i].instrument, files[i].channels);
    set.addFile(i);
  }
  return set;
}

void ReadingSet::rescale(std::size_t file, double factor) {
  for (ReadingPlace& reading : readings_) {
    if (groups_[reading.group].file == file) reading.sigma *= factor;
  }
}

std::size_t ReadingSet::groupOf(const RunGroup& group) {
  for (std::size_t g = groups_.size(); g-- > 0 && groups_[g].file == group.file;) {
    if (groups_[g].channel == group.channel && groups_[g].run == group.run) return g;
  }
  groups_.push_back(group);
  return groups_.size() - 1;
}

void ReadingSet::addFile(std::size_t file) {
  const Measurement& measurement = files_[file];
  const std::size_t channels = measurement.channels.size();
  const int first_zero = zeros_;
  if (measurement.instrument.hasZero()) zeros_ += static_cast<int>(channels);
  for (const ReadingRow& row : measurement::rowsOf(measurement)) {
    if (!row.value) continue;
    const bool angular = measurement.channels[row.channel].isAngular();
    const NoiseClass noise{measurement.instrument.kind, angular, row.sigma.has_value()};
    auto known = std::find(classes_.begin(), classes_.end(), noise);
    if (known == classes_.end()) known = classes_.insert(classes_.end(), noise);
    RunGroup group{file, row.channel, static_cast<std::size_t>(known - classes_.begin()), -1,
                   measurement.run(row.sample)};
    if (measurement.instrument.hasZero()) group.zero = first_zero + static_cast<int>(row.channel);
    if (samples_.empty() || samples_.back().file != file || samples_.back().index != row.sample) {
      samples_.push_back({file, row.sample, readings_.size(), readings_.size()});
    }
    const double unit = angular ? radFromArcsec(1.0) : mmFromUm(1.0);
    const double sigma = row.sigma && *row.sigma > 0.0 ? *row.sigma : unit;
    readings_.push_back({samples_.size() - 1, row.channel, groupOf(group), *row.value, sigma});
    samples_.back().last_row = readings_.size();
  }
}

}  // namespace nineline::estimation
