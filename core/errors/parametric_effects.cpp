#include "core/errors/parametric_effects.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"

namespace nineline::errors {

namespace {

constexpr double kReferenceTemperature = 20.0;  // °C, ISO 1
constexpr double kMicrometrePerMetre = 1e-6;

double valueOf(const std::vector<Parameter>& parameters, std::string_view name) {
  const auto found = std::find_if(parameters.begin(), parameters.end(),
                                  [&](const Parameter& one) { return one.name == name; });
  NL_EXPECTS(found != parameters.end(), name);
  return found->value;
}

double lengthOrAngle(bool angular, double shown) { return angular ? radFromArcsec(shown) : mmFromUm(shown); }

}  // namespace

ScalarEffect::ScalarEffect(const kinematics::Machine& machine, int joint, Component component,
                           std::vector<Parameter> parameters)
    : Effect(joint, component, Slot::Moved),
      unit_(unitMotion(machine.joint(joint), component)),
      parameters_(std::move(parameters)) {}

void ScalarEffect::addMotion(const MachineState& state, std::span<const double> memory,
                             SmallMotion& sum) const {
  addScaled(amplitude(state, memory), unit_, sum);
}

void ScalarEffect::addSlope(const MachineState& state, SmallMotion& sum) const {
  addScaled(amplitudeSlope(state), unit_, sum);
}

Json ScalarEffect::toJson(const kinematics::Machine& machine) const {
  Json json = Json::object();
  json.set("effect", id())
      .set("joint", machine.joint(joint()).axis.text())
      .set("component", component().text());
  Json values = Json::object();
  for (const Parameter& parameter : parameters()) {
    Json value = Json::object();
    value.set("value", parameter.value);
    if (parameter.sigma) value.set("sigma", *parameter.sigma);
    values.set(parameter.name, std::move(value.set("unit", parameter.unit)));
  }
  return json.set("parameters", std::move(values));
}

ScaleEffect::ScaleEffect(const kinematics::Machine& machine, int joint, Component component,
                         std::vector<Parameter> parameters)
    : ScalarEffect(machine, joint, component, parameters),
      k_(kMicrometrePerMetre * valueOf(parameters, "k")) {}

double ScaleEffect::amplitude(const MachineState& state, std::span<const double>) const {
  return k_ * position(state);
}

CyclicEffect::CyclicEffect(const kinematics::Machine& machine, int joint, Component component,
                           std::vector<Parameter> parameters)
    : ScalarEffect(machine, joint, component, parameters),
      amplitude_(lengthOrAngle(component.isAngular(), valueOf(parameters, "amplitude"))),
      wave_number_(kTurn / (machine.isRotary(joint) ? radFromDeg(valueOf(parameters, "period"))
                                                    : valueOf(parameters, "period"))),
      phase_(radFromDeg(valueOf(parameters, "phase"))) {}

double CyclicEffect::featureLength() const { return kTurn / std::abs(wave_number_) / 8.0; }

double CyclicEffect::amplitude(const MachineState& state, std::span<const double>) const {
  return amplitude_ * std::sin(wave_number_ * position(state) + phase_);
}

double CyclicEffect::amplitudeSlope(const MachineState& state) const {
  return amplitude_ * wave_number_ * std::cos(wave_number_ * position(state) + phase_);
}

BacklashEffect::BacklashEffect(const kinematics::Machine& machine, int joint, Component component,
                               std::vector<Parameter> parameters)
    : ScalarEffect(machine, joint, component, parameters),
      width_(lengthOrAngle(component.isAngular(), valueOf(parameters, "width"))) {}

double BacklashEffect::amplitude(const MachineState& state, std::span<const double> memory) const {
  if (!memory.empty()) return memory[0];
  return -0.5 * width_ * state.approach[static_cast<std::size_t>(joint())];
}

double BacklashEffect::play() const { return std::abs(width_); }

void BacklashEffect::start(const MachineState& state, std::span<double> memory) const {
  memory[0] = amplitude(state, {});
}

void BacklashEffect::advance(const MachineState& from, const MachineState& to,
                             std::span<double> memory) const {
  const auto k = static_cast<std::size_t>(joint());
  if (from.approach[k] == 0) {  // nothing is known of the past: the first motion finds the play taken up
    memory[0] = amplitude(to, {});
    return;
  }
  // The offset follows the command backwards until an edge of the band is reached. A negative width is a
  // control that over-compensates: the mirror image.
  const double sense = width_ < 0.0 ? -1.0 : 1.0;
  const double half = 0.5 * std::abs(width_);
  memory[0] = sense * std::clamp(sense * memory[0] + position(from) - position(to), -half, half);
}

ThermalScrewEffect::ThermalScrewEffect(const kinematics::Machine& machine, int joint, Component component,
                                       std::vector<Parameter> parameters, std::string sensor)
    : ScalarEffect(machine, joint, component, parameters),
      k_(kMicrometrePerMetre * valueOf(parameters, "k")),
      fixed_(machine.isRotary(joint) ? radFromDeg(valueOf(parameters, "q_fixed"))
                                     : valueOf(parameters, "q_fixed")),
      sensor_(std::move(sensor)) {}

double ThermalScrewEffect::amplitudeSlope(const MachineState& state) const {
  const std::optional<double> temperature = state.condition(sensor_);
  return temperature ? k_ * (*temperature - kReferenceTemperature) : 0.0;
}

double ThermalScrewEffect::amplitude(const MachineState& state, std::span<const double>) const {
  return amplitudeSlope(state) * (position(state) - fixed_);
}

Json ThermalScrewEffect::toJson(const kinematics::Machine& machine) const {
  Json json = ScalarEffect::toJson(machine);
  return json.set("sensor", sensor_);
}

}  // namespace nineline::errors
