#include "core/identification/parameters.h"

#include <algorithm>
#include <array>

#include "core/identification/table_modes.h"

namespace nineline::identification {

using errors::Component;
using errors::Slot;
using errors::SmallMotion;
using estimation::ReadingSet;
using kinematics::Joint;

std::string_view nameOf(Part part) {
  static constexpr std::array<std::string_view, 6> kNames{"location",      "mean slope", "shape",
                                                          "once per turn", "constant",   "play"};
  return kNames[static_cast<std::size_t>(part)];
}

namespace {

SmallMotion rowMotion(int row) {
  SmallMotion unit;
  (row < 3 ? unit.translation[row] : unit.rotation[row - 3]) = 1.0;
  return unit;
}

/// A parameter as the coefficients that it moves.
using Column = std::vector<std::pair<Index, double>>;

class Builder {
 public:
  Builder(const ReadingSet& readings, const ParameterOptions& options)
      : readings_(readings), machine_(readings.machine()), options_(options) {}

  ParameterSet build() {
    collectJoints();
    addLocations();
    for (const Axis& axis : axes_) addTables(axis);
    for (const Axis& axis : axes_) addConstants(axis);
    if (options_.play) addPlays();
    fillMap();
    return std::move(set_);
  }

 private:
  struct Axis {
    int joint = 0;
    bool rotary = false;
    int own = 0;         // row 0 1 2 along the axis
    double sense = 1.0;  // of the direction along that row
    bool aligned = true;
    bool fixed_frame = false;
    std::size_t basis = 0;
    std::shared_ptr<const estimation::TableBasis> table;
    std::array<std::size_t, 6> tables{};  // by row, in set_.tables
    TableModes lengths, angles;
    [[nodiscard]] int first() const { return (own + 1) % 3; }
    [[nodiscard]] int second() const { return (own + 2) % 3; }
  };

  void collectJoints() {
    for (int joint = 0; joint < machine_.jointCount(); ++joint) {
      const auto j = static_cast<std::size_t>(joint);
      const int level = j < options_.knot_levels.size() ? options_.knot_levels[j] : 2;
      const auto spacing = j < options_.spacings.size() ? options_.spacings[j] : std::nullopt;
      const std::optional<Knots> knots = chooseKnots(readings_, joint, level, spacing);
      if (!knots) continue;
      Axis axis;
      axis.joint = joint;
      axis.rotary = machine_.isRotary(joint);
      const Eigen::Vector3d& direction = machine_.joint(joint).direction;
      axis.aligned = direction.cwiseAbs().maxCoeff(&axis.own) > 1.0 - 1e-9;
      axis.sense = direction[axis.own] > 0.0 ? 1.0 : -1.0;
      axis.fixed_frame = axis.rotary && !seenFromWorkpiece(joint);
      axis.table = std::make_shared<estimation::TableBasis>(joint, knots->grid, knots->count);
      axis.basis = set_.unknowns.addBasis(axis.table);
      axis.lengths = tableModes(*axis.table, axis.rotary, kPlausibleLength);
      axis.angles = tableModes(*axis.table, axis.rotary, kPlausibleAngle);
      for (int row = 0; row < 6; ++row) addTable(axis, row);
      axes_.push_back(std::move(axis));
    }
  }

  /// True where an instrument sees the tool in the workpiece while the joint turns: then errors that turn
  /// with it can be told, else only what a gauge on the bed sees.
  [[nodiscard]] bool seenFromWorkpiece(int joint) const {
    for (std::size_t file = 0; file < readings_.files().size(); ++file) {
      if (readings_.files()[file].instrument.needsAxis()) continue;
      const auto& states = readings_.statesOf(file);
      for (const MachineState& state : states) {
        const auto j = static_cast<std::size_t>(joint);
        if (std::abs(state.q[j] - states.front().q[j]) > 1e-6) return true;
      }
    }
    return false;
  }

  void addTable(Axis& axis, int row) {
    const Slot slot = axis.fixed_frame ? Slot::Standing : Slot::Moved;
    const std::size_t block = set_.unknowns.addBlock(axis.joint, slot, rowMotion(row), axis.basis);
    axis.tables[static_cast<std::size_t>(row)] = set_.tables.size();
    set_.tables.push_back({axis.joint, Component{machine_.joint(axis.joint).axis, row, false},
                           axis.fixed_frame, axis.table, set_.unknowns.blocks()[block].first});
  }

  void addScalar(int joint, const Component& component, Part part, Slot slot, const SmallMotion& unit,
                 std::size_t basis) {
    const std::size_t block = set_.unknowns.addBlock(joint, slot, unit, basis);
    const Index coefficient = set_.unknowns.blocks()[block].first;
    const Index parameter = addColumn({{coefficient, 1.0}}, component.isAngular());
    set_.scalars.push_back({joint, component, part, coefficient, parameter});
    addChunk({component, component.text(), part, false}, {parameter});
  }

  /// Y before X before the rest, so that squareness refers to Z where only a sum is seen (theory.md, 1.2).
  void addLocations() {
    const std::size_t constant = set_.unknowns.addBasis(std::make_shared<estimation::ConstantBasis>());
    std::vector<const Axis*> order;
    for (const Axis& axis : axes_) order.push_back(&axis);
    const auto rank = [this](const Axis* axis) {
      const char letter = machine_.joint(axis->joint).axis.letter;
      return letter == 'Y' ? 0 : letter == 'X' ? 1 : 2;
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](const Axis* a, const Axis* b) { return rank(a) < rank(b); });
    for (const Axis* axis : order) {
      const AxisId id = machine_.joint(axis->joint).axis;
      for (const int row : {axis->first(), axis->second()}) {
        if (!axis->rotary) continue;
        addScalar(axis->joint, {id, row, true}, Part::Location, Slot::Located, rowMotion(row), constant);
      }
      for (const int row : {axis->first(), axis->second()}) {
        addScalar(axis->joint, {id, row + 3, true}, Part::Location, Slot::Located, rowMotion(row + 3),
                  constant);
      }
    }
  }

  [[nodiscard]] const TableUnknown& tableOf(const Axis& axis, int row) const {
    return set_.tables[axis.tables[static_cast<std::size_t>(row)]];
  }

  /// The coefficients of a table whose node values are `nodes`.
  [[nodiscard]] Column nodeColumn(const Axis& axis, int row, const VectorXd& nodes,
                                  double factor = 1.0) const {
    const TableUnknown& table = tableOf(axis, row);
    const VectorXd curvatures = axis.table->curvatures() * nodes;
    Column column;
    for (Index i = 0; i < nodes.size(); ++i) {
      column.emplace_back(table.first + i, factor * nodes[i]);
      column.emplace_back(table.first + nodes.size() + i, factor * curvatures[i]);
    }
    return column;
  }

  void addTables(const Axis& axis) {
    // Own positioning first, then across, then the rotations: a single line tells the positioning along it.
    const std::array<int, 6> linear{axis.own,         axis.first(),      axis.second(),
                                    axis.first() + 3, axis.second() + 3, axis.own + 3};
    const std::array<int, 6> rotary{axis.own + 3,  axis.own,         axis.first(),
                                    axis.second(), axis.first() + 3, axis.second() + 3};
    for (const int row : axis.rotary ? rotary : linear) {
      const TableModes& modes = row < 3 ? axis.lengths : axis.angles;
      const Component& component = tableOf(axis, row).component;
      const bool is_lateral = row < 3 && row != axis.own;
      if (!axis.rotary && modes.slope.size() > 0 && !is_lateral) {
        const Index parameter = addColumn(nodeColumn(axis, row, modes.slope), row >= 3);
        addChunk({component, component.text(), Part::Slope, false}, {parameter});
      }
      if (axis.rotary) addPerTurn(axis, row);
      addShape(axis, row, modes);
    }
  }

  void addShape(const Axis& axis, int row, const TableModes& modes) {
    if (modes.shape.cols() == 0) return;
    std::vector<Index> parameters;
    for (Index k = 0; k < modes.shape.cols(); ++k) {
      parameters.push_back(addColumn(nodeColumn(axis, row, modes.shape.col(k)), row >= 3));
    }
    const Component& component = tableOf(axis, row).component;
    addChunk({component, component.text(), Part::Shape, false}, parameters, modes.precision);
  }

  /// First harmonics of a rotary joint. Across the axis, in the turning frame, two of the four combinations
  /// of a pair stand still on the bed: they are the place and the tilt of the axis and are left to those.
  void addPerTurn(const Axis& axis, int row) {
    const TableModes& modes = row < 3 ? axis.lengths : axis.angles;
    if (modes.cosine.size() == 0) return;
    const Component& component = tableOf(axis, row).component;
    const bool is_pair = row % 3 != axis.own && axis.aligned && !axis.fixed_frame;
    if (!is_pair) {
      const Index cosine = addColumn(nodeColumn(axis, row, modes.cosine), row >= 3);
      const Index sine = addColumn(nodeColumn(axis, row, modes.sine), row >= 3);
      addChunk({component, component.text(), Part::PerTurn, false}, {cosine});
      addChunk({component, component.text(), Part::PerTurn, false}, {sine});
      return;
    }
    if (row % 3 != axis.first()) return;
    const int other = row - axis.first() + axis.second();
    const std::string name = component.text() + " and " + tableOf(axis, other).component.text();
    Column one = nodeColumn(axis, row, modes.cosine);
    append(nodeColumn(axis, other, modes.sine, axis.sense), one);
    Column two = nodeColumn(axis, row, modes.sine, axis.sense);
    append(nodeColumn(axis, other, modes.cosine, -1.0), two);
    addChunk({component, name, Part::PerTurn, false}, {addColumn(std::move(one), row >= 3)});
    addChunk({component, name, Part::PerTurn, false}, {addColumn(std::move(two), row >= 3)});
  }

  static void append(const Column& more, Column& column) {
    column.insert(column.end(), more.begin(), more.end());
  }

  void addConstants(const Axis& axis) {
    for (const int row :
         {axis.own, axis.first(), axis.second(), axis.own + 3, axis.first() + 3, axis.second() + 3}) {
      const bool is_location = axis.fixed_frame && row % 3 != axis.own;  // X0C and the like have it
      if (is_location) continue;
      const Component& component = tableOf(axis, row).component;
      const VectorXd& constant = axis.lengths.constant;
      const Index parameter = addColumn(nodeColumn(axis, row, constant), row >= 3);
      addChunk({component, component.text(), Part::Constant, true}, {parameter});
    }
  }

  void addPlays() {
    for (const Axis& axis : axes_) {
      if (!reverses(axis.joint)) continue;
      const Joint& joint = machine_.joint(axis.joint);
      const std::size_t approach =
          set_.unknowns.addBasis(std::make_shared<estimation::ApproachBasis>(axis.joint));
      const Component own = errors::positioningOf(joint);
      addScalar(axis.joint, own, Part::Play, Slot::Moved, errors::unitMotion(joint, own), approach);
      for (int row = 0; row < 6 && options_.lateral_play && !axis.rotary; ++row) {
        if (row == axis.own) continue;
        addScalar(axis.joint, {joint.axis, row, false}, Part::Play, Slot::Moved, rowMotion(row), approach);
      }
    }
  }

  [[nodiscard]] bool reverses(int joint) const {
    bool forward = false;
    bool backward = false;
    for (const estimation::SamplePlace& place : readings_.samples()) {
      const int sense = readings_.state(place).approach[static_cast<std::size_t>(joint)];
      forward = forward || sense > 0;
      backward = backward || sense < 0;
    }
    return forward && backward;
  }

  Index addColumn(Column column, bool angular) {
    columns_.push_back(std::move(column));
    plausible_.push_back(angular ? kPlausibleAngle : kPlausibleLength);
    return static_cast<Index>(columns_.size()) - 1;
  }

  void addChunk(NamedChunk name, std::vector<Index> parameters, MatrixXd prior = {}) {
    set_.chunks.push_back({std::move(parameters), std::move(prior)});
    set_.names.push_back(std::move(name));
  }

  void fillMap() {
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      for (const auto& [coefficient, value] : columns_[k]) {
        entries.emplace_back(static_cast<int>(coefficient), static_cast<int>(k), value);
      }
    }
    set_.map.resize(set_.unknowns.size(), static_cast<Index>(columns_.size()));
    set_.map.setFromTriplets(entries.begin(), entries.end());
    set_.plausible = Eigen::Map<const VectorXd>(plausible_.data(), static_cast<Index>(plausible_.size()));
  }

  const ReadingSet& readings_;
  const Machine& machine_;
  const ParameterOptions& options_;
  ParameterSet set_;
  std::vector<Axis> axes_;
  std::vector<Column> columns_;
  std::vector<double> plausible_;
};

}  // namespace

ParameterSet makeParameters(const ReadingSet& readings, const ParameterOptions& options) {
  return Builder(readings, options).build();
}

}  // namespace nineline::identification
