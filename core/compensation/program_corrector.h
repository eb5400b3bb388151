#pragma once

#include "core/compensation/line_assembler.h"
#include "core/compensation/line_editor.h"
#include "core/compensation/piece_log.h"
#include "core/compensation/turning_feed.h"

namespace nineline::compensation {

/// Where the corrected program stands, in exact decimals, so that rounding never accumulates: every increment
/// is taken from here, not from the original program.
class EmittedPosition {
 public:
  explicit EmittedPosition(const nc::AxisLayout& layout, const nc::AxisValues& start)
      : layout_(layout), position_(start) {}

  struct Word {
    int axis = 0;
    double value = 0.0;  ///< rounded
  };

  /// Rounds the words that bring the machine to `target` and goes there. `named`: axes that have a word in
  /// the block; `writable`: axes that may get one. Axes outside both stay. Words come in layout order.
  void moveTo(const nc::WordFrame& frame, const nc::AxisValues& target, nc::AxisMask named,
              nc::AxisMask writable, const std::array<int, kMaxAxes>& decimals, std::vector<Word>& words);
  /// The control moves these axes to a place that the correction does not touch.
  void jumpTo(const nc::AxisValues& target, nc::AxisMask axes);

  [[nodiscard]] const nc::AxisValues& position() const { return position_; }

 private:
  nc::AxisLayout layout_;
  nc::AxisValues position_;
};

/// Corrects a program block by block.
class ProgramCorrector {
 public:
  ProgramCorrector(const ErrorModel& model, const ProgramSetup& setup, const CompensationOptions& options,
                   nc::TextSource& source, const TextSink& sink);
  [[nodiscard]] Result<void> run(Progress& progress);

  [[nodiscard]] const PieceLog& log() const { return log_; }
  [[nodiscard]] CompensationReport takeReport();

 private:
  [[nodiscard]] Result<void> learnStyle();
  [[nodiscard]] Result<void> correct(const nc::ExecutedBlock& executed);
  [[nodiscard]] Result<void> correctMotion(const nc::ExecutedBlock& executed, const nc::Motion& motion);
  [[nodiscard]] Result<void> keep(const nc::ExecutedBlock& executed);
  [[nodiscard]] Result<void> keepAsItIs(const nc::ExecutedBlock& executed);
  [[nodiscard]] bool canCorrectCycle(const nc::ExecutedBlock& executed) const;
  [[nodiscard]] Result<void> correctCycle(const nc::ExecutedBlock& executed);
  [[nodiscard]] Result<void> refuseComputed(const nc::ExecutedBlock& executed) const;
  [[nodiscard]] nc::WordFrame shiftedFrame(const nc::WordFrame& frame) const;
  void followPositionOffsets(const nc::ExecutedBlock& executed);
  [[nodiscard]] nc::AxisMask writableAxes(const nc::ExecutedBlock& executed, const nc::Motion& motion);
  [[nodiscard]] nc::AxisMask linearAxes() const;
  [[nodiscard]] MotionPlanner::Scope scopeOf(bool may_split) const;
  void chooseTurning(const nc::ExecutedBlock& executed, const nc::Motion& motion, bool at_end);
  /// Where linear axes join a turn, F as the line at hand needs it.
  void stateTurningFeed(const nc::Motion& motion, const Piece& piece, const nc::AxisValues& from);
  void putFeedBack(const nc::Block& block, std::string_view line_end);
  void moveBeside(const nc::Motion& motion, const Piece& piece, nc::AxisMask named);
  void warnTurning(std::size_t line);
  [[nodiscard]] int codeOf(const nc::ExecutedBlock& executed, const nc::Motion& motion,
                           const Piece& piece) const;
  void writeOwnLine(const nc::ExecutedBlock& executed, const nc::Motion& motion, const Piece& piece);
  /// False where the words resolve no motion: nothing is written then.
  [[nodiscard]] bool writeInsertedLine(const nc::ExecutedBlock& executed, const nc::Motion& motion,
                                       const Piece& piece, bool before_own);
  void writeAxisWords(const nc::Motion& motion, const Piece& piece, nc::AxisMask named, bool centre_absolute,
                      bool by_radius);
  void writeCentre(const nc::Motion& motion, const Piece& piece, const nc::AxisValues& from,
                   bool centre_absolute, bool by_radius);
  void warnExceeded(std::size_t line);
  void warnOutsideTables(const nc::Motion& motion);

  const ErrorModel& model_;
  const kinematics::Machine& machine_;
  CompensationOptions options_;
  std::optional<nc::Dialect> stated_;  // the control, where the user names it
  nc::TextSource& source_;
  nc::Interpreter interpreter_;
  MotionPlanner planner_;
  LineAssembler assembler_;
  EmittedPosition emitted_;
  nc::AxisValues shift_change_{};  // G92 took the corrected position, so that its offset differs by this
  nc::AxisValues ideal_position_{};
  nc::AxisMask commanded_ = 0;
  double cycle_depth_ = 0.0;     // depth word of the last hole
  double retract_change_ = 0.0;  // by which the R plane of a cycle was moved, mm
  MachineState covered_;         // to ask whether tables cover a position
  std::array<int, kMaxAxes> decimals_{};
  LineEditor editor_;
  std::vector<Piece> pieces_;
  std::vector<Piece> written_;  // those of them that the words resolve
  std::vector<EmittedPosition::Word> words_;
  std::string line_;
  nc::WordFrame frame_;                        // of the block at hand, with the corrected program's offsets
  nc::AxisMask writable_ = 0;                  // axes that may get a word in the block at hand
  TurnWriting turning_ = TurnWriting::NoTurn;  // of the block at hand
  double feed_word_ = 0.0;                     // F of the block at hand, where it turns
  std::optional<double> feed_in_force_;        // while its lines are written
  int active_code_ = -1;                       // modal motion code where the corrected program stands
  bool changed_ = false;                       // the block at hand
  bool own_line_follows_ = false;              // lines were put before the block's own one
  PieceLog log_;
  CompensationReport report_;
  nc::AxisLayout layout_;
};

}  // namespace nineline::compensation
