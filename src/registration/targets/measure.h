// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "base/error.h"
#include "base/numbers.h"
#include "base/params.h"
#include "cloud/cloud.h"
#include "geometry/cholesky.h"
#include "registration/targets/settings.h"

namespace jalon {

/// How a centre was found; the numbers of jalon/targets.h.
enum class TargetKind : uint8_t { kSphere = 1, kChecker = 2, kDisc = 3, kPatch = 4 };

/// A target measured in a cloud, relative to the place it was looked for.
struct MeasuredTarget {
  Status status =
      Status::kOk;  ///< kOk, kInsufficientData (too few points), kDegenerate (no target in them)
  TargetKind kind = TargetKind::kSphere;
  Vec3 centre;
  Square<3> covariance{};                         ///< m2
  double radius_m = kNaN, radius_sigma_m = kNaN;  ///< of spheres and discs
  Vec3 normal{kNaN, kNaN, kNaN};                  ///< of flat ones
  double sigma_m = kNaN;                          ///< of the points from the surface
  uint64_t points = 0;                            ///< that carry it
};

/// Points around a place, relative to it, in the order of the cloud.
struct Surroundings {
  Vec3 place;
  std::vector<uint32_t> indices;
  std::vector<Vec3> points;
};
/// Those within radius_m of place + centre. centre: relative to the place as well.
Surroundings surroundings_of(const Cloud& cloud, const Octree& tree, const Vec3& place,
                             const Vec3& centre, double radius_m);

/// Parameter table of operation "target".
std::span<const ParamRow> target_rows();
/// A row a measured target, each relative to its place.
FieldTable measured_table(const std::vector<MeasuredTarget>& rows, std::span<const Vec3> places);
/// A row a place, or a target of the catalogue: see jalon/targets.h. Places must be finite.
FieldTable measure_targets(const Cloud& cloud, std::span<const Vec3> places,
                           const MeasuringSettings& settings, Task& task);

}  // namespace jalon
