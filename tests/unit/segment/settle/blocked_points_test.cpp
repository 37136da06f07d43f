// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/settle/blocked_points.h"

#include <doctest/doctest.h>

#include "unit/segment/made_scene.h"

using namespace jalon;
using namespace jalon::test;

namespace {

// The whole image, and all points on it one by one.
size_t over_by_definition(const SegmentScene& scene, const std::vector<uint32_t>& points,
                          const std::vector<uint32_t>& image, const FlatFrame& frame,
                          double pixel_m, uint32_t reach) {
  std::vector<Vec2> uv;
  for (const uint32_t position : image) uv.push_back(frame(scene.local(position)));
  const Raster raster = dilated(bounded_raster(uv, pixel_m, reach), reach);
  size_t over = 0;
  for (const uint32_t position : points) over += raster.holds(frame(scene.local(position)));
  return over;
}

// A wall, another beside it and one that runs into both, apart by the gap.
Scene walls(uint64_t seed, double gap_m) {
  Scene out;
  RandomStream random(seed, 7);
  out.rectangle(1, {0, 0, 0}, {2, 0.3, 0}, {0, 0.1, 2}, 3000, 0.01, random);
  out.rectangle(2, {2 + gap_m, 0.3, 0.4}, {1, 0.1, 0}, {0, 0, 1}, 700, 0.01, random);
  out.rectangle(3, {0.7, gap_m, 0.5}, {0, 2, 0}, {0, 0, 1}, 900, 0.01, random);
  return out;
}

}  // namespace

TEST_CASE("blocked_points__lie_over_as_the_whole_image_says") {
  for (const uint64_t seed : {1, 2, 3})
    for (const double gap_m : {0.0, 0.15, 0.5}) {
      const Scene scene = walls(seed, gap_m);
      MadeScene made(scene.points);
      const auto surfaces = made.surfaces(scene.faces, 3);
      for (size_t a = 0; a < 3; ++a)
        for (size_t b = 0; b < 3; ++b)
          for (const uint32_t reach : {0u, 1u, 4u}) {
            CAPTURE(seed);
            CAPTURE(a);
            CAPTURE(b);
            CAPTURE(reach);
            const FlatFrame frame =
                plane_frame(surfaces[a].plane, made.scene.local(surfaces[a].positions[0]));
            const size_t over =
                over_by_definition(made.scene, surfaces[b].positions, surfaces[a].positions, frame,
                                   surfaces[a].pixel_m, reach);
            const BlockedPoints image(made.scene, surfaces[a].positions, made.task),
                points(made.scene, surfaces[b].positions, made.task);
            const auto at_least = [&](size_t least) {
              return lie_over(made.scene, points, least, image, frame, surfaces[a].pixel_m, reach);
            };
            CHECK(at_least(over));
            CHECK_FALSE(at_least(over + 1));
          }
    }
}

TEST_CASE("blocked_points__those_taken_count_as_own") {
  const Scene scene = walls(4, 0.2);
  MadeScene made(scene.points);
  const auto surfaces = made.surfaces(scene.faces, 3);
  BlockedPoints joined(made.scene, surfaces[1].positions, made.task);
  joined.take(BlockedPoints(made.scene, surfaces[0].positions, made.task));
  CHECK(joined.size() == 3700);
  CHECK(joined.first_position() == std::min(surfaces[0].positions[0], surfaces[1].positions[0]));
  const FlatFrame frame = plane_frame(surfaces[0].plane, made.scene.local(0));
  const BlockedPoints own(made.scene, surfaces[0].positions, made.task);
  CHECK(lie_over(made.scene, own, own.size(), joined, frame, 0.1, 0));
  CHECK_FALSE(lie_over(made.scene, own, own.size(),
                       BlockedPoints(made.scene, surfaces[2].positions, made.task), frame, 0.1, 0));
}
