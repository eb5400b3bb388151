#include "core/kinematics/machine_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/base/units.h"

namespace nineline::kinematics {
namespace {

TEST(BuiltInMachines, AreTheEightOfTheContractInItsOrder) {
  std::vector<std::string> ids;
  for (const Machine& machine : builtInMachines()) ids.push_back(machine.id());
  const std::vector<std::string> expected = {"b2-k3032",     "generic-3axis", "trunnion-ac",
                                             "head-head-bc", "table-head-bc", "propeller-c2zxc1b1",
                                             "rotary-table", "linear-stage"};
  EXPECT_EQ(ids, expected);
  EXPECT_EQ(findBuiltInMachine("b2-k3032")->jointCount(), 3);
  EXPECT_EQ(findBuiltInMachine("nothing"), nullptr);
}

TEST(MachineFile, RoundTripGivesAnEqualMachine) {
  for (const Machine& machine : builtInMachines()) {
    const Result<Machine> back = readMachine(writeJson(machineToJson(machine)), "copy");
    ASSERT_TRUE(back) << back.error().message();
    EXPECT_EQ(writeJson(machineToJson(*back)), writeJson(machineToJson(machine)));
    for (int i = 0; i < machine.jointCount(); ++i) {
      EXPECT_EQ(back->joint(i).axis, machine.joint(i).axis);
      EXPECT_EQ(back->joint(i).direction, machine.joint(i).direction);
      EXPECT_EQ(back->joint(i).continuous, machine.joint(i).continuous);
      EXPECT_EQ(back->joint(i).travel.has_value(), machine.joint(i).travel.has_value());
      if (!machine.joint(i).travel) continue;
      EXPECT_NEAR(back->joint(i).travel->high, machine.joint(i).travel->high, 1e-14);
    }
  }
}

TEST(Machine, TravelAndNames) {
  const Machine& machine = *findBuiltInMachine("trunnion-ac");
  EXPECT_NEAR(machine.joint(0).travel->high, radFromDeg(120.0), 1e-15);
  EXPECT_EQ(machine.find({'Z', 0}), 4);
  EXPECT_EQ(machine.find({'B', 0}), -1);
  EXPECT_EQ(machine.side(1), Side::Workpiece);
  EXPECT_EQ(machine.side(2), Side::Tool);
  EXPECT_EQ(machine.firstOutsideTravel({0, 100.0, 0, 0, 0}), -1);  // C is continuous
  EXPECT_EQ(machine.firstOutsideTravel({0, 0, 0, 500.001, 0}), 3);
}

std::string fileWith(const std::string& joint, const std::string& head = "nineline-machine/1",
                     const std::string& rest = "") {
  return "{\"format\": \"" + head + "\", \"id\": \"m\",\n \"workpiece_chain\": [],\n \"tool_chain\": [\n" +
         joint + "]" + rest + "}";
}
std::string axis(const std::string& name) {
  return R"({"axis": ")" + name + R"(", "type": "linear", "direction": [1,0,0]})";
}

struct BadFile {
  std::string text;
  std::string code;
  std::string line;
  std::string found;  // part of the message: what stood there
};

std::vector<BadFile> badFiles() {
  std::string ten;
  for (const char* name : {"X", "Y", "Z", "U", "V", "W", "A", "B", "C", "C2"}) ten += axis(name) + ",\n";
  ten.resize(ten.size() - 2);
  return {
      {"{", "", "1", ""},
      {"[]", "json.type", "1", "a list"},
      {"{\"format\": 3}", "json.type", "1", "the number 3"},
      {"{\"id\": \"m\"}", "json.missing", "1", "'format' is missing"},
      {fileWith(axis("X"), "nineline-machine/9"), "machine.format", "1", "nineline-machine/9"},
      {"{\"format\": \"nineline-machine/1\"}", "json.missing", "1", "'id' is missing"},
      {"{\"format\": \"nineline-machine/1\",\n\"id\": \"m\", \"tool_chain\": []}", "json.missing", "1",
       "'workpiece_chain' is missing"},
      {fileWith(""), "machine.joints", "1", "found 0"},
      {fileWith(ten), "machine.joints", "1", "found 10"},
      {fileWith("7"), "json.type", "4", "the number 7"},
      {fileWith(axis("Q")), "machine.axis", "4", "'Q'"},
      {fileWith(axis("XX")), "machine.axis", "4", "'XX'"},
      {fileWith(axis("X0")), "machine.axis", "4", "'X0'"},
      {fileWith(axis("X") + ",\n" + axis("X")), "machine.axis", "5", "X occurs twice"},
      {fileWith(R"({"type": "linear", "direction": [1,0,0]})"), "json.missing", "4", "'axis' is missing"},
      {fileWith(R"({"axis": "X", "direction": [1,0,0]})"), "json.missing", "4", "'type' is missing"},
      {fileWith(R"({"axis": "X", "type": "round", "direction": [1,0,0]})"), "machine.type", "4", "'round'"},
      {fileWith(R"({"axis": "X", "type": "linear"})"), "json.missing", "4", "'direction' is missing"},
      {fileWith(R"({"axis": "X", "type": "linear", "direction": [1,0]})"), "json.count", "4", "2 values"},
      {fileWith(R"({"axis": "X", "type": "linear", "direction": [1,1,0]})"), "machine.direction", "4",
       "1.41421"},
      {fileWith(R"({"axis": "X", "type": "linear", "direction": [0,0,0]})"), "machine.direction", "4",
       "length 0"},
      {fileWith(R"({"axis": "X", "type": "linear", "direction": [1,0,"a"]})"), "json.type", "4", "'a'"},
      {fileWith(R"({"axis": "X", "type": "linear", "direction": [NaN,0,0]})"), "", "4", ""},
      {fileWith(R"({"axis": "X", "type": "linear", "direction": [1e999,0,0]})"), "", "4", "1e999"},
      {fileWith(R"({"axis": "X", "type": "linear", "direction": [1,0,0], "travel": [5,-5]})"),
       "machine.travel", "4", "travel of axis X"},
      {fileWith(R"({"axis": "X", "type": "linear", "direction": [1,0,0], "travel": 5})"), "json.type", "4",
       "the number 5"},
      {fileWith(R"({"axis": "X", "type": "linear", "direction": [1,0,0], "continuous": true})"),
       "machine.continuous", "4", "X is linear"},
      {fileWith(R"({"axis": "C", "type": "rotary", "direction": [0,0,1], "continuous": "yes"})"), "json.type",
       "4", "'yes'"},
      {fileWith(R"({"axis": "C", "type": "rotary", "direction": [0,0,1], "diameter": true})"),
       "machine.diameter", "4", "C is rotary"},
      {fileWith(R"({"axis": "X", "type": "linear", "direction": [1,0,0], "rapid_mm_min": 0})"),
       "machine.rapid", "4", "is 0"},
      {fileWith(R"({"axis": "X", "type": "linear", "direction": [1,0,0], "offset_mm": "far"})"), "json.type",
       "4", "'far'"},
      {fileWith(axis("X"), "nineline-machine/1", ",\n\"tool\": 5"), "json.type", "5", "the number 5"},
      {fileWith(axis("X"), "nineline-machine/1", ",\n\"tool\": {\"axis\": [0,0,2]}"), "machine.direction",
       "5", "length 2"},
      {fileWith(axis("X"), "nineline-machine/1", ",\n\"tool\": {\"tip_mm\": [0,0]}"), "json.count", "5",
       "2 values"},
  };
}

TEST(MachineFile, EachFaultIsReportedAtItsPlaceWithWhatStoodThere) {
  for (const BadFile& bad : badFiles()) {
    const Result<Machine> machine = readMachine(bad.text, "bad.json");
    ASSERT_FALSE(machine) << bad.text;
    const Error& error = machine.error();
    EXPECT_EQ(error.kind, ErrorKind::BadInput) << bad.text;
    EXPECT_TRUE(bad.code.empty() || error.code == bad.code) << error.code << ": " << error.message();
    EXPECT_TRUE(error.message().starts_with("bad.json:" + bad.line + ":")) << error.message() << "\n"
                                                                           << bad.text;
    EXPECT_GT(error.column, 0U) << error.message();
    EXPECT_NE(error.text.find(bad.found), std::string::npos) << error.message();
  }
}

TEST(MachineFile, UnknownMachineNamesBothTries) {
  const Result<Machine> machine = loadMachine("no-such-machine");
  ASSERT_FALSE(machine);
  EXPECT_EQ(machine.error().kind, ErrorKind::BadInput);
  EXPECT_NE(machine.error().text.find("no built-in machine"), std::string::npos);
}

TEST(Machine, MakeRefusesWhatAFileCannotHold) {
  Machine::Description description;
  Joint joint;
  joint.axis = {'X', 0};
  joint.direction = {std::nan(""), 0.0, 0.0};
  description.tool_chain = {joint};
  EXPECT_FALSE(Machine::make(description));
  description.tool_chain[0].direction = Vector3d::UnitX();
  EXPECT_TRUE(Machine::make(description));
  description.tool_chain[0].offset.y() = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(Machine::make(description));
  description.tool_chain[0].offset.y() = 0.0;
  description.tool_chain[0].travel = Travel{0.0, std::nan("")};
  EXPECT_FALSE(Machine::make(description));
  description.tool_chain[0].travel.reset();
  description.tool_tip.x() = std::nan("");
  EXPECT_FALSE(Machine::make(description));
}

}  // namespace
}  // namespace nineline::kinematics
