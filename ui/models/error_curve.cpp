#include "ui/models/error_curve.h"

#include "core/base/units.h"
#include "core/errors/effect_catalogue.h"

namespace nineline::models {

namespace {
constexpr std::size_t kSamplesPerSegment = 12;
constexpr std::size_t kMostSamples = 4000;
}  // namespace

SampledCurve sampleTable(const kinematics::Machine& machine, const errors::Component& component,
                         const Json& entry) {
  SampledCurve curve;
  const Result<errors::EffectPtr> effect = errors::effectFromJson(entry, "", 1, machine);
  if (!effect || (*effect)->table() == nullptr) return curve;
  const errors::ErrorTable& table = *(*effect)->table();
  const bool rotary = machine.isRotary(machine.find(component.axis));
  const double start = table.grid().start;
  const double length = table.end() - start;
  const std::size_t count = std::min(table.values().size() * kSamplesPerSegment, kMostSamples);
  for (std::size_t i = 0; i <= count; ++i) {
    const double q = start + length * static_cast<double>(i) / static_cast<double>(count);
    const double value = table.value(q);
    curve.x.push_back(rotary ? degFromRad(q) : q);
    curve.y.push_back(component.isAngular() ? arcsecFromRad(value) : umFromMm(value));
  }
  return curve;
}

}  // namespace nineline::models
