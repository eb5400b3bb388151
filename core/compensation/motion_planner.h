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
  bool closes = false;   ///< keeps the way from start to end that the program states (whole turns)
  bool arc = false;      ///< circle about `centre` in the motion's plane; otherwise a line
  std::array<double, 2> centre{};
  double sweep = 0.0;  ///< rad
};

/// Replaces motions of the ideal program by corrected ones, one after the other.
class MotionPlanner {
 public:
  MotionPlanner(const ErrorModel& model, const ProgramSetup& setup, const CompensationOptions& options);

  /// What the words of a block allow.
  struct Scope {
    unsigned free = 0;       ///< joints whose words may be written
    unsigned held = 0;       ///< joints that stay where the corrected program stands, none of them free
    bool may_split = false;  ///< several pieces are possible
    nc::AxisValues grid{};   ///< a position that the words of rotary axes can state, rad
  };
  /// Corrected pieces of a motion, in order; the last ends at fraction 1. `from`: where the corrected program
  /// stands before. Fails as PointSolver does, and beyond the correction limits.
  [[nodiscard]] Result<void> plan(const nc::Motion& motion, const Scope& scope, const nc::AxisValues& from,
                                  std::vector<Piece>& pieces);
  /// The last pieces were not written as planned: the next motion starts where the words left the machine.
  void forget() { last_.reset(); }

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
  /// `corrected` is where the joints have to stand: their play taken out, where it is known.
  struct Node {
    double fraction = 0.0;
    JointPositions ideal{};
    JointPositions corrected{};
  };
  [[nodiscard]] Result<Node> solveAt(const nc::Motion& motion, double fraction);
  [[nodiscard]] Result<void> checkLimits(const Node& node, const nc::Motion& motion) const;
  [[nodiscard]] std::optional<double> advanceAt(const nc::Motion& motion, double fraction) const;
  void updateSenses(const nc::Motion& motion, double from, double to);
  [[nodiscard]] JointPositions travelSinceReversal(const JointPositions& ideal) const;
  [[nodiscard]] bool isFree(std::size_t joint) const { return (free_ >> joint & 1U) != 0; }
  [[nodiscard]] double offsetOf(std::size_t joint) const { return 0.5 * now_[joint] * play_[joint]; }

  // piece_emission.cpp: from where the joints have to stand to what is commanded
  [[nodiscard]] Result<void> startFrom(const nc::Motion& motion, const nc::AxisValues& at);
  void emit(const nc::Motion& motion, const Node& b, Piece piece, std::vector<Piece>& pieces);
  void closeTurn(const nc::Motion& motion, const Piece& piece, const JointPositions& from, JointPositions& q);
  void followRotaryWords(const Node& b, JointPositions& places);
  [[nodiscard]] bool holds(std::size_t joint, double travel) const;
  [[nodiscard]] bool turnsBack(std::size_t joint, double travel) const;
  [[nodiscard]] bool command(const JointPositions& places, JointPositions& q, JointPositions& crossing);
  void setHolding(const nc::Motion& motion);

  [[nodiscard]] Result<void> refine(const nc::Motion& motion, const Node& a, const Node& b, int depth,
                                    std::vector<Piece>& pieces);
  [[nodiscard]] Result<bool> lineFits(const nc::Motion& motion, const Node& a, const Node& b);
  [[nodiscard]] Result<bool> arcFits(const nc::Motion& motion, const Node& a, const Node& b, Piece& piece);
  [[nodiscard]] Result<void> planSection(const nc::Motion& motion, double from, double to,
                                         std::vector<Piece>& pieces);
  [[nodiscard]] int innerSamples(const nc::Motion& motion, const Node& a, const Node& b) const;
  [[nodiscard]] bool isSmooth(const nc::Motion& motion, const Node& a, const Node& b) const;
  [[nodiscard]] double distance(const JointPositions& a, const JointPositions& b, double& tilt);

  const ErrorModel& model_;
  const kinematics::Machine& machine_;
  CompensationOptions options_;
  PointSolver solver_;
  JointPositions correction_{};  // of the last point: the next one starts from it
  JointPositions largest_{};
  Senses senses_{};            // in which the ideal motion moves the joints
  Senses now_{};               // in which the corrected commands moved last; 0: not yet
  JointPositions turned_{};    // travel since the last reversal at the start of the section
  JointPositions section_{};   // ideal positions there
  JointPositions stands_{};    // where the joints have to stand at the end of the last piece
  JointPositions followed_{};  // of that, what makes up for the rounding of rotary words
  JointPositions held_{};      // the commands there, before rounding
  JointPositions play_{};      // signed width of each joint's play: actual − command = −(play/2) · sense
  JointPositions holding_{};   // a joint with play turns back only for more than this, mm or rad
  bool has_play_ = false;
  bool follows_sense_ = false;          // some error differs by the sense of a joint
  double rotary_step_ = 0.0;            // least increment of rotary words, rad
  std::optional<JointPositions> last_;  // ideal end of the last motion
  Scope scope_;
  unsigned free_ = 0;
  bool exceeded_ = false;
};

}  // namespace nineline::compensation
