#include "core/nc/motion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/units.h"

namespace nineline::nc {
namespace {

TEST(Motion, PointsOfAnArcLieOnItsCircle) {
  Motion arc;
  arc.kind = MotionKind::Arc;
  arc.start = {10.0, 0.0, 0.0};
  arc.end = {0.0, 10.0, 8.0};
  arc.sweep = kTurn + kPi / 2.0;
  const AxisValues half = positionAt(arc, 3, 0.2);  // a quarter turn
  EXPECT_NEAR(half[0], 0.0, 1e-12);
  EXPECT_NEAR(half[1], 10.0, 1e-12);
  EXPECT_NEAR(half[2], 1.6, 1e-12);
  EXPECT_EQ(positionAt(arc, 3, 1.0), arc.end);
  EXPECT_EQ(positionAt(arc, 3, 0.0)[0], 10.0);
}

TEST(Motion, AnArcWithUnequalRadiiIsASpiral) {
  Motion arc;
  arc.kind = MotionKind::Arc;
  arc.start = {10.0, 0.0};
  arc.end = {-10.002, 0.0};
  arc.sweep = kPi;
  EXPECT_NEAR(positionAt(arc, 2, 0.5)[1], 10.001, 1e-12);
}

TEST(WordFrame, WordsAndPositionsAreInverse) {
  WordFrame frame;
  frame.factor = {0.5 * 25.4, 25.4, kPi / 180.0};
  frame.shift = {1.0, -2.0, 0.25};
  frame.rotation_plane = {0, 1};
  frame.cosine = std::cos(0.4);
  frame.sine = std::sin(0.4);
  const AxisValues words{3.0, -1.5, 90.0};
  const AxisValues back = frame.wordsOf(frame.positionOf(words, 3), 3);
  const AxisValues increment = frame.incrementWordsOf(frame.displacementOf(words, 3), 3);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(back[i], words[i], 1e-12);
    EXPECT_NEAR(increment[i], words[i], 1e-12);
  }
}

}  // namespace
}  // namespace nineline::nc
