#include "core/thread_grinding/thread_plan.h"

#include <algorithm>
#include <cmath>

namespace nineline::thread_grinding {
namespace {

void deriveWheel(const ThreadParameters& p, ThreadPlan& plan) {
  const bool external = p.type == ThreadType::External;
  plan.wheel_diameter = p.wheel_diameter.value_or(external ? 400.0 : 1.5 * plan.crest_radius);
  plan.wheel_width = p.wheel_width.value_or(p.wheel_ribs * p.pitch);
  plan.wheel_tilt = p.wheel_tilt.value_or(signOf(p.hand) * plan.geometry.helix_angle);
}

void deriveTravel(const ThreadParameters& p, const MachineLimits& limits, ThreadPlan& plan) {
  plan.lead_in_needed = neededLeadIn(std::max(p.speed_first, p.speed_last), plan.geometry.lead, limits);
  const double ribs = (p.wheel_ribs - 1) * p.pitch;  // the leading ribs enter and leave first
  const double usual = std::max(p.pitch, plan.lead_in_needed) + ribs;
  plan.lead_in = p.lead_in.value_or(usual);
  plan.run_out = p.run_out.value_or(usual);
  plan.relief = p.relief.value_or(plan.depth + 2.0 * p.clearance);
  plan.first_wz = p.towards_plus ? -plan.lead_in : p.length + plan.lead_in;
  plan.last_wz = p.towards_plus ? p.length + plan.run_out : -plan.run_out;
}

void derivePasses(const ThreadParameters& p, ThreadPlan& plan) {
  PassPlan passes;
  passes.depth = plan.depth;
  passes.infeed = p.infeed;
  passes.min_last_ratio = p.min_last_pass_ratio;
  passes.finishing_passes = p.finishing_passes;
  passes.finishing_infeed = p.finishing_infeed;
  passes.spark_out_passes = p.spark_out_passes;
  passes.speed_first = p.speed_first;
  passes.speed_last = p.speed_last;
  passes.speed_plan = p.speed_plan;
  const double roughing_depth = plan.depth - p.finishing_passes * p.finishing_infeed;
  if (roughing_depth <= 0.0) return;
  plan.roughing_count = roughingPassCount(roughing_depth, p.infeed, p.min_last_pass_ratio);
  if (plan.roughing_count + p.finishing_passes + p.spark_out_passes > kMostRoughingPasses) return;
  plan.passes = planPasses(passes);
}

}  // namespace

double neededLeadIn(double speed, double lead, const MachineLimits& limits) {
  const double velocity = speed * lead / kTurn;
  return velocity * velocity / (2.0 * limits.z_acceleration) + 5.0 * velocity / limits.velocity_gain;
}

ThreadPlan derive(const ThreadParameters& p, const MachineLimits& limits) {
  ThreadPlan plan;
  const bool external = p.type == ThreadType::External;
  plan.geometry = threadGeometry(p.diameter, p.pitch, p.starts, p.profile_angle, p.depth);
  const ThreadGeometry& thread = plan.geometry;
  plan.depth = p.depth.value_or(external ? thread.external_depth : thread.internal_depth);
  plan.depth_limit = (external ? 7.0 / 8.0 : 3.0 / 4.0) * thread.triangle_height;
  plan.crest_radius = (external ? thread.major_diameter : thread.internal_minor_diameter) / 2.0;
  plan.inward = external ? 1.0 : -1.0;
  deriveWheel(p, plan);
  deriveTravel(p, limits, plan);
  derivePasses(p, plan);
  if (p.start_index) {
    plan.start_indices = {*p.start_index};
  } else {
    for (int i = 0; i < p.starts; ++i) plan.start_indices.push_back(i);
  }
  return plan;
}

double radiusAtDepth(const ThreadPlan& plan, double depth) { return plan.crest_radius - plan.inward * depth; }

ThreadPath passPath(const ThreadParameters& p, const ThreadPlan& plan, double depth, int start_index,
                    double roughing_side) {
  ThreadPath path;
  path.hand = p.hand;
  path.lead = plan.geometry.lead;
  path.phase = p.start_angle + startPhase(start_index, p.starts);
  path.radius = radiusAtDepth(plan, depth);
  path.taper = p.taper;
  path.z_at_zero = p.start_z;
  path.contact_height = p.contact_height;
  if (p.infeed_mode != InfeedMode::Radial)
    path.axial_shift = roughing_side * (plan.depth - depth) * std::tan(plan.geometry.half_angle);
  path.radius += p.taper * path.axial_shift;  // the cone's surface where the shifted groove lies
  return path;
}

double retractX(const ThreadParameters& p, const ThreadPlan& plan) {
  const double cone_1 = p.taper * plan.first_wz;
  const double cone_2 = p.taper * plan.last_wz;
  const double furthest = plan.inward > 0.0 ? std::max(cone_1, cone_2) : std::min(cone_1, cone_2);
  const double radius = radiusAtDepth(plan, plan.depth) + furthest + plan.inward * plan.relief;
  const double height = std::min(std::abs(p.contact_height), std::abs(radius));
  return std::copysign(std::sqrt((std::abs(radius) - height) * (std::abs(radius) + height)), radius);
}

double blocksPerPass(const ThreadParameters& p, const ThreadPlan& plan) {
  if (p.block_step == 0.0) return 1.0;
  const double turn = std::abs(plan.last_wz - plan.first_wz) / plan.geometry.lead * kTurn;
  return std::max(1.0, std::ceil(turn / p.block_step - 1e-9));
}

}  // namespace nineline::thread_grinding
