#include "tests/core/measurement/set_ups.h"

namespace nineline::measurement {

Measurement measurementAt(const Instrument& instrument, std::vector<Channel> channels,
                          const std::vector<kinematics::JointPositions>& positions) {
  Measurement measurement;
  measurement.source = "test.csv";
  measurement.instrument = instrument;
  measurement.channels = std::move(channels);
  for (const kinematics::JointPositions& q : positions) {
    Sample sample;
    sample.q = q;
    sample.line = 5 + measurement.samples.size();
    measurement.samples.push_back(sample);
  }
  measurement.readings.resize(positions.size() * measurement.channels.size());
  measurement.commanded.assign(kMaxAxes, true);
  return measurement;
}

}  // namespace nineline::measurement
