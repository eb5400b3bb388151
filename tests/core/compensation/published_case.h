#pragma once

#include <array>
#include <functional>

#include "core/errors/error_model.h"

namespace nineline::test_support {

/// An error component given as a formula of the joint's position (mm or rad).
class FormulaEffect final : public errors::Effect {
 public:
  using Formula = std::function<double(double)>;
  FormulaEffect(int joint, errors::Component component, errors::Slot slot, Formula formula)
      : Effect(joint, component, slot), formula_(std::move(formula)) {}
  [[nodiscard]] std::string id() const override { return "formula"; }
  void addMotion(const errors::MachineState& state, std::span<const double> memory,
                 errors::SmallMotion& sum) const override;
  [[nodiscard]] double featureLength() const override { return 0.5; }
  [[nodiscard]] std::vector<errors::Parameter> parameters() const override { return {}; }
  [[nodiscard]] Json toJson(const kinematics::Machine&) const override { return {}; }

 private:
  Formula formula_;
};

/// A place of the thread grinder: joints Z, C, X in the machine's order.
struct GrinderPlace {
  double x = 0.0;      ///< mm
  double z = 0.0;      ///< mm
  double gamma = 0.0;  ///< rad
  [[nodiscard]] kinematics::JointPositions joints() const { return {z, gamma, x}; }
};

struct GrinderGeometry {
  Eigen::Vector3d q2, q4, t;
};

/// The machine of theory.md, 1.4: Z and C carry the workpiece, X the wheel; no travel limits.
[[nodiscard]] kinematics::Machine grinderWith(const GrinderGeometry& geometry);

/// Error of each axis where the ideal machine would touch the workpiece point w: theory.md, 1.5, eq. 3 in
/// closed form, minus the command.
[[nodiscard]] GrinderPlace axisErrors(const GrinderGeometry& geometry, const Eigen::Vector3d& w,
                                      const GrinderPlace& command);

/// What the constructed scenario "published case" of theory.md, 3.4 is made of; each switch spoils it as one
/// row of the table there does.
struct PublishedCase {
  bool translations_only = false;
  bool squareness = true;
  bool levers = true;
  bool fixed_frame = false;          ///< C errors read in the standing frame
  bool one_symbol = false;           ///< B0C takes the value of B0X
  double angle_sign = 1.0;           ///< of the angular error motions; the squarenesses stay
  bool values_at_the_start = false;  ///< every error keeps its value at the first point

  [[nodiscard]] GrinderGeometry geometry() const;
  [[nodiscard]] errors::ErrorModel model() const;
};

constexpr int kPublishedPoints = 241;
[[nodiscard]] GrinderPlace publishedCommand(int k);

}  // namespace nineline::test_support
