#include "core/identification/next_measurement.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/units.h"

namespace nineline::identification {

using estimation::Linearisation;
using estimation::ReadingSet;
using measurement::Channel;
using measurement::Instrument;
using measurement::InstrumentKind;
using measurement::Quantity;

namespace {

constexpr double kLever = 100.0;  // mm, from the axis or the first line to a point beside it
constexpr int kTargets = 11;
constexpr double kLeastGain = 1.0;  // nats: less is not worth a set-up
constexpr std::string_view kLetters = "XYZ";

Measurement planned(const Machine& machine, InstrumentKind kind, Quantity quantity) {
  Measurement plan;
  plan.source = "plan";
  plan.machine_id = machine.id();
  plan.instrument.kind = kind;
  plan.channels = {Channel{quantity}};
  plan.commanded.assign(static_cast<std::size_t>(machine.jointCount()), true);
  return plan;
}

void addSample(const kinematics::JointPositions& q, Measurement& plan) {
  measurement::Sample sample;
  sample.q = q;
  plan.samples.push_back(sample);
  for (std::size_t k = 0; k < plan.channels.size(); ++k) plan.readings.emplace_back(0.0);
}

/// Forth and back over what was measured.
void driveAlong(const ReadingSet& readings, int joint, Measurement& plan) {
  const JointPositionsSeen seen = positionsSeen(readings, joint);
  kinematics::JointPositions q{};
  for (int i = 0; i < 2 * kTargets; ++i) {
    const int step = i < kTargets ? i : 2 * kTargets - 1 - i;
    q[static_cast<std::size_t>(joint)] = seen.low + (seen.high - seen.low) * step / (kTargets - 1);
    addSample(q, plan);
  }
}

class Setups {
 public:
  explicit Setups(const ReadingSet& readings) : readings_(readings), machine_(readings.machine()) {}

  std::vector<FeasibleSetup> build() {
    for (int joint = 0; joint < machine_.jointCount(); ++joint) {
      if (!positionsSeen(readings_, joint).moves) continue;
      if (machine_.isRotary(joint)) {
        addRotary(joint);
      } else {
        addLinear(joint);
      }
    }
    addCircles();
    return std::move(setups_);
  }

 private:
  void add(int joint, InstrumentKind kind, const Eigen::Vector3d& point, int direction) {
    const bool angular = kind == InstrumentKind::LaserAngular;
    Measurement plan = planned(machine_, kind, angular ? Quantity::Angle : Quantity::Length);
    plan.instrument.axis = machine_.joint(joint).axis;
    plan.instrument.point = point;
    plan.instrument.sensitive = plan.instrument.about = direction;
    driveAlong(readings_, joint, plan);
    const std::string axis = machine_.joint(joint).axis.text();
    std::string text = fmt::format("{} of {}", measurement::nameOf(kind), axis);
    if (kind != InstrumentKind::LaserLinear) {
      text += fmt::format(" {} {}", angular ? "about" : "in",
                          kLetters.substr(static_cast<std::size_t>(direction), 1));
    }
    if (!angular) text += fmt::format(" at the point {:.0f} {:.0f} {:.0f}", point.x(), point.y(), point.z());
    setups_.push_back({std::move(text), std::move(plan)});
  }

  void addLinear(int joint) {
    Index own = 0;
    machine_.joint(joint).direction.cwiseAbs().maxCoeff(&own);
    for (int corner = 0; corner < 3; ++corner) {
      Eigen::Vector3d point = Eigen::Vector3d::Zero();
      if (corner > 0) point[(own + corner) % 3] = kLever;
      add(joint, InstrumentKind::LaserLinear, point, static_cast<int>(own));
      for (int other = 1; other < 3; ++other) {
        add(joint, InstrumentKind::LaserStraightness, point, static_cast<int>((own + other) % 3));
      }
    }
    for (int about = 0; about < 3; ++about) {
      add(joint, InstrumentKind::LaserAngular, Eigen::Vector3d::Zero(), about);
    }
  }

  void addRotary(int joint) {
    Index own = 0;
    machine_.joint(joint).direction.cwiseAbs().maxCoeff(&own);
    for (int about = 0; about < 3; ++about) {
      add(joint, InstrumentKind::LaserAngular, Eigen::Vector3d::Zero(), about);
    }
    for (const double height : {0.0, kLever}) {
      for (int sensitive = 0; sensitive < 3; ++sensitive) {
        add(joint, InstrumentKind::Dial, height * Eigen::Vector3d::Unit(own), sensitive);
      }
    }
  }

  /// Circles in the planes of two linear joints, about the middle of what was measured.
  void addCircles() {
    for (int a = 0; a < machine_.jointCount(); ++a) {
      for (int b = a + 1; b < machine_.jointCount(); ++b) {
        if (machine_.isRotary(a) || machine_.isRotary(b)) continue;
        const JointPositionsSeen one = positionsSeen(readings_, a);
        const JointPositionsSeen two = positionsSeen(readings_, b);
        if (!one.moves || !two.moves) continue;
        addCircle(a, b, one, two);
      }
    }
  }

  void addCircle(int a, int b, const JointPositionsSeen& one, const JointPositionsSeen& two) {
    Measurement plan = planned(machine_, InstrumentKind::Ballbar, Quantity::Radius);
    const double radius = 0.45 * std::min(one.high - one.low, two.high - two.low);
    kinematics::JointPositions q{};
    const auto stand = [&](double u, double v) {
      q[static_cast<std::size_t>(a)] = 0.5 * (one.low + one.high) + u;
      q[static_cast<std::size_t>(b)] = 0.5 * (two.low + two.high) + v;
    };
    stand(0.0, 0.0);
    plan.instrument.centre = kinematics::forward(machine_, q).tip;
    plan.instrument.radius = radius;
    for (int i = 0; i < 72; ++i) {
      stand(radius * std::cos(kTurn * i / 72), radius * std::sin(kTurn * i / 72));
      addSample(q, plan);
    }
    setups_.push_back({fmt::format("ballbar in the plane of {} and {}, radius {:.0f} mm",
                                   machine_.joint(a).axis.text(), machine_.joint(b).axis.text(), radius),
                       std::move(plan)});
  }

  const ReadingSet& readings_;
  const Machine& machine_;
  std::vector<FeasibleSetup> setups_;
};

/// What a measurement would say of the parameters.
Result<MatrixXd> informationOf(const Machine& machine, const ParameterSet& parameters,
                               std::span<const Measurement> measurements) {
  const Result<ReadingSet> readings = ReadingSet::make(machine, measurements);
  if (!readings) return readings.error();
  Linearisation linearisation(parameters.unknowns, *readings);
  NoProgress progress;
  if (Result<void> done = linearisation.at(VectorXd::Zero(parameters.unknowns.size()), true, progress);
      !done) {
    return done.error();
  }
  const VectorXd weights = VectorXd::Ones(static_cast<Index>(readings->rows()));
  const estimation::NormalSums sums = estimation::normalSums(linearisation, weights).reduced(parameters.map);
  return estimation::information(*readings, sums, estimation::usualNoise(*readings));
}

std::vector<std::string> newlyTold(const ParameterSet& parameters,
                                   const std::vector<estimation::Telling>& before,
                                   const std::vector<estimation::Telling>& after) {
  std::vector<std::string> names;
  for (std::size_t c = 0; c < after.size(); ++c) {
    const NamedChunk& chunk = parameters.names[c];
    if (!after[c].told || before[c].told || chunk.conventional || chunk.part == Part::Play) continue;
    if (std::find(names.begin(), names.end(), chunk.name) == names.end()) names.push_back(chunk.name);
  }
  return names;
}

}  // namespace

std::vector<FeasibleSetup> feasibleSetups(const ReadingSet& readings) { return Setups(readings).build(); }

std::vector<ProposedMeasurement> proposeMeasurements(const ReadingSet& readings, const KnotSearch& search,
                                                     std::size_t count) {
  const ParameterSet& parameters = search.parameters;
  std::vector<FeasibleSetup> setups = feasibleSetups(readings);
  std::vector<MatrixXd> information;
  for (const FeasibleSetup& setup : setups) {
    const Result<MatrixXd> one =
        informationOf(readings.machine(), parameters, std::span(&setup.measurement, 1));
    information.push_back(one ? *one : MatrixXd::Zero(parameters.map.cols(), parameters.map.cols()));
  }
  std::vector<ProposedMeasurement> proposals;
  const auto before = estimation::tellApart(search.information, parameters.plausible, parameters.chunks);
  std::vector<estimation::Telling> told = before;
  MatrixXd known = search.information;
  for (const estimation::SetupGain& gain :
       estimation::chooseSetups(known, information, parameters.plausible, estimation::Criterion::D, count)) {
    if (gain.d_gain < kLeastGain) break;
    known += information[gain.setup];
    const auto after = estimation::tellApart(known, parameters.plausible, parameters.chunks);
    std::vector<std::string> names = newlyTold(parameters, told, after);
    if (names.empty()) continue;
    proposals.push_back({setups[gain.setup].text, gain.d_gain, std::move(names)});
    told = after;
  }
  return proposals;
}

Result<PlanReport> judgePlan(const Machine& machine, std::span<const Measurement> planned_files) {
  std::vector<Measurement> files(planned_files.begin(), planned_files.end());
  for (Measurement& file : files) {
    file.readings.assign(file.samples.size() * file.channels.size(), 0.0);
  }
  const Result<ReadingSet> readings = ReadingSet::make(machine, files);
  if (!readings) return readings.error();
  const ParameterSet parameters = makeParameters(*readings, {});
  Result<MatrixXd> information = informationOf(machine, parameters, files);
  if (!information) return information.error();
  const auto tellings = estimation::tellApart(*information, parameters.plausible, parameters.chunks);
  std::vector<Index> asked;
  PlanReport report;
  for (std::size_t c = 0; c < tellings.size(); ++c) {
    const NamedChunk& chunk = parameters.names[c];
    if (chunk.conventional && !tellings[c].told) continue;
    const std::vector<Index>& of_chunk = parameters.chunks[c].parameters;
    asked.insert(asked.end(), of_chunk.begin(), of_chunk.end());
    if (tellings[c].told &&
        std::find(report.told.begin(), report.told.end(), chunk.name) == report.told.end()) {
      report.told.push_back(chunk.name);
    }
  }
  listUnobservable(parameters, tellings, report.unobservable);
  report.quality = estimation::qualityOf((*information)(asked, asked), parameters.plausible(asked));
  return report;
}

}  // namespace nineline::identification
