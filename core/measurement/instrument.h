#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/axis_id.h"

namespace nineline::measurement {

/// The instruments of `nineline-measurement/1`. Signs, frames and formulas: ReadingFunction, and
/// resources/docs/instruments.md with a worked number for each.
enum class InstrumentKind {
  Deviation,          ///< actual minus ideal tool in W, translation and rotation vector
  Joint,              ///< one joint's actual minus commanded position, its own positioning alone
  LaserLinear,        ///< a point of the moving body against the bed, along the joint's direction
  LaserStraightness,  ///< the same point along the bed axis `sensitive`
  LaserAngular,       ///< the moving body's rotation against the bed about the bed axis `about`
  Ballbar,            ///< |p_actual − centre| − radius in W
  Lead,               ///< axial deviation of a ground thread
  Dial                ///< gauge fixed in the bed on an artefact that the body carries
};

/// "laser-linear", as in the head of a file.
[[nodiscard]] std::string_view nameOf(InstrumentKind kind);
[[nodiscard]] std::optional<InstrumentKind> parseInstrumentKind(std::string_view text);
[[nodiscard]] std::vector<std::string_view> instrumentNames();

/// An instrument and how it is set up. Members that its kind does not use keep their defaults.
struct Instrument {
  InstrumentKind kind = InstrumentKind::Deviation;
  std::optional<AxisId> axis;  ///< joint, laser-*, dial: the joint under test
  Eigen::Vector3d point =
      Eigen::Vector3d::Zero();  ///< mm, in W with all joints at zero; travels with the body
  int sensitive = 0;            ///< laser-straightness, dial: bed axis 0 1 2 = X Y Z
  int about = 0;                ///< laser-angular: bed axis 0 1 2 = X Y Z
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< ballbar: mm, in W
  double radius = 0.0;                               ///< ballbar: mm
  std::string plane;                                 ///< ballbar: "XY", "YZ", "ZX" as the file says
  double pitch = 0.0;                                ///< lead: mm, distance of neighbouring grooves
  int starts = 1;                                    ///< lead
  bool left_hand = false;                            ///< lead

  /// Signed lead L = ± pitch × starts in mm a turn, + for right hand.
  [[nodiscard]] double lead() const { return (left_hand ? -1.0 : 1.0) * pitch * starts; }
  /// True where readings carry an unknown zero for each file (contract.md, convention 7).
  [[nodiscard]] bool hasZero() const {
    return kind != InstrumentKind::Deviation && kind != InstrumentKind::Ballbar;
  }
  /// True where the instrument looks at the body of `axis`.
  [[nodiscard]] bool needsAxis() const {
    return kind != InstrumentKind::Deviation && kind != InstrumentKind::Ballbar &&
           kind != InstrumentKind::Lead;
  }
};

/// What one column of readings tells.
enum class Quantity { DevX, DevY, DevZ, RotX, RotY, RotZ, Length, Angle, Radius };

/// One column of readings. Inside mm or rad.
struct Channel {
  Quantity quantity = Quantity::Length;

  friend bool operator==(const Channel&, const Channel&) = default;
  [[nodiscard]] bool isAngular() const {
    return quantity == Quantity::Angle || (quantity >= Quantity::RotX && quantity <= Quantity::RotZ);
  }
  /// "dev_x_um", "dev_arcsec", "dr_um".
  [[nodiscard]] std::string column() const;
};

/// The channel of a column name that is a reading of this instrument; nothing for any other column.
/// `rotary`: the joint under test is rotary (then `joint` reads an angle).
[[nodiscard]] std::optional<Channel> parseChannel(std::string_view column, InstrumentKind kind, bool rotary);
/// The columns that the instrument may have.
[[nodiscard]] std::vector<std::string> channelColumns(InstrumentKind kind, bool rotary);

}  // namespace nineline::measurement
