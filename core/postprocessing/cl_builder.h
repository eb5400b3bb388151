#pragma once

#include <optional>
#include <string>

#include "core/postprocessing/cl_data.h"
#include "core/postprocessing/cl_reader.h"

namespace nineline::postprocessing {

/// Arc of a CIRCLE statement, which the next GOTO ends: counter-clockwise about `normal`.
struct ClArc {
  Vector3d centre = Vector3d::Zero();
  Vector3d normal = Vector3d::UnitZ();
  double radius = 0.0;
  std::size_t line = 0;
};

/// Drilling cycle in force: lengths in mm from the point of the GOTO along the tool axis.
struct ClCycle {
  double clearance = 0.0;
  double depth = 0.0;             ///< below the point, positive
  std::optional<double> retract;  ///< absent: the clearance
  double step = 0.0;              ///< of pecking; 0: in one go
  double dwell = 0.0;             ///< s at the bottom
  std::optional<double> feed;
  ClFeed feed_kind = ClFeed::PerMinute;
};

/// Turns statements about motion into points. Keeps what is modal in the data.
class ClBuilder {
 public:
  ClBuilder(ClProgram& program, const ClOptions& options) : program_(&program), options_(options) {}

  Vector3d axis = Vector3d::UnitZ();  ///< in force
  std::optional<double> feed;
  ClFeed feed_kind = ClFeed::PerMinute;
  bool rapid_next = false;  ///< RAPID stands before the next motion
  std::optional<ClCycle> cycle;
  std::optional<ClArc> arc;

  /// Where the tool stands; nothing before the first point.
  [[nodiscard]] const std::optional<Vector3d>& place() const { return place_; }
  void from(const Vector3d& tip, std::size_t line);
  /// A motion to `tip`; the text of a fault (an arc that does not end on its circle), empty when all is well.
  [[nodiscard]] std::string moveTo(const Vector3d& tip, std::size_t line);
  void addEvent(ClEvent event);

 private:
  void push(const Vector3d& tip, ClPoint::Kind kind, bool rapid, std::size_t line);
  void drill(const Vector3d& tip, std::size_t line);
  [[nodiscard]] std::string addArc(const Vector3d& tip, std::size_t line);
  ClProgram* program_;
  ClOptions options_;
  std::optional<Vector3d> place_;
  Vector3d axis_before_ = Vector3d::UnitZ();
};

}  // namespace nineline::postprocessing
