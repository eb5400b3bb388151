#include "core/smoothing/tool_path.h"

#include <algorithm>
#include <set>

#include "core/kinematics/chain.h"

namespace nineline::smoothing {

namespace {

constexpr double kStandstill = 1e-9;  // mm or rad
constexpr double kLeastChord = 1e-6;  // mm

bool isBlank(std::string_view text) { return text.find_first_not_of(" \t") == std::string_view::npos; }

/// True when the block says nothing but N, G1, F and plain axis words.
bool isPlain(const nc::Block& block, const nc::AxisLayout& axes) {
  std::size_t at = 0;
  for (const nc::Word& word : block.words) {
    if (word.expression || word.mode != nc::WordMode::Modal || word.begin < at) return false;
    if (!isBlank(block.text.substr(at, word.begin - at))) return false;
    at = word.end;
    const bool is_code = word.letter == 'G' && word.value == 1.0;
    const bool is_axis = word.letter != 0 && axes.find({word.letter, word.digit}) >= 0;
    if (!is_code && !is_axis && word.letter != 'N' && word.letter != 'F') return false;
  }
  return isBlank(block.text.substr(at));
}

bool isSmoothable(const nc::ExecutedBlock& executed, const nc::AxisLayout& axes) {
  if (executed.motions.size() != 1 || !executed.rewritable || executed.repeated || executed.depth != 0)
    return false;
  const nc::Motion& motion = executed.motions.front();
  return motion.kind == nc::MotionKind::Linear && motion.role == nc::MotionRole::Block &&
         motion.feed_mode == nc::FeedMode::PerMinute && motion.cutter_compensation == 0 &&
         executed.frame->incremental == 0 && !executed.block->skipped &&
         !executed.block->text.starts_with('/') && isPlain(*executed.block, axes);
}

/// Gathers motions into sections.
class SectionReader {
 public:
  SectionReader(const Machine& machine, const nc::AxisLayout& axes) : machine_(machine), axes_(axes) {}

  void take(const nc::ExecutedBlock& executed) {
    if (executed.repeated) repeated_.insert(executed.block->line);
    for (const nc::Motion& motion : executed.motions) {
      if (motion.kind == nc::MotionKind::Linear && motion.role == nc::MotionRole::Block) ++motions_;
    }
    if (!isSmoothable(executed, axes_)) {
      close();
    } else {
      append(executed);
    }
    if (!executed.motions.empty()) established_ = executed.motions.back().established;
  }

  ToolPath finish() {
    close();
    ToolPath path;
    path.motions = motions_;
    for (PathSection& section : sections_) {
      const auto again = repeated_.lower_bound(section.first_line);
      if (again != repeated_.end() && *again <= section.last_line) {
        path.diagnostics.warning("smoothing.repeated",
                                 "These lines are executed more than once; they stay as programmed.",
                                 section.first_line);
        continue;
      }
      path.sections.push_back(std::move(section));
    }
    return path;
  }

 private:
  void append(const nc::ExecutedBlock& executed) {
    const nc::Motion& motion = executed.motions.front();
    const nc::AxisMask moves = movingAxes(motion);
    if (!section_.points.empty() &&
        (motion.line != section_.last_line + 1 || motion.tool_centre_point != section_.tool_centre_point)) {
      close();
    }
    if ((moves & static_cast<nc::AxisMask>(~established_)) != 0) return close();
    if (section_.points.empty()) open(executed);
    const Vector3d tip = tipOf(machine_, motion.end, motion.tool_centre_point);
    if (moves != 0 && (tip - section_.points.back().tip).norm() < kLeastChord) return close();
    if (const nc::Word* feed = executed.block->find('F')) feed_ = feed->value;
    section_.last_line = motion.line;
    if (moves == 0) return;  // a point said twice goes with the next one
    section_.moving = static_cast<nc::AxisMask>(section_.moving | moves);
    section_.points.push_back({motion.end, tip, motion.line, feed_});
  }

  [[nodiscard]] nc::AxisMask movingAxes(const nc::Motion& motion) const {
    nc::AxisMask moves = 0;
    for (int i = 0; i < axes_.count; ++i) {
      const auto k = static_cast<std::size_t>(i);
      if (std::abs(motion.end[k] - motion.start[k]) > kStandstill)
        moves = static_cast<nc::AxisMask>(moves | nc::axisBit(i));
    }
    return moves;
  }

  void open(const nc::ExecutedBlock& executed) {
    const nc::Motion& motion = executed.motions.front();
    section_ = {};
    feed_.reset();
    section_.first_line = motion.line;
    section_.tool_centre_point = motion.tool_centre_point;
    section_.frame = *executed.frame;
    section_.line_end = executed.block->line_end.empty() ? "\n" : std::string(executed.block->line_end);
    if (const nc::Word* label = executed.block->find('N'))
      section_.label = executed.block->text.substr(label->begin, label->end - label->begin);
    section_.points.push_back(
        {motion.start, tipOf(machine_, motion.start, motion.tool_centre_point), 0, std::nullopt});
  }

  void close() {
    if (section_.points.size() > 1) {
      section_.last_line = section_.points.back().line;
      sections_.push_back(std::move(section_));
    }
    section_ = {};
  }

  const Machine& machine_;
  const nc::AxisLayout& axes_;
  PathSection section_;
  std::optional<double> feed_;
  nc::AxisMask established_ = 0;
  std::vector<PathSection> sections_;
  std::set<std::size_t> repeated_;
  std::size_t motions_ = 0;
};

}  // namespace

Vector3d tipOf(const Machine& machine, const nc::AxisValues& values, bool tool_centre_point) {
  if (!tool_centre_point) return forward(machine, values).tip;
  Vector3d tip = Vector3d::Zero();
  for (int i = 0; i < machine.jointCount(); ++i) {
    const AxisId& axis = machine.joint(i).axis;
    if (!machine.isRotary(i) && axis.digit == 0 && axis.letter >= 'X' && axis.letter <= 'Z')
      tip[axis.letter - 'X'] = values[static_cast<std::size_t>(i)];
  }
  return tip;
}

Result<ToolPath> readToolPath(const Machine& machine, nc::TextSource& program,
                              const nc::InterpreterOptions& options) {
  nc::Interpreter interpreter(program, options);
  SectionReader reader(machine, options.axes);
  while (true) {
    const Result<const nc::ExecutedBlock*> block = interpreter.next();
    if (!block) return block.error();
    if (*block == nullptr) break;
    reader.take(**block);
  }
  ToolPath path = reader.finish();
  path.dialect = interpreter.dialect();
  Diagnostics all = interpreter.diagnostics();
  all.append(path.diagnostics);
  path.diagnostics = std::move(all);
  return path;
}

}  // namespace nineline::smoothing
