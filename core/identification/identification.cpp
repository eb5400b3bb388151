#include "core/identification/identification.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/identification/found_effects.h"
#include "core/identification/knot_search.h"
#include "core/identification/next_measurement.h"

namespace nineline::identification {

using estimation::Fit;
using estimation::ReadingPlace;
using estimation::ReadingSet;

std::string Unobservable::text() const {
  const bool is_whole = parts.size() > 1 || parts.empty() || parts.front() == "location";
  std::string what = is_whole ? name : fmt::format("{} ({})", name, parts.front());
  if (partners.empty()) return what + ": no reading depends on it.";
  std::string others;
  for (std::size_t i = 0; i < partners.size(); ++i) {
    others += (i == 0 ? "" : i + 1 == partners.size() ? " and " : ", ") + partners[i];
  }
  return fmt::format("{}: the readings cannot tell it from {}.", what, others);
}

void listUnobservable(const ParameterSet& parameters, const std::vector<estimation::Telling>& tellings,
                      std::vector<Unobservable>& list) {
  for (std::size_t c = 0; c < tellings.size(); ++c) {
    const NamedChunk& chunk = parameters.names[c];
    if (tellings[c].told || chunk.conventional || chunk.part == Part::Play) continue;
    auto known = std::find_if(list.begin(), list.end(),
                              [&](const Unobservable& one) { return one.name == chunk.name; });
    if (known == list.end()) {
      known = list.insert(list.end(), Unobservable{chunk.name, {}, {}});
    }
    const std::string part(nameOf(chunk.part));
    if (std::find(known->parts.begin(), known->parts.end(), part) == known->parts.end()) {
      known->parts.push_back(part);
    }
    for (const std::size_t partner : tellings[c].partners) {
      const std::string& name = parameters.names[partner].name;
      if (name != chunk.name &&
          std::find(known->partners.begin(), known->partners.end(), name) == known->partners.end()) {
        known->partners.push_back(name);
      }
    }
  }
}

namespace {
constexpr std::size_t kProposals = 6;
}

double NoiseFound::repeatability() const { return std::hypot(within_run, run_offset); }

namespace {

struct Pooled {
  double square = 0.0;
  double count = 0.0;
  [[nodiscard]] std::optional<double> root() const {
    if (count <= 0.0) return std::nullopt;
    return std::sqrt(square / count);
  }
};

void fillNoise(const ReadingSet& readings, const Fit& fit, IdentificationReport& report) {
  std::vector<Pooled> sigma(readings.classes().size());
  std::array<Pooled, 2> residual;
  for (std::size_t row = 0; row < readings.rows(); ++row) {
    const ReadingPlace& reading = readings.readings()[row];
    const std::size_t noise = readings.noiseOf(row);
    sigma[noise].square += reading.sigma * reading.sigma;
    sigma[noise].count += 1.0;
    if (fit.weights[static_cast<Index>(row)] <= 0.0) continue;
    const double rest = fit.rest[static_cast<Index>(row)] + fit.offsets[static_cast<Index>(reading.group)];
    Pooled& pool = residual[readings.classes()[noise].angular ? 1 : 0];
    pool.square += rest * rest;
    pool.count += 1.0;
  }
  std::array<Pooled, 2> repeatability;
  for (std::size_t c = 0; c < sigma.size(); ++c) {
    const estimation::NoiseClass& noise = readings.classes()[c];
    const double white = fit.noise.scale[c] * sigma[c].root().value_or(0.0);
    const double offset = white * std::sqrt(fit.noise.ratio[c]);
    report.noise.push_back({std::string(measurement::nameOf(noise.kind)), noise.angular,
                            static_cast<std::size_t>(sigma[c].count), white, offset});
    Pooled& pool = repeatability[noise.angular ? 1 : 0];
    pool.square += sigma[c].count * (white * white + offset * offset);
    pool.count += sigma[c].count;
  }
  report.residual_rms = residual[0].root().value_or(0.0);
  report.angular_residual_rms = residual[1].root();
  report.repeatability = repeatability[0].root();
  report.angular_repeatability = repeatability[1].root();
}

void fillOutliers(const ReadingSet& readings, const Fit& fit, IdentificationReport& report) {
  for (std::size_t row = 0; row < readings.rows(); ++row) {
    if (fit.weights[static_cast<Index>(row)] > 0.0) continue;
    const ReadingPlace& reading = readings.readings()[row];
    const estimation::SamplePlace& place = readings.samples()[reading.sample];
    const Measurement& file = readings.files()[place.file];
    const double sigma = fit.noise.scale[readings.noiseOf(row)] * reading.sigma;
    report.outliers.push_back({place.file, file.samples[place.index].line,
                               file.channels[reading.channel].column(),
                               std::abs(fit.rest[static_cast<Index>(row)]) / sigma});
  }
}

Result<ReadingSet> prepare(const Machine& machine, std::span<const Measurement> measurements) {
  if (measurements.empty()) return badInput("identify.files", "There is no measurement to identify from.");
  Result<ReadingSet> readings = ReadingSet::make(machine, measurements);
  if (readings && readings->rows() == 0) {
    return badInput("identify.empty", "The measurements hold no reading at a known position.",
                    measurements.front().source);
  }
  return readings;
}

}  // namespace

Result<IdentificationReport> identify(const Machine& machine, std::span<const Measurement> measurements,
                                      const IdentificationOptions& options, Progress& progress) {
  Result<ReadingSet> readings = prepare(machine, measurements);
  if (!readings) return readings.error();
  progress.report(0.0, "Identify");
  Result<KnotSearch> found = searchKnots(*readings, options, progress);
  if (!found) return found.error();
  const ParameterSet& parameters = found->parameters;
  IdentificationReport report;
  report.readings = readings->rows();
  report.parameters = static_cast<std::size_t>(found->selection.size());
  report.condition_number = found->fit.condition_number;
  listUnobservable(parameters, found->tellings, report.unobservable);
  fillNoise(*readings, found->fit, report);
  fillOutliers(*readings, found->fit, report);
  Result<errors::ErrorModel> model = modelOf(*readings, *found, options.when, report.coverage);
  if (!model) return model.error();
  report.model = std::move(*model);
  if (options.propose) {
    progress.report(0.9, "Look for the next measurement");
    report.proposals = proposeMeasurements(*readings, *found, kProposals);
  }
  progress.report(1.0, "Identify");
  return report;
}

}  // namespace nineline::identification
