#include "core/postprocessing/post_processor.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "core/base/units.h"
#include "core/kinematics/machine_file.h"
#include "core/nc/interpreter.h"
#include "core/nc/text_source.h"
#include "core/postprocessing/cl_reader.h"

namespace nineline::postprocessing {
namespace {

using kinematics::findBuiltInMachine;

/// A cut over a dome with two axes turning, a rapid to it and one off it.
std::string domeCl() {
  std::string text = "PARTNO DOME\nLOADTL/7\nSPINDL/5000,RPM,CLW\nCOOLNT/ON\nRAPID\n";
  for (int i = 0; i <= 60; ++i) {
    const double a = 0.05 * i;
    const double lean = 0.35 + 0.15 * std::sin(2.0 * a);
    const Vector3d axis(std::sin(lean) * std::cos(a), std::sin(lean) * std::sin(a), std::cos(lean));
    const Vector3d tip = 40.0 * axis + Vector3d(3.0, -2.0, -20.0);
    char line[160];
    std::snprintf(line, sizeof line, "GOTO/%.6f,%.6f,%.6f,%.9f,%.9f,%.9f\n", tip.x(), tip.y(), tip.z(),
                  axis.x(), axis.y(), axis.z());
    text += line;
    if (i == 0) text += "FEDRAT/1200,MMPM\n";
  }
  return text + "RAPID\nGODLTA/50\nCOOLNT/OFF\nSPINDL/OFF\nFINI\n";
}

nc::AxisLayout layoutOf(const Machine& machine) {
  nc::AxisLayout layout;
  layout.count = machine.jointCount();
  for (int j = 0; j < machine.jointCount(); ++j)
    layout.axes[static_cast<std::size_t>(j)] = {machine.joint(j).axis, machine.isRotary(j),
                                                machine.joint(j).diameter};
  return layout;
}

std::vector<nc::Motion> interpret(const Machine& machine, const std::string& text, nc::Dialect dialect) {
  nc::MemoryText source("post.nc", text);
  nc::InterpreterOptions options;
  options.dialect = dialect;
  options.axes = layoutOf(machine);
  options.tool_lengths = {{7, 0.0}};
  nc::Interpreter interpreter(source, options);
  std::vector<nc::Motion> motions;
  for (;;) {
    const Result<const nc::ExecutedBlock*> block = interpreter.next();
    EXPECT_TRUE(block) << block.error().message();
    if (!block || *block == nullptr) break;
    motions.insert(motions.end(), (*block)->motions.begin(), (*block)->motions.end());
  }
  for (const Diagnostic& one : interpreter.diagnostics().all()) ADD_FAILURE() << one.text;
  return motions;
}

struct Case {
  const char* machine;
  Control control;
  nc::Dialect dialect;
};

class PostRoundTrip : public testing::TestWithParam<Case> {
 protected:
  PostResult post(const PostOptions& given = {}) {
    PostOptions options = given;
    options.nc.control = GetParam().control;
    NoProgress progress;
    Result<PostResult> result = postProcess(machine_, program_, options, progress);
    EXPECT_TRUE(result) << result.error().message();
    return result ? std::move(*result) : PostResult{};
  }
  const Machine& machine_ = *findBuiltInMachine(GetParam().machine);
  ClProgram program_ = readClData(domeCl(), "dome.cls").value();
};

TEST_P(PostRoundTrip, WhatIsReadBackReachesThePoints) {
  const PostResult result = post();
  EXPECT_LT(result.report.max_residual, 1e-9);
  EXPECT_LT(result.report.max_axis_residual, 1e-10);
  EXPECT_EQ(result.report.branch_switches, 0U);
  EXPECT_EQ(result.report.points, 62U);
  const std::vector<nc::Motion> motions = interpret(machine_, result.text, GetParam().dialect);
  ASSERT_EQ(motions.size(), result.moves.moves.size());
  const TipAxisChain chain(machine_);
  for (std::size_t m = 0; m < motions.size(); ++m) {
    const AxisMove& move = result.moves.moves[m];
    const TipAxis pose = chain.at(motions[m].end);
    EXPECT_EQ(motions[m].kind == nc::MotionKind::Rapid, move.rapid);
    if (move.inserted) continue;
    // half a unit of the last digit: 0.05 µm a linear axis, 5e-6° at less than 500 mm
    EXPECT_LT((pose.tip - program_.points[move.point].tip).norm(), 2e-4) << m;
    EXPECT_LT(angleBetween(pose.axis, program_.points[move.point].axis), 2e-7) << m;
  }
}

TEST_P(PostRoundTrip, TheTipKeepsItsLineAndItsFeed) {
  const PostResult result = post();
  const std::vector<nc::Motion> motions = interpret(machine_, result.text, GetParam().dialect);
  ASSERT_EQ(motions.size(), result.moves.moves.size());
  const TipAxisChain chain(machine_);
  for (std::size_t m = 1; m < motions.size(); ++m) {
    if (motions[m].kind != nc::MotionKind::Linear) continue;
    const TipAxis from = chain.at(motions[m].start);
    const TipAxis to = chain.at(motions[m].end);
    for (const double s : {0.2, 0.5, 0.8}) {
      JointPositions q{};
      for (std::size_t k = 0; k < kMaxAxes; ++k)
        q[k] = motions[m].start[k] + s * (motions[m].end[k] - motions[m].start[k]);
      EXPECT_LT((chain.at(q).tip - between(from, to, s).tip).norm(), 0.0052) << m;
    }
    // F is what makes the tip go at 20 mm/s, by the control's meaning of F, unless an axis is too slow
    const double time =
        feedLength(machine_, GetParam().control, motions[m].start, motions[m].end) / motions[m].feed;
    EXPECT_NEAR(time, result.moves.moves[m].time, 1e-3 * time) << m;
    const double speed = (to.tip - from.tip).norm() / time;
    EXPECT_LT(speed, 20.1) << m;
    if (result.report.slowed_blocks == 0) {
      EXPECT_NEAR(speed, 20.0, 0.05) << m;
    }
  }
}

TEST_P(PostRoundTrip, InverseTimeStatesTheTimeOfEachBlock) {
  PostOptions options;
  options.nc.feed = FeedWriting::InverseTime;
  const PostResult result = post(options);
  const std::vector<nc::Motion> motions = interpret(machine_, result.text, GetParam().dialect);
  int timed = 0;
  for (std::size_t m = 1; m < motions.size(); ++m) {
    if (motions[m].kind != nc::MotionKind::Linear) continue;
    EXPECT_EQ(motions[m].feed_mode, nc::FeedMode::InverseTime) << m;
    EXPECT_NEAR(1.0 / motions[m].feed, result.moves.moves[m].time, 1e-4 * result.moves.moves[m].time) << m;
    ++timed;
  }
  EXPECT_GE(timed, 60);
}

INSTANTIATE_TEST_SUITE_P(Machines, PostRoundTrip,
                         testing::Values(Case{"trunnion-ac", Control::Fanuc, nc::Dialect::Fanuc},
                                         Case{"trunnion-ac", Control::Siemens, nc::Dialect::Siemens},
                                         Case{"trunnion-ac", Control::LinuxCnc, nc::Dialect::LinuxCnc},
                                         Case{"head-head-bc", Control::Fanuc, nc::Dialect::Fanuc},
                                         Case{"table-head-bc", Control::LinuxCnc, nc::Dialect::LinuxCnc},
                                         Case{"propeller-c2zxc1b1", Control::Fanuc, nc::Dialect::Fanuc},
                                         Case{"propeller-c2zxc1b1", Control::Siemens, nc::Dialect::Siemens}));

Result<PostResult> post(const char* machine, const std::string& cl, const PostOptions& options = {}) {
  Result<ClProgram> program = readClData(cl, "part.cls");
  if (!program) return program.error();
  NoProgress progress;
  return postProcess(*findBuiltInMachine(machine), *program, options, progress);
}

TEST(PostProcessor, TipControlWritesTheTip) {
  PostOptions options;
  options.nc.tip_control = true;
  for (const Control control : {Control::Fanuc, Control::Siemens}) {
    options.nc.control = control;
    const Result<PostResult> result = post("trunnion-ac", domeCl(), options);
    ASSERT_TRUE(result) << result.error().message();
    const auto dialect = control == Control::Fanuc ? nc::Dialect::Fanuc : nc::Dialect::Siemens;
    const std::vector<nc::Motion> motions =
        interpret(*findBuiltInMachine("trunnion-ac"), result->text, dialect);
    const ClProgram program = readClData(domeCl(), "part.cls").value();
    ASSERT_EQ(motions.size(), result->moves.moves.size());
    for (std::size_t m = 0; m < motions.size(); ++m) {
      EXPECT_TRUE(motions[m].tool_centre_point);
      const AxisMove& move = result->moves.moves[m];
      if (move.inserted) continue;
      for (std::size_t k = 0; k < 3; ++k)  // joints A C X Y Z
        EXPECT_NEAR(motions[m].end[2 + k], program.points[move.point].tip[static_cast<Eigen::Index>(k)],
                    6e-5);
      if (m > 0 && !move.rapid) {
        EXPECT_NEAR(motions[m].feed, 20.0, 1e-3);
      }
    }
  }
}

TEST(PostProcessor, FeedOfTurnsByHand) {
  // The tool stands at the origin of the trunnion and tilts by 30°: no axis but A moves; F counts degrees.
  const std::string tilt =
      "FEDRAT/600\nRAPID\nGOTO/0,0,0,0,0,1\nGOTO/0,0,0,0,0.5,0.866025403784\nRAPID\nGOTO/0,0,50,0,0.5,"
      "0.866025403784\n";
  PostOptions options;
  options.nc.control = Control::LinuxCnc;
  const Result<PostResult> result = post("trunnion-ac", tilt, options);
  ASSERT_TRUE(result) << result.error().message();
  EXPECT_NE(result->text.find(" F600.\n"), std::string::npos) << result->text;
  // 30 mm along x in the table's frame while C turns 90° about the tip's line at radius 0 … the tip's way
  // counts
  const std::string turn =
      "FEDRAT/600\nRAPID\nGOTO/0,0,0,0.5,0,0.866025403784\nGOTO/0,0,30,0,0.5,0.866025403784\n";
  for (const auto& [control, wanted] :
       {std::pair(Control::Fanuc, 3.1622776601683795 * 600.0), std::pair(Control::LinuxCnc, 600.0)}) {
    options.nc.control = control;
    options.moves.chord_tolerance = 100.0;
    options.moves.axis_deviation = 3.0;
    const Result<PostResult> one = post("trunnion-ac", turn, options);
    ASSERT_TRUE(one);
    ASSERT_EQ(one->moves.moves.size(), 2U);
    // C turns 90° in the 3 s that the tip needs for 30 mm; Y and Z move √(15² + 26²) = 30 mm
    const double time = one->moves.moves[1].time;
    EXPECT_NEAR(time, 3.0, 1e-9);
    EXPECT_NEAR(feedLength(*findBuiltInMachine("trunnion-ac"), control, one->moves.moves[0].q,
                           one->moves.moves[1].q) /
                    time * 60.0,
                wanted, 1e-3);
  }
}

TEST(PostProcessor, KlartextByHand) {
  PostOptions options;
  options.nc.control = Control::Heidenhain;
  const Result<PostResult> result =
      post("trunnion-ac",
           "PARTNO CUBE 1\nLOADTL/3\nSPINDL/900,RPM,CLW\nPPRINT SIDE (A)\nRAPID\nGOTO/10,0,-2.5\nFEDRAT/300\n"
           "GOTO/20,0,-2.5\nGOTO/20,5,-2.5\nSTOP\nFINI\n",
           options);
  ASSERT_TRUE(result) << result.error().message();
  EXPECT_EQ(
      result->text,
      "0 BEGIN PGM CUBE1 MM\n1 TOOL CALL 3 Z\n2 TOOL CALL S900\n3 L M3\n4 ; SIDE <A>\n"
      "5 L A+0 C+0 X+10 Y+0 Z-2.5 R0 FMAX\n6 L X+20 F300\n7 L Y+5\n8 L M0\n9 L M30\n10 END PGM CUBE1 MM\n");
}

TEST(PostProcessor, FanucByHand) {
  const Result<PostResult> result =
      post("trunnion-ac",
           "PARTNO CUBE\nAUXFUN/21\nRAPID\nGOTO/10,0,-2.5\nFEDRAT/300\nGOTO/20,0,-2.5\nDELAY/0.5\n"
           "GOTO/20,0,-2.5\nGOTO/20,5,-2.5\nFINI\n");
  ASSERT_TRUE(result) << result.error().message();
  EXPECT_EQ(
      result->text,
      "%\nO1000 (CUBE)\nG21 G17 G40 G49 G54 G80 G90 G94\nM21\nG0 A0. C0. X10. Y0. Z-2.5\nG1 X20. F300.\n"
      "G4 P500\nY5.\nM30\n%\n");
}

TEST(PostProcessor, HeldAxesStandStill) {
  PostOptions options;
  options.held["C2"] = radFromDeg(20.0);
  Machine::Description description = findBuiltInMachine("propeller-c2zxc1b1")->description();
  kinematics::Joint y;
  y.axis = {'Y', 0};
  y.direction = Vector3d::UnitY();
  description.tool_chain.insert(description.tool_chain.begin(), y);
  const Machine machine = Machine::make(description).value();
  NoProgress progress;
  const ClProgram program = readClData(domeCl(), "dome.cls").value();
  const Result<PostResult> held = postProcess(machine, program, options, progress);
  ASSERT_TRUE(held) << held.error().message();
  for (const AxisMove& move : held->moves.moves) EXPECT_EQ(move.q[0], radFromDeg(20.0));
  EXPECT_LT(held->report.max_residual, 1e-9);
  const Result<PostResult> free = postProcess(machine, program, {}, progress);
  ASSERT_TRUE(free) << free.error().message();
  EXPECT_LT(free->report.max_residual, 1e-9);
}

TEST(PostProcessor, WhatAControlCannotSayIsRefused) {
  PostOptions options;
  options.nc.control = Control::LinuxCnc;
  EXPECT_EQ(post("propeller-c2zxc1b1", domeCl(), options).error().kind, ErrorKind::Usage);
  options.nc.tip_control = true;
  EXPECT_EQ(post("trunnion-ac", domeCl(), options).error().kind, ErrorKind::Usage);
  options.nc.control = Control::Fanuc;
  EXPECT_EQ(post("propeller-c2zxc1b1", domeCl(), options).error().kind, ErrorKind::Usage);
  options = {};
  options.nc.control = Control::Heidenhain;
  options.nc.feed = FeedWriting::InverseTime;
  EXPECT_EQ(post("trunnion-ac", domeCl(), options).error().kind, ErrorKind::Usage);
}

TEST(PostProcessor, AFeedPerTurnNeedsTheSpindle) {
  const std::string cut = "FEDRAT/0.2,MMPR\nRAPID\nGOTO/0,0,0\nGOTO/10,0,0\n";
  EXPECT_EQ(post("trunnion-ac", cut).error().code, "post.feed");
  const Result<PostResult> result = post("trunnion-ac", "SPINDL/600,RPM,CLW\n" + cut);
  ASSERT_TRUE(result);
  EXPECT_NEAR(result->moves.moves[1].time, 5.0, 1e-12);  // 10 mm at 0.2 mm × 10 turns a second
}

TEST(PostProcessor, AThreeAxisMachineTakesUprightToolsOnly) {
  EXPECT_TRUE(post("generic-3axis", "FEDRAT/100\nGOTO/1,2,3\nGOTO/2,2,3\n"));
  const Result<PostResult> tilted = post("generic-3axis", "FEDRAT/100\nGOTO/1,2,3\nGOTO/2,2,3,0,0.6,0.8\n");
  ASSERT_FALSE(tilted);
  EXPECT_EQ(tilted.error().code, "post.unreachable");
  EXPECT_EQ(tilted.error().line, 3U);
}

}  // namespace
}  // namespace nineline::postprocessing
