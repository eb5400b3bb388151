#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/cli/commands.h"
#include "core/kinematics/machine_file.h"

namespace nineline::cli {

namespace {

using kinematics::Machine;

std::string axesOf(const Machine& machine, kinematics::Side side) {
  std::string axes;
  for (int joint = 0; joint < machine.jointCount(); ++joint) {
    if (machine.side(joint) == side) axes += " " + machine.joint(joint).axis.text();
  }
  return axes.empty() ? " -" : axes;
}

Json listRecord() {
  Json list = Json::array();
  for (const Machine& machine : kinematics::builtInMachines()) {
    Json axes = Json::array();
    for (const kinematics::Joint& joint : machine.joints()) axes.push(joint.axis.text());
    Json entry = Json::object();
    entry.set("id", machine.id()).set("name", machine.name()).set("axes", std::move(axes));
    list.push(std::move(entry));
  }
  Json record = Json::object();
  return record.set("machines", std::move(list));
}

std::string listText() {
  std::string text;
  for (const Machine& machine : kinematics::builtInMachines()) {
    text +=
        fmt::format("{:<20} {} (workpiece:{}; tool:{})\n", machine.id(), machine.name(),
                    axesOf(machine, kinematics::Side::Workpiece), axesOf(machine, kinematics::Side::Tool));
  }
  return text;
}

Result<void> runMachines(const std::string& id, Console& console) {
  if (id.empty()) {
    console.print(console.json() ? writeJson(listRecord()) + "\n" : listText());
    return {};
  }
  const Result<Machine> machine = kinematics::loadMachine(id);
  if (!machine) return machine.error();
  console.print(writeJson(kinematics::machineToJson(*machine)) + "\n");
  return {};
}

}  // namespace

Command addMachinesCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand("machines", "List the built-in machines, or print one as JSON");
  auto id = std::make_shared<std::string>();
  command->add_option("id", *id, "A built-in machine, or a machine file to check");
  return {command, [id](Console& console) { return runMachines(*id, console); }};
}

}  // namespace nineline::cli
