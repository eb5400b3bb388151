#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "core/base/diagnostics.h"

namespace nineline::postprocessing {

using Eigen::Vector3d;

/// What the feed of a point counts.
enum class ClFeed { PerMinute, PerRevolution };

/// One place that the tool goes to, in the workpiece frame.
struct ClPoint {
  enum class Kind {
    From,   ///< where the tool stands before the first motion; nothing moves there
    Goto,   ///< a GOTO or GODLTA of the file
    Inner,  ///< on the way to the next Goto: a chord of an arc
    Cycle   ///< a motion of a drilling cycle at the Goto before
  };
  Vector3d tip = Vector3d::Zero();    ///< mm
  Vector3d axis = Vector3d::UnitZ();  ///< unit vector from the tip towards the holder
  Kind kind = Kind::Goto;
  bool rapid = false;
  ClFeed feed_kind = ClFeed::PerMinute;
  std::optional<double> feed;  ///< mm/s or mm per turn; absent until a FEDRAT states it
  std::size_t line = 0;        ///< of the file, from 1
};

/// What happens between motions.
struct ClEvent {
  enum class Kind {
    Comment,       ///< `text`
    SpindleOn,     ///< `value` rev/min, `choice` +1 clockwise, −1 counter-clockwise
    SpindleOff,    //
    CoolantOn,     ///< `choice` 0 flood, 1 mist
    CoolantOff,    //
    ToolChange,    ///< `value` the tool's number
    Stop,          //
    OptionalStop,  //
    Dwell,         ///< `value` s
    MachineCode    ///< `value` of the M word
  };
  Kind kind = Kind::Comment;
  std::size_t before = 0;  ///< index of the point before which it happens; the number of points at the end
  double value = 0.0;
  int choice = 0;
  std::string text;
  std::size_t line = 0;
};

/// Cutter location data: the path of a tool past a workpiece, for no machine in particular.
struct ClProgram {
  std::string name;  ///< of PARTNO, empty where there is none
  std::vector<ClPoint> points;
  std::vector<ClEvent> events;  ///< in order
  std::size_t goto_count = 0;
  Diagnostics warnings;
};

}  // namespace nineline::postprocessing
