// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "model/trajectory/laser_beam.h"

#include "geometry/polar_covariance.h"

namespace jalon {

namespace {

Symmetric3 propagated(const std::array<Vec3, kLaserInputs>& J, const LaserSigmas& sigmas) {
  Symmetric3 c{};
  for (size_t k = 0; k < kLaserInputs; ++k) add_square(c, J[k], sigmas[k] * sigmas[k]);
  return c;
}

}  // namespace

struct BeamGeometry::Direction {
  double sin_theta, cos_theta, sin_phi, cos_phi;
  explicit Direction(const LaserReturn& from)
      : sin_theta(std::sin(from.theta_rad)),
        cos_theta(std::cos(from.theta_rad)),
        sin_phi(std::sin(from.phi_rad)),
        cos_phi(std::cos(from.phi_rad)) {}
  Vec3 unit() const { return {cos_theta * sin_phi, sin_theta * sin_phi, cos_phi}; }
  Vec3 by_theta() const { return {-sin_theta * sin_phi, cos_theta * sin_phi, 0}; }
  Vec3 by_phi() const { return {cos_theta * cos_phi, sin_theta * cos_phi, -sin_phi}; }
};

VehiclePose vehicle_pose(const Matrix3& rotation, const Vec3& position, bool is_ned) {
  // Of Rz(yaw) Ry(pitch) Rx(roll): roll turns about its first column, yaw about z, pitch about the
  // level axis across the first column. North-east-down swaps east and north and turns down up.
  const auto swapped = [](const Vec3& v) { return Vec3{v.y, v.x, -v.z}; };
  const Vec3 first = is_ned ? swapped(rotation.column(0)) : rotation.column(0);
  const double level = std::sqrt(first.x * first.x + first.y * first.y);
  // Where the vehicle stands on its tail the angles have no axes of their own: any level one.
  Vec3 across = level > 0 ? Vec3{-first.y / level, first.x / level, 0} : Vec3{0, 1, 0};
  Vec3 up{0, 0, 1};
  if (is_ned) across = swapped(across), up = swapped(up);
  return {rotation, position, {rotation.column(0), across, up}};
}

BeamGeometry::BeamGeometry(const LaserMount& mount)
    : mirror_(mount.mirror_offset_m), lever_arm_(mount.lever_arm_m) {
  const Vec3& b = mount.boresight_rad;
  const Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  if (mount.boresight_order == BoresightOrder::kZyx) {
    boresight_ = rotation_zyx(b);
    boresight_axes_ = {boresight_ * x, rotation_z(b.z) * y, z};
  } else {
    boresight_ = rotation_x(b.x) * rotation_y(b.y) * rotation_z(b.z);
    boresight_axes_ = {x, rotation_x(b.x) * y, boresight_ * z};
  }
  laser_ = boresight_ * mirror_ + lever_arm_;
}

WorldBeam BeamGeometry::beam(const Direction& along, double range_m,
                             const VehiclePose& pose) const {
  const Vec3 origin = pose.rotation * laser_ + pose.position;
  const Vec3 direction = pose.rotation * (boresight_ * along.unit());
  return {origin + direction * range_m, origin, direction};
}

WorldBeam BeamGeometry::beam(const LaserReturn& from, const VehiclePose& pose) const {
  return beam(Direction(from), from.range_m, pose);
}

std::array<Vec3, kLaserInputs> BeamGeometry::jacobian(const Direction& along, double range_m,
                                                      const VehiclePose& pose) const {
  const Matrix3& R = pose.rotation;
  const Matrix3 W = R * boresight_;
  const Vec3 turned = boresight_ * (mirror_ + along.unit() * range_m);  // R_c q
  const Vec3 arm = R * (turned + lever_arm_);                           // R p
  return {W * along.unit(),
          W * along.by_theta() * range_m,
          W * along.by_phi() * range_m,
          W.column(0),
          W.column(1),
          W.column(2),
          R * cross(boresight_axes_[0], turned),
          R * cross(boresight_axes_[1], turned),
          R * cross(boresight_axes_[2], turned),
          R.column(0),
          R.column(1),
          R.column(2),
          cross(pose.attitude_axes[0], arm),
          cross(pose.attitude_axes[1], arm),
          cross(pose.attitude_axes[2], arm),
          {1, 0, 0},
          {0, 1, 0},
          {0, 0, 1}};
}

std::array<Vec3, kLaserInputs> BeamGeometry::jacobian(const LaserReturn& from,
                                                      const VehiclePose& pose) const {
  return jacobian(Direction(from), from.range_m, pose);
}

Symmetric3 BeamGeometry::covariance(const LaserReturn& from, const VehiclePose& pose,
                                    const LaserSigmas& sigmas) const {
  return propagated(jacobian(from, pose), sigmas);
}

BeamGeometry::SureBeam BeamGeometry::sure_beam(const LaserReturn& from, const VehiclePose& pose,
                                               const LaserSigmas& sigmas) const {
  const Direction along(from);
  return {beam(along, from.range_m, pose), propagated(jacobian(along, from.range_m, pose), sigmas)};
}

}  // namespace jalon
