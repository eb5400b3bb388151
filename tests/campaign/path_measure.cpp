#include "tests/campaign/path_measure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/text.h"

namespace nineline::campaign {

namespace {

constexpr double kLever = 100.0;            // mm: a turn counts as the arc at this radius
constexpr double kSampleDistance = 0.7;     // mm
constexpr double kLargestCorrection = 0.2;  // mm
constexpr double kSamePlace = 0.03;         // mm: what corrections of neighbouring places differ by
constexpr int kPlaySteps = 64;              // between two samples, for reversals inside arcs

double jointDistance(const PlainPhysics& physics, const Positions& a, const Positions& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < physics.jointCount(); ++i) {
    const double scale = physics.machine().joints[i].rotary ? kLever : 1.0;
    sum += std::pow(scale * (a[i] - b[i]), 2);
  }
  return std::sqrt(sum);
}

double poseDistance(const PlainPose& a, const PlainPose& b) {
  return std::sqrt((a.tip - b.tip).squaredNorm() + kLever * kLever * (a.axis - b.axis).squaredNorm());
}

/// The name by which a line is found again: its N word, or its comment (B…).
std::string tagOf(std::string_view line) {
  if (line.starts_with('N')) return std::string(line.substr(0, line.find(' ')));
  const std::size_t place = line.rfind("(B");
  return place == std::string_view::npos ? std::string() : std::string(line.substr(place));
}

/// Line numbers of the original for each line of the corrected text: of the last tagged line at or above it.
std::vector<std::size_t> originalLines(const std::string& original, const std::string& corrected) {
  std::map<std::string, std::size_t> places;
  std::size_t number = 0;
  for (const std::string_view line : split(original, '\n')) {
    ++number;
    if (const std::string tag = tagOf(line); !tag.empty()) places[tag] = number;
  }
  std::vector<std::size_t> lines{0};
  for (const std::string_view line : split(corrected, '\n')) {
    const auto found = places.find(tagOf(line));
    lines.push_back(found == places.end() ? lines.back() : found->second);
  }
  return lines;
}

/// Walks along commands: the machine's dead bands and what the tool does.
class Walk {
 public:
  Walk(const PlainPhysics& physics, const Positions& start) : physics_(physics), play_(physics), at_(start) {}

  void go(const PlainMotion& motion, double from, double to) {
    for (int i = 1; i <= kPlaySteps; ++i) {
      const Positions next = motion.at(from + (to - from) * i / kPlaySteps, physics_.jointCount());
      play_.move(at_, next);
      at_ = next;
    }
  }
  [[nodiscard]] PlainPose pose() const { return physics_.actual(at_, play_.offsets()); }
  [[nodiscard]] const Positions& at() const { return at_; }
  [[nodiscard]] const Positions& play() const { return play_.offsets(); }

 private:
  const PlainPhysics& physics_;
  PlainPlay play_;
  Positions at_;
};

double lengthOf(const PlainPhysics& physics, const PlainMotion& motion, double from, double to) {
  double length = 0.0;
  Vector3d last = physics.ideal(motion.at(from, physics.jointCount())).tip;
  for (int i = 1; i <= 24; ++i) {
    const Vector3d next = physics.ideal(motion.at(from + (to - from) * i / 24.0, physics.jointCount())).tip;
    length += (next - last).norm();
    last = next;
  }
  return length;
}

/// Which part of an original motion a place of the corrected path stands for: nearest in tip and axis, from
/// `low` on.
double fractionOf(const PlainPhysics& physics, const PlainMotion& motion, const Walk& walk, double low) {
  constexpr int kGrid = 200;
  double best = low;
  double least = 1e300;
  for (int i = 0; i <= kGrid; ++i) {
    const double u = low + (1.0 - low) * i / kGrid;
    const double d = jointDistance(physics, motion.at(u, physics.jointCount()), walk.at());
    if (d < least - 1e-9) best = u;
    least = std::min(least, d);
  }
  // The grid compares commands; a correction lies between them and the tool.
  const double slack = 2.0 * (1.0 - low) / kGrid + kLargestCorrection / lengthOf(physics, motion, 0.0, 1.0);
  double a = std::max(low, best - slack);
  double b = std::min(1.0, best + slack);
  const PlainPose pose = walk.pose();
  const auto cost = [&](double u) {
    const Positions q = motion.at(u, physics.jointCount());
    return poseDistance(physics.ideal(q), pose) + 1e-5 * jointDistance(physics, q, walk.at());
  };
  for (int i = 0; i < 45; ++i) {
    const double left = a + 0.382 * (b - a);
    const double right = a + 0.618 * (b - a);
    if (cost(left) < cost(right)) {
      b = right;
    } else {
      a = left;
    }
  }
  return 0.5 * (a + b);
}

class Measure {
 public:
  Measure(const PlainPhysics& physics, const Positions& start)
      : physics_(physics), before_(physics, start), after_(physics, start) {}

  void original(const PlainMotion& motion, PathFigures& figures) {
    const double length = lengthOf(physics_, motion, 0.0, 1.0);
    const int samples = std::clamp(static_cast<int>(length / kSampleDistance), 2, 400);
    for (int i = 0; i < samples; ++i) {
      const double to = (i + 1.0) / samples;
      before_.go(motion, static_cast<double>(i) / samples, to);
      add(motion, to, length / samples, before_, i % 8 == 0 ? 8 : 0, figures);
    }
  }

  /// The pieces that stand for `motion`, the last of which ends at its end.
  void corrected(const PlainMotion& motion, const PlainMotion* first, const PlainMotion* last,
                 PathFigures& figures) {
    const bool rapid = motion.motion.kind == nc::MotionKind::Rapid;
    double low = 0.0;
    for (const PlainMotion* piece = first; piece != last; ++piece) {
      double high = 1.0;
      if (piece + 1 != last && !rapid) {
        Walk ahead = after_;
        ahead.go(*piece, 0.0, 1.0);
        high = fractionOf(physics_, motion, ahead, low);
      }
      const double length = lengthOf(physics_, motion, low, high);
      const int samples = std::clamp(static_cast<int>(length / kSampleDistance), 2, 400);
      for (int i = 0; i < samples; ++i) {
        const double to = (i + 1.0) / samples;
        after_.go(*piece, static_cast<double>(i) / samples, to);
        if (!rapid) add(motion, low + (high - low) * to, length / samples, after_, 0, figures);
      }
      low = high;
    }
  }

  void rapid(const PlainMotion& motion) { before_.go(motion, 0.0, 1.0); }

 private:
  /// `stands_for`: above 0, what cannot be removed is found too, on behalf of so many samples.
  void add(const PlainMotion& motion, double u, double length, const Walk& walk, int stands_for,
           PathFigures& figures) {
    const Positions q = motion.at(u, physics_.jointCount());
    const PlainPose ideal = physics_.ideal(q);
    const PlainPose actual = walk.pose();
    const double weight = std::max(length, 1e-6);
    const double deviation = (actual.tip - ideal.tip).norm();
    figures.length += weight;
    figures.square += weight * deviation * deviation;
    figures.tilt_square += weight * (actual.axis - ideal.axis).squaredNorm();
    if (deviation > figures.largest) figures.largest_line = motion.line;
    figures.largest = std::max(figures.largest, deviation);
    if (stands_for == 0) return;
    const double lever = physics_.machine().structure == Structure::Trunnion ? kLever : 0.0;
    const PlainPose best = physics_.best(walk.at(), walk.play(), ideal, lever);
    figures.rest_square += stands_for * weight * (best.tip - ideal.tip).squaredNorm();
    figures.rest_tilt_square += stands_for * weight * (best.axis - ideal.axis).squaredNorm();
  }

  const PlainPhysics& physics_;
  Walk before_;
  Walk after_;
};

/// One past the last of the corrected motions that stand for `motion`, from `first` on: the last one that
/// ends about where it ends, before the line of the motion after the next.
std::size_t endOfPieces(const PlainPhysics& physics, const PlainMotion& motion, std::size_t next_line,
                        const std::vector<PlainMotion>& corrected, std::size_t first) {
  const Positions end = motion.at(1.0, physics.jointCount());
  double least = 1e300;
  std::size_t found = first;
  for (std::size_t i = first; i < corrected.size() && (next_line == 0 || corrected[i].line < next_line);
       ++i) {
    const double d = jointDistance(physics, corrected[i].at(1.0, physics.jointCount()), end);
    if (d > least + kSamePlace) continue;
    least = std::min(least, d);
    found = i + 1;
  }
  return least < 1.0 ? found : first;
}

}  // namespace

double PathFigures::rms() const { return length > 0.0 ? std::sqrt(square / length) : 0.0; }
double PathFigures::tilt() const { return length > 0.0 ? std::sqrt(tilt_square / length) : 0.0; }

void PathFigures::add(const PathFigures& other) {
  length += other.length;
  square += other.square;
  tilt_square += other.tilt_square;
  rest_square += other.rest_square;
  rest_tilt_square += other.rest_tilt_square;
  largest = std::max(largest, other.largest);
}

Positions PlainMotion::at(double fraction, std::size_t joints) const {
  Positions q{};
  for (std::size_t i = 0; i < joints; ++i)
    q[i] = motion.start[i] + fraction * (motion.end[i] - motion.start[i]);
  if (motion.kind != nc::MotionKind::Arc) return q;
  const auto a = static_cast<std::size_t>(motion.plane[0]);
  const auto b = static_cast<std::size_t>(motion.plane[1]);
  const double from_a = motion.start[a] - motion.centre[0];
  const double from_b = motion.start[b] - motion.centre[1];
  const double to_radius = std::hypot(motion.end[a] - motion.centre[0], motion.end[b] - motion.centre[1]);
  const double radius = std::hypot(from_a, from_b) * (1.0 - fraction) + to_radius * fraction;
  const double angle = std::atan2(from_b, from_a) + fraction * motion.sweep;
  q[a] = motion.centre[0] + radius * std::cos(angle);
  q[b] = motion.centre[1] + radius * std::sin(angle);
  return q;
}

Result<std::vector<PlainMotion>> motionsOf(const std::string& text, const nc::InterpreterOptions& options) {
  nc::MemoryText source("campaign.nc", text);
  nc::Interpreter interpreter(source, options);
  std::vector<PlainMotion> motions;
  for (;;) {
    const Result<const nc::ExecutedBlock*> block = interpreter.next();
    if (!block) return block.error();
    if (*block == nullptr) break;
    for (const nc::Motion& motion : (*block)->motions) motions.push_back({(*block)->block->line, motion});
  }
  if (interpreter.diagnostics().hasErrors()) return interpreter.diagnostics().firstError("campaign.nc");
  return motions;
}

PathComparison comparePaths(const PlainPhysics& physics, const std::string& original_text,
                            const std::vector<PlainMotion>& original, const std::string& corrected_text,
                            const std::vector<PlainMotion>& corrected_motions, const Positions& start) {
  PathComparison comparison;
  const std::vector<std::size_t> lines = originalLines(original_text, corrected_text);
  std::vector<PlainMotion> corrected = corrected_motions;
  for (PlainMotion& motion : corrected) motion.line = lines.at(motion.line);
  Measure measure(physics, start);
  std::size_t place = 0;
  for (std::size_t i = 0; i < original.size(); ++i) {
    const PlainMotion& motion = original[i];
    const std::size_t next_line = i + 1 < original.size() ? original[i + 1].line : 0;
    const std::size_t end = endOfPieces(physics, motion, next_line, corrected, place);
    if (end == place) {
      comparison.fault = fmt::format("line {}: no corrected motion ends where this one ends", motion.line);
      return comparison;
    }
    if (motion.motion.kind == nc::MotionKind::Rapid) {
      measure.rapid(motion);
    } else {
      measure.original(motion, comparison.before);
    }
    measure.corrected(motion, corrected.data() + place, corrected.data() + end, comparison.after);
    place = end;
  }
  if (place != corrected.size()) comparison.fault = "the corrected program goes on after the original's end";
  return comparison;
}

}  // namespace nineline::campaign
