#pragma once

#include "core/estimation/reading_set.h"

namespace nineline::identification {

using estimation::Index;
using estimation::MachineState;
using estimation::MatrixXd;
using estimation::VectorXd;
using kinematics::Machine;
using measurement::Measurement;

/// Where the error tables of one joint have their values.
struct Knots {
  errors::ErrorTable::Grid grid;
  Index count = 0;
  bool at_targets = false;  ///< the values stand where the files measured
  bool closed = false;      ///< a whole turn of a continuous joint
};

/// Positions of one joint in all readings.
struct JointPositionsSeen {
  double low = 0.0;
  double high = 0.0;
  bool moves = false;                        ///< in at least one file
  std::vector<std::vector<double>> by_file;  ///< distinct positions, ascending; only files in which it moves
};
[[nodiscard]] JointPositionsSeen positionsSeen(const estimation::ReadingSet& readings, int joint);

/// How many values a table gets where the positions follow no grid: `level` 0 is the coarsest.
inline constexpr int kKnotLevels = 6;

/// The knots of a joint: at the targets where a file has measured it at equally spaced ones (a test of that
/// very axis counts first), else equally spaced over the range that was measured, as many as `level` says.
/// Nothing where the joint did not move. Never reaches beyond what was measured by more than a part of a
/// spacing.
[[nodiscard]] std::optional<Knots> chooseKnots(const estimation::ReadingSet& readings, int joint, int level,
                                               std::optional<double> spacing = std::nullopt);

}  // namespace nineline::identification
