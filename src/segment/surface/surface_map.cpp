// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/surface/surface_map.h"

#include <array>
#include <cmath>
#include <numbers>

#include "base/serial.h"
#include "segment/surface/scene.h"

namespace jalon {

namespace {

constexpr size_t kMappedPointsPerLook = 1 << 15;
constexpr size_t kSurfaceMapSectors =
    180;  // of 2 degrees: wider gaps than those between points of a scan

// Middle of the longest run of empty sectors, as an angle; half a turn when none is empty.
double widest_gap(const std::array<bool, kSurfaceMapSectors>& occupied) {
  size_t best = 0, best_end = 0, run = 0;
  for (size_t i = 0; i < 2 * kSurfaceMapSectors; ++i) {  // twice round, for a run across the start
    run = occupied[i % kSurfaceMapSectors] ? 0 : run + 1;
    if (run > best && run <= kSurfaceMapSectors) {
      best = run;
      best_end = i + 1;
    }
  }
  if (best == 0) return std::numbers::pi;
  const double middle = static_cast<double>(best_end) - static_cast<double>(best) / 2;
  return 2 * std::numbers::pi * middle / kSurfaceMapSectors;
}

}  // namespace

SurfaceMap SurfaceMap::of_plane(const Plane& plane, const Vec3& near) {
  SurfaceMap map;
  const SurfaceAxes axes = plane_axes(plane.normal);
  map.centre_ = near;
  map.u_ = axes.u;
  map.v_ = axes.v;
  return map;
}

SurfaceMap SurfaceMap::of_cylinder(const Cylinder& cylinder, std::span<const Vec3> points,
                                   Task& task) {
  SurfaceMap map;
  map.type_ = PrimitiveType::kCylinder;
  map.centre_ = cylinder.point;
  map.w_ = cylinder.direction;
  map.radius_ = cylinder.radius;
  const auto e = across(cylinder.direction);
  std::array<bool, kSurfaceMapSectors> occupied{};
  serial_for(task, points.size(), kMappedPointsPerLook, [&](size_t begin, size_t end) {
    for (const Vec3& p : points.subspan(begin, end - begin)) {
      const Vec3 d = p - cylinder.point;
      const double turn = std::atan2(dot(d, e[1]), dot(d, e[0])) / (2 * std::numbers::pi);
      occupied[static_cast<size_t>((turn - std::floor(turn)) * kSurfaceMapSectors) %
               kSurfaceMapSectors] = true;
    }
  });
  const double cut = widest_gap(occupied);  // the map begins and ends where u_ points away from
  map.u_ = -(std::cos(cut) * e[0] + std::sin(cut) * e[1]);
  map.v_ = cross(cylinder.direction, map.u_);
  return map;
}

SurfaceMap SurfaceMap::of_sphere(const Sphere& sphere, std::span<const Vec3> points, Task& task) {
  SurfaceMap map;
  map.type_ = PrimitiveType::kSphere;
  map.centre_ = sphere.centre;
  map.radius_ = sphere.radius;
  Vec3 sum;
  serial_for(task, points.size(), kMappedPointsPerLook, [&](size_t begin, size_t end) {
    for (const Vec3& p : points.subspan(begin, end - begin)) sum += normalized(p - sphere.centre);
  });
  map.w_ = squared_norm(sum) > 0 ? normalized(sum) : Vec3{0, 0, 1};
  const auto e = across(map.w_);
  map.u_ = e[0];
  map.v_ = e[1];
  return map;
}

SurfaceMap SurfaceMap::of(const Segment& segment, std::span<const Vec3> points, Task& task) {
  if (segment.type == PrimitiveType::kSphere) return of_sphere(segment.sphere.sphere, points, task);
  if (segment.type == PrimitiveType::kCylinder)
    return of_cylinder(segment.cylinder.cylinder, points, task);
  return of_plane(segment.fit.plane, segment.fit.centroid);
}

Vec2 SurfaceMap::operator()(const Vec3& p) const {
  const Vec3 d = p - centre_;
  if (type_ == PrimitiveType::kPlane) return {dot(d, u_), dot(d, v_)};
  if (type_ == PrimitiveType::kCylinder)
    return {radius_ * std::atan2(dot(d, v_), dot(d, u_)), dot(d, w_)};
  constexpr double kFarSide = 1e-6;  // the point opposite the middle is a whole circle on the map
  const Vec3 n = normalized(d);
  const double scale = radius_ * std::sqrt(2 / std::max(kFarSide, 1 + dot(n, w_)));
  return {scale * dot(n, u_), scale * dot(n, v_)};
}

}  // namespace jalon
