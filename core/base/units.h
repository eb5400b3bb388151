#pragma once

#include <numbers>

/// The only place that converts units. Inside the program: mm, rad, s, mm/s, °C, without suffix.
namespace nineline {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kTurn = 2.0 * std::numbers::pi;  ///< rad
inline constexpr double kMillimetresPerInch = 25.4;
inline constexpr double kNanometre = 1e-6;  ///< mm

constexpr double mmFromUm(double value_um) { return value_um * 1e-3; }
constexpr double umFromMm(double value) { return value * 1e3; }
constexpr double radFromDeg(double value_deg) { return value_deg * (kPi / 180.0); }
constexpr double degFromRad(double value) { return value * (180.0 / kPi); }
constexpr double radFromArcsec(double value_arcsec) { return value_arcsec * (kPi / 648000.0); }
constexpr double arcsecFromRad(double value) { return value * (648000.0 / kPi); }
constexpr double mmFromInch(double value_inch) { return value_inch * kMillimetresPerInch; }
constexpr double inchFromMm(double value) { return value / kMillimetresPerInch; }
constexpr double perSecondFromPerMinute(double value_per_min) { return value_per_min / 60.0; }
constexpr double perMinuteFromPerSecond(double value) { return value * 60.0; }

}  // namespace nineline
