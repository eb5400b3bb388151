#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "core/errors/effect_spec.h"

namespace nineline::errors {
namespace {

const char* const kHead =
    "# The effects that Nineline knows\n\n"
    "One section for each cause that a machine, a process or a measurement may have: what it adds, its "
    "parameters, "
    "what it is mistaken for, and what a fitter does about it. This page is written from the program's own "
    "catalogue (`core/errors/specs_*.cpp`) by the test `core.errors` with `NINELINE_UPDATE=1`, and the same "
    "test "
    "fails when the two differ.\n\n"
    "q is the joint's position (mm or deg), s the sense in which it last moved (-1, +1), v its speed, a its "
    "acceleration, d the travel since its last reversal, C the angle of a rotary axis, T a temperature in C, "
    "t the "
    "time, n the number of the pass. Amounts are the size without its sign; positions of a fixed point count "
    "in "
    "travels from the lower end. Machine effects are compensated; process effects only when they are "
    "switched on; "
    "measurement effects are reported and never compensated.\n\n"
    "Deformations of a rotary axis act in the frame that turns with it; `\"frame\": \"fixed\"` changes that. "
    "Growth, tilt and load may also stand at the place of a joint, before its motion: component `X0C` "
    "instead of "
    "`EXC`.\n\n";

std::string kindText(EffectKind kind) {
  if (kind == EffectKind::Machine) return "Machine";
  return kind == EffectKind::Process ? "Process" : "Measurement";
}

std::string boundsText(const Plausible& range) {
  const std::string grinder = fmt::format("{:g} to {:g}", range.grinder.low, range.grinder.high);
  const std::string mill = fmt::format("{:g} to {:g}", range.mill.low, range.mill.high);
  return grinder == mill ? grinder : fmt::format("{} (grinder), {} (mill)", grinder, mill);
}

std::string roleText(const ParameterSpec& one) {
  static const std::vector<std::string> kRoles = {
      "linear", "linear, with the phase", "linear, with the amplitude", "non-linear", "choice", "given"};
  std::string text = kRoles[static_cast<std::size_t>(one.role)];
  if (one.optional) text += ", optional";
  if (one.otherwise && one.role != Role::Phase) text += fmt::format(", {:g} if not stated", *one.otherwise);
  return text;
}

/// Unit and range at a linear joint's length, and at an angle where that is another.
std::string parameterText(const ParameterSpec& one, bool rotary_only, bool tilt_only) {
  const UnitChoice length{.angular = tilt_only, .rotary = rotary_only};
  const UnitChoice angle{.angular = true, .rotary = true};
  const bool first_is_arc = one.arc && (tilt_only || (rotary_only && one.quantity == Quantity::Position));
  const std::string unit(unitOf(one.quantity, length));
  std::string range = boundsText(first_is_arc ? *one.arc : one.linear);
  if (one.of_travel) range += " travels";
  std::string text = fmt::format("| `{}` | {} | {} |", one.name, unit, range);
  if (one.arc && !tilt_only) {
    text = fmt::format("| `{}` | {}; {} | {}; {} |", one.name, unit, unitOf(one.quantity, angle), range,
                       boundsText(*one.arc));
  }
  return fmt::format("{} {} |\n", text, roleText(one));
}

std::string sectionOf(const EffectSpec& spec) {
  const bool rotary_only = spec.joints == JointChoice::Rotary;
  const bool tilt_only =
      spec.sites != 0 && (spec.sites & ~(kTilt | kTiltPair | kLocation)) == 0 && spec.id != "location";
  std::string text = fmt::format("## `{}`: {}\n\n{} effect; discovery row {}. Formula: `{}`\n\n", spec.id,
                                 spec.title, kindText(spec.kind), spec.rows, spec.formula);
  if (!spec.parameters.empty()) text += "| parameter | unit | plausible | form |\n|---|---|---|---|\n";
  for (const ParameterSpec& one : spec.parameters) text += parameterText(one, rotary_only, tilt_only);
  if (!spec.parameters.empty()) text += "\n";
  if (spec.sensors > 0) {
    text += fmt::format("Follows {}: `{}` where none is named.\n\n",
                        spec.sensors > 1 ? "two columns" : "a column", spec.standard_sensor);
  }
  text += fmt::format("**Cause.** {}\n\n**Typical size.** {}\n\n**Remedy.** {}\n\n", spec.shop_floor.cause,
                      spec.shop_floor.size, spec.shop_floor.remedy);
  if (spec.action_limit.high > 0.0) {
    text += fmt::format("Worth acting on from {:g} um (grinder) or {:g} um (mill), RMS.\n\n",
                        spec.action_limit.low, spec.action_limit.high);
  }
  for (const LookAlike& other : spec.lookalikes) {
    text +=
        fmt::format("- Looks like `{}`: {}. Told apart by: {}.\n", other.id, other.why, other.separated_by);
  }
  return text + (spec.lookalikes.empty() ? "" : "\n");
}

TEST(EffectDocs, SayWhatTheCatalogueSays) {
  std::string expected = kHead;
  for (const EffectSpec& spec : effectCatalogue()) expected += sectionOf(spec);
  expected.pop_back();
  const std::string path = std::string(NINELINE_SOURCE_DIR) + "/resources/docs/effects/README.md";
  if (std::getenv("NINELINE_UPDATE") != nullptr) std::ofstream(path) << expected;
  std::ostringstream found;
  found << std::ifstream(path).rdbuf();
  EXPECT_TRUE(found.str() == expected) << path << " differs from the catalogue; NINELINE_UPDATE=1 writes it";
}

}  // namespace
}  // namespace nineline::errors
