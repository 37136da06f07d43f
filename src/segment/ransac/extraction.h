// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "segment/ransac/hypotheses.h"
#include "segment/surface/connectivity.h"

namespace jalon {

/// A segment in the making, in the local frame.
struct Surface {
  Plane plane;
  Curved curved;  ///< a sphere or cylinder instead of the plane, where it exists
  double sigma_m = 0;
  double area_m2 = 0;
  double pixel_m = 0;
  std::vector<uint32_t> positions;  ///< in the octree's order
  Raster image =
      {};  ///< of them on the plane, with a margin of a pixel, from the fit to the sharing out; else empty

  /// What the rounds of sharing out points know of it.
  struct Sharing {
    static constexpr size_t kAll = ~size_t{0};
    uint32_t number = 0;  ///< as owner in the last round; 0 = it was in none
    bool fresh = true;    ///< plane or points are not those of that round
    size_t moved = kAll;  ///< points that came or went since its plane was fitted
  } sharing = {};

  bool is_plane() const { return !curved.exists(); }
  Surface without_points() const {
    Surface out;
    out.plane = plane;
    out.curved = curved;
    out.sigma_m = sigma_m;
    out.area_m2 = area_m2;
    out.pixel_m = pixel_m;
    return out;
  }
};

/// The surface's points on a flat map of it, in metres.
std::vector<Vec2> flat_points(const SegmentScene& scene, const Surface& surface, Task& task);

/// From a candidate to a surface: collect, keep the largest connected region, refit by least squares, until stable;
/// then the points of the surface are taken out of the pool and belong to owner_id. False when no region is large,
/// flat and dense enough.
bool extract_surface(RansacScene& scene, PointPool& pool, const OrientationPass& pass,
                     const Candidate& candidate, uint32_t owner_id, Task& task, Surface& out);

/// Sigma of the plane that the candidate settles on, taking nothing; infinite when it settles on none.
double settled_sigma(const RansacScene& scene, const PointPool& pool, const Candidate& candidate,
                     Task& task);

/// False when the points are so narrow a strip that noise, not the surface, turns the plane about its long side: a
/// single column of a scan is spread along the ray by the noise alone, and least squares follows that spread.
bool wide_enough(const SurfaceSettings& settings, const PlaneFit& fit);

/// True when the points are spread over the tolerance rather than about a plane.
bool too_rough(const SurfaceSettings& settings, double sigma_m);

/// Reach of a plane of this sigma: 3 sigma, between a tenth of the tolerance and the tolerance.
double core_reach(const SurfaceSettings& settings, double sigma_m);

}  // namespace jalon
