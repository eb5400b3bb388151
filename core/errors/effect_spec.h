#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace nineline::errors {

/// Who causes an effect. Machine effects are compensated; process effects (wheel, workpiece, load) when the
/// user turns them on; measurement effects are reported only: they are no motion of the machine.
enum class EffectKind { Machine, Process, Measurement };

/// What a parameter measures; with the joint and the component this decides its unit (unitOf).
enum class Quantity {
  Error,            ///< um or arcsec, of the component
  Position,         ///< mm or deg, of the joint
  Length,           ///< mm
  Phase,            ///< deg
  Ratio,            ///< um/m
  Growth,           ///< um/m/C
  Number,           ///< 1
  Frequency,        ///< Hz
  Speed,            ///< mm/s or deg/s, of the joint
  Delay,            ///< ms
  Duration,         ///< s
  PerAcceleration,  ///< um/(m/s²)
  PerSpeed,         ///< um/(m/min); um/1 where the cause is no feed
  PerTemperature,   ///< um/C or arcsec/C
  Temperature,      ///< C
  PerLoad,          ///< um/kg or arcsec/kg
  PerHour,          ///< um/h or arcsec/h
  PerPass,          ///< um/pass
  PerArea           ///< um/m²
};

/// How a parameter enters the effect's formula.
enum class Role {
  Linear,     ///< the effect is proportional to it
  Amplitude,  ///< of a wave; with the Phase two linear coefficients
  Phase,
  NonLinear,  ///< searched from `starts`, then refined between low and high
  Choice,     ///< one of `starts`, never between them
  Given       ///< belongs to the set-up; neither fitted nor searched
};

/// Joints that an effect may sit on.
enum class JointChoice { Linear, Rotary, Any };

struct Bounds {
  double low = 0.0;
  double high = 0.0;
};

/// What is plausible, the amount without its sign for linear parameters: on a precision grinder and on a
/// general mill, in the parameter's unit.
struct Plausible {
  Bounds grinder{};
  Bounds mill{};
};

/// One parameter of an effect; names as in contract.md.
struct ParameterSpec {
  std::string_view name{};
  Quantity quantity = Quantity::Error;
  Role role = Role::Linear;
  Plausible linear{};              ///< where the unit has no choice, or is that of a length
  std::optional<Plausible> arc{};  ///< where the unit is that of an angle; absent: as `linear`
  std::vector<double> starts{};    ///< values to begin a search at; fractions of the travel where `of_travel`
  bool of_travel = false;          ///< bounds and starts count in travels from its lower end
  std::optional<double> otherwise{};      ///< taken where a file does not state the parameter
  bool optional = false;                  ///< may be left out, which is another form of the effect
  int sign = 0;                           ///< +1: physics allows no negative value
  JointChoice joints = JointChoice::Any;  ///< joints of which it makes sense
};

/// Components that an effect may add to; flags.
enum Sites : unsigned {
  kOwn = 1,         ///< the joint's own positioning
  kLateral = 2,     ///< translations across a linear joint
  kTilt = 4,        ///< rotations: all three of a linear joint, those across a rotary one's axis
  kRadialPair = 8,  ///< both translations across a rotary axis at once; named by the first
  kTiltPair = 16,   ///< both rotations across a rotary axis at once; named by the first
  kAxial = 32,      ///< translation along a rotary axis
  kEachWay = 64,    ///< one translation for each direction of the bed, wherever it sits
  kLocation = 128   ///< also the place of the joint (B0Z, X0C)
};

/// Conditions of a state that an effect depends on; flags. Temperatures and other columns: `sensors`.
enum Covariates : unsigned {
  kApproach = 1,
  kVelocity = 2,
  kAcceleration = 4,
  kSinceReversal = 8,
  kTime = 16,
  kPass = 32,
  kLoad = 64,
  kFeed = 128
};

/// Another effect that the same readings may show.
struct LookAlike {
  std::string_view id{};
  std::string_view why{};           ///< what the two have in common
  std::string_view separated_by{};  ///< the measurement that tells them apart
};

/// For the shop floor, one sentence or two each.
struct ShopFloor {
  std::string_view cause{};
  std::string_view size{};
  std::string_view remedy{};
};

/// A kind of effect, as the catalogue knows it: everything about it save its place on a machine and its size.
struct EffectSpec {
  std::string_view id{};     ///< contract.md
  std::string_view title{};  ///< "Backlash"
  EffectKind kind = EffectKind::Machine;
  std::string_view rows{};     ///< of discovery.md, section 2
  std::string_view formula{};  ///< "−(w/2) s"
  std::vector<ParameterSpec> parameters{};
  JointChoice joints = JointChoice::Linear;
  unsigned sites = kOwn;  ///< where a search looks for it
  unsigned covariates = 0;
  int sensors = 0;                     ///< columns that it follows besides: 0, 1, 2
  std::string_view standard_sensor{};  ///< where a file names none; {} is the joint: "temp_screw_{}_C"
  std::vector<LookAlike> lookalikes{};
  Bounds action_limit{};  ///< RMS in um: grinder (low), mill (high)
  ShopFloor shop_floor{};

  [[nodiscard]] const ParameterSpec* find(std::string_view name) const;
  /// Whether compensation counts with it unless the user says otherwise.
  [[nodiscard]] bool isActiveByDefault() const;
  /// Whether other commands can remove it: not what follows the speed, the acceleration or an instant of
  /// time, nor a spike at a reversal.
  [[nodiscard]] bool isCorrectable() const;
};

/// Every effect of contract.md's table, in its order.
[[nodiscard]] const std::vector<EffectSpec>& effectCatalogue();
/// nullptr for an unknown id.
[[nodiscard]] const EffectSpec* findEffectSpec(std::string_view id);

/// What decides the unit of a parameter besides its quantity.
struct UnitChoice {
  bool angular = false;             ///< of the component
  bool rotary = false;              ///< of the joint
  bool of_other_than_feed = false;  ///< PerSpeed: the cause is another column, in its own unit
};

/// The unit of a parameter ("um", "arcsec/C"), as in contract.md.
[[nodiscard]] std::string_view unitOf(Quantity quantity, const UnitChoice& choice);
/// One of that unit in the program's own (mm, rad, s, °C).
[[nodiscard]] double scaleOf(Quantity quantity, const UnitChoice& choice);

}  // namespace nineline::errors
