#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/nc/code_table.h"
#include "core/nc/fault.h"
#include "core/nc/interpreter.h"
#include "core/nc/jump.h"
#include "core/nc/parameters.h"
#include "core/nc/statement.h"

namespace nineline::nc {

constexpr std::size_t index(int axis) { return static_cast<std::size_t>(axis); }
constexpr std::size_t letterIndex(char letter) { return static_cast<std::size_t>(letter - 'A'); }
constexpr std::uint32_t letterBit(char letter) { return 1U << letterIndex(letter); }

/// What stays in force from block to block.
struct ModalState {
  int motion = 0;   ///< 0, 1, 2, 3, 32, 33, 34; −1: cancelled (LinuxCNC's G80)
  int cycle = 0;    ///< 73…89 while a canned cycle is active, else 0
  int turning = 0;  ///< tenths of G90, G92, G94 while one of them is the turning cycle in force, else 0
  int plane = 17;
  bool inch = false;
  bool incremental = false;
  bool arc_absolute = false;
  bool diameter = false;         ///< LinuxCNC G7
  bool return_to_plane = false;  ///< G99
  bool tip_control = false;
  bool surface_speed = false;
  std::int8_t cutter = 0;
  FeedMode feed_mode = FeedMode::PerMinute;
  double feed_word = 0.0;     ///< as written
  double feed_unit = 1.0;     ///< mm for one unit of it when it was stated
  double spindle_word = 0.0;  ///< rev/min
};

/// Offsets of the control: mm and rad in layout order.
struct Offsets {
  std::vector<AxisValues> work;       ///< G54 is 0; LinuxCNC G59.3 is 8; extended P1 is 100
  std::vector<double> work_rotation;  ///< LinuxCNC: rad about the work offset
  int active = 0;                     ///< −1: none (G500)
  AxisValues external{};
  AxisValues local{};                       ///< G52
  AxisValues position{};                    ///< G92
  AxisValues suspended{};                   ///< kept by G92.2 for G92.3
  AxisValues tool{};                        ///< length offset in force
  std::map<int, AxisValues> tools;          ///< by H number (LinuxCNC: tool number)
  bool rotated = false;                     ///< G68
  double rotation = 0.0;                    ///< rad
  std::array<double, 2> rotation_centre{};  ///< words, mm
  int rotation_plane = 17;
};

/// Values of a canned cycle that stay until it is cancelled: mm, program coordinates as written.
struct CycleWords {
  std::optional<double> r, depth, peck, dwell;
  double taper = 0.0;    ///< R of a turning cycle, mm
  AxisValues target{};   ///< end of the turning cycle before, in machine coordinates
  double initial = 0.0;  ///< machine position of the drilling axis when the cycle began
};

/// The words of one block by meaning.
struct BlockWords {
  AxisMask axes = 0;        ///< named
  AxisMask plain = 0;       ///< of these, by a plain number
  AxisMask increments = 0;  ///< by U W or IC( )
  AxisMask absolutes = 0;   ///< by AC( ), DC( )
  AxisMask shortest = 0;    ///< by DC( )
  std::uint32_t letters = 0;
  std::uint32_t absolute_centre = 0;  ///< I J K written as AC( )
  std::uint32_t groups = 0;           ///< modal groups named
  CodeAction non_modal = CodeAction::Unknown;
  int non_modal_code = 0;
  CodeAction motion_action = CodeAction::Unknown;  ///< of a motion code that stands in the block
  int motion_tenths = 0;
  bool machine_coordinates = false;
  bool unknown_code = false;
  int unknown_tenths = 0;
  bool cancels_cycle = false;
  bool m_codes = false;
  CodeAction length_action = CodeAction::Unknown;
  AxisValues value;
  std::array<double, 26> letter;

  [[nodiscard]] bool has(char name) const { return (letters & letterBit(name)) != 0; }
  [[nodiscard]] double of(char name) const { return letter[letterIndex(name)]; }
  [[nodiscard]] double of(char name, double otherwise) const { return has(name) ? of(name) : otherwise; }
};

/// Everything that execution knows. The functions on it are spread over files by subject; each returns false
/// after `fail`.
struct Execution {
  Execution(TextSource& text, InterpreterOptions given);
  ~Execution();

  TextSource& source;
  InterpreterOptions options;
  Dialect dialect = Dialect::Fanuc;
  DialectSigns signs;
  bool lathe = false;  ///< no Y axis
  bool turning_codes =
      false;  ///< Fanuc lathe G code system A: G90 G92 G94 cycles, U W increments, G98 G99 feed
  Diagnostics diagnostics;
  std::optional<Error> failure;
  bool ended = false;

  // the text
  std::uint64_t offset = 0;
  std::uint64_t line_offset = 0;  ///< of the line being executed
  std::size_t line = 0;           ///< its number
  std::size_t highest_line = 0;
  bool entered_branch = false;  ///< the line was reached by skipping a false IF
  bool skip_line = false;       ///< the line ends what was skipped; it is not executed
  Block block;
  Statement statement;
  std::vector<CallLevel> calls;
  std::vector<LoopLevel> loops;
  Jump jump;
  std::size_t jumps = 0;
  std::map<long, std::pair<std::uint64_t, std::size_t>> programs;  ///< O number → place of its line
  std::map<std::string, std::pair<std::uint64_t, std::size_t>> named_programs;
  bool indexed = false;
  std::size_t program_words = 0;

  bool supa = false;  ///< Siemens SUPA stands in the block
  bool gather_keywords = false;

  // the machine
  const CodeTable* codes = nullptr;
  std::array<std::int8_t, 26> axis_of_letter{};
  std::array<std::int8_t, 26> increment_of_letter{};  ///< U W V H on lathes
  AxisMask rotary = 0;
  AxisMask digit_axes = 0;
  AxisValues position{};
  AxisMask established = 0;
  ModalState modal;
  Offsets offsets;
  CycleWords cycle;
  int selected_tool = 0;
  int current_tool = 0;
  std::unique_ptr<SystemVariables> system;
  std::unique_ptr<Parameters> parameters;
  std::array<std::uint64_t, 16> warned_codes{};

  // the block
  BlockWords words;
  WordFrame frame;        ///< of the modal state
  WordFrame block_frame;  ///< of this block, where it differs
  bool frame_stale = true;
  std::vector<Motion> motions;
  Motion single;
  ExecutedBlock executed;
};

bool fail(Execution& e, const char* code, std::uint32_t column, std::string text);
/// The fault of the word with this letter.
bool failAt(Execution& e, const char* code, char letter, std::string text);
void warnOnce(Execution& e, const char* code, const std::string& text);

// execution.cpp
void setUpAxes(Execution& e);
// block_words.cpp: gathers words, applies modal codes
bool gatherWords(Execution& e);
// modal_codes.cpp
bool executeCode(Execution& e, const Word& word);
// frame.cpp
void refreshFrame(Execution& e);
// motions.cpp
bool executeMotion(Execution& e);
void beginMotion(Execution& e, Motion& motion, MotionKind kind, MotionRole role);
/// The end point that the block's axis words state.
AxisValues endOfWords(Execution& e, const WordFrame& frame);
void finishFeed(Execution& e, Motion& motion);
/// Appends a straight motion to `position` of a cycle or reference return and moves there.
void appendStraight(Execution& e, MotionKind kind, MotionRole role, const AxisValues& end);
std::array<int, 3> planeAxes(const Execution& e);  ///< first, second, normal; −1 where the machine lacks one
// arcs.cpp
bool executeArc(Execution& e, const WordFrame& frame);
// threads.cpp
bool executeThread(Execution& e, const WordFrame& frame);
bool executeRigidTap(Execution& e, const WordFrame& frame);
bool executeThread76(Execution& e);
bool executeTurningCycle(Execution& e, int code);
// cycles.cpp
bool executeCycle(Execution& e);
// offsets.cpp
bool executeData(Execution& e);
bool setPosition(Execution& e);
bool setLocalOffset(Execution& e);
bool selectWorkOffset(Execution& e, int tenths);
bool selectExtendedOffset(Execution& e);
bool rotateFrame(Execution& e);
void loadOffsets(Execution& e);
// tools.cpp
bool applyToolLength(Execution& e, CodeAction action);
void changeTool(Execution& e);
// reference.cpp
bool executeReferenceReturn(Execution& e);
// flow.cpp
bool executeFlow(Execution& e);
bool executeStopCodes(Execution& e);
bool followJump(Execution& e);
bool atEndOfText(Execution& e);
/// M30 and the like: ends execution. A loop that is left so may stand open; one that nothing closes is a
/// fault.
bool endProgram(Execution& e);
bool returnFromCall(Execution& e);

}  // namespace nineline::nc
