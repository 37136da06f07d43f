// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/settle/surface_patch.h"

#include <algorithm>
#include <cmath>

#include "segment/settle/blocked_points.h"

namespace jalon {

namespace {

/// Places of a block's points, component by component, so that distances are found several at a time.
struct BlockPlaces {
  double x[kPointsPerBlock], y[kPointsPerBlock], z[kPointsPerBlock];

  BlockPlaces(const GridCoordinates& grid, const SharedBlock& block) {
    for (size_t i = 0; i < block.last - block.first; ++i) {
      x[i] = static_cast<double>(grid.x[block.first + i]) * grid.step_m;
      y[i] = static_cast<double>(grid.y[block.first + i]) * grid.step_m;
      z[i] = static_cast<double>(grid.z[block.first + i]) * grid.step_m;
    }
  }
  Vec3 at(size_t i) const { return {x[i], y[i], z[i]}; }

  /// From the first n points, unsigned.
  void distances(const SurfacePatch& patch, size_t n, double* out) const {
    if (patch.curved.exists()) {
      for (size_t i = 0; i < n; ++i) out[i] = std::fabs(patch.curved.distance(at(i)));
      return;
    }
    const Plane plane = patch.plane;
    for (size_t i = 0; i < n; ++i) out[i] = std::fabs(plane.distance(at(i)));
  }
};

/// Whether the patch reaches points of a block, of which most lie in the midst of their surface: that is asked once.
class BlockReach {
 public:
  BlockReach(const SurfacePatch& patch, const Box3& box, double slack_m)
      : patch_(patch), box_(box), slack_m_(slack_m) {}
  bool operator()(const Vec3& p) {
    if (known_ == kUnknown) known_ = patch_.reaches_all(box_, slack_m_) ? kAll : kSome;
    return known_ == kAll || patch_.reaches(p);
  }

 private:
  enum { kUnknown, kAll, kSome } known_ = kUnknown;
  const SurfacePatch& patch_;
  const Box3& box_;
  double slack_m_;
};

}  // namespace

bool SurfacePatch::reaches_all(const Box3& of_points, double slack_m) const {
  if (mask.size() == 0) return true;
  if (curved.exists()) return false;
  const FlatBox shadow = shadow_of(of_points, frame, slack_m);
  const auto cell = [&](double place, double from) { return (place - from) / mask.pixel_m; };
  const double left = cell(shadow.low.u, mask.origin.u), right = cell(shadow.high.u, mask.origin.u);
  const double low = cell(shadow.low.v, mask.origin.v), high = cell(shadow.high.v, mask.origin.v);
  if (!(left >= 0 && low >= 0 && right < mask.columns && high < mask.rows)) return false;
  const auto first = static_cast<size_t>(left), last = static_cast<size_t>(right);
  for (auto row = static_cast<size_t>(low); row <= static_cast<size_t>(high); ++row) {
    const uint8_t* pixels = mask.pixels.data() + row * mask.columns;
    for (size_t column = first; column <= last; ++column)
      if (pixels[column] == 0) return false;
  }
  return true;
}

void choose_owners(const SegmentScene& scene, const std::vector<SurfacePatch>& patches,
                   std::span<const uint32_t> near, const SharedBlock& block, uint32_t* owners) {
  const size_t n = block.last - block.first;
  std::fill_n(owners, n, 0u);
  if (near.empty()) return;
  const double tolerance_m = scene.settings.distance_tolerance_m, min_cosine = scene.min_cosine();
  const BlockPlaces places(scene.grid, block);
  double distances[kPointsPerBlock], costs[kPointsPerBlock];
  std::fill_n(costs, n, INFINITY);
  for (const uint32_t k : near) {
    const SurfacePatch& patch = patches[k];
    BlockReach reaches(patch, block.box, projection_slack_m(scene));
    places.distances(patch, n, distances);
    for (size_t i = 0; i < n; ++i) {
      const double distance = distances[i];
      if (distance > tolerance_m) continue;
      if (distance > patch.core_m && patch.inconsistent(scene, block.first + i, min_cosine))
        continue;
      const double cost = distance * distance * patch.weight + patch.evidence;
      if (!(cost < costs[i]) || !reaches(places.at(i))) continue;
      owners[i] = k + 1;
      costs[i] = cost;
    }
  }
}

}  // namespace jalon
