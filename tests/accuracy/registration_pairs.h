// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Pairs of scans whose pose is known, and pairs that have none.

#include <functional>
#include <string>

#include "accuracy/pair_scenes.h"
#include "cloud/cloud.h"
#include "geometry/rigid_motion.h"

namespace jalon::test {

/// What a scanner measures from a standpoint, in a frame of its own.
struct StandScan {
  CloudPtr cloud;
  Transform T_world_scan;
};

struct ScanSettings {
  size_t points = 20000;
  double noise_m = 0.004;
  bool is_turned =
      true;          ///< the frame of the scan is turned and shifted at random; else the world's
  double scale = 1;  ///< of the coordinates
  bool is_mirrored = false;
};

inline StandScan scan_from(const PairScene& scene, size_t standpoint, const ScanSettings& settings,
                           uint64_t seed) {
  Task task;
  const auto tree = TriangleTree::build(scene.vertices, scene.triangles, task);
  RandomStream random(seed, 100 + standpoint);
  const Vec3 from = scene.standpoints[standpoint];
  Transform T_scan_world;
  if (settings.is_turned)
    T_scan_world = motion_about(from, {0, 0, between(random, -3.1, 3.1)},
                                Vec3{between(random, -9, 9), between(random, -9, 9), 0} - from);
  Buffer<double> xyz(3 * settings.points);
  size_t n = 0;
  for (size_t tries = 0; n < settings.points && tries < 40 * settings.points; ++tries) {
    // Even steps of both angles, as scanners turn; none straight below.
    const double turn = 2 * std::numbers::pi * random.uniform(), up = between(random, -1.1, 1.4);
    const Vec3 d{std::cos(turn) * std::cos(up), std::sin(turn) * std::cos(up), std::sin(up)};
    RayHit hit;
    if (!tree->nearest({from, d, 0.3, scene.range_m}, hit)) continue;
    Vec3 p = T_scan_world.point(from + d * (hit.t + settings.noise_m * random.normal()));
    if (settings.is_mirrored) p.x = -p.x;
    p = p * settings.scale;
    for (int c = 0; c < 3; ++c) xyz[3 * n + static_cast<size_t>(c)] = p[c];
    ++n;
  }
  Buffer<double> kept(3 * n);
  std::copy(xyz.data(), xyz.data() + 3 * n, kept.data());
  return {std::make_shared<const Cloud>(make_cloud(std::move(kept))), inverse(T_scan_world)};
}

}  // namespace jalon::test
