#include "tests/core/estimation/sample_problem.h"

#include "core/measurement/reading_function.h"

namespace nineline::estimation {

using kinematics::Machine;
using measurement::Channel;
using measurement::InstrumentKind;
using measurement::Quantity;

namespace {

Machine drawMachine(test_support::Random& random) {
  Machine::Description description;
  description.id = "sample";
  kinematics::Joint x;
  x.axis = {'X', 0};
  x.direction = random.unitVector();
  x.offset = random.vector(100.0);
  kinematics::Joint c;
  c.axis = {'C', 0};
  c.type = kinematics::JointType::Rotary;
  c.direction = random.unitVector();
  c.offset = random.vector(100.0);
  kinematics::Joint z;
  z.axis = {'Z', 0};
  z.direction = random.unitVector();
  description.workpiece_chain = {x, c};
  description.tool_chain = {z};
  description.tool_tip = random.vector(200.0);
  return Machine::make(description).value();
}

Measurement newFile(const Machine& machine, InstrumentKind kind, std::vector<Channel> channels) {
  Measurement file;
  file.source = "sample";
  file.instrument.kind = kind;
  file.channels = std::move(channels);
  file.repeatability = 1e-3;
  file.angular_repeatability = 5e-6;
  file.covariates.push_back({"run", {}});
  file.commanded.assign(static_cast<std::size_t>(machine.jointCount()), true);
  return file;
}

void fill(test_support::Random& random, int runs, int targets, Measurement& file) {
  for (int run = 0; run < runs; ++run) {
    for (int i = 0; i < targets; ++i) {
      measurement::Sample sample;
      sample.q[0] = random.between(-100.0, 100.0);
      sample.q[1] = random.between(-1.0, 1.0);
      sample.q[2] = random.between(-100.0, 100.0);
      file.samples.push_back(sample);
      file.covariates.front().values.push_back(run);
      for (std::size_t k = 0; k < file.channels.size(); ++k) file.readings.emplace_back(0.0);
    }
  }
}

errors::SmallMotion along(int row) {
  errors::SmallMotion unit;
  (row < 3 ? unit.translation[row] : unit.rotation[row - 3]) = 1.0;
  return unit;
}

}  // namespace

SampleProblem::SampleProblem(unsigned seed, int runs, int targets)
    : machine([seed] {
        test_support::Random random(seed);
        return drawMachine(random);
      }()) {
  test_support::Random random(seed + 1000);
  files.push_back(newFile(machine, InstrumentKind::Deviation,
                          {Channel{Quantity::DevX}, Channel{Quantity::DevY}, Channel{Quantity::DevZ}}));
  files.push_back(newFile(machine, InstrumentKind::LaserAngular, {Channel{Quantity::Angle}}));
  files.back().instrument.axis = AxisId{'C', 0};
  files.back().instrument.about = 1;
  files.push_back(newFile(machine, InstrumentKind::LaserStraightness, {Channel{Quantity::Length}}));
  files.back().instrument.axis = AxisId{'X', 0};
  files.back().instrument.sensitive = 2;
  for (Measurement& file : files) fill(random, runs, targets, file);
  std::vector<Eigen::Triplet<double>> entries;
  int parameter = 0;
  for (int joint = 0; joint < 3; ++joint) {
    const double spacing = joint == 1 ? 0.5 : 50.0;
    const errors::ErrorTable::Grid grid{-2.0 * spacing, spacing, errors::Interpolation::Cubic, std::nullopt};
    const auto table = std::make_shared<TableBasis>(joint, grid, 5);
    const std::size_t basis = unknowns.addBasis(table);
    for (const int row : {joint, 3 + joint}) {
      if (joint == 2 && row > 2) continue;  // its constant would look like a translation
      const auto slot = joint == 1 && row < 3 ? errors::Slot::Standing : errors::Slot::Moved;
      const int first =
          static_cast<int>(unknowns.blocks()[unknowns.addBlock(joint, slot, along(row), basis)].first);
      for (int node = 0; node < 5; ++node, ++parameter) {
        entries.emplace_back(first + node, parameter, 1.0);
        for (int i = 0; i < 5; ++i) {
          entries.emplace_back(first + 5 + i, parameter, table->curvatures()(i, node));
        }
      }
    }
  }
  const std::size_t constant = unknowns.addBasis(std::make_shared<ConstantBasis>());
  const std::size_t block = unknowns.addBlock(1, errors::Slot::Located, along(5), constant);
  entries.emplace_back(static_cast<int>(unknowns.blocks()[block].first), parameter++, 1.0);
  map.resize(unknowns.size(), parameter);
  map.setFromTriplets(entries.begin(), entries.end());
  truth.resize(parameter);
  for (Index k = 0; k < truth.size(); ++k) truth[k] = random.between(-5e-5, 5e-5);
  setReadings(truth);
}

void SampleProblem::setReadings(const VectorXd& parameters) {
  const VectorXd coefficients = map * parameters;
  std::vector<BasisValues> values(unknowns.bases().size());
  kinematics::JointDisplacements displacements;
  for (Measurement& file : files) {
    const measurement::ReadingFunction function(machine, file.instrument, file.channels);
    const std::vector<MachineState> states = measurement::statesOf(file, machine);
    std::vector<double> readings(file.channels.size());
    for (std::size_t i = 0; i < states.size(); ++i) {
      unknowns.evaluate(states[i], values);
      unknowns.displacements(values, coefficients, displacements);
      function.read(states[i].q, displacements, readings);
      for (std::size_t k = 0; k < readings.size(); ++k) file.readings[i * readings.size() + k] = readings[k];
    }
  }
}

}  // namespace nineline::estimation
