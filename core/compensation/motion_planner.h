#pragma once

#include "core/compensation/point_solver.h"
#include "core/nc/motion.h"

namespace nineline::compensation {

/// One motion of the corrected program: where it ends, and which part of the original motion it replaces.
struct Piece {
  nc::AxisValues end{};  ///< corrected end, machine coordinates as nc::Motion has them, not yet rounded
  double from = 0.0;     ///< fractions of the original motion
  double to = 1.0;
  bool take_up = false;  ///< crosses the play of a joint that reverses; from = to
  bool arc = false;      ///< circle about `centre` in the motion's plane; otherwise a line
  std::array<double, 2> centre{};
  double sweep = 0.0;  ///< rad
};

/// Replaces motions of the ideal program by corrected ones, one after the other.
class MotionPlanner {
 public:
  MotionPlanner(const ErrorModel& model, const ProgramSetup& setup, const CompensationOptions& options);

  /// Corrected pieces of a motion, in order; the last ends at fraction 1. `free`: joints whose words may be
  /// written. `from`: where the corrected program stands before. `may_split`: several pieces are possible.
  /// Fails as PointSolver does, and beyond the correction limits.
  [[nodiscard]] Result<void> plan(const nc::Motion& motion, unsigned free, const nc::AxisValues& from,
                                  bool may_split, std::vector<Piece>& pieces);

  /// Least increments of the words, mm and rad: below half of one nothing is subdivided, rounding would undo
  /// it.
  void setResolution(double linear, double rotary);

  /// A motion that stays as it is (a reference return, a cycle): takes note of the senses of the joints.
  void pass(const nc::Motion& motion);

  /// Of the last motion's `free` joints those that the mode lets move.
  [[nodiscard]] nc::AxisMask freeAxes() const { return static_cast<nc::AxisMask>(free_); }
  /// Whether a block could not be brought within the tolerance (keep_block_count, or arcs below a degree).
  [[nodiscard]] bool exceeded() const { return exceeded_; }
  /// Largest correction of each joint so far, mm or rad.
  [[nodiscard]] const JointPositions& largestCorrections() const { return largest_; }

 private:
  using Senses = std::array<std::int8_t, kMaxAxes>;
  struct Node {
    double fraction = 0.0;
    JointPositions ideal{};
    JointPositions corrected{};
  };
  [[nodiscard]] Result<Node> solveAt(const nc::Motion& motion, double fraction);
  [[nodiscard]] Result<void> checkLimits(const Node& node, const nc::Motion& motion) const;
  [[nodiscard]] std::optional<double> advanceAt(const nc::Motion& motion, double fraction) const;
  void updateSenses(const nc::Motion& motion, double from, double to);
  /// Appends a piece that ends at node b. A joint with play that rests in the ideal motion is moved by its
  /// correction alone: where that turns back by more than the tolerance, the play is crossed first; where by
  /// less, it waits.
  void emit(const nc::Motion& motion, const Node& b, Piece piece, std::vector<Piece>& pieces);
  [[nodiscard]] bool reverses(const Senses& before) const;
  [[nodiscard]] bool needsTakeUp(const nc::Motion& motion, const Senses& before) const;
  [[nodiscard]] Result<void> refine(const nc::Motion& motion, const Node& a, const Node& b, int depth,
                                    std::vector<Piece>& pieces);
  [[nodiscard]] Result<bool> lineFits(const nc::Motion& motion, const Node& a, const Node& b);
  [[nodiscard]] Result<bool> arcFits(const nc::Motion& motion, const Node& a, const Node& b, Piece& piece);
  [[nodiscard]] Result<Node> sectionStart(const nc::Motion& motion, double from, bool first,
                                          const nc::AxisValues& at, const Senses& before);
  [[nodiscard]] Result<void> planSection(const nc::Motion& motion, double from, double to, bool first,
                                         const nc::AxisValues& at, std::vector<Piece>& pieces);
  [[nodiscard]] int innerSamples(const nc::Motion& motion, const Node& a, const Node& b) const;
  [[nodiscard]] bool isSmooth(const nc::Motion& motion, const Node& a, const Node& b) const;
  [[nodiscard]] double distance(const JointPositions& a, const JointPositions& b, double& tilt);

  const ErrorModel& model_;
  const kinematics::Machine& machine_;
  CompensationOptions options_;
  PointSolver solver_;
  Senses senses_{};
  JointPositions correction_{};  // of the last point: the next one starts from it
  JointPositions largest_{};
  Senses now_{};           // senses in which the corrected commands moved last
  JointPositions held_{};  // corrected commands at the end of the last piece, before rounding
  JointPositions play_{};  // signed width of each joint's play: actual − command = −(play/2) · sense
  std::array<bool, kMaxAxes> resting_{};  // joints that the ideal motion at hand does not move
  std::optional<Node> last_;              // where the last motion ended, before rounding
  unsigned free_ = 0;
  bool may_split_ = true;
  bool exceeded_ = false;
};

}  // namespace nineline::compensation
