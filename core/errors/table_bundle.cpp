#include "core/errors/table_bundle.h"

namespace nineline::errors {

std::vector<TableBundle> TableBundle::group(std::span<const EffectPtr> effects) {
  std::vector<TableBundle> bundles;
  for (const EffectPtr& effect : effects) {
    const ErrorTable* table = effect->table();
    if (table == nullptr) continue;
    TableBundle* bundle = nullptr;
    for (TableBundle& known : bundles) {
      const bool same = known.joint_ == effect->joint() && known.slot_ == effect->slot() &&
                        known.first_->grid() == table->grid() &&
                        known.first_->values().size() == table->values().size();
      if (same) bundle = &known;
    }
    if (bundle == nullptr) {
      bundle = &bundles.emplace_back();
      bundle->joint_ = effect->joint();
      bundle->slot_ = effect->slot();
      bundle->first_ = table;
      bundle->segments_.resize(table->segmentCount());
    }
    const auto row = static_cast<std::size_t>(effect->component().row);
    for (std::size_t i = 0; i < bundle->segments_.size(); ++i) {
      const ErrorTable::Cubic& c = table->coefficients(i);
      Segment& segment = bundle->segments_[i];
      segment.c[0][row] += c.c0;
      segment.c[1][row] += c.c1;
      segment.c[2][row] += c.c2;
      segment.c[3][row] += c.c3;
    }
  }
  return bundles;
}

void TableBundle::addMotion(double position, SmallMotion& sum) const {
  const ErrorTable::Place at = first_->place(position);
  const Segment& s = segments_[at.segment];
  SixValues v;
  for (std::size_t r = 0; r < 6; ++r)
    v[r] = s.c[0][r] + at.t * (s.c[1][r] + at.t * (s.c[2][r] + at.t * s.c[3][r]));
  sum.translation += Eigen::Vector3d(v[0], v[1], v[2]);
  sum.rotation += Eigen::Vector3d(v[3], v[4], v[5]);
}

void TableBundle::addSlope(double position, SmallMotion& sum) const {
  const ErrorTable::Place at = first_->place(position);
  if (at.outside) return;
  const Segment& s = segments_[at.segment];
  SixValues v;
  for (std::size_t r = 0; r < 6; ++r) v[r] = s.c[1][r] + at.t * (2.0 * s.c[2][r] + 3.0 * at.t * s.c[3][r]);
  sum.translation += Eigen::Vector3d(v[0], v[1], v[2]);
  sum.rotation += Eigen::Vector3d(v[3], v[4], v[5]);
}

}  // namespace nineline::errors
