#include "core/errors/error_model_file.h"

#include <gtest/gtest.h>

#include "core/base/units.h"
#include "core/errors/effect_catalogue.h"

namespace nineline::errors {
namespace {

std::string modelText(const std::string& effects, const std::string& machine = "\"b2-k3032\"") {
  return "{\"format\": \"nineline-model/1\",\n\"machine\": " + machine + ",\n\"effects\": [\n" + effects +
         "]}";
}
std::string table(const std::string& members) { return "{\"effect\": \"table\",\n" + members + "}"; }
std::string scale(const std::string& parameters) {
  return "{\"effect\": \"scale\", \"joint\": \"X\",\n\"parameters\": " + parameters + "}";
}

TEST(Component, NamesOfIso230) {
  for (const char* name : {"EZZ", "EXC", "EAC2", "B0X", "X0C", "C0Y"}) {
    const std::optional<Component> component = parseComponent(name);
    ASSERT_TRUE(component) << name;
    EXPECT_EQ(component->text(), name);
  }
  EXPECT_EQ(parseComponent("EB0Z")->text(), "B0Z");
  EXPECT_TRUE(parseComponent("EBX")->isAngular());
  for (const char* name : {"", "E", "EZ", "XX", "EQZ", "EZQ", "0BX", "B0", "EZZZ", "E0Z", "EZZ0"})
    EXPECT_FALSE(parseComponent(name)) << name;
}

TEST(ErrorModelFile, RoundTripKeepsEveryEffect) {
  const std::string text = modelText(
      R"({"effect": "table", "joint": "Z", "component": "EZZ", "start_mm": 0, "spacing_mm": 25, "values_um": [0, 1.2, 3],
          "sigmas_um": [0.1, 0.2, 0.3], "interpolation": "linear", "reference_mm": [1, 2, 3], "source": "measured"},
      {"effect": "table", "component": "EBC", "start_deg": 0, "spacing_deg": 120, "values_arcsec": [0, 1.5, -2],
       "frame": "fixed", "when": "2026-01-02"},
      {"effect": "location", "component": "B0X", "value_arcsec": 4.1, "sigma_arcsec": 0.2},
      {"effect": "backlash", "joint": "X", "parameters": {"width": {"value": 3.2, "sigma": 0.2, "unit": "um"}}},
      {"effect": "cyclic", "joint": "C", "parameters": {"amplitude": 2, "period": 30}},
      {"effect": "thermal_screw", "joint": "Z", "parameters": {"k": 11}, "sensor": "temp_nut_C"}, )" +
      scale("{\"k\": 5}"));
  const Result<ErrorModel> model = readErrorModel(text, "a");
  ASSERT_TRUE(model) << model.error().message();
  const std::string written = writeJson(errorModelToJson(*model));
  const Result<ErrorModel> back = readErrorModel(written, "b");
  ASSERT_TRUE(back) << back.error().message();
  EXPECT_EQ(back->effects().size(), 7U);
  EXPECT_EQ(back->effects()[0]->provenance().source, "measured");
  EXPECT_EQ(back->effects()[1]->provenance().when, "2026-01-02");
  MachineState state;
  state.q = {31.0, 2.0, 77.0};
  state.approach = {1, -1, 1};
  state.conditions = {{"temp_nut_C", 25.0}};
  EXPECT_LT((model->actualPose(state).tip - back->actualPose(state).tip).norm(), 1e-13);
  EXPECT_GT((model->actualPose(state).tip - model->idealPose(state).tip).norm(), 1e-3);
  EXPECT_NE(written.find("\"b2-k3032\""), std::string::npos);
}

TEST(ErrorModelFile, ATurnThatRepeatsItsFirstValueIsPeriodic) {
  const Result<ErrorModel> model = readErrorModel(
      modelText(table(R"("component": "EXC", "start_deg": 0, "spacing_deg": 120, "values_um": [1, 2, 3, 1],
                         "sigmas_um": [0.1, 0.1, 0.1, 0.1])")),
      "a");
  ASSERT_TRUE(model) << model.error().message();
  EXPECT_TRUE(model->effects()[0]->table()->grid().period);
  EXPECT_EQ(model->effects()[0]->table()->values().size(), 3U);
}

struct BadModel {
  std::string text;
  std::string code;
  std::string line;
  std::string found;
};

std::vector<BadModel> badHeads() {
  return {
      {"{\"format\": 1}", "json.type", "1", "the number 1"},
      {"{\"machine\": \"b2-k3032\"}", "json.missing", "1", "'format'"},
      {"{\"format\": \"nineline-machine/1\"}", "model.format", "1", "nineline-machine/1"},
      {"{\"format\": \"nineline-model/1\"}", "json.missing", "1", "'machine'"},
      {"{\"format\": \"nineline-model/1\",\n\"machine\": \"b2-k3032\"}", "json.missing", "1", "'effects'"},
      {"{\"format\": \"nineline-model/1\",\n\"machine\": \"b2-k3032\",\n\"effects\": 5}", "json.type", "3",
       "number 5"},
      {modelText("", "\"lathe\""), "model.machine", "2", "'lathe'"},
      {modelText("", "7"), "json.type", "2", "number 7"},
      {modelText("", "{\"format\": \"x\"}"), "machine.format", "2", "'x'"},
      {modelText("{\"joint\": \"X\"}"), "json.missing", "4", "'effect' is missing"},
      {modelText("{\"effect\": \"magic\"}"), "model.effect", "4", "'magic'"},
      {modelText("{\"effect\": \"wobble\", \"joint\": \"C\"}"), "json.missing", "4", "'parameters'"},
      {modelText("{\"effect\": \"cosine\", \"joint\": \"X\"}"), "model.effect", "4", "'cosine'"},
      {modelText("[1]"), "json.type", "4", "list"},
      {modelText("{\"effect\": \"table\"} x"), "", "4", "x"},
  };
}

std::vector<BadModel> badTables() {
  const std::string grid = R"("start_mm": 0, "spacing_mm": 10,)";
  const std::string turn = R"("component": "EXC", "start_deg": 0, )";
  return {
      {modelText(table(R"("start_mm": 0)")), "json.missing", "4", "'component'"},
      {modelText(table(R"("component": "EQZ")")), "model.component", "5", "'EQZ'"},
      {modelText(table(R"("component": "EZY")")), "model.joint", "5", "no axis Y"},
      {modelText(table(R"("component": "EZZ", "joint": "X")")), "model.component", "5", "'joint' is X"},
      {modelText(table(R"("component": "B0Z")")), "model.component", "5", "B0Z"},
      {modelText(table(R"("component": "EZZ", "spacing_mm": 10, "values_um": [1])")), "json.missing", "4",
       "'start_mm'"},
      {modelText(table(R"("component": "EZZ", "start_mm": "0")")), "json.type", "5", "'0'"},
      {modelText(table(R"("component": "EZZ",)" + grid + "\n\"values_arcsec\": [1]")), "json.missing", "4",
       "'values_um'"},
      {modelText(table(R"("component": "EZZ",)" + grid + "\n\"values_um\": []")), "table.empty", "6",
       "at least one"},
      {modelText(table(R"("component": "EZZ",)" + grid + "\n\"values_um\": [1,\n\"a\"]")), "json.type", "7",
       "'a'"},
      {modelText(table(R"("component": "EZZ",)" + grid + "\n\"values_um\": [1,\nnull]")), "json.type", "7",
       "value 2"},
      {modelText(table(R"("component": "EZZ",)" + grid + "\n\"values_um\": [1,\nNaN]")), "", "7", ""},
      {modelText(table(R"("component": "EZZ",)" + grid + "\n\"values_um\": [1, 2000]")), "model.size", "6",
       "2000"},
      {modelText(table(R"("component": "EBZ",)" + grid + "\n\"values_arcsec\": [1, -3600]")), "model.size",
       "6", "-3600"},
      {modelText(table(R"("component": "EZZ", "start_mm": 0, "spacing_mm": 0, "values_um": [1])")),
       "table.spacing", "5", "spacing"},
      {modelText(
           table(R"("component": "EZZ",)" + grid + "\n\"values_um\": [1], \"interpolation\": \"step\"")),
       "model.interpolation", "6", "'step'"},
      {modelText(table(R"("component": "EZZ",)" + grid + "\n\"values_um\": [1], \"frame\": \"bed\"")),
       "model.frame", "6", "'bed'"},
      {modelText(table(R"("component": "EZZ",)" + grid + "\n\"values_um\": [1], \"reference_mm\": [1, 2]")),
       "json.count", "6", "2 values"},
      {modelText(table(R"("component": "EZZ",)" + grid + "\n\"values_um\": [1], \"sigmas_um\": [1, 2]")),
       "json.count", "6", "2 values"},
      {modelText(table(R"("component": "EZZ",)" + grid + "\n\"values_um\": [1], \"sigmas_um\": [-1]")),
       "model.sigma", "6", "-1"},
      {modelText(table(turn + "\n\"spacing_deg\": 120, \"values_um\": [1, 2, 3, 4]")), "model.closure", "6",
       "turn"},
      {modelText(table(R"("component": "EBC", "start_deg": 0,)"
                       "\n\"spacing_deg\": 120, \"values_arcsec\": [1, 2, 3, 4]")),
       "model.closure", "6", "turn"},
      {modelText(
           table(R"("component": "EXZ", "values_um": [1], "reference_mm": [1, 0, 0], )" + grid + "\"x\": 1") +
           "," +
           table(R"("component": "EYZ", "values_um": [1], "reference_mm": [2, 0, 0], )" + grid + "\"x\": 1")),
       "model.reference", "", "axis Z"},
  };
}

std::vector<BadModel> badParameters() {
  const std::string cyclic = "{\"effect\": \"cyclic\", \"joint\": \"X\",\n\"parameters\": ";
  return {
      {modelText("{\"effect\": \"location\", \"component\": \"B0X\",\n\"value_um\": 1}"), "json.missing", "4",
       "'value_arcsec'"},
      {modelText("{\"effect\": \"location\", \"component\": \"EXX\", \"value_um\": 1}"), "model.component",
       "4", "EXX"},
      {modelText("{\"effect\": \"location\", \"component\": \"X0C\",\n\"value_um\": 12000}"), "model.size",
       "5", "12000"},
      {modelText("{\"effect\": \"location\", \"component\": \"X0C\", \"value_um\": 1,\n\"sigma_um\": -1}"),
       "model.sigma", "5", "-1"},
      {modelText("{\"effect\": \"scale\", \"parameters\": {\"k\": 1}}"), "json.missing", "4", "'component'"},
      {modelText("{\"effect\": \"scale\", \"joint\": \"Y\", \"parameters\": {\"k\": 1}}"), "model.joint", "4",
       "axis Y"},
      {modelText("{\"effect\": \"scale\", \"joint\": \"X\"}"), "json.missing", "4", "'parameters'"},
      {modelText(scale("4")), "json.type", "5", "number 4"},
      {modelText(scale("{\"q\": 4}")), "model.parameter", "5", "'k' is missing"},
      {modelText(scale("{\"k\": \"4\"}")), "json.type", "5", "'4'"},
      {modelText(scale("{\"k\": {\"value\": \"4\"}}")), "json.type", "5", "'4'"},
      {modelText(scale("{\"k\":\n{\"value\": 4,\n\"unit\": \"mm\"}}")), "model.unit", "7", "'mm'"},
      {modelText(scale("{\"k\": {\"value\": 4, \"sigma\": -2}}")), "model.sigma", "5", "-2"},
      {modelText(scale("{\"k\": 50000}")), "model.size", "5", "50000"},
      {modelText("{\"effect\": \"scale\", \"component\": \"EBX\",\n\"parameters\": {\"k\": 4}}"),
       "model.component", "4", "EBX"},
      {modelText(cyclic + "{\"amplitude\": 4}}"), "model.parameter", "5", "'period'"},
      {modelText(cyclic + "{\"amplitude\": 4, \"period\": 0}}"), "model.period", "5", "is 0"},
      {modelText(cyclic + "{\"amplitude\": 4, \"period\": {\"value\": 3, \"unit\": \"deg\"}}}"), "model.unit",
       "5", "'deg'"},
      {modelText("{\"effect\": \"backlash\", \"joint\": \"X\", \"parameters\": {\"width\": 4000}}"),
       "model.size", "4", "4000"},
      {modelText(
           "{\"effect\": \"backlash\", \"joint\": \"X\", \"parameters\": {\"width\": 4}, \"source\": 3}"),
       "json.type", "4", "number 3"},
  };
}

void expectRefused(const std::vector<BadModel>& models) {
  for (const BadModel& bad : models) {
    const Result<ErrorModel> model = readErrorModel(bad.text, "bad.json");
    ASSERT_FALSE(model) << bad.text;
    const Error& error = model.error();
    EXPECT_EQ(error.kind, ErrorKind::BadInput) << bad.text;
    EXPECT_TRUE(bad.code.empty() || bad.code == error.code) << error.code << ": " << error.message();
    EXPECT_TRUE(error.message().starts_with("bad.json:" + bad.line)) << error.message() << "\n" << bad.text;
    EXPECT_GT(error.line, 0U) << error.message();
    EXPECT_GT(error.column, 0U) << error.message();
    EXPECT_NE(error.text.find(bad.found), std::string::npos) << error.message();
  }
}

TEST(ErrorModelFile, RefusesBadHeadsWithTheirPlace) { expectRefused(badHeads()); }
TEST(ErrorModelFile, RefusesBadTablesWithTheirPlace) { expectRefused(badTables()); }
TEST(ErrorModelFile, RefusesBadParametersWithTheirPlace) { expectRefused(badParameters()); }

}  // namespace
}  // namespace nineline::errors
