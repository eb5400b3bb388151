#include "core/base/json.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace nineline {
namespace {

Json parsed(std::string_view text) {
  const Result<Json> json = parseJson(text, "test");
  EXPECT_TRUE(json) << text << ": " << (json ? "" : json.error().message());
  return json.value_or(Json());
}

Error refused(std::string_view text) {
  const Result<Json> json = parseJson(text, "file.json");
  EXPECT_FALSE(json) << text;
  return json ? Error() : json.error();
}

TEST(ParseJson, ReadsEveryKindOfValue) {
  const Json json = parsed(R"({"a": [1, -2.5e3, true, false, null, "t\u00b5\n"], "b": {}})");
  const Json::Array& items = *json.find("a")->items();
  ASSERT_EQ(items.size(), 6U);
  EXPECT_EQ(*items[0].number(), 1.0);
  EXPECT_EQ(*items[1].number(), -2500.0);
  EXPECT_TRUE(*items[2].boolean());
  EXPECT_FALSE(*items[3].boolean());
  EXPECT_TRUE(items[4].isNull());
  EXPECT_EQ(*items[5].string(), "tµ\n");
  EXPECT_TRUE(json.find("b")->members()->empty());
  EXPECT_EQ(json.find("c"), nullptr);
}

TEST(ParseJson, KeepsTheOrderOfKeys) {
  const Json json = parsed(R"({"z": 1, "a": 2, "m": 3})");
  std::string keys;
  for (const auto& [key, value] : *json.members()) keys += key;
  EXPECT_EQ(keys, "zam");
}

TEST(ParseJson, ValuesRememberTheirLine) {
  const Json json = parsed("{\n  \"a\": 1,\n\n  \"b\": [\n    2,\n    \"x\"\n  ]\n}");
  EXPECT_EQ(json.line(), 1U);
  EXPECT_EQ(json.find("a")->line(), 2U);
  EXPECT_EQ(json.find("b")->line(), 4U);
  EXPECT_EQ((*json.find("b")->items())[0].line(), 5U);
  EXPECT_EQ((*json.find("b")->items())[1].line(), 6U);
}

TEST(ParseJson, ValuesRememberTheirColumn) {
  const Json json = parsed("{\"a\": {\"b\": \"text\"}}");
  EXPECT_EQ(json.find("a")->column(), 7U);
}

TEST(ParseJson, SkipsAByteOrderMark) { EXPECT_EQ(*parsed("\xef\xbb\xbf[1]").items()->at(0).number(), 1.0); }

TEST(ParseJson, RefusesARepeatedKeyWithItsPlace) {
  const Error error = refused("{\n \"a\": 1,\n \"a\": 2\n}");
  EXPECT_EQ(error.code, "json.duplicate");
  EXPECT_EQ(error.line, 3U);
  EXPECT_NE(error.text.find("'a'"), std::string::npos);
  parsed(R"([{"a": 1}, {"a": 2}])");  // in two objects it is none
}

TEST(ParseJson, RefusesBadTextWithItsPlace) {
  for (const char* text :
       {"",       "{",     "[1,",     "[1,]",       "{\"a\"}",  "{\"a\":}",   "{a: 1}", "[1] 2",
        "nul",    "'a'",   "[NaN]",   "[Infinity]", "[01]",     "[1.]",       "[.5]",   "[+1]",
        "\"\t\"", "[1 2]", "// c\n1", "\"\\x\"",    "\"\xff\"", "\"\\ud800\""}) {
    const Error error = refused(text);
    EXPECT_EQ(error.code, "json.syntax") << text;
    EXPECT_EQ(error.source, "file.json") << text;
    EXPECT_GE(error.line, 1U) << text;
  }
  EXPECT_EQ(refused("[\n1,\n2,\nx]").line, 4U);
}

TEST(ParseJson, RefusesNumbersThatAreNone) {
  const Error error = refused("[\n1e999]");
  EXPECT_EQ(error.kind, ErrorKind::BadInput);
  EXPECT_EQ(error.line, 2U);
}

TEST(ParseJson, RefusesDeepNestingWithoutHarm) {
  parsed(std::string(200, '[') + std::string(200, ']'));
  EXPECT_EQ(refused(std::string(201, '[') + std::string(201, ']')).code, "json.depth");
  EXPECT_EQ(refused(std::string(1000000, '[')).code, "json.depth");
}

TEST(ParseJson, EveryCutOfAFileIsRefused) {
  const std::string text =
      R"({"format": "nineline-machine/1", "chain": [{"axis": "Z", "travel": [-4e2, 4.5]}]})";
  for (std::size_t length = 0; length < text.size(); ++length) refused(text.substr(0, length));
  parsed(text);
}

TEST(WriteJson, ReadsBackTheSame) {
  const std::string text = R"({"a":[1,-2.5,0.1,true,null,"q\"\\\nµ"],"b":{"c":[],"d":{}}})";
  EXPECT_EQ(writeJson(parsed(text), -1), text);
  EXPECT_EQ(writeJson(parsed(writeJson(parsed(text), 2)), -1), text);
}

TEST(WriteJson, NumbersReadBackToTheSameBits) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> exponent(-300.0, 300.0);
  for (int i = 0; i < 5000; ++i) {
    const double value = std::pow(10.0, exponent(random)) * (i % 2 == 0 ? 1.0 : -1.0);
    ASSERT_EQ(*parsed(writeJson(Json(value))).number(), value);
  }
}

TEST(WriteJson, WritesNoNumberThatIsNone) {
  EXPECT_EQ(writeJson(Json(std::numeric_limits<double>::quiet_NaN())), "null");
  EXPECT_EQ(writeJson(Json(-std::numeric_limits<double>::infinity())), "null");
  EXPECT_EQ(writeJson(Json(-0.0)), "0");
}

TEST(WriteJson, StrayBytesBecomeText) {
  EXPECT_TRUE(parseJson(writeJson(Json("a\xff"
                                       "b")),
                        "test"));
}

TEST(Json, SetReplacesAndAppends) {
  Json object = Json::object();
  object.set("a", 1).set("b", 2).set("a", 3);
  EXPECT_EQ(writeJson(object, -1), R"({"a":3,"b":2})");
  EXPECT_THROW(object.push(1), ContractViolation);
  Json array = Json::array();
  array.push(1).push("two");
  EXPECT_EQ(writeJson(array, -1), R"([1,"two"])");
  EXPECT_THROW(array.set("a", 1), ContractViolation);
}

TEST(JsonReader, ReadsMembers) {
  const Json json = parsed(R"({"n": 1.5, "t": "x", "f": true, "v": [1, 2, 3]})");
  JsonReader reader(json, "file.json", "machine");
  EXPECT_EQ(reader.number("n"), 1.5);
  EXPECT_EQ(reader.numberOr("absent", 9.0), 9.0);
  EXPECT_EQ(reader.string("t"), "x");
  EXPECT_EQ(reader.stringOr("absent", "d"), "d");
  EXPECT_TRUE(reader.booleanOr("f", false));
  EXPECT_EQ(reader.numbers("v", 3), (std::vector<double>{1, 2, 3}));
  EXPECT_FALSE(reader.failed());
}

TEST(JsonReader, NamesTheFirstFaultWithPlaceFoundAndExpected) {
  const Json json = parsed("{\n \"n\": \"abc\",\n \"v\": [1,\n \"x\"]\n}");
  JsonReader reader(json, "file.json", "joint X");
  EXPECT_EQ(reader.number("n"), 0.0);
  EXPECT_EQ(reader.string("missing"), "");
  ASSERT_TRUE(reader.failed());
  EXPECT_EQ(reader.error().line, 2U);
  EXPECT_EQ(reader.error().text, "joint X: 'n' is the text 'abc', expected a number.");
}

TEST(JsonReader, FaultsOfLists) {
  const Json json = parsed("{\n \"v\": [1,\n \"x\"],\n \"w\": 3}");
  JsonReader text_in_numbers(json, "f", "t");
  EXPECT_TRUE(text_in_numbers.numbers("v").empty());
  EXPECT_EQ(text_in_numbers.error().line, 3U);
  JsonReader no_list(json, "f", "t");
  EXPECT_TRUE(no_list.items("w").empty());
  EXPECT_EQ(no_list.error().code, "json.type");
  JsonReader absent(json, "f", "t");
  EXPECT_EQ(absent.numbers("gone", 3).size(), 3U) << "so that a caller may index before it asks";
  EXPECT_EQ(absent.error().code, "json.missing");
}

TEST(JsonReader, WantsAnObject) {
  const Json json = parsed("[1]");
  const JsonReader reader(json, "f", "machine");
  ASSERT_TRUE(reader.failed());
  EXPECT_EQ(reader.error().text, "machine: found a list, expected an object.");
}

}  // namespace
}  // namespace nineline
