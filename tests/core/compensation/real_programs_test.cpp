// Cases that real programs have brought up (resources/docs/reports/real-programs.md).
#include <gtest/gtest.h>

#include "core/compensation/line_editor.h"
#include "core/nc/tokenizer.h"
#include "tests/core/compensation/correction.h"

namespace nineline::compensation {
namespace {

using test_support::corrected;
using test_support::modelFrom;
using test_support::squareX;

std::string withC(const std::string& text, bool named) {
  nc::Block block;
  block.line = 2;
  block.text = text;
  EXPECT_TRUE(nc::readPlainWords(block, nc::Dialect::Fanuc));
  LineEditor editor;
  editor.begin(block);
  editor.setAxis({'C', 0}, 64.5, 1, named);
  std::string line;
  editor.finish(line);
  return line;
}

TEST(RealPrograms, TheNumberOfALengthIsNoIncrementOfC) {
  EXPECT_EQ(withC("G43 H1 Z5.0 M08", false), "G43 H1 Z5.0 C64.5 M08");
  EXPECT_EQ(withC("G01 H12.", true), "G01 H64.5");
}

TEST(RealPrograms, AHoleIsPutRightWhereTheToolFirstRises) {
  const ErrorModel mill = modelFrom("generic-3axis", squareX());
  EXPECT_EQ(corrected(mill, "G21 G90 G0 X0 Y0 Z3\nG99 G81 X10 Y30 Z4 R5 F100\nG80\nG0 X50\n"),
            "G21 G90 G0 X0 Y0 Z3\nG99 G81 X9.997 Y30 Z4 R5 F100\nG80\nG0 X49.997\n");
  EXPECT_EQ(corrected(mill, "G21 G90 G0 X0 Y0 Z3\nG99 G84 X10 Y30 Z4 R5 F100\nG80\nG0 X50\n"),
            "G21 G90 G0 X0 Y0 Z3\nG99 G84 X9.997 Y30 Z4 R5 F100\nG80\nG0 X49.997\n");
}

TEST(RealPrograms, ABlockWithAComputedInverseTimeStaysOneBlock) {
  const ErrorModel bent =
      modelFrom("linear-stage",
                R"({"effect": "table", "joint": "X", "component": "EXX", "start_mm": 0, "spacing_mm": 10,
                          "values_um": [0, 9, 0, 9, 0, 9, 0, 9, 0, 9, 5]})");
  const std::string plain = corrected(bent, "G21 G90 G0 X0\nG93 G1 X100 F2\n");
  EXPECT_GT(test_support::linesOf(plain).size(), 2U);
  EXPECT_EQ(corrected(bent, "G21 G90 G0 X0\nG93 G1 X100 F[1+1]\n"), "G21 G90 G0 X0\nG93 G1 X99.995 F[1+1]\n");
}

}  // namespace
}  // namespace nineline::compensation
