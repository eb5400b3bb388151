#include "core/errors/error_model.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/units.h"
#include "core/errors/error_model_file.h"
#include "core/errors/table_effects.h"
#include "core/kinematics/machine_file.h"
#include "tests/support/random_machines.h"

namespace nineline::errors {
namespace {

using Eigen::Vector3d;
using test_support::Random;

ErrorModel modelOf(const std::string& machine, const std::string& effects) {
  const Result<ErrorModel> model = readErrorModel(
      R"({"format": "nineline-model/1", "machine": ")" + machine + R"(", "effects": [)" + effects + "]}",
      "test");
  if (!model) throw std::runtime_error(model.error().message());
  return *model;
}

MachineState at(const JointPositions& q) {
  MachineState state;
  state.q = q;
  return state;
}

Vector3d deviation(const ErrorModel& model, const JointPositions& q) {
  return model.actualPose(at(q)).tip - model.idealPose(at(q)).tip;
}

std::string constant(const std::string& component, const std::string& values, const std::string& more = "") {
  return R"({"effect": "table", "component": ")" + component + R"(", "start_mm": 0, "spacing_mm": 10, )" +
         values + more + "}";
}

TEST(ErrorModel, WithoutEffectsIsTheIdealMachine) {
  const ErrorModel model(*kinematics::findBuiltInMachine("trunnion-ac"));
  EXPECT_EQ(deviation(model, {0.3, 0.4, 1, 2, 3}), Vector3d::Zero());
  EXPECT_EQ(model.featureLength(0), std::numeric_limits<double>::infinity());
}

TEST(ErrorModel, PositiveErrorsOfATableMoveTheToolBackwards) {
  // Contract, convention 2: +EXX of a table X moves the tool by -x in W; on the tool's side by +x.
  EXPECT_NEAR(deviation(modelOf("generic-3axis", constant("EXX", R"("values_um": [5])")), {0, 50, 0}).x(),
              -0.005, 1e-14);
  EXPECT_NEAR(deviation(modelOf("generic-3axis", constant("EXZ", R"("values_um": [5])")), {0, 50, 0}).x(),
              0.005, 1e-14);
}

TEST(ErrorModel, AngularErrorsActAboutTheMovingReferencePoint) {
  // Head Z of the mill at z = 100 tilts by EBZ = 10 arcsec: the tip is the reference point, nothing moves.
  const std::string tilt = constant("EBZ", R"("values_arcsec": [10])");
  EXPECT_LT(deviation(modelOf("generic-3axis", tilt), {0, 0, 100}).norm(), 1e-13);
  // About a reference point 200 mm above, the tip swings: -200 z under a turn about +y moves by -x.
  const std::string about = constant("EBZ", R"("values_arcsec": [10])", R"(, "reference_mm": [0, 0, 200])");
  EXPECT_NEAR(deviation(modelOf("generic-3axis", about), {0, 0, 100}).x(),
              -200.0 * std::sin(radFromArcsec(10.0)), 1e-12);
}

TEST(ErrorModel, TranslationsReferToTheReferencePoint) {
  const std::string tables = constant("EXZ", R"("values_um": [5])", R"(, "reference_mm": [0, 0, 200])") +
                             "," + constant("EBZ", R"("values_arcsec": [10])");
  EXPECT_NEAR(deviation(modelOf("generic-3axis", tables), {0, 0, 100}).x(),
              0.005 - 200.0 * std::sin(radFromArcsec(10.0)), 1e-12);
}

TEST(ErrorModel, LocationErrorsTurnAndMoveAnAxisAtZeroToo) {
  const double angle = radFromArcsec(20.0);
  // C0Y turns +Y about +Z by the value: the tool-side Y of the trunnion machine at y = 100 goes to -x.
  const ErrorModel square =
      modelOf("trunnion-ac", R"({"effect": "location", "component": "C0Y", "value_arcsec": 20})");
  EXPECT_NEAR(deviation(square, {0, 0, 0, 100, 0}).x(), -100.0 * std::sin(angle), 1e-12);
  // X0C moves the axis line, the workpiece with it: at C = 0 the tool goes to -x, at 180 degrees too (in M).
  const ErrorModel offset =
      modelOf("b2-k3032", R"({"effect": "location", "component": "X0C", "value_um": 7})");
  EXPECT_NEAR(deviation(offset, {0, 0, 30}).x(), -0.007, 1e-14);
  EXPECT_NEAR(deviation(offset, {0, kPi, 30}).x(), 0.007, 1e-14);
  // B0X: the wheel slide turned about y, at x = 300 the tip has gone to -z.
  const ErrorModel slide =
      modelOf("b2-k3032", R"({"effect": "location", "component": "B0X", "value_arcsec": 20})");
  EXPECT_NEAR(deviation(slide, {0, 0, 300}).z(), -300.0 * std::sin(angle), 1e-12);
  // A0C: a point of the work at z = -100 swings to +y, the tool relative to it to -y.
  const ErrorModel spindle =
      modelOf("b2-k3032", R"({"effect": "location", "component": "A0C", "value_arcsec": 20})");
  EXPECT_NEAR(deviation(spindle, {100, 0, 30}).y(), -100.0 * std::sin(angle), 1e-12);
}

std::string turnTable(const std::string& component, const std::string& frame, const std::string& more = "") {
  return R"({"effect": "table", "component": ")" + component +
         R"(", "start_deg": 0, "spacing_deg": 90, "values_um": [4, 4, 4, 4], "frame": ")" + frame + "\"" +
         more + "}";
}

TEST(ErrorModel, FixedAndMovedFramesOfARotaryTable) {
  // EXC = 4 um on the workpiece's spindle, turned by 90 degrees: W's x is the bed's y.
  const JointPositions q = {0, kPi / 2, 30};
  EXPECT_LT((deviation(modelOf("b2-k3032", turnTable("EXC", "moved")), q) - Vector3d(-0.004, 0, 0)).norm(),
            1e-14);
  EXPECT_LT((deviation(modelOf("b2-k3032", turnTable("EXC", "fixed")), q) - Vector3d(0, 0.004, 0)).norm(),
            1e-14);
}

TEST(ErrorModel, FixedFrameIsTheSamePoseAsTheTurnedMovedFrame) {
  // theory.md, 1.4: E_body = R(-q) E_fixed R(q), also with a reference point.
  Random random(51);
  const Machine& machine = *kinematics::findBuiltInMachine("b2-k3032");
  const auto table = [&](int row, double value, bool fixed, const Vector3d& reference) {
    const ErrorTable::Grid grid{0.0, 1.0, Interpolation::Cubic, std::nullopt};
    auto effect = std::make_shared<TableEffect>(1, Component{{'C', 0}, row, false},
                                                ErrorTable::make(grid, {value}).value(), fixed);
    effect->setReference(reference);
    return effect;
  };
  for (int k = 0; k < 20; ++k) {
    const Vector3d reference = random.vector(100.0), delta = random.vector(0.01),
                   epsilon = random.vector(1e-4);
    const double q = random.between(-9.0, 9.0);
    const Eigen::Matrix3d back = kinematics::rotationAbout(Vector3d::UnitZ(), -q);
    std::vector<EffectPtr> fixed, moved;
    for (int row = 0; row < 3; ++row) {
      fixed.push_back(table(row, delta[row], true, reference));
      fixed.push_back(table(row + 3, epsilon[row], true, reference));
      moved.push_back(table(row, (back * delta)[row], false, reference));
      moved.push_back(table(row + 3, (back * epsilon)[row], false, reference));
    }
    const MachineState state = at({17.0, q, 30.0});
    const ToolPose a = ErrorModel::make(machine, fixed).value().actualPose(state);
    const ToolPose b = ErrorModel::make(machine, moved).value().actualPose(state);
    EXPECT_LT((a.tip - b.tip).norm(), 1e-12);
    EXPECT_LT((a.R_WP - b.R_WP).norm(), 1e-14);
  }
}

TEST(ErrorModel, BundledTablesGiveTheSumOfTheEffects) {
  Random random(52);
  for (int k = 0; k < 20; ++k) {
    const Machine machine = test_support::randomMachine(random, 2 + k % 8);
    const ErrorModel model = test_support::randomModel(random, machine);
    const MachineState state = at(test_support::randomPositions(random, machine));
    JointDisplacements found, sum;
    kinematics::DisplacementSlopes slopes, slope_sum;
    model.displacements(state, {}, found);
    model.slopes(state, found, slopes);
    for (const EffectPtr& effect : model.effects()) {
      const auto joint = static_cast<std::size_t>(effect->joint());
      const Slot slot = effect->slot();
      effect->addMotion(state, {},
                        slot == Slot::Located    ? sum[joint].located
                        : slot == Slot::Standing ? sum[joint].standing
                                                 : sum[joint].moved);
      if (slot == Slot::Located) continue;
      effect->addSlope(state, slot == Slot::Standing ? slope_sum[joint].standing : slope_sum[joint].moved);
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(machine.jointCount()); ++i) {
      EXPECT_LT((found[i].located.rotation - sum[i].located.rotation).norm(), 1e-17);
      EXPECT_LT((found[i].standing.rotation - sum[i].standing.rotation).norm(), 1e-17);
      EXPECT_LT((found[i].moved.translation - sum[i].moved.translation).norm(), 1e-16);
      EXPECT_LT((slopes[i].moved.translation - slope_sum[i].moved.translation).norm(), 1e-16);
      EXPECT_LT((slopes[i].standing.rotation - slope_sum[i].standing.rotation).norm(), 1e-16);
    }
  }
}

void compareWithDifferences(const ErrorModel& model, const JointPositions& q) {
  const Machine& machine = model.machine();
  kinematics::PoseJacobian jacobian;
  (void)model.actualPoseWithJacobian(at(q), {}, jacobian);
  for (int i = 0; i < machine.jointCount(); ++i) {
    const double h = machine.isRotary(i) ? 1e-5 : 1e-3;
    JointPositions low = q, high = q;
    low[static_cast<std::size_t>(i)] -= h;
    high[static_cast<std::size_t>(i)] += h;
    const ToolPose a = model.actualPose(at(low)), b = model.actualPose(at(high));
    EXPECT_LT(((b.tip - a.tip) / (2 * h) - jacobian.col(i).head<3>()).norm(), 1e-6) << i;
    const Vector3d turn = kinematics::logarithm(b.R_WP * a.R_WP.transpose()) / (2 * h);
    EXPECT_LT((turn - jacobian.col(i).tail<3>()).norm(), 1e-8) << i;
  }
}

TEST(ErrorModel, JacobianWithTheSlopesAgreesWithCentralDifferences) {
  Random random(53);
  for (int k = 0; k < 30; ++k) {
    const Machine machine = test_support::randomMachine(random, 2 + k % 8);
    compareWithDifferences(test_support::randomModel(random, machine),
                           test_support::randomPositions(random, machine));
  }
}

TEST(ErrorModel, SlopesWithReferencePointsAgreeWithCentralDifferences) {
  for (const std::string frame : {"moved", "fixed"}) {
    const std::string reference = R"(, "reference_mm": [30, -200, 100])";
    const std::string head =
        R"({"effect": "table", "start_deg": 0, "spacing_deg": 60, "frame": ")" + frame + "\"";
    const ErrorModel model =
        modelOf("b2-k3032",
                head + reference + R"(, "component": "EXC", "values_um": [9, -8, 7, 1, 3, -5]}, )" + head +
                    reference + R"(, "component": "EBC", "values_arcsec": [90, -80, 70, 10, 30, -50]})");
    compareWithDifferences(model, {20.0, 2.2, 40.0});
    compareWithDifferences(model, {-20.0, -1.7, 40.0});
  }
}

TEST(ErrorModel, ReportsWhatItsTablesDoNotCover) {
  const ErrorModel model = modelOf("generic-3axis", constant("EXX", R"("values_um": [5, 6])"));
  EXPECT_EQ(model.firstUncovered(at({0, 5, 0})), -1);
  EXPECT_EQ(model.firstUncovered(at({0, 11, 0})), 0);
  EXPECT_EQ(model.featureLength(1), 10.0);
}

TEST(ErrorModel, MemoryOfTheWrongSizeIsAContractViolation) {
  const ErrorModel model = modelOf("generic-3axis", constant("EXX", R"("values_um": [5, 6])"));
  const std::vector<double> wrong(3);
  JointDisplacements d;
  EXPECT_THROW(model.displacements(at({}), wrong, d), ContractViolation);
}

}  // namespace
}  // namespace nineline::errors
