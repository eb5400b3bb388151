#include "core/measurement/measurement_columns.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/base/text.h"

namespace nineline::measurement {

namespace {

/// A column that looks like a position: an axis name and a unit.
std::optional<AxisId> positionAxis(std::string_view name, bool& in_degrees) {
  in_degrees = name.ends_with("_deg");
  if (!in_degrees && !name.ends_with("_mm")) return std::nullopt;
  const std::string_view axis = name.substr(0, name.size() - (in_degrees ? 4 : 3));
  return axis.empty() || axis != upper(axis) ? std::nullopt : parseAxisId(axis);
}

class Assigner {
 public:
  Assigner(std::size_t line, const Machine* machine, Measurement& measurement, Diagnostics& diagnostics)
      : line_(line), machine_(machine), measurement_(measurement), diagnostics_(diagnostics) {}

  std::vector<Column> assign(const std::vector<Cell>& names) {
    if (machine_ != nullptr)
      measurement_.commanded.assign(static_cast<std::size_t>(machine_->jointCount()), false);
    for (const Cell& name : names) {
      Column column{name.text, name.column, Role::Covariate, 0, false};
      const bool twice =
          !name.text.empty() && std::any_of(columns_.begin(), columns_.end(),
                                            [&](const Column& one) { return one.name == name.text; });
      if (twice) {
        diagnostics_.error("measurement.columns",
                           fmt::format("The column '{}' stands twice.", printable(name.text)), line_,
                           name.column);
        column.role = Role::Ignored;
      } else {
        assignRole(column);
      }
      columns_.push_back(column);
      measurement_.columns.push_back(column.name);
    }
    if (measurement_.channels.empty()) reportNoReadings();
    return std::move(columns_);
  }

 private:
  void assignRole(Column& column) {
    if (column.name.empty()) {
      column.role = Role::Ignored;
    } else if (column.name == "sigma_um" || column.name == "sigma_arcsec") {
      column.role = column.name == "sigma_um" ? Role::Sigma : Role::AngularSigma;
    } else if (assignPosition(column)) {
      return;
    } else if (const auto channel =
                   parseChannel(column.name, measurement_.instrument.kind, isTestedAxisRotary())) {
      column.role = Role::Reading;
      column.index = measurement_.channels.size();
      measurement_.channels.push_back(*channel);
    } else {
      if (column.name.starts_with("dev_") || column.name.starts_with("rot_") ||
          column.name.starts_with("dr_")) {
        diagnostics_.warning(
            "measurement.columns",
            fmt::format("'{}' is no reading of the instrument '{}'; the column is kept as a covariate.",
                        printable(column.name), nameOf(measurement_.instrument.kind)),
            line_, column.place);
      }
      addCovariate(column);
    }
  }

  void addCovariate(Column& column) {
    column.role = Role::Covariate;
    column.index = measurement_.covariates.size();
    measurement_.covariates.push_back({column.name, {}});
  }

  /// True when the column is a position, or was refused as one.
  bool assignPosition(Column& column) {
    bool in_degrees = false;
    const std::optional<AxisId> axis = positionAxis(column.name, in_degrees);
    if (!axis || machine_ == nullptr) return false;
    const int joint = machine_->find(*axis);
    if (joint < 0) {
      diagnostics_.warning(
          "measurement.columns",
          fmt::format("'{}' names no axis of the machine '{}'; the column is kept as a covariate.",
                      column.name, machine_->id()),
          line_, column.place);
      addCovariate(column);
      return true;
    }
    column.is_rotary = machine_->isRotary(joint);
    if (in_degrees != column.is_rotary) {
      diagnostics_.error(
          "measurement.columns",
          fmt::format("'{}' is the column of a {} axis, expected '{}_{}'.", column.name,
                      column.is_rotary ? "rotary" : "linear", axis->text(), column.is_rotary ? "deg" : "mm"),
          line_, column.place);
      column.role = Role::Ignored;
      return true;
    }
    column.role = Role::Position;
    column.index = static_cast<std::size_t>(joint);
    measurement_.commanded[column.index] = true;
    return true;
  }

  bool isTestedAxisRotary() const {
    const std::optional<AxisId>& axis = measurement_.instrument.axis;
    const int joint = axis && machine_ != nullptr ? machine_->find(*axis) : -1;
    return joint >= 0 && machine_->isRotary(joint);
  }

  void reportNoReadings() {
    const InstrumentKind kind = measurement_.instrument.kind;
    diagnostics_.error("measurement.columns",
                       fmt::format("No column holds readings of the instrument '{}', expected {}{}.",
                                   nameOf(kind), kind == InstrumentKind::Deviation ? "any of " : "",
                                   fmt::join(channelColumns(kind, isTestedAxisRotary()), ", ")),
                       line_);
  }

  std::size_t line_;
  const Machine* machine_;
  Measurement& measurement_;
  Diagnostics& diagnostics_;
  std::vector<Column> columns_;
};

}  // namespace

std::vector<Column> assignColumns(const std::vector<Cell>& names, std::size_t line, const Machine* machine,
                                  Measurement& measurement, Diagnostics& diagnostics) {
  return Assigner(line, machine, measurement, diagnostics).assign(names);
}

Result<Machine> standInMachine(const std::vector<Cell>& names, const std::string& id) {
  Machine::Description description;
  description.id = id;
  for (const Cell& name : names) {
    bool in_degrees = false;
    const std::optional<AxisId> axis = positionAxis(name.text, in_degrees);
    if (!axis) continue;
    kinematics::Joint joint;
    joint.axis = *axis;
    joint.type = in_degrees ? kinematics::JointType::Rotary : kinematics::JointType::Linear;
    constexpr std::string_view kDirections = "XYZUVWABC";
    joint.direction = Eigen::Vector3d::Unit(static_cast<int>(kDirections.find(axis->letter) % 3));
    description.tool_chain.push_back(joint);
  }
  return Machine::make(std::move(description));
}

}  // namespace nineline::measurement
