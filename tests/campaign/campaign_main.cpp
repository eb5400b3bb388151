#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include "core/base/units.h"
#include "tests/campaign/campaign.h"

namespace {

using namespace nineline;
using namespace nineline::campaign;

struct Group {
  PathFigures before, after;
  std::size_t cases = 0, faults = 0, changed = 0, second = 0, below = 0, lines = 0, corrected_lines = 0;
  double seconds = 0.0, worst = 100.0;
};

void count(const Outcome& outcome, Group& group) {
  ++group.cases;
  group.second += outcome.second_read ? 1U : 0U;
  group.changed += outcome.meaning.empty() ? 0U : 1U;
  group.faults += outcome.fault.empty() ? 0U : 1U;
  if (!outcome.fault.empty()) return;
  const double removed = removedPercent(outcome.paths.before, outcome.paths.after);
  group.below += removed < 99.0 ? 1U : 0U;
  group.worst = std::min(group.worst, removed);
  group.before.add(outcome.paths.before);
  group.after.add(outcome.paths.after);
  group.lines += outcome.lines;
  group.corrected_lines += outcome.corrected_lines;
  group.seconds += outcome.seconds;
}

std::string rowOf(const std::string& name, const Group& g) {
  return fmt::format(
      "| {} | {} | {} | {:.3f} | {:.4f} | {:.3f} | {:.2f} | {:.2f} | {} | {:.2f} | {:.2f} | {} / {} | {} → "
      "{} | {:.1f} |\n",
      name, g.cases, g.faults, umFromMm(g.before.rms()), umFromMm(g.after.rms()), umFromMm(g.after.largest),
      removedPercent(g.before, g.after), g.worst, g.below, arcsecFromRad(g.before.tilt()),
      arcsecFromRad(g.after.tilt()), g.changed, g.second, g.lines, g.corrected_lines, g.seconds);
}

std::string caseRow(const Case& one, const Outcome& o) {
  const std::string head =
      fmt::format("{},{},{},{}", one.seed, nameOf(one.machine.structure),
                  one.more_effects ? "more" : "tables", one.program.inch ? "inch" : "mm");
  return fmt::format("{},{},{},{:.4f},{:.5f},{:.4f},{},{:.3f},{:.3f},{:.4f},{:.5f},{:.3f},\"{}\",\"{}\"\n",
                     head, o.lines, o.corrected_lines, umFromMm(o.paths.before.rms()),
                     umFromMm(o.paths.after.rms()), umFromMm(o.paths.after.largest),
                     o.paths.after.largest_line, removedPercent(o.paths.before, o.paths.after),
                     removedTiltPercent(o.paths.before, o.paths.after), umFromMm(o.reported_before),
                     umFromMm(o.reported_after), o.seconds, o.fault, o.meaning);
}

}  // namespace

/// campaign FIRST_SEED COUNT FOLDER [WRITING…]: writes FOLDER/figures.md and FOLDER/cases-<n>.csv, one row a
/// case; WRITING 0, 1, 2 are 3, 4 and 6 decimals. Exit status 1 where a program changed its meaning.
int main(int argc, char** argv) {
  if (argc < 4) {
    std::fputs("usage: campaign FIRST_SEED COUNT FOLDER [WRITING...]\n", stderr);
    return 2;
  }
  const auto first = static_cast<unsigned>(std::atoi(argv[1]));
  const auto cases = static_cast<unsigned>(std::atoi(argv[2]));
  const std::filesystem::path folder = std::filesystem::absolute(argv[3]);
  std::filesystem::create_directories(folder);
  const SecondOpinion opinion(folder / "rs274");
  const bool second = SecondOpinion::isInstalled();
  if (!second) std::fputs("rs274 (package linuxcnc-uspace) is absent: no second opinion\n", stderr);
  std::string figures =
      "| written with | cases | faults | RMS before (um) | RMS after (um) | max after (um) | removed (%) | "
      "worst case (%) "
      "| cases below 99 % | tilt before (arcsec) | tilt after (arcsec) | changed meaning / read by rs274 | "
      "lines | "
      "time (s) |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  std::size_t changed = 0;
  for (std::size_t w = 0; w < writings().size(); ++w) {
    bool wanted = argc == 4;
    for (int i = 4; i < argc; ++i) wanted = wanted || std::atoi(argv[i]) == static_cast<int>(w);
    if (!wanted) continue;
    Group all;
    std::array<Group, 3> groups;
    std::ofstream rows(folder / fmt::format("cases-{}.csv", w));
    rows << "seed,structure,errors,unit,lines,corrected_lines,before_um,after_um,max_um,max_line,removed_pct,"
            "tilt_"
            "removed_pct,"
            "reported_before_um,reported_after_um,time_s,fault,meaning\n";
    for (unsigned seed = first; seed < first + cases; ++seed) {
      const Case one = drawCase(seed, 60);
      const Outcome outcome = run(one, writings()[w], second ? &opinion : nullptr);
      count(outcome, all);
      count(outcome, groups[static_cast<std::size_t>(one.machine.structure)]);
      rows << caseRow(one, outcome) << std::flush;
      if (outcome.fault.empty() && outcome.meaning.empty()) continue;
      std::ofstream(folder / fmt::format("seed{}-{}.nc", seed, w)) << one.program.text;
      std::ofstream(folder / fmt::format("seed{}-{}-corrected.nc", seed, w)) << outcome.corrected_text;
      std::ofstream(folder / fmt::format("seed{}.json", seed)) << modelText(one.machine);
    }
    figures += rowOf(fmt::format("**{}**", writings()[w].name), all);
    for (std::size_t s = 0; s < groups.size(); ++s)
      figures += rowOf(nameOf(static_cast<Structure>(s)), groups[s]);
    changed += all.changed;
  }
  std::ofstream(folder / "figures.md") << figures;
  std::fputs(figures.c_str(), stdout);
  return changed == 0 ? 0 : 1;
}
