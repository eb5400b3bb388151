#pragma once

#include "core/nc/execution.h"

namespace nineline::nc {

/// What the machine's state says under a number or a name: positions, offsets, tool number.
class MachineVariables final : public SystemVariables {
 public:
  explicit MachineVariables(Execution& execution) : execution_(&execution) {}
  [[nodiscard]] std::optional<double> number(int id) const override;
  [[nodiscard]] std::optional<double> named(std::string_view name) const override;

 private:
  [[nodiscard]] std::optional<double> wordOf(char letter) const;
  [[nodiscard]] std::optional<double> machineOf(char letter) const;
  [[nodiscard]] std::optional<double> linuxCncNumber(int id) const;
  Execution* execution_;
};

}  // namespace nineline::nc
