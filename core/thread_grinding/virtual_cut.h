#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/thread_grinding/thread_path.h"

namespace nineline::thread_grinding {

/// One straight motion of the machine in model coordinates.
struct VirtualMove {
  ThreadPoint from;
  ThreadPoint to;
  bool rapid = false;
  std::size_t line = 0;
};

/// The blank before grinding.
struct VirtualBlank {
  ThreadType type = ThreadType::External;
  double crest_radius = 0.0;  ///< mm at wz = 0: outside of a bar, inside of a bore
  double taper = 0.0;
  double length = 0.0;  ///< material from wz = 0 to here
  double z_at_zero = 0.0;
  double contact_height = 0.0;
  double tolerance = 1e-3;  ///< mm: a shallower contact than this is none
};

/// One uninterrupted cut: the screw line wz = slope · (φ − middle_angle) + middle_wz that fits it best.
struct GrooveRun {
  double slope = 0.0;         ///< mm/rad: positive for a right-hand groove
  double middle_angle = 0.0;  ///< rad: mean φ of the cut on the workpiece, not wrapped
  double middle_wz = 0.0;     ///< mm
  double residual = 0.0;      ///< mm: largest distance of the cut from that line along wz
  double depth = 0.0;         ///< mm: deepest below the crest
  double least_depth = 0.0;
  double first_wz = 0.0;
  double last_wz = 0.0;
  std::size_t line = 0;  ///< of the first motion
};

/// Cuts a thread from motions alone: knows the blank, not the thread that is wanted.
class VirtualCut {
 public:
  explicit VirtualCut(const VirtualBlank& blank) : blank_(blank) {}

  /// Motions in the order of the program.
  void add(const VirtualMove& move);
  /// Ends the run in progress; to be called after the last motion.
  void finish();

  [[nodiscard]] const std::vector<GrooveRun>& runs() const { return runs_; }
  /// The first thing that no grinding program does: a rapid motion through the material, a wheel beyond the
  /// axis.
  [[nodiscard]] const std::optional<std::string>& fault() const { return fault_; }

 private:
  struct Contact {
    double angle = 0.0;  ///< φ on the workpiece, not wrapped
    double wz = 0.0;
    double depth = 0.0;  ///< below the crest, negative outside
  };
  [[nodiscard]] Contact contactAt(const ThreadPoint& point) const;
  [[nodiscard]] GrooveRun fittedRun() const;
  void report(std::string text);

  VirtualBlank blank_;
  std::vector<Contact> contacts_;
  std::size_t first_line_ = 0;
  std::vector<GrooveRun> runs_;
  std::optional<std::string> fault_;
};

}  // namespace nineline::thread_grinding
