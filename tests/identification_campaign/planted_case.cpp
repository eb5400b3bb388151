#include "tests/identification_campaign/planted_case.h"

#include <array>
#include <cmath>

#include "core/base/units.h"
#include "core/errors/effect_catalogue.h"
#include "core/errors/table_effects.h"
#include "core/kinematics/machine_file.h"
#include "core/measurement/prediction.h"

namespace nineline::identification_campaign {

using errors::Component;
using errors::EffectPtr;
using errors::ErrorTable;
using kinematics::JointPositions;
using kinematics::Machine;
using measurement::Channel;
using measurement::InstrumentKind;
using measurement::Quantity;

namespace {

constexpr std::array<const char*, 4> kMachines{"b2-k3032", "generic-3axis", "trunnion-ac", "rotary-table"};
constexpr int kTurnTargets = 12;

/// Targets of one joint; 0 is one of them.
struct Targets {
  double start = 0.0;
  double spacing = 1.0;
  int count = 0;
  bool closed = false;
  [[nodiscard]] double at(int i) const { return start + spacing * i; }
};

class Planter {
 public:
  Planter(unsigned seed, int kind, int runs, const NoisePlan* noise)
      : random_(seed), runs_(runs), noise_(noise), machine_(drawMachine(kind)) {}

  PlantedCase plant() {
    for (int joint = 0; joint < machine_.jointCount(); ++joint) targets_.push_back(targetsOf(joint));
    for (int joint = 0; joint < machine_.jointCount(); ++joint) plantJoint(joint);
    PlantedCase result{machine_, errors::ErrorModel::make(machine_, effects_).value(), {}, 0};
    for (int joint = 0; joint < machine_.jointCount(); ++joint) measureJoint(joint);
    measurePoses();
    for (Measurement& file : files_) read(result.truth, file);
    result.files = std::move(files_);
    result.outliers = outliers_;
    return result;
  }

 private:
  Machine drawMachine(int kind) {
    Machine::Description description =
        kinematics::findBuiltInMachine(kMachines[static_cast<std::size_t>(kind)])->description();
    for (auto* chain : {&description.workpiece_chain, &description.tool_chain}) {
      for (kinematics::Joint& joint : *chain) joint.offset += random_.vector(80.0);
    }
    description.tool_tip += random_.vector(60.0);
    description.id = "planted";
    return Machine::make(description).value();
  }

  [[nodiscard]] Targets targetsOf(int joint) {
    if (machine_.joint(joint).continuous) return {0.0, kTurn / kTurnTargets, kTurnTargets, true};
    if (machine_.isRotary(joint)) return {-1.2, 0.3, 9, false};
    const int count = random_.whole(7, 10);
    return {-40.0 * random_.whole(1, 4), 40.0, count, false};
  }

  /// A few waves, 2 to 8 µm or 1 to 4 arcsec.
  std::vector<double> wave(const Targets& targets, double size) {
    std::vector<double> values(static_cast<std::size_t>(targets.count), 0.0);
    for (int order = 1; order <= 3; ++order) {
      const double amplitude = random_.between(0.3, 1.0) * size;
      const double phase = random_.between(0.0, kTurn);
      for (int i = 0; i < targets.count; ++i) {
        const double turn = targets.closed ? order * targets.at(i) : order * 2.5 * i / targets.count;
        values[static_cast<std::size_t>(i)] += amplitude * std::sin(turn + phase);
      }
    }
    return values;
  }

  void subtract(const std::vector<double>& pattern, std::vector<double>& values) const {
    double product = 0.0;
    double square = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      product += pattern[i] * values[i];
      square += pattern[i] * pattern[i];
    }
    for (std::size_t i = 0; i < values.size(); ++i) values[i] -= product / square * pattern[i];
  }

  /// Linear joint: value 0 at position 0; straightness with mean slope 0.
  void gaugeLinear(const Targets& targets, bool lateral, std::vector<double>& values) const {
    if (lateral) {
      std::vector<double> slope;
      for (int i = 0; i < targets.count; ++i) slope.push_back(i - 0.5 * (targets.count - 1));
      subtract(slope, values);
    }
    const auto datum = static_cast<std::size_t>(std::lround(-targets.start / targets.spacing));
    const double at_datum = values[datum];
    for (double& value : values) value -= at_datum;
  }

  /// Rotary joint: no mean and no first harmonic, but the second harmonic of the standing frame.
  void gaugeRotary(const Targets& targets, std::vector<double>& values) const {
    // Three vectors that are not orthogonal where the turn is not whole: by repeated projection.
    for (int pass = 0; pass < 400; ++pass) {
      for (const double phase : {0.0, 0.25 * kTurn}) {
        std::vector<double> pattern;
        for (int i = 0; i < targets.count; ++i) pattern.push_back(std::cos(targets.at(i) - phase));
        subtract(pattern, values);
      }
      subtract(std::vector<double>(values.size(), 1.0), values);
    }
  }

  void plantJoint(int joint) {
    const auto j = static_cast<std::size_t>(joint);
    const AxisId axis = machine_.joint(joint).axis;
    const Component own = errors::positioningOf(machine_.joint(joint));
    const bool rotary = machine_.isRotary(joint);
    for (int row = 0; row < 6; ++row) {
      std::vector<double> values = wave(targets_[j], row < 3 ? 4e-3 : 1e-5);
      if (rotary) {
        gaugeRotary(targets_[j], values);
      } else {
        gaugeLinear(targets_[j], row < 3 && row != own.row, values);
      }
      ErrorTable::Grid grid{targets_[j].start, targets_[j].spacing, errors::Interpolation::Cubic,
                            std::nullopt};
      if (targets_[j].closed) grid.period = kTurn;
      effects_.push_back(std::make_shared<errors::TableEffect>(
          joint, Component{axis, row, false}, ErrorTable::make(grid, std::move(values)).value(), false));
    }
    for (int k = 1; k < 3; ++k) {
      const int row = (own.row + k) % 3;
      plantLocation(joint, row + 3, 3e-5);
      if (rotary) plantLocation(joint, row, 0.02);
    }
    if (!rotary) plantBacklash(joint);
  }

  void plantLocation(int joint, int row, double size) {
    effects_.push_back(std::make_shared<errors::LocationEffect>(
        joint, Component{machine_.joint(joint).axis, row, true}, random_.between(-size, size), std::nullopt));
  }

  void plantBacklash(int joint) {
    Json width = Json::object();
    width.set("value", random_.between(3.0, 8.0)).set("unit", "um");
    Json parameters = Json::object();
    parameters.set("width", std::move(width));
    Json json = Json::object();
    json.set("effect", "backlash")
        .set("joint", machine_.joint(joint).axis.text())
        .set("parameters", std::move(parameters));
    effects_.push_back(errors::effectFromJson(json, "planted", 1, machine_).value());
  }

  Measurement newFile(InstrumentKind kind, std::vector<Channel> channels) {
    Measurement file;
    file.source = "planted-" + std::to_string(files_.size());
    file.machine_id = machine_.id();
    file.instrument.kind = kind;
    file.channels = std::move(channels);
    file.covariates.push_back({"run", {}});
    file.commanded.assign(static_cast<std::size_t>(machine_.jointCount()), true);
    return file;
  }

  static void addSample(const JointPositions& q, int run, Measurement& file) {
    measurement::Sample sample;
    sample.q = q;
    file.samples.push_back(sample);
    file.covariates.front().values.push_back(run);
    for (std::size_t k = 0; k < file.channels.size(); ++k) file.readings.emplace_back(0.0);
  }

  /// Every target forward and backward, in every run.
  void driveTargets(int joint, Measurement& file) {
    const auto j = static_cast<std::size_t>(joint);
    const Targets& targets = targets_[j];
    for (int run = 1; run <= runs_; ++run) {
      for (int i = 0; i < 2 * targets.count; ++i) {
        JointPositions q{};
        q[j] = targets.at(i < targets.count ? i : 2 * targets.count - 1 - i);
        addSample(q, run, file);
      }
    }
  }

  void addTest(int joint, InstrumentKind kind, const Eigen::Vector3d& point, int direction) {
    const bool angular = kind == InstrumentKind::LaserAngular;
    Measurement file = newFile(kind, {Channel{angular ? Quantity::Angle : Quantity::Length}});
    file.instrument.axis = machine_.joint(joint).axis;
    file.instrument.point = point;
    file.instrument.sensitive = file.instrument.about = direction;
    driveTargets(joint, file);
    files_.push_back(std::move(file));
  }

  void measureJoint(int joint) {
    const int own = errors::positioningOf(machine_.joint(joint)).row % 3;
    const int b = (own + 1) % 3;
    const int c = (own + 2) % 3;
    const Eigen::Vector3d r0 = random_.vector(50.0);
    if (machine_.isRotary(joint)) {
      for (int about = 0; about < 3; ++about) addTest(joint, InstrumentKind::LaserAngular, r0, about);
      const Eigen::Vector3d upper = r0 + 200.0 * Eigen::Vector3d::Unit(own);
      for (const int sensitive : {own, b, c}) addTest(joint, InstrumentKind::Dial, r0, sensitive);
      for (const int sensitive : {b, c}) addTest(joint, InstrumentKind::Dial, upper, sensitive);
      return;
    }
    const Eigen::Vector3d rb = r0 + random_.between(150.0, 300.0) * Eigen::Vector3d::Unit(b);
    const Eigen::Vector3d rc = r0 + random_.between(150.0, 300.0) * Eigen::Vector3d::Unit(c);
    for (const Eigen::Vector3d& point : {r0, rb, rc}) addTest(joint, InstrumentKind::LaserLinear, point, own);
    for (const Eigen::Vector3d& point : {r0, rb}) {
      for (const int sensitive : {b, c}) addTest(joint, InstrumentKind::LaserStraightness, point, sensitive);
    }
    if (random_.whole(0, 1) == 1) {
      for (int about = 0; about < 3; ++about) addTest(joint, InstrumentKind::LaserAngular, r0, about);
    }
  }

  void measurePoses() {
    Measurement file = newFile(InstrumentKind::Deviation,
                               {Channel{Quantity::DevX}, Channel{Quantity::DevY}, Channel{Quantity::DevZ},
                                Channel{Quantity::RotX}, Channel{Quantity::RotY}, Channel{Quantity::RotZ}});
    for (int run = 1; run <= 2 * runs_; ++run) {
      for (int i = 0; i < 40; ++i) {
        JointPositions q{};
        for (std::size_t j = 0; j < targets_.size(); ++j) {
          const Targets& targets = targets_[j];
          q[j] = random_.between(targets.at(0), targets.at(targets.count - (targets.closed ? 0 : 1)));
        }
        addSample(q, run, file);
      }
    }
    files_.push_back(std::move(file));
  }

  void read(const errors::ErrorModel& truth, Measurement& file) {
    const measurement::Prediction prediction = measurement::predict(truth, file).value();
    const double share = noise_ == nullptr ? 0.0 : random_.between(0.5, 1.5);
    const double total = noise_ == nullptr ? 0.0 : share * std::hypot(1.0, noise_->run_offset);
    if (noise_ != nullptr && noise_->stated) {
      file.repeatability = noise_->length * total;
      file.angular_repeatability = noise_->angle * total;
    }
    std::vector<double> offsets(file.channels.size(), 0.0);
    std::optional<double> run;
    std::vector<double> zeros;
    for (std::size_t k = 0; k < file.channels.size(); ++k) {
      zeros.push_back(file.instrument.hasZero() ? random_.between(-0.01, 0.01) : 0.0);
    }
    for (std::size_t row = 0; row < prediction.rows.size(); ++row) {
      const measurement::ReadingRow& place = prediction.rows[row];
      double& reading = *file.readings[place.sample * file.channels.size() + place.channel];
      const bool angular = file.channels[place.channel].isAngular();
      reading =
          prediction.readings[static_cast<Eigen::Index>(row)] + zeros[place.channel] * (angular ? 1e-3 : 1.0);
      if (noise_ == nullptr) continue;
      if (file.run(place.sample) != run) {
        run = file.run(place.sample);
        for (double& offset : offsets) offset = noise_->run_offset * normal(random_);
      }
      const double sigma = share * (angular ? noise_->angle : noise_->length);
      reading += sigma * (normal(random_) + offsets[place.channel]);
      if (random_.between(0.0, 1.0) < noise_->outliers) {
        reading += sigma * random_.between(10.0, 40.0) * (random_.whole(0, 1) == 1 ? 1.0 : -1.0);
        ++outliers_;
      }
    }
  }

  Random random_;
  int runs_;
  const NoisePlan* noise_;
  Machine machine_;
  std::vector<Targets> targets_;
  std::vector<EffectPtr> effects_;
  std::vector<Measurement> files_;
  std::size_t outliers_ = 0;
};

}  // namespace

double normal(Random& random) {
  const double u = 1.0 - random.between(0.0, 1.0);
  return std::sqrt(-2.0 * std::log(u)) * std::cos(random.between(0.0, kTurn));
}

const char* kindName(int kind) { return kMachines[static_cast<std::size_t>(kind)]; }

PlantedCase plantCase(unsigned seed, int kind, int runs, const NoisePlan* noise) {
  return Planter(seed, kind, runs, noise).plant();
}

}  // namespace nineline::identification_campaign
