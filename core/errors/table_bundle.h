#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/errors/effect.h"

namespace nineline::errors {

/// Tables of one joint that share grid, slot and interpolation, evaluated together: the position is located
/// once and six polynomials run side by side. Gives the same sums as the effects themselves (tested).
class TableBundle {
 public:
  /// Groups the table effects of a model; effects that are no tables are not touched.
  [[nodiscard]] static std::vector<TableBundle> group(std::span<const EffectPtr> effects);

  [[nodiscard]] int joint() const { return joint_; }
  [[nodiscard]] Slot slot() const { return slot_; }
  void addMotion(double position, SmallMotion& sum) const;
  void addSlope(double position, SmallMotion& sum) const;

 private:
  using SixValues = std::array<double, 6>;
  struct Segment {
    std::array<SixValues, 4> c{};  // c[k][row]: coefficient of t^k
  };
  int joint_ = 0;
  Slot slot_ = Slot::Moved;
  const ErrorTable* first_ = nullptr;  // owned by the effect; gives the place of a position
  std::vector<Segment> segments_;
};

}  // namespace nineline::errors
