// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "geometry/rotation.h"
#include "geometry/symmetric_eigen.h"
#include "geometry/vec.h"

// From what a mobile scanner measures to a point of the world, and what that point is worth.
//
//   u(theta, phi) = (cos theta sin phi, sin theta sin phi, cos phi)      scanner frame
//   P = R (R_c (P0 + r u) + a) + T                                       world
//
// r: range, theta and phi: angles of the beam, P0: mirror offset, R_c: boresight rotation, a: lever
// arm, R and T: attitude and position of the inertial unit. The covariance of P follows from the 18
// inputs by linear propagation, C_P = J diag(sigma^2) J^T. (Glennie 2007 has the equation and its
// derivatives for mobile mapping.)
namespace jalon {

enum class BoresightOrder {
  kZyx,  ///< R_c = Rz(kappa) Ry(phi) Rx(omega): roll, pitch, yaw
  kXyz,  ///< R_c = Rx(omega) Ry(phi) Rz(kappa)
};

/// How the scanner sits on the vehicle, constant for a drive.
struct LaserMount {
  Vec3 mirror_offset_m;
  Vec3
      boresight_rad;  ///< omega, phi, kappa: roll, pitch, yaw of the scanner in the vehicle's frame
  BoresightOrder boresight_order = BoresightOrder::kZyx;
  Vec3 lever_arm_m;  ///< from the inertial unit to the scanner's origin, in the vehicle's frame
};

/// One return as measured.
struct LaserReturn {
  double range_m = 0, theta_rad = 0, phi_rad = 0;
};

/// Standard deviations of the 18 inputs in their order: range, theta, phi, mirror offset, boresight,
/// lever arm, attitude (roll, pitch, yaw), position.
constexpr size_t kLaserInputs = 18;
using LaserSigmas = std::array<double, kLaserInputs>;

/// Pose of the vehicle when the return came: R with the axes that its roll, pitch and yaw turn about
/// in the world.
struct VehiclePose {
  Matrix3 rotation;
  Vec3 position;
  std::array<Vec3, 3> attitude_axes;
};
/// is_ned: the convention of the angles (trajectory.h): the axes of Rz(yaw) Ry(pitch) Rx(roll) that
/// make this rotation.
VehiclePose vehicle_pose(const Matrix3& rotation, const Vec3& position, bool is_ned);

/// A return in the world.
struct WorldBeam {
  Vec3 point;
  Vec3 origin;     ///< the laser's centre: R (R_c P0 + a) + T
  Vec3 direction;  ///< unit: R R_c u
};

class BeamGeometry {
 public:
  explicit BeamGeometry(const LaserMount& mount);

  WorldBeam beam(const LaserReturn& from, const VehiclePose& pose) const;
  /// Both at once: what they share is calculated once.
  struct SureBeam {
    WorldBeam beam;
    Symmetric3 covariance;  ///< of the point (m2)
  };
  SureBeam sure_beam(const LaserReturn& from, const VehiclePose& pose,
                     const LaserSigmas& sigmas) const;
  /// The derivatives of the point by the 18 inputs.
  std::array<Vec3, kLaserInputs> jacobian(const LaserReturn& from, const VehiclePose& pose) const;
  /// Of the point (m2): the sum of sigma^2 j j^T.
  Symmetric3 covariance(const LaserReturn& from, const VehiclePose& pose,
                        const LaserSigmas& sigmas) const;

 private:
  struct Direction;
  WorldBeam beam(const Direction& along, double range_m, const VehiclePose& pose) const;
  std::array<Vec3, kLaserInputs> jacobian(const Direction& along, double range_m,
                                          const VehiclePose& pose) const;

  Vec3 mirror_, lever_arm_;
  Matrix3 boresight_;
  Vec3 laser_;  ///< its centre in the vehicle's frame
  std::array<Vec3, 3> boresight_axes_;
};

}  // namespace jalon
