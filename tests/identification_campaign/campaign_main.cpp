// nineline_identification_campaign FIRST_SEED COUNT [KIND]: plants, measures, identifies, and prints the
// coverage of the stated uncertainties. KIND 0…3 restricts it to one machine.
#include <fmt/format.h>

#include <array>
#include <chrono>
#include <cstdlib>

#include "tests/identification_campaign/campaign.h"

namespace {

using namespace nineline;
using namespace nineline::identification_campaign;

struct Tally {
  Coverage all;
  std::map<std::string, Coverage> by_part;
  int cases = 0;
  int failures = 0;
  std::size_t missing = 0, invented = 0;
  std::size_t outliers = 0, found_outliers = 0;
  double seconds = 0.0;
};

void runCase(unsigned seed, int kind, Tally& tally) {
  NoisePlan noise;
  noise.stated = seed % 2 == 0;
  noise.run_offset = 0.25 * (seed % 5);
  const PlantedCase planted = plantCase(seed, kind, 2 + static_cast<int>(seed % 3), &noise);
  NoProgress progress;
  identification::IdentificationOptions options;
  options.propose = false;
  const auto start = std::chrono::steady_clock::now();
  const auto report = identification::identify(planted.machine, planted.files, options, progress);
  tally.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  ++tally.cases;
  if (!report) {
    ++tally.failures;
    fmt::print("seed {} {}: {}\n", seed, kindName(kind), report.error().message());
    return;
  }
  const Comparison comparison = compare(*report->model, planted.truth);
  tally.all.add(comparison.all);
  for (const auto& [part, coverage] : comparison.by_part) tally.by_part[part].add(coverage);
  tally.missing += comparison.missing.size();
  tally.invented += comparison.invented.size();
  tally.outliers += planted.outliers;
  tally.found_outliers += report->outliers.size();
  for (const std::string& name : comparison.missing)
    fmt::print("seed {} {}: no {}\n", seed, kindName(kind), name);
  if (comparison.all.percent() < 90.0 || comparison.all.largest > 6.0) {
    fmt::print("seed {} {}: {:.1f} % of {}, largest {:.1f} sigma, invented {}\n", seed, kindName(kind),
               comparison.all.percent(), comparison.all.values, comparison.all.largest,
               comparison.invented.size());
  }
}

void print(const char* name, const Tally& tally) {
  fmt::print("| {} | {} | {} | {:.2f} |", name, tally.cases, tally.all.values, tally.all.percent());
  for (const char* part : {"table", "location", "play"}) {
    const auto found = tally.by_part.find(part);
    fmt::print(" {:.2f} ({}) |", found == tally.by_part.end() ? 0.0 : found->second.percent(),
               found == tally.by_part.end() ? 0 : found->second.values);
  }
  fmt::print(" {:.3f} | {:.1f} | {} / {} | {} / {} | {} | {:.2f} s |\n",
             std::sqrt(tally.all.square / std::max<double>(1.0, static_cast<double>(tally.all.values))),
             tally.all.largest, tally.found_outliers, tally.outliers, tally.missing, tally.invented,
             tally.failures, tally.seconds / std::max(1, tally.cases));
}

}  // namespace

int main(int argc, char** argv) {
  const unsigned first = argc > 1 ? static_cast<unsigned>(std::atoi(argv[1])) : 1;
  const int count = argc > 2 ? std::atoi(argv[2]) : 20;
  const int only = argc > 3 ? std::atoi(argv[3]) : -1;
  std::array<Tally, 4> tallies;
  Tally total;
  for (int i = 0; i < count; ++i) {
    const int kind = only >= 0 ? only : i % 4;
    runCase(first + static_cast<unsigned>(i), kind, tallies[static_cast<std::size_t>(kind)]);
  }
  fmt::print(
      "| machine | cases | values | within 2 sigma, % | tables | locations | plays | rms of deviation / "
      "sigma "
      "| largest | left out / planted outliers | missing / invented | failed | time a case |\n");
  for (int kind = 0; kind < 4; ++kind) {
    const Tally& tally = tallies[static_cast<std::size_t>(kind)];
    print(kindName(kind), tally);
    total.all.add(tally.all);
    for (const auto& [part, coverage] : tally.by_part) total.by_part[part].add(coverage);
    total.cases += tally.cases;
    total.failures += tally.failures;
    total.missing += tally.missing;
    total.invented += tally.invented;
    total.outliers += tally.outliers;
    total.found_outliers += tally.found_outliers;
    total.seconds += tally.seconds;
  }
  print("all", total);
  return total.failures == 0 ? 0 : 1;
}
