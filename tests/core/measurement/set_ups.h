#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "core/errors/error_model_file.h"
#include "core/measurement/measurement.h"
#include "tests/support/random_machines.h"

namespace nineline::measurement {

/// A model file's effects on a built-in machine.
inline errors::ErrorModel modelOf(const std::string& machine, const std::string& effects) {
  const Result<errors::ErrorModel> model = errors::readErrorModel(
      R"({"format": "nineline-model/1", "machine": ")" + machine + R"(", "effects": [)" + effects + "]}",
      "test");
  if (!model) throw std::runtime_error(model.error().message());
  return *model;
}

/// A table of one constant value.
inline std::string constantUm(const std::string& component, double value_um, const std::string& more = "") {
  return R"({"effect": "table", "component": ")" + component +
         R"(", "start_mm": 0, "spacing_mm": 10, "values_um": [)" + std::to_string(value_um) + "]" + more +
         "}";
}

inline std::string constantArcsec(const std::string& component, double value_arcsec,
                                  const std::string& more = "") {
  return R"({"effect": "table", "component": ")" + component +
         R"(", "start_mm": 0, "spacing_mm": 10, "values_arcsec": [)" + std::to_string(value_arcsec) + "]" +
         more + "}";
}

inline std::string locationArcsec(const std::string& component, double value_arcsec) {
  return R"({"effect": "location", "component": ")" + component + R"(", "value_arcsec": )" +
         std::to_string(value_arcsec) + "}";
}

/// A measurement without readings at these positions.
Measurement measurementAt(const Instrument& instrument, std::vector<Channel> channels,
                          const std::vector<kinematics::JointPositions>& positions);

inline void addColumn(Measurement& measurement, const std::string& column,
                      const std::vector<std::optional<double>>& values) {
  measurement.covariates.push_back({column, values});
}

/// Every instrument that fits a machine, with all its channels, set up at random.
inline std::vector<Measurement> everyInstrument(test_support::Random& random,
                                                const kinematics::Machine& machine) {
  std::vector<Measurement> all;
  std::vector<kinematics::JointPositions> positions;
  for (int i = 0; i < 4; ++i) positions.push_back(test_support::randomPositions(random, machine));
  for (const std::string_view name : instrumentNames()) {
    Instrument instrument;
    instrument.kind = *parseInstrumentKind(name);
    const int joint = random.whole(0, machine.jointCount() - 1);
    const bool rotary = machine.isRotary(joint);
    if (instrument.kind == InstrumentKind::LaserLinear && rotary) continue;
    if (instrument.needsAxis()) instrument.axis = machine.joint(joint).axis;
    instrument.point = random.vector(200.0);
    instrument.sensitive = random.whole(0, 2);
    instrument.about = random.whole(0, 2);
    instrument.centre = random.vector(500.0);
    instrument.radius = 100.0;
    instrument.pitch = 6.0;
    instrument.starts = random.whole(1, 3);
    instrument.left_hand = random.whole(0, 1) == 1;
    std::vector<Channel> channels;
    for (const std::string& column : channelColumns(instrument.kind, rotary)) {
      channels.push_back(*parseChannel(column, instrument.kind, rotary));
    }
    all.push_back(measurementAt(instrument, channels, positions));
  }
  return all;
}

}  // namespace nineline::measurement
