#include "core/thread_grinding/thread_parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/base/json.h"
#include "core/base/text.h"

namespace nineline::thread_grinding {
namespace {

/// A JsonReader that knows which keys it was asked for.
class Fields {
 public:
  Fields(const Json& object, const std::string& source, const std::string& what)
      : reader_(object, source, what), what_(what) {}

  double number(const char* key) { return asked(key), reader_.number(key); }
  void read(const char* key, double& target, double factor = 1.0) {
    asked(key);
    if (given(key)) target = reader_.number(key) * factor;
  }
  void read(const char* key, std::optional<double>& target, double factor = 1.0) {
    asked(key);
    if (given(key)) target = reader_.number(key) * factor;
  }
  void read(const char* key, int& target) {
    asked(key);
    if (!given(key)) return;
    const double value = reader_.number(key);
    if (std::abs(value) > 1e9 || value != std::floor(value)) {
      reader_.fail(key, "thread.whole_number",
                   fmt::format("'{}' is {}, expected a whole number.", key, value));
      return;
    }
    target = static_cast<int>(value);
  }
  void read(const char* key, std::optional<int>& target) {
    asked(key);
    if (!given(key)) return;
    int value = 0;
    read(key, value);
    target = value;
  }
  void read(const char* key, std::string& target) {
    asked(key);
    if (given(key)) target = reader_.string(key);
  }
  void read(const char* key, bool& target) {
    asked(key);
    if (given(key)) target = reader_.booleanOr(key, target);
  }
  template <typename Enum>
  void choose(const char* key, Enum& target, const std::vector<std::pair<std::string_view, Enum>>& choices) {
    std::string text;
    read(key, text);
    if (text.empty() || reader_.failed()) return;
    std::string expected;
    for (const auto& [name, value] : choices) {
      if (name == text) {
        target = value;
        return;
      }
      expected += expected.empty() ? fmt::format("'{}'", name) : fmt::format(" or '{}'", name);
    }
    reader_.fail(key, "thread.choice",
                 fmt::format("'{}' is '{}', expected {}.", key, printable(text), expected));
  }
  /// The object at `key`, null when absent.
  const Json* object(const char* key) { return asked(key), given(key) ? reader_.json().find(key) : nullptr; }
  void range(const char* key, std::optional<MachineLimits::Range>& target) {
    asked(key);
    if (!given(key)) return;
    const std::vector<double> ends = reader_.numbers(key, 2);
    if (reader_.failed()) return;
    if (ends[0] >= ends[1]) {
      reader_.fail(key, "thread.range",
                   fmt::format("'{}' is [{}, {}], expected [lower, higher].", key, ends[0], ends[1]));
      return;
    }
    target = MachineLimits::Range{ends[0], ends[1]};
  }
  void warnUnknown(Diagnostics& warnings) const {
    if (reader_.json().members() == nullptr) return;
    for (const auto& [key, value] : *reader_.json().members()) {
      if (std::find(asked_.begin(), asked_.end(), key) != asked_.end()) continue;
      warnings.warning("thread.unknown_key",
                       fmt::format("{}: '{}' is no known key; it is ignored.", what_, printable(key)),
                       value.line(), value.column());
    }
  }
  JsonReader& reader() { return reader_; }

 private:
  void asked(const char* key) { asked_.emplace_back(key); }
  /// Absent and null both mean: the default.
  [[nodiscard]] bool given(const char* key) const {
    const Json* found = reader_.json().find(key);
    return found != nullptr && !found->isNull();
  }
  JsonReader reader_;
  std::string what_;
  std::vector<std::string> asked_;
};

constexpr double kDegree = radFromDeg(1.0);
constexpr double kTurnPerMinute = perSecondFromPerMinute(kTurn);
constexpr double kMillimetrePerMinute = perSecondFromPerMinute(1.0);

void readThread(Fields& fields, ThreadParameters& p) {
  fields.read("name", p.name);
  p.diameter = fields.number("diameter_mm");
  p.pitch = fields.number("pitch_mm");
  p.length = fields.number("length_mm");
  fields.read("starts", p.starts);
  fields.read("start_index", p.start_index);
  fields.choose<Hand>("hand", p.hand, {{"right", Hand::Right}, {"left", Hand::Left}});
  fields.choose<ThreadType>("type", p.type,
                            {{"external", ThreadType::External}, {"internal", ThreadType::Internal}});
  fields.read("profile_angle_deg", p.profile_angle, kDegree);
  fields.read("depth_mm", p.depth);
  fields.read("taper_1", p.taper);
  fields.read("start_angle_deg", p.start_angle, kDegree);
  fields.read("start_z_mm", p.start_z);
}

void readPasses(Fields& fields, ThreadParameters& p) {
  fields.read("infeed_mm", p.infeed);
  fields.read("min_last_pass_ratio", p.min_last_pass_ratio);
  fields.choose<InfeedMode>("infeed_mode", p.infeed_mode,
                            {{"radial", InfeedMode::Radial},
                             {"flank", InfeedMode::Flank},
                             {"alternating", InfeedMode::Alternating}});
  fields.read("finishing_passes", p.finishing_passes);
  fields.read("finishing_infeed_mm", p.finishing_infeed);
  fields.read("spark_out_passes", p.spark_out_passes);
  fields.read("speed_first_rpm", p.speed_first, kTurnPerMinute);
  fields.read("speed_last_rpm", p.speed_last, kTurnPerMinute);
  fields.choose<SpeedPlan>("speed_plan", p.speed_plan,
                           {{"linear", SpeedPlan::Linear}, {"geometric", SpeedPlan::Geometric}});
  fields.read("infeed_feed_mm_min", p.infeed_speed, kMillimetrePerMinute);
}

void readTravel(Fields& fields, ThreadParameters& p) {
  fields.choose<bool>("direction", p.towards_plus, {{"plus", true}, {"minus", false}});
  fields.read("lead_in_mm", p.lead_in);
  fields.read("run_out_mm", p.run_out);
  fields.read("shoulder_mm", p.shoulder);
  fields.read("relief_mm", p.relief);
  fields.read("clearance_mm", p.clearance);
  fields.read("safety_mm", p.safety);
  fields.choose<ReturnMode>("return_mode", p.return_mode,
                            {{"unwind", ReturnMode::Unwind}, {"continue", ReturnMode::Continue}});
}

void readWheel(Fields& fields, ThreadParameters& p) {
  fields.read("wheel_diameter_mm", p.wheel_diameter);
  fields.read("wheel_width_mm", p.wheel_width);
  fields.read("wheel_ribs", p.wheel_ribs);
  fields.read("wheel_tilt_deg", p.wheel_tilt, kDegree);
  fields.read("grinding_height_mm", p.contact_height);
  fields.read("dress_every_passes", p.dress_every_passes);
}

void readProgram(Fields& fields, ThreadParameters& p) {
  fields.read("block_step_deg", p.block_step, kDegree);
  fields.read("decimals", p.decimals);
  fields.read("program_number", p.program_number);
  fields.choose<FeedWords>("feed_mode", p.feed_words,
                           {{"inverse-time", FeedWords::InverseTime}, {"per-minute", FeedWords::PerMinute}});
  int fanuc = 0;  // the only dialect written so far
  fields.choose<int>("dialect", fanuc, {{"fanuc", 0}});
}

void readAxes(const Json& object, const std::string& source, AxisConvention& axes, Diagnostics& warnings,
              std::optional<Error>& error) {
  Fields fields(object, source, "axes");
  bool diameter = axes.x_factor == 2.0;
  fields.read("x_sign", axes.x_sign);
  fields.read("z_sign", axes.z_sign);
  fields.read("c_sign", axes.c_sign);
  fields.read("x_is_diameter", diameter);
  fields.read("x_zero_mm", axes.x_zero);
  fields.read("z_zero_mm", axes.z_zero);
  fields.read("c_zero_deg", axes.c_zero, kDegree);
  axes.x_factor = diameter ? 2.0 : 1.0;
  fields.warnUnknown(warnings);
  if (fields.reader().failed()) error = fields.reader().error();
}

void readCodes(const Json& object, const std::string& source, ProgramCodes& codes, Diagnostics& warnings,
               std::optional<Error>& error) {
  Fields fields(object, source, "codes");
  fields.read("wheel_on", codes.wheel_on);
  fields.read("wheel_off", codes.wheel_off);
  fields.read("coolant_on", codes.coolant_on);
  fields.read("coolant_off", codes.coolant_off);
  fields.read("c_axis_on", codes.c_axis_on);
  fields.read("c_axis_off", codes.c_axis_off);
  fields.read("dress", codes.dress);
  fields.read("work_offset", codes.work_offset);
  fields.warnUnknown(warnings);
  if (fields.reader().failed()) error = fields.reader().error();
}

void readLimits(const Json& object, const std::string& source, MachineLimits& limits, Diagnostics& warnings,
                std::optional<Error>& error) {
  Fields fields(object, source, "limits");
  fields.range("x_mm", limits.x);
  fields.range("z_mm", limits.z);
  fields.read("c_max_rpm", limits.c_speed, kTurnPerMinute);
  fields.read("z_max_mm_min", limits.z_speed, kMillimetrePerMinute);
  fields.read("z_acceleration_mm_s2", limits.z_acceleration);
  fields.read("z_velocity_gain_1_s", limits.velocity_gain);
  fields.read("c_velocity_gain_1_s", limits.c_velocity_gain);
  fields.read("max_blocks", limits.most_blocks);
  fields.warnUnknown(warnings);
  if (fields.reader().failed()) error = fields.reader().error();
}

}  // namespace

Result<ThreadJob> parseThreadJob(std::string_view text, const std::string& source) {
  const Result<Json> json = parseJson(text, source);
  if (!json) return json.error();
  Fields fields(*json, source, "thread parameters");
  if (fields.reader().failed()) return fields.reader().error();
  ThreadJob job;
  std::string format;
  fields.read("format", format);
  if (!fields.reader().failed() && format != "nineline-thread/1") {
    fields.reader().fail("format", "thread.format",
                         fmt::format("'format' is '{}', expected 'nineline-thread/1'.", printable(format)));
  }
  readThread(fields, job.parameters);
  readPasses(fields, job.parameters);
  readTravel(fields, job.parameters);
  readWheel(fields, job.parameters);
  readProgram(fields, job.parameters);
  std::optional<Error> error;
  const Json* axes = fields.object("axes");
  const Json* codes = fields.object("codes");
  const Json* limits = fields.object("limits");
  if (fields.reader().failed()) return fields.reader().error();
  fields.warnUnknown(job.warnings);
  if (axes != nullptr) readAxes(*axes, source, job.parameters.axes, job.warnings, error);
  if (codes != nullptr) readCodes(*codes, source, job.parameters.codes, job.warnings, error);
  if (limits != nullptr) readLimits(*limits, source, job.limits, job.warnings, error);
  if (error) return *error;
  return job;
}

}  // namespace nineline::thread_grinding
