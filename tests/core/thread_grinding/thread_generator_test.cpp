#include "core/thread_grinding/thread_generator.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <string>

#include "core/base/file.h"
#include "core/base/text.h"
#include "core/nc/interpreter.h"
#include "core/nc/text_source.h"
#include "core/thread_grinding/program_moves.h"

namespace nineline::thread_grinding {
namespace {

using testing::HasSubstr;

ThreadParameters literatureThread() {
  ThreadParameters p;
  p.diameter = 48.0;
  p.pitch = 1.5;
  p.length = 15.0;
  p.hand = Hand::Left;
  p.spark_out_passes = 0;
  return p;
}

/// Programs are long: a failure should not print them.
bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// The literature's thread in few passes.
ThreadParameters quickThread() {
  ThreadParameters p = literatureThread();
  p.infeed = 0.3;
  p.spark_out_passes = 1;
  return p;
}

ThreadProgram generated(const ThreadParameters& p) {
  Result<ThreadProgram> program = generateThread(p, {});
  if (!program) {
    ADD_FAILURE() << program.error().message();
    return {};
  }
  return *program;
}

/// The cuts that a program makes on its blank, judged by nobody.
std::vector<GrooveRun> cutsOf(const ThreadParameters& p) {
  VirtualCut cut(blankOf(p, derive(p, {})));
  const Result<void> read =
      forEachMove(generated(p).text, p.axes, [&](const VirtualMove& move) { cut.add(move); });
  EXPECT_TRUE(read);
  cut.finish();
  EXPECT_FALSE(cut.fault()) << *cut.fault();
  return cut.runs();
}

TEST(ThreadGenerator, LiteratureCaseGrinds46PassesOfALeftHandThread) {
  const Result<std::string> file =
      readFile(std::string(NINELINE_SOURCE_DIR) + "/resources/examples/published-thread.json");
  ASSERT_TRUE(file) << file.error().message();
  const Result<ThreadJob> job = parseThreadJob(*file, "published-thread.json");
  ASSERT_TRUE(job) << job.error().message();
  EXPECT_TRUE(job->warnings.all().empty());
  const Result<ThreadProgram> program = generateThread(job->parameters, job->limits);
  ASSERT_TRUE(program) << program.error().message();
  EXPECT_EQ(program->report.passes, 46U);
  EXPECT_EQ(program->report.cut.hand, Hand::Left);
  EXPECT_EQ(program->report.cut.starts, 1);
  EXPECT_NEAR(program->report.cut.lead, 1.5, 1e-5);
  EXPECT_NEAR(program->report.cut.depth, 0.920152, 6e-4);
  EXPECT_NEAR(program->report.final_radius, 23.079848, 1e-6);
  // 12 turns with lead-in and run-out at 15°, 46 times; retract, return and infeed for each pass.
  EXPECT_EQ(program->report.motion_blocks, 46U * (12U * 24U + 3U) + 1U + 1U + 1U);
}

TEST(ThreadGenerator, TheFirstPassStatesTheWordsWorkedByHand) {
  const std::string text = generated(literatureThread()).text;
  // wz = −1.5: γ = −φ = −(−2π (−1.5)/1.5) = −360°, z = +1.5; retracted to 23.0798 + 0.9202 + 2·0.5 = 25; X 24
  // − 0.02.
  EXPECT_TRUE(has(text, "(APPROACH)\nG00 X30.000\n"));
  EXPECT_TRUE(has(text,
                  "Z1.500 C-360.000\nX25.000\nG94 G01 X23.980 F300.000\n"
                  "G93 G01 Z1.438 C-345.000 F240.000\nZ1.375 C-330.000 F240.000\n"));
  EXPECT_TRUE(has(text, "Z-16.500 C3960.000 F240.000\nG00 X25.000\n"));
}

TEST(ThreadGenerator, ProgramBeginsAndEndsAsFanucReadsIt) {
  const std::string text = generated(quickThread()).text;
  EXPECT_EQ(text.substr(0, 8), "%\nO0001\n");
  EXPECT_TRUE(has(text, "G21 G90 G40 G80 G94\nG54\nM03\nM08\n"));
  EXPECT_THAT(text, testing::EndsWith("\nM09\nM05\nM30\n%\n"));
  EXPECT_FALSE(has(text, ("-0.000")));
}

TEST(ThreadGenerator, EqualParametersGiveEqualBytes) {
  EXPECT_EQ(generated(quickThread()).text, generated(quickThread()).text);
}

TEST(ThreadGenerator, EveryHandAndNumberOfStartsIsFoundAgainOnTheWork) {
  for (const Hand hand : {Hand::Right, Hand::Left}) {
    for (const int starts : {1, 2, 3, 4}) {
      ThreadParameters p = quickThread();
      p.hand = hand;
      p.starts = starts;
      const ThreadReport report = generated(p).report;
      EXPECT_EQ(report.cut.hand, hand);
      EXPECT_EQ(report.cut.starts, starts);
      EXPECT_NEAR(report.cut.lead, 1.5 * starts, 1e-4);
    }
  }
}

TEST(ThreadGenerator, EverySignConventionGivesTheSameThread) {
  for (const double x_sign : {1.0, -1.0}) {
    for (const double z_sign : {1.0, -1.0}) {
      for (const double c_sign : {1.0, -1.0}) {
        for (const double factor : {1.0, 2.0}) {
          ThreadParameters p = quickThread();
          p.axes = {x_sign, z_sign, c_sign, factor, 3.0, -7.0, 0.5};
          EXPECT_EQ(generated(p).report.cut.hand, Hand::Left);
        }
      }
    }
  }
}

TEST(ThreadGenerator, AMachineThatMovesOtherwiseIsCaught) {
  std::vector<AxisConvention> machines(4);
  machines[0].x_sign = -1.0;
  machines[1].z_sign = -1.0;
  machines[2].c_sign = -1.0;
  machines[3].x_factor = 2.0;
  for (const AxisConvention& machine : machines) {
    MachineLimits limits;
    limits.axes = machine;
    const Result<ThreadProgram> program = generateThread(quickThread(), limits);
    ASSERT_FALSE(program);
    EXPECT_EQ(program.error().kind, ErrorKind::NoAnswer);
    EXPECT_EQ(program.error().code, "thread.hand_check");
  }
}

TEST(ThreadGenerator, AMirroredSpindleShowsTheOtherHand) {
  MachineLimits limits;
  limits.axes = AxisConvention{};
  limits.axes->c_sign = -1.0;
  ThreadParameters symmetric = quickThread();
  const Result<ThreadProgram> program = generateThread(symmetric, limits);
  ASSERT_FALSE(program);
  EXPECT_THAT(program.error().text, HasSubstr("cuts a right-hand groove, asked for left hand"));
}

TEST(ThreadGenerator, ConsecutivePassesStayInTheirGroove) {
  for (const ReturnMode mode : {ReturnMode::Unwind, ReturnMode::Continue}) {
    ThreadParameters p = quickThread();
    p.starts = 3;
    p.return_mode = mode;
    p.start_angle = 0.7;
    p.lead_in = 1.234;  // no whole number of turns in a pass
    const std::vector<GrooveRun> runs = cutsOf(p);
    const double lead = 4.5;
    for (std::size_t i = 0; i < runs.size(); ++i) {
      const double phase = 0.7 + kTurn * static_cast<double>(i % 3) / 3.0;
      const double miss = runs[i].middle_wz + lead / kTurn * (runs[i].middle_angle - phase);
      EXPECT_NEAR(std::remainder(miss, lead), 0.0, 1e-3) << i;
    }
  }
}

TEST(ThreadGenerator, ContinuingTheSpindleNeverTurnsItBack) {
  ThreadParameters p = quickThread();
  p.return_mode = ReturnMode::Continue;
  p.lead_in = 1.1;
  double before = -1e9;
  ASSERT_TRUE(forEachMove(generated(p).text, p.axes, [&](const VirtualMove& move) {
    EXPECT_GE(move.to.gamma, before);
    before = move.to.gamma;
  }));
  EXPECT_GT(before, 4.0 * 11.0 * kTurn);
}

TEST(ThreadGenerator, UnwindingReturnsToTheSameAbsoluteAngle) {
  const std::string text = generated(quickThread()).text;
  std::size_t count = 0;
  for (std::size_t at = text.find("Z1.500 C-360.000\n"); at != std::string::npos;
       at = text.find("Z1.500 C-360.000\n", at + 1))
    ++count;
  EXPECT_EQ(count, generated(quickThread()).report.passes);
}

TEST(ThreadGenerator, CutsTowardsMinusToo) {
  ThreadParameters p = quickThread();
  p.towards_plus = false;
  const std::vector<GrooveRun> runs = cutsOf(p);
  ASSERT_FALSE(runs.empty());
  EXPECT_GT(runs[0].first_wz, runs[0].last_wz);
}

TEST(ThreadGenerator, TaperedThreadsKeepTheirDepthAlongTheCone) {
  for (const double taper : {1.0 / 32.0, -1.0 / 32.0}) {
    ThreadParameters p = quickThread();
    p.taper = taper;
    for (const GrooveRun& run : cutsOf(p)) EXPECT_NEAR(run.depth, run.least_depth, 2e-3);
    EXPECT_TRUE(has(generated(p).text, taper > 0.0 ? "G01 X23.653 F" : "G01 X23.747 F"));
  }
}

TEST(ThreadGenerator, InternalThreadsDeepenOutwards) {
  ThreadParameters p = quickThread();
  p.type = ThreadType::Internal;
  p.towards_plus = false;
  const ThreadProgram program = generated(p);
  EXPECT_NEAR(program.report.final_radius, 24.0, 1e-9);
  EXPECT_NEAR(program.report.depth, 5.0 / 8.0 * std::sqrt(3.0) / 2.0 * 1.5, 1e-9);
  EXPECT_EQ(program.report.cut.hand, Hand::Left);
  for (const GrooveRun& run : cutsOf(p)) EXPECT_GT(run.depth, 0.0);
}

TEST(ThreadGenerator, FlankInfeedShiftsRoughingAndEndsInTheGroove) {
  for (const InfeedMode mode : {InfeedMode::Flank, InfeedMode::Alternating}) {
    ThreadParameters p = quickThread();
    p.infeed_mode = mode;
    const std::vector<GrooveRun> runs = cutsOf(p);
    const double first = runs.front().middle_wz + 1.5 / kTurn * runs.front().middle_angle;
    const double last = runs.back().middle_wz + 1.5 / kTurn * runs.back().middle_angle;
    EXPECT_NEAR(std::remainder(first, 1.5), (0.920152 - 0.3) * std::tan(kPi / 6.0), 2e-3);
    EXPECT_NEAR(std::remainder(last, 1.5), 0.0, 1e-3);
  }
}

TEST(ThreadGenerator, AContactAboveTheAxisGrindsTheSameThread) {
  ThreadParameters p = quickThread();
  p.contact_height = 4.0;
  EXPECT_NEAR(generated(p).report.cut.depth, 0.920152, 1e-3);
}

TEST(ThreadGenerator, OneBlockForEachPassWhenTheStepIsZero) {
  ThreadParameters p = quickThread();
  p.block_step = 0.0;
  const ThreadReport report = generated(p).report;
  EXPECT_EQ(report.motion_blocks, report.passes * 4U + 3U);
}

TEST(ThreadGenerator, FeedPerMinuteTakesTheSameTime) {
  ThreadParameters p = quickThread();
  p.feed_words = FeedWords::PerMinute;
  const ThreadProgram per_minute = generated(p);
  EXPECT_FALSE(has(per_minute.text, ("G93")));
  // √(0.0625² + 15²) mm and deg in 0.25 s
  EXPECT_TRUE(has(per_minute.text, "G94 G01 Z1.438 C-345.000 F3600.031\nZ1.375 C-330.000\n"));
  EXPECT_DOUBLE_EQ(per_minute.report.duration, generated(quickThread()).report.duration);
}

TEST(ThreadGenerator, DressingIsCalledBetweenPasses) {
  ThreadParameters p = quickThread();
  p.dress_every_passes = 2;
  p.codes.dress = "M50";
  const std::string text = generated(p).text;
  EXPECT_TRUE(has(text, "LOST)\nX30.000\nM50\n(PASS 3 OF 4"));
  EXPECT_FALSE(has(text, ("LOST)\nX30.000\nM50\n(PASS 2 OF 4")));
}

TEST(ThreadGenerator, OneStartAloneKeepsItsPlace) {
  ThreadParameters p = quickThread();
  p.starts = 2;
  p.start_index = 1;
  const ThreadReport report = generated(p).report;
  EXPECT_EQ(report.cut.starts, 1);
  EXPECT_EQ(report.cut.runs, report.passes);
}

TEST(ThreadGenerator, CommentsCannotEscapeTheirParentheses) {
  ThreadParameters p = quickThread();
  p.name = "a) G00 X0\n%\xC3\xA9";
  const std::string text = generated(p).text;
  EXPECT_TRUE(has(text, "O0001\n(A  G00 X0    )\n"));
}

TEST(ThreadGenerator, SpindleAnglesBeyondTheControlsWordsAreRefused) {
  ThreadParameters p = literatureThread();
  p.return_mode = ReturnMode::Continue;
  p.infeed = 0.003;
  p.length = 40.0;
  const Result<ThreadProgram> program = generateThread(p, {});
  ASSERT_FALSE(program);
  EXPECT_EQ(program.error().code, "thread.word_range");
}

TEST(ThreadGenerator, ACodeThatChangesWhatWordsMeanIsCaught) {
  for (const char* code : {"G91", "G20", "G18 G68 X0 Z0 R10"}) {
    ThreadParameters p = quickThread();
    p.codes.c_axis_on = code;
    const Result<ThreadProgram> program = generateThread(p, {});
    ASSERT_FALSE(program) << code;
    EXPECT_EQ(program.error().kind, ErrorKind::NoAnswer) << program.error().message();
  }
}

TEST(ThreadGenerator, InverseTimeWordsGiveTheWorkSpeedOfEachPass) {
  const ThreadProgram program = generated(quickThread());
  nc::MemoryText text("thread", program.text);
  nc::InterpreterOptions options;
  options.dialect = nc::Dialect::Fanuc;
  options.axes.count = 3;
  options.axes.axes[0] = {AxisId{'X'}, false, false};
  options.axes.axes[1] = {AxisId{'Z'}, false, false};
  options.axes.axes[2] = {AxisId{'C'}, true, false};
  nc::Interpreter interpreter(text, options);
  std::vector<double> speeds;
  while (true) {
    const Result<const nc::ExecutedBlock*> block = interpreter.next();
    ASSERT_TRUE(block) << block.error().message();
    if (*block == nullptr) break;
    for (const nc::Motion& motion : (*block)->motions) {
      if (motion.kind != nc::MotionKind::Linear || motion.feed_mode != nc::FeedMode::InverseTime) continue;
      const double speed = std::abs(motion.end[2] - motion.start[2]) * motion.feed;
      if (speeds.empty() || std::abs(speeds.back() - speed) > 1e-4) speeds.push_back(speed);
    }
  }
  ASSERT_EQ(speeds.size(), program.passes.size());
  for (std::size_t i = 0; i < speeds.size(); ++i) EXPECT_NEAR(speeds[i], program.passes[i].speed, 1e-4);
  EXPECT_TRUE(interpreter.diagnostics().all().empty());
}

TEST(ThreadGenerator, RandomSoundParametersNeverFailTheirOwnCheck) {
  std::mt19937 random(20260101);  // NOLINT: the seed is fixed by intention
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
  };
  const auto coin = [&] { return random() % 2 == 0; };
  std::size_t made = 0;
  for (int i = 0; i < 200; ++i) {
    ThreadParameters p;
    p.diameter = between(6.0, 200.0);
    p.pitch = between(0.35, 6.0);
    p.length = between(0.5, 60.0);
    p.starts = 1 + static_cast<int>(random() % 4);
    p.hand = coin() ? Hand::Right : Hand::Left;
    p.type = coin() ? ThreadType::External : ThreadType::Internal;
    p.taper = coin() ? 0.0 : between(-0.06, 0.06);
    p.start_angle = between(-kPi, kPi);
    p.start_z = between(-100.0, 100.0);
    p.infeed = between(0.1, 0.5);
    p.infeed_mode = std::array{InfeedMode::Radial, InfeedMode::Flank, InfeedMode::Alternating}[random() % 3];
    p.finishing_passes = static_cast<int>(random() % 3);
    p.speed_plan = coin() ? SpeedPlan::Linear : SpeedPlan::Geometric;
    p.towards_plus = coin();
    p.return_mode = coin() ? ReturnMode::Unwind : ReturnMode::Continue;
    p.feed_words = coin() ? FeedWords::InverseTime : FeedWords::PerMinute;
    p.contact_height = coin() ? 0.0 : between(-0.3, 0.3) * p.diameter / 2.0;
    p.block_step = coin() && p.taper == 0.0 ? 0.0 : radFromDeg(between(5.0, 90.0));
    p.decimals = 2 + static_cast<int>(random() % 4);
    p.axes = {
        coin() ? 1.0 : -1.0, coin() ? 1.0 : -1.0, coin() ? 1.0 : -1.0, coin() ? 1.0 : 2.0, 0.0, 5.0, 0.25};
    const Result<ThreadProgram> program = generateThread(p, {});
    if (!program) {
      EXPECT_NE(program.error().code, "thread.hand_check") << i << ": " << program.error().message();
      continue;
    }
    ++made;
    EXPECT_EQ(program->report.cut.hand, p.hand) << i;
    EXPECT_EQ(program->report.cut.starts, p.starts) << i;
  }
  EXPECT_GT(made, 120U);
}

TEST(ThreadGenerator, TravelIsNoAnswer) {
  MachineLimits limits;
  limits.z = MachineLimits::Range{-10.0, 400.0};
  const Result<ThreadProgram> program = generateThread(quickThread(), limits);
  ASSERT_FALSE(program);
  EXPECT_EQ(program.error().code, "thread.travel");
  EXPECT_EQ(program.error().kind, ErrorKind::NoAnswer);
}

}  // namespace
}  // namespace nineline::thread_grinding
