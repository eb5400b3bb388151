#pragma once

#include <span>

#include "core/base/progress.h"
#include "core/estimation/unknowns.h"
#include "core/measurement/reading_function.h"
#include "core/measurement/states.h"

namespace nineline::estimation {

using kinematics::Machine;
using measurement::Measurement;

/// Readings of one kind of instrument and one kind of unit share one level of noise, relative to the sigma of
/// each.
struct NoiseClass {
  measurement::InstrumentKind kind = measurement::InstrumentKind::Deviation;
  bool angular = false;
  bool stated = false;  ///< the files state a repeatability; otherwise readings count in µm and arcsec
  friend bool operator==(const NoiseClass&, const NoiseClass&) = default;
};

/// Readings of one channel in one run of one file: they share one unknown offset.
struct RunGroup {
  std::size_t file = 0;
  std::size_t channel = 0;
  std::size_t noise = 0;  ///< index of its NoiseClass
  int zero = -1;          ///< index of the file's unknown zero of this channel, −1: the instrument has none
  std::optional<double> run;
};

/// One reading that takes part.
struct ReadingPlace {
  std::size_t sample = 0;  ///< of all files one after the other
  std::size_t channel = 0;
  std::size_t group = 0;
  double value = 0.0;  ///< mm, rad
  double sigma = 1.0;  ///< stated standard uncertainty, or µm/arcsec
};

/// One sample that has readings; its rows are [first_row, last_row).
struct SamplePlace {
  std::size_t file = 0;
  std::size_t index = 0;  ///< in the file
  std::size_t first_row = 0;
  std::size_t last_row = 0;
};

/// All readings of several files of any instruments, ready for a fit. The machine and the measurements must
/// outlive it.
class ReadingSet {
 public:
  /// Fails when an instrument does not fit the machine.
  [[nodiscard]] static Result<ReadingSet> make(const Machine& machine, std::span<const Measurement> files);

  [[nodiscard]] const Machine& machine() const { return *machine_; }
  [[nodiscard]] std::span<const Measurement> files() const { return files_; }
  [[nodiscard]] std::size_t rows() const { return readings_.size(); }
  [[nodiscard]] const std::vector<ReadingPlace>& readings() const { return readings_; }
  [[nodiscard]] const std::vector<SamplePlace>& samples() const { return samples_; }
  [[nodiscard]] const std::vector<RunGroup>& groups() const { return groups_; }
  [[nodiscard]] const std::vector<NoiseClass>& classes() const { return classes_; }
  [[nodiscard]] int zeroCount() const { return zeros_; }
  [[nodiscard]] const MachineState& state(const SamplePlace& place) const {
    return states_[place.file][place.index];
  }
  [[nodiscard]] const std::vector<MachineState>& statesOf(std::size_t file) const { return states_[file]; }
  [[nodiscard]] const measurement::ReadingFunction& function(std::size_t file) const {
    return functions_[file];
  }
  /// Multiplies the sigma of all readings of a file: where nothing is stated, the readings themselves say how
  /// well one file repeats beside another.
  void rescale(std::size_t file, double factor);
  [[nodiscard]] std::size_t noiseOf(std::size_t row) const { return groups_[readings_[row].group].noise; }

 private:
  ReadingSet() = default;
  void addFile(std::size_t file);
  [[nodiscard]] std::size_t groupOf(const RunGroup& group);
  const Machine* machine_ = nullptr;
  std::span<const Measurement> files_;
  std::vector<std::vector<MachineState>> states_;
  std::vector<measurement::ReadingFunction> functions_;
  std::vector<ReadingPlace> readings_;
  std::vector<SamplePlace> samples_;
  std::vector<RunGroup> groups_;
  std::vector<NoiseClass> classes_;
  int zeros_ = 0;
};

}  // namespace nineline::estimation
