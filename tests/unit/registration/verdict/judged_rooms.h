// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Scans of a furnished room from two places, with all that the verdict needs.

#include "accuracy/registration_pairs.h"
#include "registration/verdict/sights.h"

namespace jalon::test {

struct JudgedScan {
  CloudPtr cloud;
  SurfacePlanes surface;
  Vec3 station;  ///< in the frame of the surface
  JudgedCloud judged;
};

inline std::shared_ptr<JudgedScan> judged_cloud_of(CloudPtr cloud) {
  Task task;
  auto out = std::make_shared<JudgedScan>();
  out->cloud = std::move(cloud);
  out->surface = surface_planes(out->cloud->octree(task), 16, task);
  out->judged = judged_cloud(*out->cloud, out->surface, {}, task);
  return out;
}

/// In the frame of the room, unturned, so that the right pose is a shift between the cubes of both.
inline std::shared_ptr<JudgedScan> judged_scan(const PairScene& scene, size_t standpoint,
                                               uint64_t seed, ScanSettings scanner = {}) {
  scanner.is_turned = false;
  auto out = judged_cloud_of(scan_from(scene, standpoint, scanner, seed).cloud);
  out->station = scene.standpoints[standpoint] - out->surface.tree->cube().origin;
  return out;
}

/// Between the frames of two surfaces, for clouds that lie right in one world.
inline Transform shift_between(const JudgedScan& to, const JudgedScan& from) {
  Transform out;
  const Vec3 shift = from.surface.tree->cube().origin - to.surface.tree->cube().origin;
  for (int axis = 0; axis < 3; ++axis) out.m[static_cast<size_t>(4 * axis + 3)] = shift[axis];
  return out;
}

}  // namespace jalon::test
