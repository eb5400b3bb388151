// nineline_estimation_benchmark [REPETITIONS [CASE]]: identification of the errors of a five-axis machine
// (three linear axes carry the tool, A and C the workpiece) by estimation::fit, beside Ceres with automatic
// derivatives on the same readings and the same exact kinematics, in turn in one run. Rows LS-1, LS-2, LS-3
// of performance.md, and the volumetric fit with splines. A pose gives three numbers: the deviation, or at
// every third pose the rotation.
#include <ceres/ceres.h>
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>

#include "core/base/units.h"
#include "core/estimation/fit.h"
#include "core/identification/table_modes.h"
#include "tests/bench/ceres_reference.h"
#include "tests/support/random_machines.h"

namespace {

using namespace nineline;
using namespace nineline::bench;
using namespace nineline::estimation;
using kinematics::Machine;
using test_support::Random;

constexpr double kReach = 480.0;
Machine fiveAxis(bool rotary) {
  Machine::Description description;
  description.id = "bench";
  for (int k = 0; k < 3; ++k) {
    kinematics::Joint joint;
    joint.axis = {"XYZ"[k], 0};
    joint.direction = Eigen::Vector3d::Unit(k);
    description.tool_chain.push_back(joint);
  }
  if (rotary) {
    for (int k = 0; k < 2; ++k) {
      kinematics::Joint joint;
      joint.axis = {"AC"[k], 0};
      joint.type = kinematics::JointType::Rotary;
      joint.direction = Eigen::Vector3d::Unit(2 * k);
      description.workpiece_chain.push_back(joint);
    }
  }
  description.tool_tip = {kTip[0], kTip[1], kTip[2]};
  return Machine::make(description).value();
}

/// Everything of one case: unknowns for the fit, and the weights of every pose for Ceres.
struct Case {
  Case(const Shape& shape, int count);
  void addAxis(int axis);
  void addScalar(int joint, int row);
  void addColumn(const std::vector<std::pair<Index, double>>& column);

  Shape shape;
  Machine machine;
  std::vector<Measurement> files;  // positions, rotations
  std::vector<kinematics::JointPositions> poses;
  std::vector<Eigen::Vector3d> readings;
  Unknowns unknowns;
  std::optional<std::size_t> constant;
  std::vector<Eigen::Triplet<double>> entries;
  int parameters = 0;
  Eigen::SparseMatrix<double> map;
  std::vector<std::shared_ptr<TableBasis>> tables;
  std::vector<MatrixXd> lateral_modes, other_modes;
};

errors::SmallMotion along(int row) {
  errors::SmallMotion unit;
  (row < 3 ? unit.translation[row] : unit.rotation[row - 3]) = 1.0;
  return unit;
}

void Case::addColumn(const std::vector<std::pair<Index, double>>& column) {
  for (const auto& [coefficient, value] : column) {
    entries.emplace_back(static_cast<int>(coefficient), parameters, value);
  }
  ++parameters;
}

void Case::addAxis(int axis) {
  const int joint = machine.find({"XYZ"[axis], 0});
  std::size_t powers = 0;
  std::size_t lateral_powers = 0;
  if (shape.nodes == 0) {
    powers = unknowns.addBasis(std::make_shared<PowerBasis>(joint, 500.0, 1, shape.degree));
    lateral_powers = unknowns.addBasis(std::make_shared<PowerBasis>(joint, 500.0, 2, shape.degree + 1));
  } else {
    const errors::ErrorTable::Grid grid{-kReach, 2.0 * kReach / (shape.nodes - 1),
                                        errors::Interpolation::Cubic, std::nullopt};
    tables.push_back(std::make_shared<TableBasis>(joint, grid, shape.nodes));
    const identification::TableModes modes = identification::tableModes(*tables.back(), false, 1.0);
    lateral_modes.push_back(modes.shape);
    other_modes.emplace_back(shape.nodes, shape.nodes - 1);
    other_modes.back() << modes.slope, modes.shape;
    powers = lateral_powers = unknowns.addBasis(tables.back());
  }
  for (int row = 0; row < 6; ++row) {
    const bool lateral = row < 3 && row != axis;
    const std::size_t block =
        unknowns.addBlock(joint, errors::Slot::Moved, along(row), lateral ? lateral_powers : powers);
    const Index first = unknowns.blocks()[block].first;
    for (int k = 0; k < (lateral ? shape.lateral() : shape.other()); ++k) {
      std::vector<std::pair<Index, double>> column;
      if (shape.nodes == 0) {
        column.emplace_back(first + k, 1.0);
      } else {
        const VectorXd nodes = (lateral ? lateral_modes : other_modes).back().col(k);
        const VectorXd curvatures = tables.back()->curvatures() * nodes;
        for (Index i = 0; i < nodes.size(); ++i) {
          column.emplace_back(first + i, nodes[i]);
          column.emplace_back(first + nodes.size() + i, curvatures[i]);
        }
      }
      addColumn(column);
    }
  }
}

void Case::addScalar(int joint, int row) {
  if (!constant) constant = unknowns.addBasis(std::make_shared<ConstantBasis>());
  const std::size_t block = unknowns.addBlock(joint, errors::Slot::Located, along(row), *constant);
  addColumn({{unknowns.blocks()[block].first, 1.0}});
}

Case::Case(const Shape& of_shape, int count) : shape(of_shape), machine(fiveAxis(of_shape.rotary)) {
  for (int axis = 0; axis < 3; ++axis) addAxis(axis);
  const int y = machine.find({'Y', 0});
  const int z = machine.find({'Z', 0});
  addScalar(y, 5);
  addScalar(z, 3);
  addScalar(z, 4);
  if (shape.rotary) {
    for (const int row : {1, 2, 4, 5}) addScalar(0, row);     // A
    for (const int row : {0, 1, 3, 4, 5}) addScalar(1, row);  // C, with its zero
  }
  map.resize(unknowns.size(), parameters);
  map.setFromTriplets(entries.begin(), entries.end());
  using measurement::Quantity;
  files.resize(2);
  for (Measurement& file : files) {
    file.instrument.kind = measurement::InstrumentKind::Deviation;
    file.repeatability = kNoise;
    file.angular_repeatability = kAngleNoise;
  }
  files[0].channels = {{Quantity::DevX}, {Quantity::DevY}, {Quantity::DevZ}};
  files[1].channels = {{Quantity::RotX}, {Quantity::RotY}, {Quantity::RotZ}};
  Random random(7);
  VectorXd truth(parameters);
  for (Index k = 0; k < truth.size(); ++k) truth[k] = random.between(-3e-5, 3e-5);
  const VectorXd coefficients = map * truth;
  const std::array functions{measurement::ReadingFunction(machine, files[0].instrument, files[0].channels),
                             measurement::ReadingFunction(machine, files[1].instrument, files[1].channels)};
  std::vector<BasisValues> values(unknowns.bases().size());
  kinematics::JointDisplacements displacements;
  std::array<double, 3> exact{};
  for (int i = 0; i < count; ++i) {
    MachineState state;
    for (int j = 0; j < machine.jointCount(); ++j) {
      const double reach = machine.isRotary(j) ? (j == 0 ? 1.5 : kPi) : kReach;
      state.q[static_cast<std::size_t>(j)] = random.between(-reach, reach);
    }
    unknowns.evaluate(state, values);
    unknowns.displacements(values, coefficients, displacements);
    const bool angular = i % 3 == 2;
    functions[angular ? 1 : 0].read(state.q, displacements, exact);
    Measurement& file = files[angular ? 1 : 0];
    measurement::Sample sample;
    sample.q = state.q;
    file.samples.push_back(sample);
    poses.push_back(state.q);
    Eigen::Vector3d reading;
    for (std::size_t k = 0; k < 3; ++k) {
      double noise = 0.0;
      for (int n = 0; n < 12; ++n) noise += random.between(-0.5, 0.5);  // normal enough
      reading[static_cast<Index>(k)] = exact[k] + noise * (angular ? kAngleNoise : kNoise);
      file.readings.emplace_back(reading[static_cast<Index>(k)]);
    }
    readings.push_back(reading);
  }
}

std::vector<Pose> posesOf(const Case& of_case) {
  std::vector<Pose> poses;
  const int linear = of_case.shape.rotary ? 2 : 0;
  for (std::size_t i = 0; i < of_case.poses.size(); ++i) {
    Pose pose;
    pose.shape = &of_case.shape;
    pose.q = of_case.poses[i];
    pose.reading = of_case.readings[i];
    pose.angular = i % 3 == 2;
    for (std::size_t k = 0; k < 3; ++k) {
      const double q = pose.q[static_cast<std::size_t>(linear) + k];
      if (of_case.shape.nodes > 0) {
        const VectorXd cardinal = of_case.tables[k]->cardinal(q);
        pose.lateral[k] = of_case.lateral_modes[k].transpose() * cardinal;
        pose.other[k] = of_case.other_modes[k].transpose() * cardinal;
        continue;
      }
      pose.lateral[k].resize(of_case.shape.degree);
      pose.other[k].resize(of_case.shape.degree);
      for (int n = 0; n < of_case.shape.degree; ++n) {
        pose.other[k][n] = std::pow(q / 500.0, n + 1);
        pose.lateral[k][n] = std::pow(q / 500.0, n + 2);
      }
    }
    poses.push_back(std::move(pose));
  }
  return poses;
}

struct Run {
  double seconds = 0.0;  // CPU time of the process
  double rms = 0.0;      // of the weighted residuals
  int iterations = 0;
};

double cpuSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

template <int NP>
Run runCeres(const Case& of_case, const std::vector<Pose>& poses) {
  Run run;
  std::vector<double> p(NP, 0.0);
  const double start = cpuSeconds();
  ceres::Problem::Options keep;
  keep.cost_function_ownership = ceres::TAKE_OWNERSHIP;
  ceres::Problem problem(keep);
  for (const Pose& pose : poses) {
    problem.AddResidualBlock(new ceres::AutoDiffCostFunction<Pose, 3, NP>(new Pose(pose)), nullptr, p.data());
  }
  ceres::Solver::Options options;
  options.linear_solver_type = of_case.parameters > 100 ? ceres::DENSE_NORMAL_CHOLESKY : ceres::DENSE_QR;
  options.max_num_iterations = 30;
  options.function_tolerance = 1e-10;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  run.seconds = cpuSeconds() - start;
  run.rms = std::sqrt(2.0 * summary.final_cost / (3.0 * static_cast<double>(poses.size())));
  run.iterations = static_cast<int>(summary.iterations.size());
  return run;
}

Run runOwn(const Case& of_case) {
  Run run;
  const double start = cpuSeconds();
  const ReadingSet readings = ReadingSet::make(of_case.machine, of_case.files).value();
  Linearisation linearisation(of_case.unknowns, readings);
  FitOptions options;
  options.robust.enabled = false;
  options.estimate_noise = false;
  NoProgress progress;
  const Result<Fit> found = fit(linearisation, of_case.map,
                                MatrixXd::Zero(of_case.parameters, of_case.parameters), options, progress);
  run.seconds = cpuSeconds() - start;
  if (!found) {
    fmt::print("{}\n", found.error().message());
    return run;
  }
  double square = 0.0;
  for (std::size_t row = 0; row < readings.rows(); ++row) {
    const double rest = found->rest[static_cast<Index>(row)] / readings.readings()[row].sigma;
    square += rest * rest;
  }
  run.rms = std::sqrt(square / static_cast<double>(readings.rows()));
  run.iterations = found->linearisations;
  return run;
}

template <int NP>
void compare(const char* name, const Shape& shape, int count, int repetitions) {
  const Case of_case(shape, count);
  if (of_case.parameters != NP) {
    fmt::print("{}: {} parameters, expected {}\n", name, of_case.parameters, NP);
    return;
  }
  const std::vector<Pose> poses = posesOf(of_case);
  std::vector<double> ratios;
  Run own;
  Run ceres;
  for (int i = 0; i < repetitions; ++i) {
    own = runOwn(of_case);
    ceres = runCeres<NP>(of_case, poses);
    ratios.push_back(ceres.seconds / own.seconds);
  }
  std::sort(ratios.begin(), ratios.end());
  fmt::print(
      "| {} | {} x {} | {:.4f} s, {} predictions | {:.3f} s, {} iterations | {:.1f} | {:.9f} | {:.9f} |\n",
      name, NP, count, own.seconds, own.iterations, ceres.seconds, ceres.iterations,
      ratios[ratios.size() / 2], own.rms, ceres.rms);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const int repetitions = argc > 1 ? std::atoi(argv[1]) : 1;
  const int only = argc > 2 ? std::atoi(argv[2]) : 0;
  fmt::print("| row | parameters x poses | nineline | Ceres | ratio (median) | rms nineline | rms Ceres |\n");
  if (only == 0 || only == 1) compare<66>("LS-1", {0, 3, true}, 100000, repetitions);
  if (only == 0 || only == 2) compare<174>("LS-2", {0, 9, true}, 10000, repetitions);
  if (only == 0 || only == 3) compare<66>("LS-3", {0, 3, true}, 1000, repetitions);
  if (only == 0 || only == 4) compare<195>("splines", {12, 0, false}, 100000, repetitions);
  return 0;
}
