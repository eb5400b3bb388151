#include "core/identification/knots.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/units.h"

namespace nineline::identification {

using errors::Interpolation;
using estimation::ReadingSet;
using estimation::SamplePlace;

namespace {

constexpr std::size_t kMostTargets = 73;  // more values than this are a path, no targets
constexpr double kSame = 1e-6;            // mm, rad: positions that differ less are one target
constexpr std::array<Index, kKnotLevels> kLinearCounts{4, 6, 9, 13, 19, 27};
constexpr std::array<Index, kKnotLevels> kTurnCounts{6, 8, 12, 16, 24, 36};

std::vector<double> distinct(std::vector<double> positions) {
  std::sort(positions.begin(), positions.end());
  std::vector<double> result;
  for (const double position : positions) {
    if (result.empty() || position - result.back() > kSame) result.push_back(position);
  }
  return result;
}

/// The spacing of equally spaced targets; nothing where they are not.
std::optional<double> spacingOf(const std::vector<double>& targets) {
  if (targets.size() < 3 || targets.size() > kMostTargets) return std::nullopt;
  const double spacing = (targets.back() - targets.front()) / static_cast<double>(targets.size() - 1);
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const double at = targets.front() + spacing * static_cast<double>(i);
    if (std::abs(targets[i] - at) > 1e-3 * spacing) return std::nullopt;
  }
  return spacing;
}

struct Targets {
  double start = 0.0;
  double spacing = 0.0;
  std::size_t count = 0;
};

/// The finest regular targets of the joint's own tests; else of any file.
std::optional<Targets> regularTargets(const ReadingSet& readings, int joint) {
  std::optional<Targets> own;
  std::optional<Targets> other;
  const AxisId axis = readings.machine().joint(joint).axis;
  std::vector<std::vector<double>> positions(readings.files().size());
  for (const SamplePlace& place : readings.samples()) {
    positions[place.file].push_back(readings.state(place).q[static_cast<std::size_t>(joint)]);
  }
  for (std::size_t file = 0; file < positions.size(); ++file) {
    const std::vector<double> targets = distinct(std::move(positions[file]));
    const std::optional<double> spacing = spacingOf(targets);
    if (!spacing) continue;
    std::optional<Targets>& best = readings.files()[file].instrument.axis == axis ? own : other;
    if (!best || targets.size() > best->count) best = Targets{targets.front(), *spacing, targets.size()};
  }
  return own ? own : other;
}

/// True where the positions, taken round the turn, leave no gap above a quarter of it.
bool coversTurn(const JointPositionsSeen& seen) {
  if (seen.high - seen.low < 0.7 * kTurn) return false;
  std::vector<double> turned;
  for (const std::vector<double>& file : seen.by_file) {
    for (const double position : file) turned.push_back(position - kTurn * std::floor(position / kTurn));
  }
  std::sort(turned.begin(), turned.end());
  double gap = turned.front() + kTurn - turned.back();
  for (std::size_t i = 1; i < turned.size(); ++i) gap = std::max(gap, turned[i] - turned[i - 1]);
  return gap < 0.25 * kTurn + kSame;
}

Knots closedKnots(const std::optional<Targets>& targets, Index level_count) {
  Knots knots;
  knots.closed = true;
  knots.count = level_count;
  if (targets) {
    const double count = kTurn / targets->spacing;
    if (std::abs(count - std::round(count)) < 1e-3 && count < static_cast<double>(kMostTargets)) {
      knots.count = static_cast<Index>(std::round(count));
      knots.at_targets = true;
      knots.grid.start = targets->start - kTurn * std::floor(targets->start / kTurn + 1e-9);
    }
  }
  knots.grid.spacing = kTurn / static_cast<double>(knots.count);
  knots.grid.period = kTurn;
  return knots;
}

Knots openKnots(const JointPositionsSeen& seen, const std::optional<Targets>& targets, Index level_count) {
  Knots knots;
  if (targets) {
    const double h = targets->spacing;
    // Readings of other files may lie beyond the targets; half a spacing of theirs gets a value of its own.
    const double before = std::max(0.0, std::floor((targets->start - seen.low) / h + 0.5));
    const double end = targets->start + h * static_cast<double>(targets->count - 1);
    const double after = std::max(0.0, std::floor((seen.high - end) / h + 0.5));
    knots.grid.start = targets->start - h * before;
    knots.grid.spacing = h;
    knots.count = static_cast<Index>(targets->count) + static_cast<Index>(before + after);
    knots.at_targets = true;
    if (knots.count <= static_cast<Index>(2 * kMostTargets)) return knots;
  }
  knots.grid.start = seen.low;
  knots.grid.spacing = (seen.high - seen.low) / static_cast<double>(level_count - 1);
  knots.count = level_count;
  knots.at_targets = false;
  return knots;
}

}  // namespace

JointPositionsSeen positionsSeen(const ReadingSet& readings, int joint) {
  JointPositionsSeen seen;
  std::vector<std::vector<double>> files(readings.files().size());
  for (const SamplePlace& place : readings.samples()) {
    files[place.file].push_back(readings.state(place).q[static_cast<std::size_t>(joint)]);
  }
  bool is_first = true;
  for (std::vector<double>& file : files) {
    std::vector<double> targets = distinct(std::move(file));
    if (targets.size() < 2) continue;
    seen.moves = true;
    seen.low = is_first ? targets.front() : std::min(seen.low, targets.front());
    seen.high = is_first ? targets.back() : std::max(seen.high, targets.back());
    is_first = false;
    seen.by_file.push_back(std::move(targets));
  }
  return seen;
}

std::optional<Knots> chooseKnots(const ReadingSet& readings, int joint, int level,
                                 std::optional<double> spacing) {
  const JointPositionsSeen seen = positionsSeen(readings, joint);
  if (!seen.moves) return std::nullopt;
  std::optional<Targets> targets = regularTargets(readings, joint);
  if (spacing) targets = Targets{seen.low, *spacing, 1};
  const auto step = static_cast<std::size_t>(std::clamp(level, 0, kKnotLevels - 1));
  const bool closed = readings.machine().joint(joint).continuous && coversTurn(seen);
  if (closed) return closedKnots(targets, kTurnCounts[step]);
  return openKnots(seen, targets, kLinearCounts[step]);
}

}  // namespace nineline::identification
