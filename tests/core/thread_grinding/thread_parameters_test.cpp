#include "core/thread_grinding/thread_parameters.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace nineline::thread_grinding {
namespace {

using testing::HasSubstr;

const char* const kShortest =
    R"({"format": "nineline-thread/1", "diameter_mm": 48, "pitch_mm": 1.5, "length_mm": 15})";

std::string with(const std::string& members) {
  return R"({"format": "nineline-thread/1", "diameter_mm": 48, "pitch_mm": 1.5, "length_mm": 15, )" +
         members + "}";
}

TEST(ThreadParameters, ThreeSizesAreEnough) {
  const Result<ThreadJob> job = parseThreadJob(kShortest, "p.json");
  ASSERT_TRUE(job) << job.error().message();
  const ThreadParameters& p = job->parameters;
  EXPECT_DOUBLE_EQ(p.diameter, 48.0);
  EXPECT_DOUBLE_EQ(p.infeed, 0.02);
  EXPECT_EQ(p.hand, Hand::Right);
  EXPECT_DOUBLE_EQ(p.block_step, radFromDeg(15.0));
  EXPECT_FALSE(p.depth);
  EXPECT_FALSE(job->limits.z);
}

TEST(ThreadParameters, UnitsAreConverted) {
  const Result<ThreadJob> job = parseThreadJob(
      with(R"("speed_first_rpm": 30, "wheel_tilt_deg": -0.5, "infeed_feed_mm_min": 120, "start_angle_deg": 90,
              "limits": {"x_mm": [-50, 350], "z_mm": [-400, 400], "c_max_rpm": 60, "z_max_mm_min": 6000})"),
      "p.json");
  ASSERT_TRUE(job) << job.error().message();
  EXPECT_DOUBLE_EQ(job->parameters.speed_first, kPi);
  EXPECT_DOUBLE_EQ(*job->parameters.wheel_tilt, radFromDeg(-0.5));
  EXPECT_DOUBLE_EQ(job->parameters.infeed_speed, 2.0);
  EXPECT_DOUBLE_EQ(job->parameters.start_angle, kPi / 2.0);
  EXPECT_DOUBLE_EQ(job->limits.x->high, 350.0);
  EXPECT_DOUBLE_EQ(*job->limits.c_speed, kTurn);
  EXPECT_DOUBLE_EQ(*job->limits.z_speed, 100.0);
}

TEST(ThreadParameters, ChoicesAxesAndCodesAreRead) {
  const Result<ThreadJob> job = parseThreadJob(
      with(R"("hand": "left", "type": "internal", "speed_plan": "geometric", "return_mode": "continue",
              "direction": "minus", "feed_mode": "per-minute", "infeed_mode": "alternating", "dialect": "fanuc",
              "depth_mm": null, "start_index": 1, "starts": 2,
              "axes": {"z_sign": -1, "x_is_diameter": true, "c_zero_deg": 180},
              "codes": {"dress": "M50", "work_offset": ""})"),
      "p.json");
  ASSERT_TRUE(job) << job.error().message();
  const ThreadParameters& p = job->parameters;
  EXPECT_EQ(p.hand, Hand::Left);
  EXPECT_EQ(p.type, ThreadType::Internal);
  EXPECT_EQ(p.speed_plan, SpeedPlan::Geometric);
  EXPECT_EQ(p.return_mode, ReturnMode::Continue);
  EXPECT_FALSE(p.towards_plus);
  EXPECT_EQ(p.feed_words, FeedWords::PerMinute);
  EXPECT_EQ(p.infeed_mode, InfeedMode::Alternating);
  EXPECT_FALSE(p.depth);
  EXPECT_EQ(p.start_index, 1);
  EXPECT_DOUBLE_EQ(p.axes.z_sign, -1.0);
  EXPECT_DOUBLE_EQ(p.axes.x_factor, 2.0);
  EXPECT_DOUBLE_EQ(p.axes.c_zero, kPi);
  EXPECT_EQ(p.codes.dress, "M50");
  EXPECT_EQ(p.codes.work_offset, "");
}

TEST(ThreadParameters, UnknownKeysAreWarningsWithTheirPlace) {
  const Result<ThreadJob> job = parseThreadJob(
      with("\n\"pich_mm\": 2, \"axes\": {\"y_sign\": 1}, \"limits\": {\"y_mm\": [0, 1]}"), "p.json");
  ASSERT_TRUE(job) << job.error().message();
  const std::vector<Diagnostic>& warnings = job->warnings.all();
  ASSERT_EQ(warnings.size(), 3U);
  EXPECT_EQ(warnings[0].code, "thread.unknown_key");
  EXPECT_THAT(warnings[0].text, HasSubstr("'pich_mm'"));
  EXPECT_EQ(warnings[0].line, 2U);
  EXPECT_THAT(warnings[1].text, HasSubstr("'y_sign'"));
  EXPECT_THAT(warnings[2].text, HasSubstr("'y_mm'"));
}

struct Bad {
  const char* text;
  const char* code;
  const char* says;
};

TEST(ThreadParameters, WrongValuesNameKeyPlaceAndExpectation) {
  const std::vector<Bad> cases{
      {R"({"format": "nineline-thread/1", "pitch_mm": 1.5, "length_mm": 15})", "json.missing",
       "'diameter_mm'"},
      {R"({"diameter_mm": 48, "pitch_mm": 1.5, "length_mm": 15})", "thread.format", "nineline-thread/1"},
      {R"({"format": "nineline-thread/2", "diameter_mm": 48, "pitch_mm": 1.5, "length_mm": 15})",
       "thread.format", "nineline-thread/2"},
      {R"([1, 2])", "json.type", "expected an object"},
      {R"({"format": )", "", ""},
      {R"({"format": "nineline-thread/1", "diameter_mm": "48", "pitch_mm": 1.5, "length_mm": 15})",
       "json.type", "'diameter_mm' is the text '48', expected a number"},
      {R"({"format": "nineline-thread/1", "diameter_mm": null, "pitch_mm": 1.5, "length_mm": 15})",
       "json.type", "'diameter_mm'"},
  };
  for (const Bad& bad : cases) {
    SCOPED_TRACE(bad.text);
    const Result<ThreadJob> job = parseThreadJob(bad.text, "p.json");
    ASSERT_FALSE(job);
    EXPECT_EQ(job.error().kind, ErrorKind::BadInput);
    EXPECT_EQ(job.error().source, "p.json");
    EXPECT_GE(job.error().line, 1U);
    if (*bad.code != '\0') {
      EXPECT_EQ(job.error().code, bad.code);
    }
    EXPECT_THAT(job.error().text, HasSubstr(bad.says));
  }
}

TEST(ThreadParameters, WrongMembersNameKeyAndExpectation) {
  const std::vector<Bad> cases{
      {R"("hand": "lefty")", "thread.choice", "'hand' is 'lefty', expected 'right' or 'left'"},
      {R"("starts": 1.5)", "thread.whole_number", "'starts' is 1.5, expected a whole number"},
      {R"("starts": 1e99)", "thread.whole_number", "'starts'"},
      {R"("start_index": 0.5)", "thread.whole_number", "'start_index'"},
      {R"("axes": 3)", "json.type", "axes"},
      {R"("axes": {"x_is_diameter": 1})", "json.type", "'x_is_diameter'"},
      {R"("limits": {"x_mm": [5, 5]})", "thread.range", "expected [lower, higher]"},
      {R"("limits": {"x_mm": [5]})", "json.count", "'x_mm'"},
      {R"("codes": {"dress": 50})", "json.type", "'dress'"},
      {R"("dialect": "siemens")", "thread.choice", "expected 'fanuc'"},
  };
  for (const Bad& bad : cases) {
    SCOPED_TRACE(bad.text);
    const Result<ThreadJob> job = parseThreadJob(with(bad.text), "p.json");
    ASSERT_FALSE(job);
    EXPECT_EQ(job.error().code, bad.code);
    EXPECT_THAT(job.error().text, HasSubstr(bad.says));
  }
}

}  // namespace
}  // namespace nineline::thread_grinding
