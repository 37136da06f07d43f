// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "unit/scan/fixture.h"
#include "base/random.h"
#include "spatial/triangles/tree.h"

// After Girardeau-Montaut 2006, 2.3.3: four days of earthworks from one scanner, and what was truly in its shadow.

namespace jalon::test {

constexpr double kDegree_rad = std::numbers::pi / 180;
constexpr double kSiteLeft_rad = -60 * kDegree_rad, kSiteRight_rad = 60 * kDegree_rad;
constexpr double kSiteLow_rad = -45 * kDegree_rad, kSiteHigh_rad = 15 * kDegree_rad;
constexpr uint32_t kGround = 1, kHeap = 2, kPit = 3, kBackWall = 4, kFreeWall = 6, kExcavator = 11;

/// One day of the site.
struct SiteDay {
  std::shared_ptr<const TriangleTree> tree;
  std::vector<uint32_t> faces;  ///< of the triangles
  Transform pose;               ///< T_world_scanner
  CloudPtr cloud;

  uint32_t face(uint32_t triangle) const { return faces[triangle]; }
  bool is_in_field(const Vec3& p, double border_rad = 0) const {
    const Vec3 q = inverse(pose).point(p);
    const double h = std::atan2(q.x, q.y), v = std::atan2(q.z, std::hypot(q.x, q.y));
    return h >= kSiteLeft_rad + border_rad && h <= kSiteRight_rad - border_rad &&
           v >= kSiteLow_rad + border_rad && v <= kSiteHigh_rad - border_rad;
  }
  /// How far behind the first surface a point lies as the scanner sees it: 0 on it, negative before it.
  double depth_behind(const Vec3& p) const {
    const Vec3 eye = pose.translation();
    RayHit hit;
    const Ray ray{eye, p - eye};
    return tree->nearest(ray, hit) ? (1 - hit.t) * norm(p - eye) : -1e9;
  }
};

/// The pose of a day: 2 m above the ground, off by 5 cm and half a degree, and known.
inline Transform site_pose(int day) {
  RandomStream random(2006, static_cast<uint64_t>(day));
  const auto off = [&](double sigma) { return sigma * random.normal(); };
  const double a = off(0.5 * kDegree_rad), b = off(0.5 * kDegree_rad), c = off(0.5 * kDegree_rad);
  Transform x, y, z, shift;
  x.m = {1, 0, 0, 0, 0, std::cos(a), -std::sin(a), 0, 0, std::sin(a), std::cos(a), 0};
  y.m = {std::cos(b), 0, std::sin(b), 0, 0, 1, 0, 0, -std::sin(b), 0, std::cos(b), 0};
  z.m = {std::cos(c), -std::sin(c), 0, 0, std::sin(c), std::cos(c), 0, 0, 0, 0, 1, 0};
  shift.m[3] = 30 + off(0.05);
  shift.m[7] = 1 + off(0.05);
  shift.m[11] = 2.4 + off(0.05);  // the ground is at 0.4 m there
  return shift * z * y * x;
}

inline StaticSettings site_scanner(double step_deg, uint64_t seed) {
  StaticSettings s;
  s.horizontal_step_rad = s.vertical_step_rad = step_deg * kDegree_rad;
  s.horizontal_from_rad = kSiteLeft_rad;
  s.horizontal_to_rad = kSiteRight_rad;
  s.vertical_from_rad = kSiteLow_rad;
  s.vertical_to_rad = kSiteHigh_rad;
  s.range_noise_m = 0.006;
  s.range_noise_ppm = 20;
  s.beam_diameter_m = 0.005;
  s.beam_divergence_rad = 0.0003;
  s.seed = seed;
  return s;
}

/// Scanned as the table of 3 says: day 3 with a window at 0.0277 degrees, day 4 at 0.18 degrees. The window belongs to
/// the one station of the day.
inline SiteDay site_day(int day) {
  Task task;
  const Model model = scene("earthworks", {{"day", static_cast<double>(day)}});
  SiteDay out;
  out.tree = TriangleTree::build(model.vertices, model.triangles, task);
  out.faces = model.triangle_faces;
  out.pose = site_pose(day);
  const ScanStation stations[] = {{"day " + std::to_string(day), out.pose}};
  const auto seed = static_cast<uint64_t>(100 + day);
  Cloud cloud = scanned(model, site_scanner(day == 4 ? 0.18 : 0.2, seed), stations);
  if (day == 3) {
    StaticSettings window = site_scanner(0.0277, seed + 50);
    window.horizontal_from_rad = -45 * kDegree_rad;
    window.horizontal_to_rad = -15 * kDegree_rad;
    window.vertical_from_rad = -15 * kDegree_rad;
    window.vertical_to_rad = 0;
    cloud = append(cloud, scanned(model, window, stations), task);
    cloud.stations = {cloud.stations[0]};
    cloud.stations[0].count = cloud.size();
  }
  out.cloud = std::make_shared<const Cloud>(std::move(cloud));
  return out;
}

inline const std::array<SiteDay, 4>& site_days() {
  static const std::array<SiteDay, 4> days{site_day(1), site_day(2), site_day(3), site_day(4)};
  return days;
}

}  // namespace jalon::test
