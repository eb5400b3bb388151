#include "core/postprocessing/nc_output.h"

#include <fmt/format.h>

#include <cmath>

#include "core/base/units.h"
#include "core/postprocessing/control_writer.h"

namespace nineline::postprocessing {

namespace {

const char* nameOf(Control control) {
  switch (control) {
    case Control::Siemens:
      return "Siemens";
    case Control::LinuxCnc:
      return "LinuxCNC";
    case Control::Heidenhain:
      return "Heidenhain";
    default:
      return "Fanuc";
  }
}

class ProgramWriter {
 public:
  ProgramWriter(const Machine& machine, const ClProgram& program, const AxisMoves& moves,
                const NcOptions& options)
      : machine_(machine),
        program_(program),
        moves_(moves),
        options_(options),
        writer_(options.control == Control::Heidenhain ? makeKlartextWriter(machine, options)
                                                       : makeGCodeWriter(machine, options)) {}

  Result<NcText> run() {
    writer_->begin(program_.name);
    for (std::size_t m = 0; m < moves_.moves.size(); ++m) {
      const AxisMove& move = moves_.moves[m];
      if (m == 0 || moves_.moves[m - 1].point != move.point) writeEvents(move.point + 1);
      if (!writeMove(m)) return tooLarge(move);
    }
    writeEvents(program_.points.size() + 1);
    writer_->end();
    out_.text = writer_->take();
    return std::move(out_);
  }

 private:
  /// All events before a point, `end` being the first one that is not yet due.
  void writeEvents(std::size_t end) {
    for (; event_ < program_.events.size() && program_.events[event_].before < end; ++event_) {
      const ClEvent& event = program_.events[event_];
      writer_->event(event);
      if (event.kind != ClEvent::Kind::ToolChange) continue;
      tool_ = static_cast<int>(event.value);
      tip_control_on_ = false;
      feed_.clear();
    }
  }

  /// False where a number is too large to be written.
  bool writeMove(std::size_t m) {
    const AxisMove& move = moves_.moves[m];
    const bool is_end = m + 1 == moves_.moves.size() || moves_.moves[m + 1].point != move.point;
    if (options_.tip_control && !tip_control_on_) startTipControl(move);
    const TipAxis pose = chain_.at(move.q);
    const WrittenAxes axes =
        writtenAxes(machine_, options_, move.q, is_end ? program_.points[move.point].tip : pose.tip);
    std::string words;
    for (int j = 0; j < machine_.jointCount(); ++j) {
      const auto k = static_cast<std::size_t>(j);
      if (last_ && last_->words[k] == axes.words[k]) continue;
      if (!(std::abs(axes.words[k]) < 1e8)) return false;
      words += (words.empty() ? "" : " ") + writer_->axisWord(j, axes.words[k]);
    }
    if (!words.empty()) writeBlock(move, axes, words);
    last_ = axes;
    return true;
  }

  void startTipControl(const AxisMove& move) {
    tip_control_on_ = true;
    if (!tool_)
      out_.warnings.countedWarning("post.tool", "Tip control without a tool number; tool 1 is named.",
                                   program_.points[move.point].line);
    writer_->tipControl(tool_.value_or(1));
  }

  void writeBlock(const AxisMove& move, const WrittenAxes& axes, const std::string& words) {
    ++out_.blocks;
    if (move.rapid) return writer_->rapid(words);
    const bool timed = move.starts_known && move.time > 0.0 && last_;
    const bool inverse = options_.feed == FeedWriting::InverseTime && timed;
    double value = perMinuteFromPerSecond(move.feed);
    if (inverse) {  // the time itself
      value = perMinuteFromPerSecond(1.0 / move.time);
    } else if (timed && !isPlain(move, axes)) {
      value = perMinuteFromPerSecond(countedLength(move, axes) / move.time);
    }
    const std::string feed = feedNumber(value);
    const FeedWriting writing = inverse ? FeedWriting::InverseTime : FeedWriting::PerMinute;
    const bool stays = !inverse && writing == writing_ && feed == feed_;
    writer_->line(words, stays ? "" : feed, writing);
    feed_ = inverse ? "" : feed;
    writing_ = writing;
  }

  /// Linear axes alone at the feed asked for: F is that feed, without the words' rounding.
  bool isPlain(const AxisMove& move, const WrittenAxes& axes) const {
    for (int j = 0; j < machine_.jointCount(); ++j) {
      const auto k = static_cast<std::size_t>(j);
      if (machine_.isRotary(j) && axes.words[k] != last_->words[k]) return false;
    }
    return std::abs(move.length - move.time * move.feed) < 1e-9 * move.length;
  }

  double countedLength(const AxisMove& move, const WrittenAxes& axes) const {
    if (options_.tip_control && move.length > 1e-9) return move.length;
    return feedLength(machine_, options_.control, last_->positions, axes.positions);
  }

  Error tooLarge(const AxisMove& move) const {
    return noAnswer("post.number", "An axis position is too large to be written.", {},
                    program_.points[move.point].line);
  }

  const Machine& machine_;
  TipAxisChain chain_{machine_};
  const ClProgram& program_;
  const AxisMoves& moves_;
  NcOptions options_;
  std::unique_ptr<ControlWriter> writer_;
  NcText out_;
  std::size_t event_ = 0;
  std::optional<int> tool_;
  bool tip_control_on_ = false;
  std::optional<WrittenAxes> last_;
  std::string feed_;
  FeedWriting writing_ = FeedWriting::PerMinute;
};

}  // namespace

double feedLength(const Machine& machine, Control control, const JointPositions& from,
                  const JointPositions& to) {
  double linear = 0.0;
  double turned = 0.0;
  for (int j = 0; j < machine.jointCount(); ++j) {
    const auto k = static_cast<std::size_t>(j);
    const double way = to[k] - from[k];
    if (machine.isRotary(j)) {
      turned += degFromRad(way) * degFromRad(way);
    } else {
      linear += way * way;
    }
  }
  if (control == Control::LinuxCnc && linear > 0.0) return std::sqrt(linear);
  return std::sqrt(linear + turned);
}

Result<void> checkControl(const Machine& machine, const NcOptions& options) {
  const char* const name = nameOf(options.control);
  const bool no_digits = options.control == Control::LinuxCnc || options.control == Control::Heidenhain;
  for (const kinematics::Joint& joint : machine.joints()) {
    if (no_digits && joint.axis.digit != 0)
      return usageError("post.axis", fmt::format("{} has no axis name like {}; choose fanuc or siemens.",
                                                 name, joint.axis.text()));
  }
  if (options.control == Control::Heidenhain && options.feed == FeedWriting::InverseTime)
    return usageError("post.feed", "Heidenhain programs state no inverse time.");
  if (!options.tip_control) return {};
  if (options.control == Control::LinuxCnc)
    return usageError("post.tip-control", "LinuxCNC has no code for tip control; leave --tcp out.");
  for (const char letter : {'X', 'Y', 'Z'}) {
    const int joint = machine.find({letter, 0});
    if (joint < 0 || machine.isRotary(joint))
      return usageError(
          "post.tip-control",
          fmt::format("Tip control needs the axes X, Y and Z; '{}' has no {}.", machine.id(), letter));
  }
  return {};
}

Result<NcText> writeNc(const Machine& machine, const ClProgram& program, const AxisMoves& moves,
                       const NcOptions& options) {
  if (Result<void> possible = checkControl(machine, options); !possible) return possible.error();
  return ProgramWriter(machine, program, moves, options).run();
}

}  // namespace nineline::postprocessing
