#pragma once

#include <Eigen/Dense>
#include <array>

#include "core/errors/error_model.h"

namespace nineline::bench {

/// Joint order of the built-in `trunnion-ac`: A C X Y Z.
using FiveJoints = std::array<double, 5>;

/// Six errors of each joint as linear tables of 64 nodes, and two plain ways to compute with them.
class TrunnionReference {
 public:
  static constexpr int kNodes = 64;
  TrunnionReference();

  /// Tip in W by products of 4×4 matrices, as a textbook writes them; `axis`: the tool axis.
  [[nodiscard]] Eigen::Vector3d textbook(const FiveJoints& q, Eigen::Vector3d& axis) const;
  /// The same by hand: tip and axis carried through the chain as vectors.
  [[nodiscard]] Eigen::Vector3d byHand(const FiveJoints& q, Eigen::Vector3d& axis) const;
  /// Textbook compensation: the target is shifted by the miss and inverted ideally, three times.
  [[nodiscard]] FiveJoints compensated(const FiveJoints& ideal, bool by_hand) const;
  /// The same tables as an ErrorModel.
  [[nodiscard]] errors::ErrorModel model() const;

 private:
  void errorsAt(int joint, double q, double* six) const;
  static double startOf(int joint);
  static double spacingOf(int joint);
  double nodes_[5][kNodes][6];
};

/// Commands along a smooth five-axis path.
[[nodiscard]] std::vector<FiveJoints> commandsOfPath(int count);

}  // namespace nineline::bench
