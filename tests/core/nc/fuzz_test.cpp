#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/core/nc/program_runner.h"

namespace nineline::nc::testing {
namespace {

constexpr int kRounds = 1500;

const char* const kPrograms[] = {
    "%\nO0001(A)\nN10 G21 G90 G17 G94\nG0 X1. Y2.\nG2 X3. Y0 I1. J-1. F100.\nG81 Z-5. R2. "
    "F50.\nX5.\nG80\n#1=[1+2]*SIN[30]\n"
    "WHILE [#1 LT 5] DO1\n#1=#1+1\nG1 X#1\nEND1\nIF [#1 EQ 5] GOTO 20\nN20 M98 P2 L2\nM30\nO2\nG91 "
    "X1.\nM99\n%\n",
    "DEF REAL A=1\nR1=5 R2=R1*2\nG0 X=R2 Y=IC(3)\nIF R1==5 GOTOF L1\nX7\nL1: G3 X0 Y5 CR=5 "
    "F100\nMSG(\"t\")\nCYCLE832(0.1)\nM30\n",
    "o<s> sub\n#<a>=#1\no1 if [#<a> GT 1]\nG0 X[#<a>*2]\no1 else\nG1 X1 F5\no1 endif\no<s> endsub\no<s> call "
    "[2]\n"
    "o2 repeat [2]\nG33 Z-1 K1\no2 endrepeat\nG10 L2 P1 X1 R30\nG2 X2 Y0 I1 J0 P2\n(debug, x)\nM2\n"};

TEST(Fuzz, SpoiltProgramsEndWithoutHarm) {
  std::mt19937 random(20240601);
  const std::string alphabet = "GXYZIJKRFMNO0123456789.-+#[]()=;:%/<> \n\r\"$,*o\x01\xc3";
  std::size_t ended = 0;
  for (int round = 0; round < kRounds; ++round) {
    std::string program = kPrograms[round % 3];
    const int changes = 1 + static_cast<int>(random() % 6);
    for (int i = 0; i < changes; ++i) {
      const std::size_t place = random() % program.size();
      const char c = alphabet[random() % alphabet.size()];
      switch (random() % 3) {
        case 0:
          program[place] = c;
          break;
        case 1:
          program.insert(place, 1, c);
          break;
        default:
          program.erase(place, 1 + random() % 3);
          break;
      }
      if (program.empty()) program = "G0";
    }
    InterpreterOptions options = optionsFor("XYZ", Dialect::Fanuc);
    options.most_jumps = 300;
    if (round % 2 == 0) options.dialect.reset();
    const ProgramRun result = run(program, options);
    for (const Motion& motion : result.motions) {
      for (int i = 0; i < 3; ++i)
        ASSERT_TRUE(std::isfinite(motion.end[static_cast<std::size_t>(i)])) << program;
    }
    ++ended;
  }
  EXPECT_EQ(ended, static_cast<std::size_t>(kRounds));
}

}  // namespace
}  // namespace nineline::nc::testing
