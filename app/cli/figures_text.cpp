#include "app/cli/figures_text.h"

#include <fmt/format.h>

#include <functional>

#include "core/base/units.h"

namespace nineline::cli {

namespace {

using kinematics::Machine;
using simulation::DeviationSummary;
using simulation::Figures;

struct Row {
  std::string name;
  std::string unit;
  Figures figures;  // in the unit
};

Row rowOf(std::string name, const Figures& figures, bool rotary) {
  const auto shown = [rotary](double value) { return rotary ? arcsecFromRad(value) : umFromMm(value); };
  return {std::move(name), rotary ? "arcsec" : "um",
          Figures{shown(figures.mean), shown(figures.rms), shown(figures.max)}};
}

std::vector<Row> rowsOf(const DeviationSummary& deviation, const Machine& machine) {
  std::vector<Row> rows{rowOf("tip", deviation.norm, false), rowOf("tip x", deviation.x, false),
                        rowOf("tip y", deviation.y, false), rowOf("tip z", deviation.z, false)};
  for (std::size_t joint = 0; joint < deviation.joints.size(); ++joint) {
    const int index = static_cast<int>(joint);
    rows.push_back(
        rowOf("axis " + machine.joint(index).axis.text(), deviation.joints[joint], machine.isRotary(index)));
  }
  return rows;
}

std::string numbers(const Figures& figures) {
  return fmt::format("{:>11.4f} {:>11.4f} {:>11.4f}", figures.mean, figures.rms, figures.max);
}

}  // namespace

std::string figuresText(const DeviationSummary& deviation, const Machine& machine) {
  std::string text = fmt::format("{:<16} {:>11} {:>11} {:>11}\n", "", "mean", "RMS", "largest");
  for (const Row& row : rowsOf(deviation, machine)) {
    text += fmt::format("{:<9}{:<7} {}\n", row.name, row.unit, numbers(row.figures));
  }
  return text;
}

std::string figuresText(const DeviationSummary& before, const DeviationSummary& after,
                        const Machine& machine) {
  std::string text = fmt::format("{:<16} {:^35}  {:^35}\n{:<16}", "", "before", "after", "");
  for (int side = 0; side < 2; ++side) {
    text += fmt::format("{} {:>11} {:>11} {:>11}", side == 0 ? "" : " ", "mean", "RMS", "largest");
  }
  text += "   RMS gone\n";
  const std::vector<Row> rows = rowsOf(before, machine);
  const std::vector<Row> rest = rowsOf(after, machine);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double rms = rows[i].figures.rms;
    const std::string gone = rms > 0.0 ? fmt::format("{:8.3f} %", 100.0 * (1.0 - rest[i].figures.rms / rms))
                                       : fmt::format("{:>10}", "-");
    text += fmt::format("{:<9}{:<7} {}  {} {}\n", rows[i].name, rows[i].unit, numbers(rows[i].figures),
                        numbers(rest[i].figures), gone);
  }
  return text;
}

}  // namespace nineline::cli
