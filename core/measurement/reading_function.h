#pragma once

#include <span>

#include "core/kinematics/chain.h"
#include "core/measurement/measurement.h"

namespace nineline::measurement {

/// How many numbers describe the sensitivity of one reading to one joint: the slots Located, Standing, Moved
/// in this order, each dx dy dz (mm per mm) and rx ry rz (mm per rad) in the frame of the slot.
inline constexpr std::size_t kGradientPerJoint = 18;

/// What an instrument reads on a machine whose joints are displaced, through the exact kinematics; nothing is
/// linearised and no zero is subtracted. Frames: W workpiece, M bed, B the body that the joint `axis`
/// carries; p actual, p₀ ideal, both at the same command. All readings are actual minus ideal, mm and rad.
///
/// - `deviation`: p − p₀ of the tool tip in W; rotation vector of R R₀ᵀ in W. A table-side joint that moves
/// by
///   +δ reads −δ.
/// - `joint`: (δ · direction) or (ε · direction) of the joint's own Standing and Moved displacements; other
///   joints, location errors and levers do not enter.
/// - `laser-linear`: (T_MB b − T₀_MB b) · R₀_MF direction, b the body's point that stands at `point` (in W)
///   with all joints at zero. F is the joint's fixed side: the beam follows the nominal direction of motion.
/// - `laser-straightness`: the same difference along the bed axis `sensitive`. Yaw ε with the point at y
/// gives
///   −ε y along X.
/// - `laser-angular`: rotation vector of R_MB R₀_MBᵀ about the bed axis `about`.
/// - `ballbar`: |p − centre| − radius in W; nothing is fitted out.
/// - `lead`: (z − z₀) − L/2π (φ − φ₀), z and polar angle φ of the tool point in W. Where the ideal point lies
///   on the axis (r < 1 nm) φ − φ₀ is the tool's rotation about z in W, the limit of a point far outside.
/// - `dial`: (T_MB T₀_MB⁻¹ P − P) · sensitive, P the gauge, fixed in the bed at `point`: the perfect artefact
///   turns with the body, the reading shows how far its material at the gauge has moved.
class ReadingFunction {
 public:
  /// The machine and the measurement must outlive this object. Requires an axis of the machine where the
  /// instrument needs one.
  ReadingFunction(const Machine& machine, const Instrument& instrument, std::vector<Channel> channels);

  [[nodiscard]] std::size_t channelCount() const { return channels_.size(); }
  [[nodiscard]] std::size_t gradientSize() const {
    return kGradientPerJoint * static_cast<std::size_t>(machine_->jointCount());
  }

  /// One reading for each channel, mm or rad.
  void read(const JointPositions& q, const kinematics::JointDisplacements& displacements,
            std::span<double> readings) const;
  /// Also the derivatives of each reading with respect to the displacements of every joint and slot, at these
  /// displacements: channelCount() blocks of gradientSize() numbers. Rotations are parameters of exp([ε]×)
  /// (Located: of Rx Ry Rz).
  void readWithGradient(const JointPositions& q, const kinematics::JointDisplacements& displacements,
                        std::span<double> readings, std::span<double> gradient) const;

 private:
  struct Chain;
  struct Sight;
  void evaluate(const JointPositions& q, const kinematics::JointDisplacements& displacements,
                std::span<double> readings, double* gradient) const;
  [[nodiscard]] Sight sightOf(const Channel& channel, const Chain& actual, const Chain& ideal) const;
  [[nodiscard]] Sight toolSight(const Channel& channel, const Chain& actual, const Chain& ideal) const;
  [[nodiscard]] Sight bodySight(const Chain& actual, const Chain& ideal) const;
  void spread(const Sight& sight, const Chain& chain, const kinematics::JointDisplacements& displacements,
              double* gradient) const;
  double ownPositioning(const kinematics::JointDisplacements& displacements, double* gradient) const;

  const Machine* machine_;
  Instrument instrument_;
  std::vector<Channel> channels_;
  int joint_ = -1;           // index of the axis under test
  Eigen::Vector3d point_B_;  // the instrument's point in B
  Eigen::Vector3d point_M_;  // and in M, all joints at zero
};

}  // namespace nineline::measurement
