#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/thread_grinding/check_groups.h"
#include "core/thread_grinding/wheel_profile.h"

namespace nineline::thread_grinding {
namespace {

double smallestRadius(const ThreadCase& c) {
  const double cone = std::min(c.parameters.taper * c.plan.first_wz, c.parameters.taper * c.plan.last_wz);
  return std::min(radiusAtDepth(c.plan, c.plan.depth), c.plan.crest_radius) + cone;
}

void checkRoot(const ThreadCase& c, Diagnostics& findings) {
  if (smallestRadius(c) > 0.0) return;
  findings.error("thread.diameter",
                 finding("the smallest ground diameter in mm", 2.0 * smallestRadius(c), "above 0",
                         fmt::format("the pitch of {:g} mm is too coarse for a diameter of {:g} mm",
                                     c.parameters.pitch, c.parameters.diameter)));
}

void checkDepth(const ThreadCase& c, Diagnostics& findings) {
  const double depth = c.plan.depth;
  if (depth <= 0.0) {
    findings.error("thread.depth", finding("depth_mm", depth, "above 0", "nothing is ground"));
  } else if (depth > c.plan.depth_limit + 1e-9) {
    findings.error("thread.depth", finding("depth_mm", depth,
                                           fmt::format("at most {:.6g}, the sharp root", c.plan.depth_limit),
                                           "the profile is no longer the thread's"));
  }
}

void checkHelixAngle(const ThreadCase& c, Diagnostics& findings) {
  const double angle_deg = degFromRad(c.plan.geometry.helix_angle);
  if (angle_deg <= 10.0) return;
  findings.warning("thread.helix_angle",
                   finding("the helix angle in deg", angle_deg, "at most 10",
                           "a straight-flanked wheel grinds a wrong profile; use its profile table"));
}

void checkInfeed(const ThreadCase& c, Diagnostics& findings) {
  const double infeed = c.parameters.infeed;
  const double resolution = std::pow(10.0, -c.parameters.decimals) / c.parameters.axes.x_factor;
  if (infeed > c.plan.depth) {
    findings.error("thread.infeed",
                   finding("infeed_mm", infeed, fmt::format("at most depth_mm {:.6g}", c.plan.depth),
                           "the first pass is deeper than the thread"));
  } else if (infeed < resolution * (1.0 - 1e-9)) {
    findings.error("thread.infeed",
                   finding("infeed_mm", infeed, fmt::format("at least the word step {:g}", resolution),
                           "passes are rounded to the same depth"));
  } else if (c.plan.roughing_count > kMostRoughingPasses) {
    findings.error("thread.infeed",
                   finding("the number of passes", c.plan.roughing_count,
                           fmt::format("at most {:g}", kMostRoughingPasses), "grinding hardly ever ends"));
  } else if (infeed > 0.1) {
    findings.warning("thread.infeed", finding("infeed_mm", infeed, "at most 0.1", "the flanks may burn"));
  }
}

void checkFinishing(const ThreadCase& c, Diagnostics& findings) {
  const double resolution = std::pow(10.0, -c.parameters.decimals) / c.parameters.axes.x_factor;
  if (c.parameters.finishing_passes > 0 && c.parameters.finishing_infeed < resolution * (1.0 - 1e-9)) {
    findings.error("thread.finishing_infeed", finding("finishing_infeed_mm", c.parameters.finishing_infeed,
                                                      fmt::format("at least the word step {:g}", resolution),
                                                      "passes are rounded to the same depth"));
  }
  const double finishing = c.parameters.finishing_passes * c.parameters.finishing_infeed;
  if (finishing >= c.plan.depth) {
    findings.error("thread.finishing_passes",
                   finding("finishing_passes times finishing_infeed_mm", finishing,
                           fmt::format("below {:.6g}", c.plan.depth), "no depth is left for roughing"));
  } else if (c.plan.passes.empty() && c.plan.roughing_count <= kMostRoughingPasses) {
    findings.error(
        "thread.finishing_passes",
        finding("the number of passes",
                c.plan.roughing_count + c.parameters.finishing_passes + c.parameters.spark_out_passes,
                fmt::format("at most {:g}", kMostRoughingPasses), "grinding hardly ever ends"));
  }
}

void checkSpeed(const ThreadCase& c, Diagnostics& findings) {
  const double speed = std::max(c.parameters.speed_first, c.parameters.speed_last);
  const double feed = speed * c.plan.geometry.lead / kTurn;
  const double speed_rpm = perMinuteFromPerSecond(speed / kTurn);
  if (c.limits.c_speed && speed > *c.limits.c_speed * (1.0 + 1e-12)) {
    findings.error("thread.speed", finding("the work speed in rpm", speed_rpm,
                                           fmt::format("at most {:g} (C axis)",
                                                       perMinuteFromPerSecond(*c.limits.c_speed / kTurn)),
                                           "the control slows C and Z down or stops"));
  }
  if (c.limits.z_speed && feed > *c.limits.z_speed * (1.0 + 1e-12)) {
    findings.error("thread.speed",
                   finding("the feed of Z in mm/min", perMinuteFromPerSecond(feed),
                           fmt::format("at most {:g} (Z axis)", perMinuteFromPerSecond(*c.limits.z_speed)),
                           "the control slows C and Z down or stops"));
  }
}

void checkServoLag(const ThreadCase& c, Diagnostics& findings) {
  if (!c.limits.c_velocity_gain) return;
  const double lead = c.plan.geometry.lead;
  const double rise = std::abs(c.parameters.speed_last - c.parameters.speed_first) * lead / kTurn;
  const double shift_um =
      umFromMm(rise * std::abs(1.0 / c.limits.velocity_gain - 1.0 / *c.limits.c_velocity_gain));
  if (shift_um <= 0.1) return;
  findings.warning(
      "thread.velocity_gain",
      finding("the shift of the groove between first and last pass in um", shift_um, "at most 0.1",
              "the flanks are ground unevenly; give C and Z the same velocity gain or keep one speed"));
}

void checkLeadIn(const ThreadCase& c, Diagnostics& findings) {
  const double ribs = (c.parameters.wheel_ribs - 1) * c.parameters.pitch;
  const double needed = std::max(c.plan.lead_in_needed, c.parameters.pitch / 2.0) + ribs;
  const auto check = [&](const char* code, const char* what, double value, const char* otherwise) {
    if (value < needed - 1e-9)
      findings.warning(code, finding(what, value, fmt::format("at least {:.4g}", needed), otherwise));
  };
  check("thread.lead_in", "lead_in_mm", c.plan.lead_in,
        "the first turn is ground while C and Z still accelerate");
  check("thread.run_out", "run_out_mm", c.plan.run_out, "the last turn is incomplete");
}

void checkShoulder(const ThreadCase& c, Diagnostics& findings) {
  if (!c.parameters.shoulder) return;
  const double reach = c.plan.run_out + c.plan.wheel_width / 2.0;
  if (reach <= *c.parameters.shoulder) return;
  findings.error("thread.shoulder", finding("run_out_mm and half the wheel's width", reach,
                                            fmt::format("at most shoulder_mm {:g}", *c.parameters.shoulder),
                                            "the wheel runs into the shoulder"));
}

void checkRelief(const ThreadCase& c, Diagnostics& findings) {
  const double least = c.plan.depth + c.parameters.clearance;
  if (c.plan.relief >= least - 1e-12) return;
  findings.error("thread.relief", finding("relief_mm", c.plan.relief,
                                          fmt::format("at least {:.6g} (depth and clearance)", least),
                                          "the wheel drags over the thread on its return"));
}

void checkWheelSize(const ThreadCase& c, Diagnostics& findings) {
  const double needed = c.parameters.wheel_ribs * c.parameters.pitch;
  if (c.plan.wheel_width < needed - 1e-9) {
    findings.error("thread.wheel_width", finding("wheel_width_mm", c.plan.wheel_width,
                                                 fmt::format("at least {:g} (ribs times pitch)", needed),
                                                 "the profile is cut off"));
  }
  if (c.parameters.type == ThreadType::External) return;
  // Retracted, the far side of the wheel must stay inside the bore.
  const double room = retractX(c.parameters, c.plan) + smallestRadius(c) - c.parameters.clearance;
  if (c.plan.wheel_diameter <= room) return;
  findings.error("thread.wheel_diameter",
                 finding("wheel_diameter_mm", c.plan.wheel_diameter, fmt::format("at most {:.6g}", room),
                         "the wheel does not fit into the bore"));
}

void checkTilt(const ThreadCase& c, Diagnostics& findings) {
  const double right_tilt = signOf(c.parameters.hand) * c.plan.geometry.helix_angle;
  const double miss_deg = degFromRad(c.plan.wheel_tilt - right_tilt);
  if (std::abs(miss_deg) < 0.2) return;
  if (std::abs(miss_deg) > 30.0) {
    findings.error("thread.wheel_tilt",
                   finding("wheel_tilt_deg", degFromRad(c.plan.wheel_tilt),
                           fmt::format("{:.4f} (helix angle, sign of the hand)", degFromRad(right_tilt)),
                           "the wheel cuts across the groove"));
    return;
  }
  std::string otherwise = "the flanks are overcut";
  if (c.parameters.type == ThreadType::External) {
    const Result<double> change =
        pitchDiameterChange(c.plan.geometry, c.parameters.hand, {c.plan.wheel_diameter, c.plan.wheel_tilt});
    if (change) otherwise = fmt::format("the pitch diameter changes by {:.1f} um", umFromMm(*change));
  }
  findings.warning("thread.wheel_tilt",
                   finding("wheel_tilt_deg", degFromRad(c.plan.wheel_tilt),
                           fmt::format("{:.4f} within 0.2", degFromRad(right_tilt)), otherwise));
}

void checkContactHeight(const ThreadCase& c, Diagnostics& findings) {
  const double height = std::abs(c.parameters.contact_height);
  const double radius = smallestRadius(c);
  if (height >= 0.99 * radius) {
    findings.error(
        "thread.grinding_height",
        finding("grinding_height_mm", height, fmt::format("below {:.6g} (0.99 of the radius)", 0.99 * radius),
                "the wheel passes above the work"));
  } else if (height >= 0.5 * radius) {
    findings.warning(
        "thread.grinding_height",
        finding("grinding_height_mm", height, fmt::format("below {:.6g} (half the radius)", 0.5 * radius),
                "small errors of X and C are magnified"));
  }
}

void checkTaperedPass(const ThreadCase& c, Diagnostics& findings) {
  if (std::abs(c.parameters.taper) <= 0.0625) return;
  findings.warning("thread.taper",
                   finding("taper_1", c.parameters.taper, "at most 0.0625 (1:8 on diameter)",
                           "state whether the profile stands on the axis (as ground here) or on the cone"));
}

void checkRange(Diagnostics& findings, const char* axis, const std::optional<MachineLimits::Range>& range,
                double low, double high) {
  if (!range) return;
  const auto report = [&](double value) {
    findings.error("thread.travel", finding(fmt::format("{} in mm", axis), value,
                                            fmt::format("{:g} to {:g}", range->low, range->high),
                                            "the axis leaves its travel"));
  };
  if (low < range->low) report(low);
  if (high > range->high) report(high);
}

void checkTravel(const ThreadCase& c, Diagnostics& findings) {
  const AxisConvention& axes = c.parameters.axes;
  const double outside = retractX(c.parameters, c.plan) + c.plan.inward * c.parameters.safety;
  const double deepest = radiusAtDepth(c.plan, c.plan.depth);
  const double cone_1 = c.parameters.taper * c.plan.first_wz;
  const double cone_2 = c.parameters.taper * c.plan.last_wz;
  const double x_1 = axes.x_sign * (std::min({outside, deepest + cone_1, deepest + cone_2}) - axes.x_zero);
  const double x_2 = axes.x_sign * (std::max({outside, deepest + cone_1, deepest + cone_2}) - axes.x_zero);
  checkRange(findings, "X", c.limits.x, std::min(x_1, x_2), std::max(x_1, x_2));
  // Flank infeed shifts roughing along the axis; a bore is entered from `safety` before the first pass.
  const double shift = c.parameters.infeed_mode == InfeedMode::Radial
                           ? 0.0
                           : c.plan.depth * std::tan(c.plan.geometry.half_angle);
  const double entry = c.parameters.type == ThreadType::Internal ? c.parameters.safety : 0.0;
  const double low_wz =
      std::min(c.plan.first_wz, c.plan.last_wz) - std::max(shift, c.parameters.towards_plus ? entry : 0.0);
  const double high_wz =
      std::max(c.plan.first_wz, c.plan.last_wz) + std::max(shift, c.parameters.towards_plus ? 0.0 : entry);
  const double z_1 = axes.z_sign * (c.parameters.start_z - low_wz - axes.z_zero);
  const double z_2 = axes.z_sign * (c.parameters.start_z - high_wz - axes.z_zero);
  checkRange(findings, "Z", c.limits.z, std::min(z_1, z_2), std::max(z_1, z_2));
}

void checkBlockCount(const ThreadCase& c, Diagnostics& findings) {
  const double most = c.limits.most_blocks.value_or(5e6);
  const double count = blocksPerPass(c.parameters, c.plan) *
                       static_cast<double>(c.plan.passes.size() * c.plan.start_indices.size());
  if (count <= most) return;
  findings.error("thread.block_step",
                 finding("the number of blocks", count, fmt::format("at most {:g}", most),
                         "the control cannot hold the program; use a longer block_step_deg"));
}

constexpr std::array<PlanCheck, 16> kPlanChecks{
    checkRoot,          checkDepth,       checkHelixAngle, checkInfeed,    checkFinishing, checkSpeed,
    checkServoLag,      checkLeadIn,      checkShoulder,   checkRelief,    checkWheelSize, checkTilt,
    checkContactHeight, checkTaperedPass, checkTravel,     checkBlockCount};

}  // namespace

std::span<const PlanCheck> planChecks() { return kPlanChecks; }

}  // namespace nineline::thread_grinding
