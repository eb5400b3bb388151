#include "core/measurement/instrument.h"

#include <array>
#include <utility>

namespace nineline::measurement {

namespace {

constexpr std::array<std::pair<InstrumentKind, std::string_view>, 8> kKinds = {{
    {InstrumentKind::Deviation, "deviation"},
    {InstrumentKind::Joint, "joint"},
    {InstrumentKind::LaserLinear, "laser-linear"},
    {InstrumentKind::LaserStraightness, "laser-straightness"},
    {InstrumentKind::LaserAngular, "laser-angular"},
    {InstrumentKind::Ballbar, "ballbar"},
    {InstrumentKind::Lead, "lead"},
    {InstrumentKind::Dial, "dial"},
}};

constexpr std::array<std::pair<Quantity, std::string_view>, 9> kColumns = {{
    {Quantity::DevX, "dev_x_um"},
    {Quantity::DevY, "dev_y_um"},
    {Quantity::DevZ, "dev_z_um"},
    {Quantity::RotX, "rot_x_arcsec"},
    {Quantity::RotY, "rot_y_arcsec"},
    {Quantity::RotZ, "rot_z_arcsec"},
    {Quantity::Length, "dev_um"},
    {Quantity::Angle, "dev_arcsec"},
    {Quantity::Radius, "dr_um"},
}};

std::vector<Quantity> quantitiesOf(InstrumentKind kind, bool rotary) {
  switch (kind) {
    case InstrumentKind::Deviation:
      return {Quantity::DevX, Quantity::DevY, Quantity::DevZ, Quantity::RotX, Quantity::RotY, Quantity::RotZ};
    case InstrumentKind::Joint:
      return {rotary ? Quantity::Angle : Quantity::Length};
    case InstrumentKind::LaserAngular:
      return {Quantity::Angle};
    case InstrumentKind::Ballbar:
      return {Quantity::Radius};
    default:
      return {Quantity::Length};
  }
}

}  // namespace

std::string_view nameOf(InstrumentKind kind) {
  for (const auto& [one, name] : kKinds) {
    if (one == kind) return name;
  }
  return "";
}

std::optional<InstrumentKind> parseInstrumentKind(std::string_view text) {
  for (const auto& [kind, name] : kKinds) {
    if (name == text) return kind;
  }
  return std::nullopt;
}

std::vector<std::string_view> instrumentNames() {
  std::vector<std::string_view> names;
  for (const auto& [kind, name] : kKinds) names.push_back(name);
  return names;
}

std::string Channel::column() const {
  for (const auto& [one, name] : kColumns) {
    if (one == quantity) return std::string(name);
  }
  return "";
}

std::optional<Channel> parseChannel(std::string_view column, InstrumentKind kind, bool rotary) {
  for (const Quantity quantity : quantitiesOf(kind, rotary)) {
    const Channel channel{quantity};
    if (channel.column() == column) return channel;
  }
  return std::nullopt;
}

std::vector<std::string> channelColumns(InstrumentKind kind, bool rotary) {
  std::vector<std::string> columns;
  for (const Quantity quantity : quantitiesOf(kind, rotary)) columns.push_back(Channel{quantity}.column());
  return columns;
}

}  // namespace nineline::measurement
