#include "core/nc/motion.h"

#include <cmath>

namespace nineline::nc {
namespace {

std::size_t at(int axis) { return static_cast<std::size_t>(axis); }

/// Turns the two plane values of `values` by the frame's angle, or back by it.
void rotate(const WordFrame& frame, AxisValues& values, double sine) {
  if (frame.rotation_plane[0] < 0) return;
  double& u = values[at(frame.rotation_plane[0])];
  double& v = values[at(frame.rotation_plane[1])];
  const double turned_u = frame.cosine * u - sine * v;
  v = sine * u + frame.cosine * v;
  u = turned_u;
}

}  // namespace

AxisValues positionAt(const Motion& motion, int axes, double fraction) {
  if (fraction >= 1.0) return motion.end;
  AxisValues position = motion.start;
  for (int i = 0; i < axes; ++i) position[at(i)] += (motion.end[at(i)] - motion.start[at(i)]) * fraction;
  if (motion.kind != MotionKind::Arc) return position;
  const std::size_t u = at(motion.plane[0]);
  const std::size_t v = at(motion.plane[1]);
  const double start_u = motion.start[u] - motion.centre[0];
  const double start_v = motion.start[v] - motion.centre[1];
  const double end_radius = std::hypot(motion.end[u] - motion.centre[0], motion.end[v] - motion.centre[1]);
  const double start_radius = std::hypot(start_u, start_v);
  const double scale = start_radius > 0.0 ? 1.0 + (end_radius / start_radius - 1.0) * fraction : 1.0;
  const double cosine = std::cos(motion.sweep * fraction) * scale;
  const double sine = std::sin(motion.sweep * fraction) * scale;
  position[u] = motion.centre[0] + cosine * start_u - sine * start_v;
  position[v] = motion.centre[1] + sine * start_u + cosine * start_v;
  return position;
}

AxisValues WordFrame::incrementWordsOf(const AxisValues& displacement, int axes) const {
  AxisValues words = displacement;
  rotate(*this, words, -sine);
  for (int i = 0; i < axes; ++i) words[at(i)] /= factor[at(i)];
  return words;
}

AxisValues WordFrame::wordsOf(const AxisValues& position, int axes) const {
  AxisValues moved = position;
  for (int i = 0; i < axes; ++i) moved[at(i)] -= shift[at(i)];
  return incrementWordsOf(moved, axes);
}

AxisValues WordFrame::displacementOf(const AxisValues& words, int axes) const {
  AxisValues displacement = words;
  for (int i = 0; i < axes; ++i) displacement[at(i)] *= factor[at(i)];
  rotate(*this, displacement, sine);
  return displacement;
}

AxisValues WordFrame::positionOf(const AxisValues& words, int axes) const {
  AxisValues position = displacementOf(words, axes);
  for (int i = 0; i < axes; ++i) position[at(i)] += shift[at(i)];
  return position;
}

}  // namespace nineline::nc
