#include "core/thread_grinding/thread_checks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "core/thread_grinding/thread_generator.h"

namespace nineline::thread_grinding {
namespace {

using testing::HasSubstr;

ThreadParameters soundThread() {
  ThreadParameters p;
  p.diameter = 48.0;
  p.pitch = 1.5;
  p.length = 15.0;
  return p;
}

struct Draft {
  ThreadParameters p = soundThread();
  MachineLimits limits;
};

struct Case {
  void (*change)(Draft&);
  Severity severity;
  const char* code;
  const char* says;
};

void expectFinding(const Case& bad) {
  Draft draft;
  bad.change(draft);
  const Diagnostics findings = checkThread(draft.p, draft.limits);
  const Diagnostic* found = nullptr;
  for (const Diagnostic& finding : findings.all()) {
    if (finding.code == bad.code && finding.severity == bad.severity) found = &finding;
  }
  ASSERT_NE(found, nullptr) << bad.code << " was not found";
  EXPECT_THAT(found->text, HasSubstr(bad.says));
  EXPECT_THAT(found->text, HasSubstr("expected"));
  EXPECT_THAT(found->text, HasSubstr("otherwise"));
  const Result<ThreadProgram> program = generateThread(draft.p, draft.limits);
  EXPECT_EQ(program.has_value(), bad.severity == Severity::Warning);
  if (!program) {
    EXPECT_NE(program.error().code, "thread.hand_check");
  }
}

void expectFindings(const std::vector<Case>& cases) {
  for (std::size_t i = 0; i < cases.size(); ++i) {
    SCOPED_TRACE(testing::Message() << "case " << i << " " << cases[i].code);
    expectFinding(cases[i]);
  }
}

TEST(ThreadChecks, SoundParametersGiveNoFinding) {
  EXPECT_TRUE(checkThread(soundThread(), {}).all().empty());
  ThreadParameters internal = soundThread();
  internal.type = ThreadType::Internal;
  EXPECT_TRUE(checkThread(internal, {}).all().empty());
}

TEST(ThreadChecks, SizesOutOfLimits) {
  expectFindings({
      {[](Draft& d) { d.p.diameter = 0.0; }, Severity::Error, "thread.diameter", "diameter_mm is 0"}
      // namespace
      ,
      {[](Draft& d) { d.p.diameter = 1.0; }  // namespace nineline::thread_grinding
       ,
       Severity::Error, "thread.diameter", "too coarse"},
      {[](Draft& d) { d.p.pitch = -1.5; }, Severity::Error, "thread.pitch",
       "pitch_mm is -1.5, expected above 0"},
      {[](Draft& d) { d.p.starts = 0; }, Severity::Error, "thread.starts", "at least 1"},
      {[](Draft& d) { d.p.starts = 101; }, Severity::Error, "thread.starts", "at most 100"},
      {[](Draft& d) { d.p.starts = 18; }, Severity::Warning, "thread.helix_angle", "at most 10"},
      {[](Draft& d) { d.p.length = 0.01; }, Severity::Error, "thread.length", "above 0.01"},
      {[](Draft& d) { d.p.length = 0.0; }, Severity::Error, "thread.length", "nothing is ground"},
      {[](Draft& d) { d.p.pitch = std::numeric_limits<double>::quiet_NaN(); }, Severity::Error,
       "thread.finite", "nan"},
      {[](Draft& d) { d.p.lead_in = std::numeric_limits<double>::infinity(); }, Severity::Error,
       "thread.finite", "inf"},
      {[](Draft& d) { d.p.profile_angle = radFromDeg(10.0); }, Severity::Error, "thread.profile_angle",
       "20 to 120"},
      {[](Draft& d) { d.p.profile_angle = radFromDeg(55.0); }, Severity::Error, "thread.profile_angle",
       "depth_mm"},
      {[](Draft& d) { d.p.depth = 1.14; }, Severity::Error, "thread.depth", "sharp root"},
      {[](Draft& d) { d.p.depth = 0.0; }, Severity::Error, "thread.depth", "above 0"},
      {[](Draft& d) { d.p.start_index = 1; }, Severity::Error, "thread.start_index", "0 to 0"},
      {[](Draft& d) { d.p.taper = 0.2; }, Severity::Error, "thread.taper", "0.2"},
      {[](Draft& d) { d.p.taper = 0.1; }, Severity::Warning, "thread.taper", "0.0625"},
      {[](Draft& d) { d.p.contact_height = 22.9; }, Severity::Error, "thread.grinding_height",
       "above the work"},
      {[](Draft& d) { d.p.contact_height = -12.0; }, Severity::Warning, "thread.grinding_height", "half"},
  });
}

TEST(ThreadChecks, PassesOutOfLimits) {
  expectFindings({
      {[](Draft& d) { d.p.infeed = 0.0; }, Severity::Error, "thread.infeed", "never end"},
      {[](Draft& d) { d.p.infeed = 1.0; }, Severity::Error, "thread.infeed", "at most depth_mm"},
      {[](Draft& d) { d.p.infeed = 0.0005; }, Severity::Error, "thread.infeed", "word step 0.001"},
      {[](Draft& d) { d.p.infeed = 5e-5, d.p.decimals = 5; }, Severity::Error, "thread.infeed",
       "number of passes"},
      {[](Draft& d) { d.p.infeed = 0.15; }, Severity::Warning, "thread.infeed", "burn"},
      {[](Draft& d) { d.p.min_last_pass_ratio = 1.5; }, Severity::Error, "thread.min_last_pass_ratio",
       "0 to 1"},
      {[](Draft& d) { d.p.spark_out_passes = -1; }, Severity::Error, "thread.spark_out_passes", "at least 0"},
      {[](Draft& d) { d.p.spark_out_passes = 0; }, Severity::Warning, "thread.spark_out_passes", "settled"},
      {[](Draft& d) { d.p.spark_out_passes = 20000; }, Severity::Error, "thread.finishing_passes",
       "number of passes"},
      {[](Draft& d) { d.p.finishing_passes = -1; }, Severity::Error, "thread.finishing_passes", "at least 0"},
      {[](Draft& d) { d.p.finishing_passes = 2, d.p.finishing_infeed = 0.0; }, Severity::Error,
       "thread.finishing_infeed", "spark_out"},
      {[](Draft& d) { d.p.finishing_passes = 1, d.p.decimals = 2; }, Severity::Error,
       "thread.finishing_infeed", "word step 0.01"},
      {[](Draft& d) { d.p.finishing_passes = 10, d.p.finishing_infeed = 0.1; }, Severity::Error,
       "thread.finishing_passes", "roughing"},
      {[](Draft& d) { d.p.speed_first = 0.0; }, Severity::Error, "thread.speed", "does not turn"},
      {[](Draft& d) { d.p.speed_last = d.p.speed_first / 2.0; }, Severity::Warning, "thread.speed", "falls"},
      {[](Draft& d) { d.limits.c_speed = d.p.speed_last * 0.9; }, Severity::Error, "thread.speed", "C axis"},
      {[](Draft& d) { d.limits.z_speed = 0.9; }, Severity::Error, "thread.speed", "Z axis"},
      {[](Draft& d) { d.limits.velocity_gain = 30.0, d.limits.c_velocity_gain = 33.0; }, Severity::Warning,
       "thread.velocity_gain", "is 2.272727"},  // 0.75 mm/s · (1/30 − 1/33) s
      {[](Draft& d) { d.limits.velocity_gain = 0.0; }, Severity::Error, "thread.velocity_gain", "above 0"},
      {[](Draft& d) { d.limits.z_acceleration = 0.0; }, Severity::Error, "thread.z_acceleration", "above 0"},
      {[](Draft& d) { d.p.infeed_speed = 0.0; }, Severity::Error, "thread.infeed_feed", "above 0"},
  });
}

TEST(ThreadChecks, TravelOutOfLimits) {
  expectFindings({
      {[](Draft& d) { d.p.lead_in = -0.1; }, Severity::Error, "thread.lead_in", "at least 0"},
      {[](Draft& d) { d.p.lead_in = 0.5; }, Severity::Warning, "thread.lead_in", "at least 0.75"},
      {[](Draft& d) { d.p.pitch = 3.0, d.p.speed_last = 30.0, d.p.lead_in = 2.0; }, Severity::Warning,
       "thread.lead_in", "accelerate"},
      {[](Draft& d) { d.p.run_out = -0.1; }, Severity::Error, "thread.run_out", "at least 0"},
      {[](Draft& d) { d.p.run_out = 0.0; }, Severity::Warning, "thread.run_out", "incomplete"},
      {[](Draft& d) { d.p.shoulder = -1.0; }, Severity::Error, "thread.shoulder", "at least 0"},
      {[](Draft& d) { d.p.shoulder = 2.0; }, Severity::Error, "thread.shoulder", "runs into"},
      {[](Draft& d) { d.p.relief = 1.0; }, Severity::Error, "thread.relief", "drags"},
      {[](Draft& d) { d.p.clearance = 0.0; }, Severity::Error, "thread.clearance", "above 0"},
      {[](Draft& d) { d.p.safety = -1.0; }, Severity::Error, "thread.safety", "above 0"},
      {[](Draft& d) {
         d.limits.z = MachineLimits::Range{-16.0, 10.0};
       },
       Severity::Error, "thread.travel", "Z in mm is -16.5, expected -16 to 10"},
      {[](Draft& d) {
         d.limits.x = MachineLimits::Range{0.0, 29.0};
       },
       Severity::Error, "thread.travel", "X in mm is 30, expected 0 to 29"},
  });
}

TEST(ThreadChecks, WheelOutOfLimits) {
  expectFindings({
      {[](Draft& d) { d.p.wheel_diameter = 0.0; }, Severity::Error, "thread.wheel_diameter", "above 0"},
      {[](Draft& d) { d.p.type = ThreadType::Internal, d.p.wheel_diameter = 46.0; }, Severity::Error,
       "thread.wheel_diameter", "bore"},
      {[](Draft& d) { d.p.wheel_width = 0.0; }, Severity::Error, "thread.wheel_width", "above 0"},
      {[](Draft& d) { d.p.wheel_width = 4.0, d.p.wheel_ribs = 3; }, Severity::Error, "thread.wheel_width",
       "at least 4.5"},
      {[](Draft& d) { d.p.wheel_ribs = 0; }, Severity::Error, "thread.wheel_ribs", "at least 1"},
      {[](Draft& d) { d.p.wheel_ribs = 3, d.p.lead_in = 3.0; }, Severity::Warning, "thread.lead_in",
       "at least 3.75"},
      // M48x1.5, right hand: an untilted wheel takes 6.4 µm, the wrong sign four times as much.
      {[](Draft& d) { d.p.wheel_tilt = 0.0; }, Severity::Warning, "thread.wheel_tilt", "by -6.4 um"},
      {[](Draft& d) { d.p.wheel_tilt = radFromDeg(-0.5817); }, Severity::Warning, "thread.wheel_tilt",
       "by -26.0 um"},
      {[](Draft& d) { d.p.wheel_tilt = radFromDeg(60.0); }, Severity::Error, "thread.wheel_tilt", "across"},
      {[](Draft& d) { d.p.dress_every_passes = -1; }, Severity::Error, "thread.dress_every_passes",
       "at least 0"},
  });
}

TEST(ThreadChecks, WordsOutOfLimits) {
  expectFindings({
      {[](Draft& d) { d.p.block_step = radFromDeg(0.5); }, Severity::Error, "thread.block_step", "1 to 90"},
      {[](Draft& d) { d.p.block_step = radFromDeg(91.0); }, Severity::Error, "thread.block_step", "1 to 90"},
      {[](Draft& d) { d.limits.most_blocks = 1000.0; }, Severity::Error, "thread.block_step", "cannot hold"},
      {[](Draft& d) { d.p.decimals = 1; }, Severity::Error, "thread.decimals", "2 to 6"},
      {[](Draft& d) { d.p.program_number = 0; }, Severity::Error, "thread.program_number", "1 to"},
      {[](Draft& d) { d.p.axes.x_sign = 0.0; }, Severity::Error, "thread.axis_sign", "x_sign is 0"},
      {[](Draft& d) { d.p.axes.z_sign = 2.0; }, Severity::Error, "thread.axis_sign", "z_sign is 2"},
      {[](Draft& d) { d.p.axes.c_sign = -0.5; }, Severity::Error, "thread.axis_sign", "c_sign is -0.5"},
      {[](Draft& d) { d.p.axes.x_factor = 3.0; }, Severity::Error, "thread.x_factor", "1 or 2"},
  });
}

TEST(ThreadChecks, CodesThatWouldReadAsSomethingElse) {
  for (const char* code : {"M50\nG00 X0", "(M50", "M50;", "m50"}) {
    ThreadParameters p = soundThread();
    p.codes.dress = code;
    const Diagnostics findings = checkThread(p, {});
    ASSERT_TRUE(findings.hasErrors()) << code;
    EXPECT_EQ(findings.firstError("").code, "thread.codes");
  }
}

TEST(ThreadChecks, EveryFaultIsReportedAtOnce) {
  ThreadParameters p = soundThread();
  p.pitch = -1.0;
  p.infeed = 0.0;
  p.decimals = 9;
  std::size_t errors = 0;
  const Diagnostics findings = checkThread(p, {});
  for (const Diagnostic& finding : findings.all()) errors += finding.severity == Severity::Error ? 1U : 0U;
  EXPECT_EQ(errors, 3U);
}

}  // namespace
}  // namespace nineline::thread_grinding
