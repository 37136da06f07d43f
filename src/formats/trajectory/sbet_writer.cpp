// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include "base/error.h"
#include "formats/files/atomic_file.h"
#include "formats/files/endian.h"
#include "formats/trajectory/sbet.h"
#include "formats/trajectory/smrmsg.h"

namespace jalon {

namespace {

// Which world the positions are in: written files say nothing of it, so that it must be said.
MapProjection stated_projection(const TrajectoryFileSettings& settings) {
  if (settings.projection == MapSystem::kUtm && settings.utm_zone == 0)
    fail(Status::kInvalidArgument,
         "SBET holds latitudes: say the zone of the positions (utm_zone)");
  if (settings.projection == MapSystem::kEnu && settings.origin.empty())
    fail(Status::kInvalidArgument,
         "SBET holds latitudes: say the origin of the positions (origin)");
  return projection_of(settings, {});
}

Vec3 velocity_at(const Trajectory& t, size_t i) {
  if (!t.velocities_m_s.empty()) return t.velocities_m_s[i];
  const size_t a = i > 0 ? i - 1 : 0, b = std::min(i + 1, t.size() - 1);
  return (t.positions[b] - t.positions[a]) / (t.times_s[b] - t.times_s[a]);
}

}  // namespace

void write_sbet(const Trajectory& trajectory, const std::string& path,
                const std::string& sigma_path, const TrajectoryFileSettings& settings, Task& task) {
  const MapProjection world = stated_projection(settings);
  std::vector<Matrix3> turns;
  AtomicFile file(path);
  constexpr size_t kTogether = 4096;
  for (size_t i = 0; i < trajectory.size(); ++i) {
    if (i % kTogether == 0)
      task.checkpoint(static_cast<double>(i) / static_cast<double>(trajectory.size()));
    const Geodetic place = unprojected(world, trajectory.positions[i]);
    turns.push_back(projected(world, place).T_world_local);
    const Matrix3 to_local = transposed(turns.back());
    const Vec3 enu = to_local * velocity_at(trajectory, i);
    const Vec3 angles = attitude_angles(
        AxesConvention::kNed,
        to_local * attitude_rotation(trajectory.axes, trajectory.attitudes_rad[i]) *
            (trajectory.axes == AxesConvention::kNed ? Matrix3{} : kForwardRightDown));
    std::array<double, kSbetFields> r{};
    r[kSbetTime] = trajectory.times_s[i];
    r[kSbetLatitude] = place.latitude_rad, r[kSbetLongitude] = place.longitude_rad;
    r[kSbetAltitude] = place.height_m;
    r[kSbetVelocityX] = enu.y, r[kSbetVelocityY] = enu.x, r[kSbetVelocityZ] = -enu.z;
    r[kSbetRoll] = angles.x, r[kSbetPitch] = angles.y, r[kSbetHeading] = angles.z;
    std::array<std::byte, 8 * kSbetFields> bytes;
    for (size_t k = 0; k < kSbetFields; ++k) store(bytes.data() + 8 * k, r[k]);
    file.write(bytes.data(), bytes.size());
  }
  if (!sigma_path.empty()) write_smrmsg(trajectory, turns, sigma_path, task);
  file.commit();
}

}  // namespace jalon
