#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/diagnostics.h"
#include "core/base/result.h"
#include "core/thread_grinding/pass_plan.h"
#include "core/thread_grinding/thread_geometry.h"

namespace nineline::thread_grinding {

/// Where each roughing pass enters: straight, along one flank, or along both flanks in turn.
enum class InfeedMode { Radial, Flank, Alternating };
/// How the spindle comes back: turning backwards to the same C, or going on to the next angle of equal phase.
enum class ReturnMode { Unwind, Continue };
/// InverseTime: G93, F = blocks per minute. PerMinute: G94, F = √(ΔX² + ΔZ² + ΔC_deg²) per minute.
enum class FeedWords { InverseTime, PerMinute };

/// How words become model coordinates: x = sx X/dia + x0, z = sz Z + z0, γ = sc C π/180 + c0.
struct AxisConvention {
  double x_sign = 1.0;    ///< +1: growing X takes the wheel away from the work axis
  double z_sign = 1.0;    ///< +1: growing Z takes the table along +z of the bed
  double c_sign = 1.0;    ///< +1: growing C turns the work counter-clockwise seen from +z
  double x_factor = 1.0;  ///< dia: 2 where X words are diameters, else 1
  double x_zero = 0.0;    ///< mm
  double z_zero = 0.0;    ///< mm
  double c_zero = 0.0;    ///< rad
};

/// What the control executes around the grinding. Empty: nothing but a comment.
struct ProgramCodes {
  std::string wheel_on = "M03";
  std::string wheel_off = "M05";
  std::string coolant_on = "M08";
  std::string coolant_off = "M09";
  std::string c_axis_on;  ///< makes the work spindle an axis
  std::string c_axis_off;
  std::string dress;  ///< starts the dressing cycle
  std::string work_offset = "G54";
};

/// All that a thread-grinding program depends on. mm, rad, s, mm/s; absent values are derived (see `derive`).
struct ThreadParameters {
  std::string name;
  double diameter = 0.0;  ///< nominal: major diameter of both external and internal threads
  double pitch = 0.0;
  double length = 0.0;  ///< of the full thread, along the axis
  int starts = 1;
  std::optional<int> start_index;  ///< grinds this start only, from 0; absent: all starts
  Hand hand = Hand::Right;
  ThreadType type = ThreadType::External;
  double profile_angle = kIsoProfileAngle;
  std::optional<double> depth;  ///< radial, below the crest; absent: ISO 68-1
  double taper = 0.0;           ///< mm of radius for each mm along +wz
  double start_angle = 0.0;     ///< of the groove at the thread's beginning, workpiece frame
  double start_z = 0.0;         ///< z (model) where the thread's beginning meets the wheel: K0

  double infeed = 0.02;
  double min_last_pass_ratio = 0.25;
  InfeedMode infeed_mode = InfeedMode::Radial;
  int finishing_passes = 0;
  double finishing_infeed = 0.005;
  int spark_out_passes = 2;
  double speed_first = perSecondFromPerMinute(10.0 * kTurn);  ///< work spindle, rad/s
  double speed_last = perSecondFromPerMinute(40.0 * kTurn);
  SpeedPlan speed_plan = SpeedPlan::Linear;

  bool towards_plus = true;       ///< cuts from the beginning (wz = 0) towards +wz; false: the other way
  std::optional<double> lead_in;  ///< absent: one pitch or what accelerating needs
  std::optional<double> run_out;
  std::optional<double> shoulder;  ///< free length behind the thread's end; absent: no shoulder
  std::optional<double> relief;    ///< radial retract from full depth before the return
  double clearance = 0.5;          ///< least radial distance to the crest while returning
  double safety = 5.0;             ///< further distance for approach and end
  ReturnMode return_mode = ReturnMode::Unwind;

  std::optional<double> wheel_diameter;  ///< absent: 400 external, 3/4 of the bore internal
  std::optional<double> wheel_width;     ///< absent: ribs · pitch
  int wheel_ribs = 1;
  std::optional<double> wheel_tilt;  ///< absent: helix angle at d2, sign of the hand
  double contact_height = 0.0;       ///< of the grinding point over the work axis
  int dress_every_passes = 0;        ///< 0: never

  double block_step = radFromDeg(15.0);  ///< of C for each block; 0: one block for each pass
  int decimals = 3;
  int program_number = 1;
  FeedWords feed_words = FeedWords::InverseTime;
  double infeed_speed = 5.0;  ///< mm/s of X when it sets the depth
  AxisConvention axes;
  ProgramCodes codes;
};

/// What the machine can do. Absent: unknown, not checked. Axis values as the control shows them (radius).
struct MachineLimits {
  struct Range {
    double low = 0.0;
    double high = 0.0;
  };
  std::optional<Range> x;                 ///< mm
  std::optional<Range> z;                 ///< mm
  std::optional<double> c_speed;          ///< rad/s
  std::optional<double> z_speed;          ///< mm/s: rapid
  std::optional<double> most_blocks;      ///< that the control's memory takes
  double z_acceleration = 500.0;          ///< mm/s²
  double velocity_gain = 20.0;            ///< Kv of the Z servo loop, 1/s
  std::optional<double> c_velocity_gain;  ///< Kv of the C loop; absent: as Z
  std::optional<AxisConvention> axes;     ///< how the machine really moves; absent: as the parameters say
};

struct ThreadJob {
  ThreadParameters parameters;
  MachineLimits limits;
  Diagnostics warnings;  ///< unknown keys
};

/// Reads `nineline-thread/1` (resources/docs/thread-parameters.md). Unknown keys are warnings; a value of the
/// wrong kind is BadInput with its place. Whether the values make a thread is `checkThread`'s question.
[[nodiscard]] Result<ThreadJob> parseThreadJob(std::string_view text, const std::string& source);

}  // namespace nineline::thread_grinding
