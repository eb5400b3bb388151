#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/compensation/motion_planner.h"

namespace nineline::compensation {

/// Which motions of the corrected program stand for which motion of the original one, in the order of
/// execution; four bytes for a motion that stayed whole.
class PieceLog {
 public:
  struct Span {
    double from = 0.0;
    double to = 1.0;
  };
  /// A motion that is one motion still.
  void addWhole() { counts_.push_back(1); }
  void add(std::span<const Piece> pieces) {
    counts_.push_back(static_cast<std::uint32_t>(pieces.size()));
    if (pieces.size() == 1) return;
    for (const Piece& piece : pieces) spans_.push_back({piece.from, piece.to});
  }
  [[nodiscard]] const std::vector<std::uint32_t>& counts() const { return counts_; }
  [[nodiscard]] const std::vector<Span>& spans() const { return spans_; }

 private:
  std::vector<std::uint32_t> counts_;
  std::vector<Span> spans_;
};

}  // namespace nineline::compensation
