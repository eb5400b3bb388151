#pragma once

#include "core/errors/effect.h"

namespace nineline::errors {

/// One error component of a joint as a table over its position: effect `table`. The value acts along or about
/// the axis of the joint's frame that the component names, after the joint's motion (or before it, frame
/// "fixed").
class TableEffect final : public Effect {
 public:
  TableEffect(int joint, Component component, ErrorTable table, bool fixed_frame);

  [[nodiscard]] std::string id() const override { return "table"; }
  void addMotion(const MachineState& state, std::span<const double> memory, SmallMotion& sum) const override;
  void addSlope(const MachineState& state, SmallMotion& sum) const override;
  [[nodiscard]] double featureLength() const override { return table_.grid().spacing; }
  [[nodiscard]] bool covers(const MachineState& state) const override;
  [[nodiscard]] const ErrorTable* table() const override { return &table_; }
  [[nodiscard]] std::vector<Parameter> parameters() const override { return {}; }
  [[nodiscard]] Json toJson(const kinematics::Machine& machine) const override;

  /// The point in the moved frame, mm, to which translations refer when the joint also tilts; its origin by
  /// default.
  void setReference(const Eigen::Vector3d& reference) { reference_ = reference; }
  [[nodiscard]] const Eigen::Vector3d& reference() const { return reference_; }

  /// Standard uncertainties of the values (mm, rad), empty when unknown.
  void setSigmas(std::vector<double> sigmas) { sigmas_ = std::move(sigmas); }
  [[nodiscard]] const std::vector<double>& sigmas() const { return sigmas_; }

  /// Reads an effect of a model file; fails with what stood there and what was expected.
  [[nodiscard]] static Result<std::shared_ptr<Effect>> fromJson(JsonReader& reader,
                                                                const kinematics::Machine& machine, int joint,
                                                                Component component);

 private:
  ErrorTable table_;
  std::vector<double> sigmas_;
  Eigen::Vector3d reference_ = Eigen::Vector3d::Zero();
};

/// A constant small displacement before the joint's motion: effect `location` (theory.md, 1.2; contract.md,
/// 3).
class LocationEffect final : public Effect {
 public:
  LocationEffect(int joint, Component component, double value, std::optional<double> sigma);

  [[nodiscard]] std::string id() const override { return "location"; }
  void addMotion(const MachineState& state, std::span<const double> memory, SmallMotion& sum) const override;
  [[nodiscard]] std::vector<Parameter> parameters() const override;
  [[nodiscard]] Json toJson(const kinematics::Machine& machine) const override;
  [[nodiscard]] double value() const { return value_; }  ///< mm, rad

  [[nodiscard]] static Result<std::shared_ptr<Effect>> fromJson(JsonReader& reader, int joint,
                                                                Component component);

 private:
  double value_;
  std::optional<double> sigma_;
};

}  // namespace nineline::errors
