#include "core/kinematics/built_in_machine_texts.h"
#include "core/kinematics/machine_file.h"

namespace nineline::kinematics {

const std::vector<Machine>& builtInMachines() {
  static const std::vector<Machine> kMachines = [] {
    std::vector<Machine> machines;
    for (const std::string_view text : builtInMachineTexts()) {
      machines.push_back(readMachine(text, "built-in machine").value());
    }
    return machines;
  }();
  return kMachines;
}

const Machine* findBuiltInMachine(std::string_view id) {
  for (const Machine& machine : builtInMachines()) {
    if (machine.id() == id) return &machine;
  }
  return nullptr;
}

}  // namespace nineline::kinematics
