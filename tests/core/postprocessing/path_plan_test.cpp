#include "core/postprocessing/path_plan.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/units.h"
#include "core/kinematics/machine_file.h"
#include "core/postprocessing/branches.h"

namespace nineline::postprocessing {
namespace {

using kinematics::findBuiltInMachine;

ClPoint cut(const Vector3d& tip, const Vector3d& axis, std::size_t line) {
  ClPoint point;
  point.tip = tip;
  point.axis = axis.normalized();
  point.feed = 10.0;
  point.line = line;
  return point;
}

Result<PathPlan> plan(const Machine& machine, const std::vector<ClPoint>& points,
                      double tolerance_deg = 0.0) {
  NoProgress progress;
  const PoseSolver solver(machine);
  PlanOptions options;
  options.axis_tolerance = radFromDeg(tolerance_deg);
  Result<PathPlan> result = planPath(solver, points, homeOf(machine), options, progress);
  if (result) calmTurns(solver, points, options, *result);
  return result;
}

double largestStep(const Machine& machine, const PathPlan& plan, int joint) {
  double most = 0.0;
  const auto k = static_cast<std::size_t>(joint);
  for (std::size_t i = 1; i < plan.points.size(); ++i)
    most = std::max(most, std::abs(plan.points[i].q[k] - plan.points[i - 1].q[k]));
  EXPECT_LT(joint, machine.jointCount());
  return most;
}

void expectReached(const Machine& machine, const std::vector<ClPoint>& points, const PathPlan& plan) {
  const TipAxisChain chain(machine);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const TipAxis pose = chain.at(plan.points[i].q);
    EXPECT_LT((pose.tip - points[i].tip).norm(), 1e-9) << i;
    EXPECT_LT(angleBetween(pose.axis, points[i].axis), 1e-10) << i;
    EXPECT_LT(machine.firstOutsideTravel(plan.points[i].q), 0) << i;
  }
}

/// A spiral about z, the tool leaning outwards: C turns on and on.
std::vector<ClPoint> spiral(int turns, double lean) {
  std::vector<ClPoint> points;
  for (int i = 0; i <= 72 * turns; ++i) {
    const double angle = radFromDeg(5.0 * i);
    const Vector3d outward(std::cos(angle), std::sin(angle), 0.0);
    points.push_back(cut(50.0 * outward, std::sin(lean) * outward + std::cos(lean) * Vector3d::UnitZ(),
                         static_cast<std::size_t>(i) + 1));
  }
  return points;
}

TEST(PathPlan, AContinuousAxisIsUnwound) {
  const Machine& machine = *findBuiltInMachine("trunnion-ac");
  const std::vector<ClPoint> points = spiral(4, 0.5);
  const Result<PathPlan> result = plan(machine, points);
  ASSERT_TRUE(result) << result.error().message();
  expectReached(machine, points, *result);
  EXPECT_NEAR(std::abs(result->points.back().q[1] - result->points.front().q[1]), 4.0 * kTurn, 1e-9);
  EXPECT_NEAR(largestStep(machine, *result, 1), radFromDeg(5.0), 1e-9);
  EXPECT_EQ(result->switches, 0U);
}

TEST(PathPlan, ALimitedAxisStartsWhereTheWholeCutFits) {
  const Machine& machine = *findBuiltInMachine("head-head-bc");  // C −360°…360°
  const std::vector<ClPoint> points = spiral(1, 0.5);            // needs one whole turn, in one sense
  const Result<PathPlan> result = plan(machine, points);
  ASSERT_TRUE(result) << result.error().message();
  expectReached(machine, points, *result);
  EXPECT_NEAR(std::abs(result->points.back().q[3] - result->points.front().q[3]), kTurn, 1e-9);
  EXPECT_EQ(result->switches, 0U);
}

TEST(PathPlan, ACutThatNoBranchCanFinishIsRefusedWithItsLine) {
  const std::vector<ClPoint> points = spiral(3, 0.5);  // three turns into ±360°
  const Result<PathPlan> result = plan(*findBuiltInMachine("head-head-bc"), points);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().kind, ErrorKind::NoAnswer);
  EXPECT_EQ(result.error().code, "post.flip");
  EXPECT_GT(result.error().line, 72U);
}

TEST(PathPlan, TheRewindHappensInARapid) {
  std::vector<ClPoint> points = spiral(3, 0.5);
  for (const std::size_t at : {73U, 74U, 145U, 146U}) {  // retract after each turn
    points[at].rapid = true;
  }
  const Machine& machine = *findBuiltInMachine("head-head-bc");
  const Result<PathPlan> result = plan(machine, points);
  ASSERT_TRUE(result) << result.error().message();
  expectReached(machine, points, *result);
  EXPECT_GE(result->switches, 1U);
  for (std::size_t i = 1; i < points.size(); ++i)
    EXPECT_TRUE(!result->points[i].switched || points[i].rapid) << i;
  EXPECT_FALSE(result->warnings.all().empty());
}

TEST(PathPlan, TheBranchIsChosenForThePathNotForItsFirstPoint) {
  // A −5°…120°: the tilt starts at +10° on one branch and ends at 60°; the other branch has A negative.
  Machine::Description description = findBuiltInMachine("trunnion-ac")->description();
  for (const bool positive : {true, false}) {
    description.workpiece_chain[0].travel = {radFromDeg(positive ? -12.0 : -120.0),
                                             radFromDeg(positive ? 120.0 : 12.0)};
    const Machine machine = Machine::make(description).value();
    std::vector<ClPoint> points;
    for (int i = 0; i <= 50; ++i) {
      const double tilt = radFromDeg(10.0 + i);
      points.push_back(
          cut({0.1 * i, 0, 0}, {0.0, std::sin(tilt), std::cos(tilt)}, 10U + static_cast<std::size_t>(i)));
    }
    const Result<PathPlan> result = plan(machine, points);
    ASSERT_TRUE(result) << result.error().message();
    expectReached(machine, points, *result);
    EXPECT_EQ(result->switches, 0U);
    EXPECT_EQ(result->points.back().q[0] > 0.0, positive);
  }
}

TEST(PathPlan, ThroughThePoleTheTiltGoesOnWhereItsTravelAllows) {
  const Machine& machine = *findBuiltInMachine("trunnion-ac");
  std::vector<ClPoint> points;
  for (int i = -20; i <= 20; ++i) {
    const double tilt = radFromDeg(i);
    points.push_back(
        cut({i * 1.0, 0, 0}, {0.0, std::sin(tilt), std::cos(tilt)}, 30U + static_cast<std::size_t>(i)));
  }
  const Result<PathPlan> result = plan(machine, points);
  ASSERT_TRUE(result) << result.error().message();
  expectReached(machine, points, *result);
  EXPECT_LT(largestStep(machine, *result, 1), 1e-9);  // C stands still
  EXPECT_EQ(result->switches, 0U);
  EXPECT_GE(result->singular, 1U);
}

TEST(PathPlan, AtThePoleCTurnsOnTheSpotWhereTheTiltCannotGoOn) {
  Machine::Description description = findBuiltInMachine("trunnion-ac")->description();
  description.workpiece_chain[0].travel = {0.0, radFromDeg(120.0)};
  const Machine machine = Machine::make(description).value();
  std::vector<ClPoint> points;
  for (int i = -20; i <= 20; ++i) {
    const double tilt = radFromDeg(i);
    points.push_back(cut({i == 0 ? 0.0 : i + (i > 0 ? -1.0 : 0.0), 0, 0},
                         {0.0, std::sin(tilt), std::cos(tilt)}, 30U + static_cast<std::size_t>(i)));
    if (i == 0) points.push_back(points.back());  // the tool stands while C turns
  }
  const Result<PathPlan> result = plan(machine, points);
  ASSERT_TRUE(result) << result.error().message();
  expectReached(machine, points, *result);
  EXPECT_EQ(result->switches, 1U);
  EXPECT_NEAR(largestStep(machine, *result, 1), kPi, 1e-9);
  EXPECT_FALSE(result->warnings.all().empty());
}

TEST(PathPlan, AWildTurnIsSpreadWithinTheAxisTolerance) {
  const Machine& machine = *findBuiltInMachine("trunnion-ac");
  std::vector<ClPoint> points;
  for (int i = -100; i <= 100; ++i) {
    // passes the pole at 0.02°: C must turn by almost 180° within a few points
    const Vector3d axis(std::tan(radFromDeg(0.02 * i)), std::tan(radFromDeg(0.02)), 1.0);
    points.push_back(cut({0.5 * i, 0, 0}, axis, 200U + static_cast<std::size_t>(i)));
  }
  const Result<PathPlan> exact = plan(machine, points);
  ASSERT_TRUE(exact);
  expectReached(machine, points, *exact);
  EXPECT_GT(largestStep(machine, *exact, 1), 0.7);
  EXPECT_FALSE(exact->warnings.all().empty());

  const Result<PathPlan> calm = plan(machine, points, 0.5);
  ASSERT_TRUE(calm);
  EXPECT_LE(largestStep(machine, *calm, 1), 0.1);
  EXPECT_TRUE(calm->warnings.all().empty());
  const TipAxisChain chain(machine);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const TipAxis pose = chain.at(calm->points[i].q);
    EXPECT_LT((pose.tip - points[i].tip).norm(), 1e-9);
    EXPECT_LE(angleBetween(pose.axis, points[i].axis), radFromDeg(0.5));
  }
}

TEST(PathPlan, APointBeyondTheTravelNamesItsLineAndAxis) {
  const Result<PathPlan> result = plan(*findBuiltInMachine("trunnion-ac"),
                                       {cut({0, 0, 0}, {0, 0, 1}, 7), cut({0, 0, 700}, {0, 0, 1}, 8)});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().kind, ErrorKind::NoAnswer);
  EXPECT_EQ(result.error().line, 8U);
  EXPECT_NE(result.error().text.find("travel of Z"), std::string::npos) << result.error().text;
}

}  // namespace
}  // namespace nineline::postprocessing
