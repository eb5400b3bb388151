#pragma once

#include <random>

#include "core/errors/error_model.h"
#include "core/kinematics/chain.h"

namespace nineline::test_support {

/// Numbers that are the same on every machine and in every run.
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  /// Evenly distributed in [low, high).
  [[nodiscard]] double between(double low, double high);
  /// A whole number from low to high, both included.
  [[nodiscard]] int whole(int low, int high);
  [[nodiscard]] Eigen::Vector3d vector(double largest);
  [[nodiscard]] Eigen::Vector3d unitVector();

 private:
  std::mt19937_64 engine_;
};

/// A machine of `joints` axes in random order on random sides, about half of them along bed axes, with
/// offsets up to 200 mm. At most three joints are rotary.
[[nodiscard]] kinematics::Machine randomMachine(Random& random, int joints);

/// Positions inside the travel; ±1 rad and ±200 mm where there is none.
[[nodiscard]] kinematics::JointPositions randomPositions(Random& random, const kinematics::Machine& machine);

/// Displacements in every slot, up to 10 µm and `angle` rad.
[[nodiscard]] kinematics::JointDisplacements randomDisplacements(Random& random,
                                                                 const kinematics::Machine& machine,
                                                                 double angle = 1e-4);

/// Tables on all six components of every joint over ±500 mm or one turn, and location errors.
[[nodiscard]] errors::ErrorModel randomModel(Random& random, const kinematics::Machine& machine);

}  // namespace nineline::test_support
