#include "core/measurement/evaluation_record.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/units.h"
#include "core/measurement/measurement_file.h"

namespace nineline::measurement {
namespace {

using testing::HasSubstr;

MeasurementReading read(const std::string& text) {
  MeasurementReading reading = readMeasurement(text, "test.csv", {nullptr, true});
  EXPECT_FALSE(reading.diagnostics.hasErrors()) << reading.diagnostics.firstError("test.csv").text;
  return reading;
}

std::string head(const std::string& machine, const std::string& instrument) {
  return "#nineline-measurement: 1\n#machine: " + machine + "\n#instrument: " + instrument + "\n";
}

Result<std::vector<Evaluation>> evaluate(const MeasurementReading& reading) {
  const std::vector<EvaluationInput> inputs{{&reading.measurement, &*reading.machine}};
  return evaluateMeasurements(inputs);
}

double at(const Json& record, const char* standard, const char* key) {
  const Json* figures = record.find(standard);
  const Json* value = figures == nullptr ? nullptr : figures->find(key);
  EXPECT_TRUE(value != nullptr && value->number() != nullptr) << standard << " " << key;
  return value == nullptr || value->number() == nullptr ? NAN : *value->number();
}

/// The hand case of iso_230_2_test in um: up, turned round at the end after an overrun, down; twice. The
/// direction follows from the order of positions alone.
TEST(Evaluation, FindsTheDirectionsOfAPendulum) {
  const MeasurementReading reading = read(head("linear-stage", "laser-linear") +
                                          "#axis: X\n#point_mm: 0 0 0\nrun,X_mm,dev_um\n"
                                          "1,0,0\n1,100,5\n1,100,7\n1,0,4\n"
                                          "2,0,2\n2,100,5\n2,100,11\n2,0,4\n");
  const Result<std::vector<Evaluation>> found = evaluate(reading);
  ASSERT_TRUE(found) << found.error().text;
  const Json record = evaluationsToJson(*found);
  EXPECT_NEAR(at(record, "iso_230_2", "E_um"), 8.0, 1e-9);
  EXPECT_NEAR(at(record, "iso_230_2", "B_um"), 4.0, 1e-9);
  EXPECT_NEAR(at(record, "iso_230_2", "mean_B_um"), -3.5, 1e-9);
  EXPECT_NEAR(at(record, "iso_230_2", "M_um"), 4.5, 1e-9);
  EXPECT_NEAR(at(record, "iso_230_2", "R_um"), 8.0 * std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(at(record, "iso_230_2", "A_um"), 8.0 + 6.0 * std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(at(record, "vdi_3441", "Pa_um"), 4.5, 1e-9);
  const Json& position = (*record.find("iso_230_2")->find("positions")->items())[1];
  EXPECT_EQ(*position.find("target_mm")->number(), 100.0);
  EXPECT_NEAR(*position.find("B_um")->number(), -4.0, 1e-9);
  EXPECT_THAT(evaluationText(found->front()), HasSubstr("A accuracy"));
  EXPECT_EQ(found->front().warnings.all().front().code, "evaluation.runs");  // two approaches, five asked for
}

/// The column wins over the order, and an unread direction leaves its target out.
TEST(Evaluation, TakesTheApproachColumn) {
  const MeasurementReading reading = read(head("linear-stage", "joint") +
                                          "#axis: X\nX_mm,approach_X_1,dev_um\n"
                                          "0,1,1\n10,1,2\n20,1,3\n20,-1,4\n10,-1,5\n");
  const Result<std::vector<Evaluation>> found = evaluate(reading);
  ASSERT_TRUE(found) << found.error().text;
  EXPECT_EQ(found->front().iso_230_2->positions.size(), 2U);
  EXPECT_NEAR(*found->front().iso_230_2->B, 3e-3, 1e-12);
  EXPECT_EQ(found->front().warnings.all().front().code, "evaluation.target");
  EXPECT_THAT(found->front().warnings.all().front().text, HasSubstr("Target 0 was not read in the backward"));
}

TEST(Evaluation, ShowsAngles) {
  const MeasurementReading reading = read(head("rotary-table", "joint") +
                                          "#axis: C\nrun,C_deg,dev_arcsec\n"
                                          "1,0,0\n1,90,5\n1,180,2\n2,0,1\n2,90,6\n2,180,3\n");
  const Result<std::vector<Evaluation>> found = evaluate(reading);
  ASSERT_TRUE(found) << found.error().text;
  const Json record = evaluationsToJson(*found);
  EXPECT_NEAR(at(record, "iso_230_2", "E_forward_arcsec"), 5.0, 1e-9);
  EXPECT_TRUE(record.find("iso_230_2")->find("E_arcsec")->isNull());
  EXPECT_NEAR(*(*record.find("iso_230_2")->find("positions")->items())[2].find("target_deg")->number(), 180.0,
              1e-9);
}

std::string circle(double sense, double shift_um, double oval_um, double radius) {
  std::string rows;
  for (int i = 0; i < 72; ++i) {
    const double angle = sense * kTurn * i / 72.0;
    rows += std::to_string(sense > 0 ? 1 : 2) + "," + std::to_string(radius * std::cos(angle)) + "," +
            std::to_string(radius * std::sin(angle)) + ",0," +
            std::to_string(shift_um + oval_um * std::cos(2.0 * angle)) + "\n";
  }
  return rows;
}

/// Ballbar on the tool side: counter-clockwise then clockwise; figures by hand.
TEST(Evaluation, TellsTheSensesOfABallbar) {
  const std::string text = head("generic-3axis", "ballbar") +
                           "#centre_mm: 0 0 0\n#radius_mm: 150\n#plane: XY\nrun,X_mm,Y_mm,Z_mm,dr_um\n" +
                           circle(1.0, 0.0, 3.0, 150.0) + circle(-1.0, 1.0, 2.0, 150.0);
  const MeasurementReading reading = read(text);
  const Result<std::vector<Evaluation>> found = evaluate(reading);
  ASSERT_TRUE(found) << found.error().text;
  const Json record = evaluationsToJson(*found);
  EXPECT_NEAR(at(record, "iso_230_4", "G_ccw_um"), 6.0, 1e-3);
  EXPECT_NEAR(at(record, "iso_230_4", "G_cw_um"), 4.0, 1e-3);
  EXPECT_NEAR(at(record, "iso_230_4", "G_um"), 6.0, 0.1);
  EXPECT_NEAR(at(record, "iso_230_4", "D_um"), 0.5, 0.05);
  EXPECT_NEAR(at(record, "iso_230_4", "H_um"), 2.0, 0.02);
}

TEST(Evaluation, GivesTheRunOutOfADial) {
  std::string text =
      head("rotary-table", "dial") + "#axis: C\n#point_mm: 50 0 0\n#sensitive: X\nC_deg,dev_um\n";
  for (int i = 0; i < 36; ++i) {
    text += std::to_string(10 * i) + "," + std::to_string(4.0 * std::cos(radFromDeg(10.0 * i))) + "\n";
  }
  const MeasurementReading reading = read(text);
  const Result<std::vector<Evaluation>> found = evaluate(reading);
  ASSERT_TRUE(found) << found.error().text;
  const Json record = evaluationsToJson(*found);
  EXPECT_NEAR(at(record, "run_out", "total_um"), 8.0, 1e-4);
  EXPECT_NEAR(at(record, "run_out", "without_eccentricity_um"), 0.0, 1e-4);
}

TEST(Evaluation, RefusesWhatHasNoFigures) {
  const MeasurementReading straight =
      read(head("linear-stage", "laser-straightness") +
           "#axis: X\n#sensitive: Y\n#point_mm: 0 0 0\nX_mm,dev_um\n0,1\n1,2\n");
  EXPECT_EQ(evaluate(straight).error().code, "evaluation.instrument");
  const MeasurementReading standing =
      read(head("linear-stage", "joint") + "#axis: X\nX_mm,dev_um\n5,1\n5,2\n");
  EXPECT_FALSE(evaluate(standing));
}

}  // namespace
}  // namespace nineline::measurement
