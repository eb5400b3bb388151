#pragma once

#include "core/base/diagnostics.h"
#include "core/errors/error_model.h"
#include "core/measurement/reading_function.h"
#include "core/measurement/states.h"

namespace nineline::measurement {

using errors::ErrorModel;

/// The past of a model's effects along a measurement's samples (contract.md, convention 7): in equilibrium at
/// the first one, from there by Effect::advanceSampled. So play answers from the approach direction, −(w/2)
/// s, and what lags behind a temperature follows the time.
class MemoryWalk {
 public:
  /// The effects must outlive this object.
  explicit MemoryWalk(const std::vector<errors::EffectPtr>& effects);
  /// Goes on to the next sample, in order. Gives the memory of all effects there.
  [[nodiscard]] std::span<const double> to(const MachineState& state);

 private:
  struct Part {
    const errors::Effect* effect;
    std::size_t first;
    std::size_t size;
  };
  std::vector<Part> parts_;
  std::vector<double> memory_;
  const MachineState* before_ = nullptr;
};

/// What a model says that an instrument would read.
struct Prediction {
  std::vector<ReadingRow> rows;  ///< rowsOf(measurement)
  /// By row, mm or rad, without the unknown zero of the file.
  Eigen::VectorXd readings;
  /// By row: 0 where a condition that the model needs is missing at that sample; the prediction there lacks
  /// the effects that need it and takes no part in the zero.
  std::vector<std::uint8_t> is_complete;
  /// By channel: what the instrument's zero adds to every reading of the file, the mean of reading −
  /// prediction weighted by 1/σ². 0 for instruments that have none; absent where no reading is there to fit
  /// it.
  std::vector<std::optional<double>> zeros;
  Diagnostics warnings;  ///< samples outside an error table, missing conditions

  /// readings[row] plus the zero of its channel: comparable to the reading itself.
  [[nodiscard]] double shown(std::size_t row) const;
};

/// Readings of every sample and channel through the exact kinematics. Fails with BadInput when the machine
/// lacks the instrument's axis, or when the measurement nowhere states a condition that the model needs.
[[nodiscard]] Result<Prediction> predict(const ErrorModel& model, const Measurement& measurement);

/// The zero of each channel for given predictions by row; see Prediction::zeros. `use` leaves rows out
/// (empty: all are used).
[[nodiscard]] std::vector<std::optional<double>> fitZeros(const Measurement& measurement,
                                                          const std::vector<ReadingRow>& rows,
                                                          const Eigen::VectorXd& predictions,
                                                          std::span<const std::uint8_t> use = {});

/// Fails with BadInput when the instrument cannot stand on this machine: its axis is missing or of the wrong
/// type.
[[nodiscard]] Result<void> requireInstrument(const Machine& machine, const Measurement& measurement);

}  // namespace nineline::measurement
