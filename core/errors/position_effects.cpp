#include "core/errors/position_effects.h"

#include <array>
#include <cmath>

#include "core/base/units.h"

namespace nineline::errors {

namespace {

constexpr std::array<double, 2> kLine{0.0, 1.0};
constexpr std::array<double, 3> kBow{-1.0 / 3.0, 0.0, 1.0};
constexpr std::array<double, 4> kSnake{0.0, -0.6, 0.0, 1.0};
constexpr std::array<double, 5> kFourth{3.0 / 8.0, 0.0, -30.0 / 8.0, 0.0, 35.0 / 8.0};
constexpr std::array<double, 6> kFifth{0.0, 15.0 / 8.0, 0.0, -70.0 / 8.0, 0.0, 63.0 / 8.0};
constexpr std::array<double, 7> kSixth{-5.0 / 16.0, 0.0, 105.0 / 16.0, 0.0, -315.0 / 16.0, 0.0, 231.0 / 16.0};
constexpr std::array<std::span<const double>, 6> kShapes{kLine, kBow, kSnake, kFourth, kFifth, kSixth};

constexpr double kPiecesOfAWave = 8.0;
constexpr double kPiecesOfASag = 25.0;      // mm
constexpr double kMillimetresOfASag = 1e3;  // the cube's third factor of (q − q_ref)/1000

double waveNumber(const EffectParts& parts) {
  if (parts.has("period")) return kTurn / parts.value("period");
  return parts.valueOr("n", 1.0);
}

}  // namespace

WaveEffect::WaveEffect(const EffectParts& parts)
    : ScalarEffect(parts),
      amplitude_(parts.value("amplitude")),
      wave_number_(waveNumber(parts)),
      phase_(parts.valueOr("phase", 0.0)) {}

double WaveEffect::featureLength() const { return kTurn / std::abs(wave_number_) / kPiecesOfAWave; }

double WaveEffect::amplitude(const MachineState& state, std::span<const double>) const {
  return amplitude_ * std::sin(wave_number_ * position(state) + phase_);
}

double WaveEffect::amplitudeSlope(const MachineState& state) const {
  return amplitude_ * wave_number_ * std::cos(wave_number_ * position(state) + phase_);
}

BendEffect::BendEffect(const EffectParts& parts)
    : ScalarEffect(parts), amplitude_(parts.value("amplitude")), middle_(0.0), half_(1.0) {
  const std::optional<kinematics::Travel>& travel =
      parts.placement.range ? parts.placement.range : parts.joint().travel;
  NL_EXPECTS(travel.has_value());
  middle_ = 0.5 * (travel->low + travel->high);
  half_ = 0.5 * (travel->high - travel->low);
  const auto degree = static_cast<std::size_t>(std::lround(parts.value("shape")));
  NL_EXPECTS(degree >= 1 && degree <= kShapes.size(), degree);
  polynomial_ = kShapes[degree - 1];
}

double BendEffect::featureLength() const {
  return polynomial_.size() == 2 ? std::numeric_limits<double>::infinity()
                                 : half_ / (kPiecesOfAWave * static_cast<double>(polynomial_.size() - 1));
}

double BendEffect::amplitude(const MachineState& state, std::span<const double>) const {
  const double x = (position(state) - middle_) / half_;
  double sum = 0.0;
  for (std::size_t k = polynomial_.size(); k-- > 0;) sum = sum * x + polynomial_[k];
  return amplitude_ * sum;
}

double BendEffect::amplitudeSlope(const MachineState& state) const {
  const double x = (position(state) - middle_) / half_;
  double sum = 0.0;
  for (std::size_t k = polynomial_.size(); k-- > 1;) sum = sum * x + static_cast<double>(k) * polynomial_[k];
  return amplitude_ * sum / half_;
}

SagEffect::SagEffect(const EffectParts& parts)
    : ScalarEffect(parts),
      k_(parts.value("k")),
      reference_(parts.valueOr("q_ref", 0.0)),
      cubed_(parts.valueOr("power", 2.0) > 2.5) {}

double SagEffect::featureLength() const { return kPiecesOfASag; }

double SagEffect::amplitude(const MachineState& state, std::span<const double>) const {
  const double out = position(state) - reference_;
  return -k_ * out * out * (cubed_ ? out / kMillimetresOfASag : 1.0);
}

double SagEffect::amplitudeSlope(const MachineState& state) const {
  const double out = position(state) - reference_;
  return -k_ * (cubed_ ? 3.0 * out * out / kMillimetresOfASag : 2.0 * out);
}

}  // namespace nineline::errors
