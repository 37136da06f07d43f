// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/settle/surface_patch.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "segment/settle/blocked_points.h"
#include "unit/segment/made_scene.h"

using namespace jalon;
using namespace jalon::test;

namespace {

// Two walls that cross and a third, little off the first one, so that many points have a choice.
Scene crossing_walls(uint64_t seed) {
  Scene out;
  RandomStream random(seed, 11);
  out.rectangle(1, {0, 0, 0}, {2, 0.3, 0}, {0, 0.1, 2}, 4000, 0.01, random);
  out.rectangle(2, {0.7, -0.5, 0.5}, {0, 1.5, 0}, {0, 0, 1}, 1500, 0.01, random);
  out.rectangle(3, {0.5, 0.09, 0.2}, {1, 0.15, 0}, {0, 0.05, 1}, 1200, 0.01, random);
  return out;
}

std::vector<SurfacePatch> patches_of(const MadeScene& made, const std::vector<Surface>& surfaces) {
  std::vector<SurfacePatch> patches;
  for (const Surface& surface : surfaces) {
    SurfacePatch patch;
    patch.plane = surface.plane;
    patch.core_m = 0.015;
    patch.weight = 1e4 * static_cast<double>(patches.size() + 1);
    patch.evidence = -0.5 * static_cast<double>(patches.size());
    patch.frame = plane_frame(surface.plane, made.scene.local(surface.positions[0]));
    std::vector<Vec2> uv;
    for (const uint32_t position : surface.positions)
      uv.push_back(patch.frame(made.scene.local(position)));
    patch.mask = dilated(bounded_raster(uv, surface.pixel_m, 1), 1);
    patches.push_back(patch);
  }
  return patches;
}

uint32_t owner_by_definition(const SegmentScene& scene, const std::vector<SurfacePatch>& patches,
                             size_t position) {
  const Vec3 p = scene.local(position);
  uint32_t best = 0;
  double least = INFINITY;
  for (uint32_t k = 0; k < patches.size(); ++k) {
    const SurfacePatch& patch = patches[k];
    const double distance = std::fabs(patch.plane.distance(p));
    if (distance > scene.settings.distance_tolerance_m || !patch.reaches(p)) continue;
    if (distance > patch.core_m && patch.inconsistent(scene, position, scene.min_cosine()))
      continue;
    const double cost = distance * distance * patch.weight + patch.evidence;
    if (cost < least) best = k + 1, least = cost;
  }
  return best;
}

Box3 box_of(const SegmentScene& scene, size_t first, size_t last) {
  Box3 box;
  for (size_t i = first; i < last; ++i) box.add(scene.local(i));
  return box;
}

}  // namespace

TEST_CASE("surface_patch__owners_of_a_block_are_those_of_its_points_one_by_one") {
  for (const uint64_t seed : {1, 2, 3}) {
    const Scene scene = crossing_walls(seed);
    MadeScene made(scene.points);
    const auto patches = patches_of(made, made.surfaces(scene.faces, 3));
    const std::vector<uint32_t> near{0, 1, 2};
    std::vector<size_t> count(4, 0);
    for (size_t first = 0; first < made.scene.size(); first += kPointsPerBlock) {
      const size_t last = std::min(made.scene.size(), first + kPointsPerBlock);
      const Box3 box = box_of(made.scene, first, last);
      uint32_t owners[kPointsPerBlock];
      choose_owners(made.scene, patches, near, {first, last, box}, owners);
      for (size_t i = first; i < last; ++i) {
        CAPTURE(i);
        REQUIRE(owners[i - first] == owner_by_definition(made.scene, patches, i));
        ++count[owners[i - first]];
      }
    }
    for (uint32_t k = 1; k < 4; ++k) CHECK(count[k] > 100);
  }
}

TEST_CASE("surface_patch__reaches_all_of_a_box_only_when_it_reaches_each_point") {
  const Scene scene = crossing_walls(4);
  MadeScene made(scene.points);
  const auto patches = patches_of(made, made.surfaces(scene.faces, 3));
  size_t whole = 0, part = 0;
  for (const SurfacePatch& patch : patches)
    for (size_t first = 0; first + 8 <= made.scene.size(); first += 8) {
      const Box3 box = box_of(made.scene, first, first + 8);
      const bool all = patch.reaches_all(box, projection_slack_m(made.scene));
      ++(all ? whole : part);
      for (size_t i = first; all && i < first + 8; ++i) REQUIRE(patch.reaches(made.scene.local(i)));
    }
  CHECK(whole > 100);
  CHECK(part > 100);
}

TEST_CASE("surface_patch__without_a_mask_reaches_everything") {
  CHECK(SurfacePatch{}.reaches_all({{0, 0, 0}, {1e6, 1e6, 1e6}}, 0));
}
