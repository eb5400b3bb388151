#include <fmt/format.h>

#include <array>
#include <cmath>

#include "core/thread_grinding/check_groups.h"

namespace nineline::thread_grinding {
namespace {

using Parameters = const ThreadParameters&;
using Limits = const MachineLimits&;

void above(Diagnostics& findings, const char* code, const char* what, double value, double limit,
           const char* otherwise) {
  if (value > limit) return;
  findings.error(code, finding(what, value, fmt::format("above {:g}", limit), otherwise));
}

void atLeast(Diagnostics& findings, const char* code, const char* what, double value, double limit,
             const char* otherwise) {
  if (value >= limit) return;
  findings.error(code, finding(what, value, fmt::format("at least {:g}", limit), otherwise));
}

void checkFinite(Parameters p, Limits limits, Diagnostics& findings) {
  const AxisConvention& a = p.axes;
  const std::array<double, 30> values{p.diameter,
                                      p.pitch,
                                      p.length,
                                      p.profile_angle,
                                      p.depth.value_or(0.0),
                                      p.taper,
                                      p.start_angle,
                                      p.start_z,
                                      p.infeed,
                                      p.min_last_pass_ratio,
                                      p.finishing_infeed,
                                      p.speed_first,
                                      p.speed_last,
                                      p.lead_in.value_or(0.0),
                                      p.run_out.value_or(0.0),
                                      p.shoulder.value_or(0.0),
                                      p.relief.value_or(0.0),
                                      p.clearance,
                                      p.safety,
                                      p.wheel_diameter.value_or(0.0),
                                      p.wheel_width.value_or(0.0),
                                      p.wheel_tilt.value_or(0.0),
                                      p.contact_height,
                                      p.block_step,
                                      p.infeed_speed,
                                      a.x_zero,
                                      a.z_zero,
                                      a.c_zero,
                                      limits.z_acceleration,
                                      limits.velocity_gain};
  for (const double value : values) {
    if (std::isfinite(value) && std::abs(value) < 1e9) continue;
    findings.error("thread.finite",
                   finding("a parameter", value, "a finite number below 1e9", "nothing can be computed"));
    return;
  }
}

void checkSizes(Parameters p, Limits, Diagnostics& findings) {
  above(findings, "thread.diameter", "diameter_mm", p.diameter, 0.0, "there is no thread");
  above(findings, "thread.pitch", "pitch_mm", p.pitch, 0.0,
        "the lead is not positive and the groove has no direction");
  atLeast(findings, "thread.starts", "starts", p.starts, 1.0, "the lead is not positive");
  if (p.starts > 100) {
    findings.error("thread.starts",
                   finding("starts", p.starts, "at most 100", "the grooves cut each other away"));
  }
  above(findings, "thread.length", "length_mm", p.length, 10.0 * std::pow(10.0, -p.decimals),
        "nothing is ground");
}

void checkProfileAngle(Parameters p, Limits, Diagnostics& findings) {
  const double angle_deg = degFromRad(p.profile_angle);
  if (angle_deg < 20.0 - 1e-9 || angle_deg > 120.0 + 1e-9) {
    findings.error("thread.profile_angle",
                   finding("profile_angle_deg", angle_deg, "20 to 120", "the flanks are no screw thread's"));
  } else if (std::abs(p.profile_angle - kIsoProfileAngle) > 1e-9 && !p.depth) {
    findings.error("thread.profile_angle",
                   finding("profile_angle_deg", angle_deg, "60, or depth_mm given as well",
                           "ISO 68-1 states no depth for it"));
  }
}

void checkStart(Parameters p, Limits, Diagnostics& findings) {
  if (!p.start_index || (*p.start_index >= 0 && *p.start_index < p.starts)) return;
  findings.error("thread.start_index",
                 finding("start_index", *p.start_index, fmt::format("0 to {}", p.starts - 1),
                         "a groove that is there already would be ground twice"));
}

void checkTaper(Parameters p, Limits, Diagnostics& findings) {
  if (std::abs(p.taper) < 0.2) return;
  findings.error("thread.taper", finding("taper_1", p.taper, "between -0.2 and 0.2",
                                         "the profile perpendicular to the axis is no longer the thread's"));
}

void checkPassValues(Parameters p, Limits, Diagnostics& findings) {
  above(findings, "thread.infeed", "infeed_mm", p.infeed, 0.0, "the passes never end");
  if (p.min_last_pass_ratio < 0.0 || p.min_last_pass_ratio > 1.0) {
    findings.error("thread.min_last_pass_ratio",
                   finding("min_last_pass_ratio", p.min_last_pass_ratio, "0 to 1",
                           "the last pass rubs or takes a double depth"));
  }
  atLeast(findings, "thread.finishing_passes", "finishing_passes", p.finishing_passes, 0.0,
          "there is no such pass");
  if (p.finishing_passes > 0)
    above(findings, "thread.finishing_infeed", "finishing_infeed_mm", p.finishing_infeed, 0.0,
          "finishing removes nothing; that is spark_out_passes");
  atLeast(findings, "thread.spark_out_passes", "spark_out_passes", p.spark_out_passes, 0.0,
          "there is no such pass");
  if (p.spark_out_passes == 0)
    findings.warning("thread.spark_out_passes", finding("spark_out_passes", 0.0, "1 or more",
                                                        "the size has not settled when grinding ends"));
  above(findings, "thread.infeed_feed", "infeed_feed_mm_min", perMinuteFromPerSecond(p.infeed_speed), 0.0,
        "X never reaches the depth");
}

void checkSpeedValues(Parameters p, Limits limits, Diagnostics& findings) {
  const double first_rpm = perMinuteFromPerSecond(p.speed_first / kTurn);
  const double last_rpm = perMinuteFromPerSecond(p.speed_last / kTurn);
  above(findings, "thread.speed", "speed_first_rpm", first_rpm, 0.0, "the work does not turn");
  above(findings, "thread.speed", "speed_last_rpm", last_rpm, 0.0, "the work does not turn");
  if (first_rpm > 0.0 && last_rpm > 0.0 && last_rpm < first_rpm - 1e-9) {
    findings.warning("thread.speed", finding("speed_last_rpm", last_rpm,
                                             fmt::format("at least {:g} (speed_first_rpm)", first_rpm),
                                             "the speed falls while the cut grows finer"));
  }
  above(findings, "thread.z_acceleration", "z_acceleration_mm_s2", limits.z_acceleration, 0.0,
        "Z cannot start");
  above(findings, "thread.velocity_gain", "z_velocity_gain_1_s", limits.velocity_gain, 0.0,
        "the servo lag is unknown");
  if (limits.c_velocity_gain)
    above(findings, "thread.velocity_gain", "c_velocity_gain_1_s", *limits.c_velocity_gain, 0.0,
          "the servo lag is unknown");
}

void checkTravelValues(Parameters p, Limits, Diagnostics& findings) {
  if (p.lead_in)
    atLeast(findings, "thread.lead_in", "lead_in_mm", *p.lead_in, 0.0, "the pass begins inside the thread");
  if (p.run_out)
    atLeast(findings, "thread.run_out", "run_out_mm", *p.run_out, 0.0,
            "the pass ends before the thread does");
  if (p.shoulder)
    atLeast(findings, "thread.shoulder", "shoulder_mm", *p.shoulder, 0.0, "the shoulder covers the thread");
  above(findings, "thread.clearance", "clearance_mm", p.clearance, 0.0,
        "the wheel touches the crests on its return");
  above(findings, "thread.safety", "safety_mm", p.safety, 0.0,
        "the approach at rapid speed may touch the work");
}

void checkWheelValues(Parameters p, Limits, Diagnostics& findings) {
  if (p.wheel_diameter)
    above(findings, "thread.wheel_diameter", "wheel_diameter_mm", *p.wheel_diameter, 0.0,
          "there is no wheel");
  if (p.wheel_width)
    above(findings, "thread.wheel_width", "wheel_width_mm", *p.wheel_width, 0.0, "there is no wheel");
  atLeast(findings, "thread.wheel_ribs", "wheel_ribs", p.wheel_ribs, 1.0, "there is no profile on the wheel");
  if (p.wheel_ribs > 1000)
    findings.error("thread.wheel_ribs",
                   finding("wheel_ribs", p.wheel_ribs, "at most 1000", "there is no such wheel"));
  atLeast(findings, "thread.dress_every_passes", "dress_every_passes", p.dress_every_passes, 0.0,
          "dressing has no place; 0 means never");
}

void checkWords(Parameters p, Limits, Diagnostics& findings) {
  const double step_deg = degFromRad(p.block_step);
  if (p.block_step != 0.0 && (step_deg < 1.0 - 1e-9 || step_deg > 90.0 + 1e-9)) {
    findings.error("thread.block_step",
                   finding("block_step_deg", step_deg, "0 (one block a pass) or 1 to 90",
                           "the program is too long, or a correction between block ends too coarse"));
  }
  if (p.decimals < 2 || p.decimals > 6) {
    findings.error("thread.decimals",
                   finding("decimals", p.decimals, "2 to 6", "words are too coarse or not accepted"));
  }
  if (p.program_number < 1 || p.program_number > 99999999) {
    findings.error("thread.program_number", finding("program_number", p.program_number, "1 to 99999999",
                                                    "the control stores no such program"));
  }
}

void checkAxes(Parameters p, Limits, Diagnostics& findings) {
  const auto sign = [&](const char* what, double value) {
    if (value != 1.0 && value != -1.0)
      findings.error("thread.axis_sign",
                     finding(what, value, "1 or -1", "the axis moves by a wrong amount or mirrored"));
  };
  sign("x_sign", p.axes.x_sign);
  sign("z_sign", p.axes.z_sign);
  sign("c_sign", p.axes.c_sign);
  if (p.axes.x_factor != 1.0 && p.axes.x_factor != 2.0) {
    findings.error("thread.x_factor", finding("the factor of X words", p.axes.x_factor, "1 or 2",
                                              "half or double the depth is ground"));
  }
}

/// Words that the user supplies may not end the line or open a comment.
void checkCodes(Parameters p, Limits, Diagnostics& findings) {
  const ProgramCodes& c = p.codes;
  for (const std::string* code : {&c.wheel_on, &c.wheel_off, &c.coolant_on, &c.coolant_off, &c.c_axis_on,
                                  &c.c_axis_off, &c.dress, &c.work_offset}) {
    for (const char letter : *code) {
      const bool plain = letter == ' ' || letter == '.' || letter == '-' ||
                         (letter >= '0' && letter <= '9') || (letter >= 'A' && letter <= 'Z');
      if (plain) continue;
      findings.error("thread.codes",
                     fmt::format("codes: '{}' holds a character other than A-Z 0-9 . - and blank: the "
                                 "control would read something else.",
                                 *code));
      break;
    }
  }
}

constexpr std::array<ValueCheck, 12> kValueChecks{
    checkFinite,      checkSizes,        checkProfileAngle, checkStart, checkTaper, checkPassValues,
    checkSpeedValues, checkTravelValues, checkWheelValues,  checkWords, checkAxes,  checkCodes};

}  // namespace

std::span<const ValueCheck> valueChecks() { return kValueChecks; }

std::string finding(std::string_view what, double value, std::string_view limit, std::string_view otherwise) {
  return fmt::format("{} is {:.7g}, expected {}: otherwise {}.", what, value, limit, otherwise);
}

}  // namespace nineline::thread_grinding
