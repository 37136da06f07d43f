// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Method "raster_growing" on the facade of the comparison of 2006, and its parameters.
#include <doctest/doctest.h>

#include <cmath>

#include "unit/segment/plane_methods.h"
#include "unit/segment/same_bits.h"

using namespace jalon;
using namespace jalon::test;

namespace {

// The planes of the front and of the six windows are found, to a third of the noise.
void has_front_and_windows(const Scene& scene, const Segmentation& s) {
  for (int face = 1; face <= 7; ++face) {
    CAPTURE(face);
    const BestMatch match = best_match(scene, s, face);
    CHECK(match.share > 0.9);
    if (match.label == 0) continue;
    CHECK(largest_miss_m(scene, face, s.segments[match.label - 1], face == 1 ? 0 : 0.2) < 0.001);
  }
}

}  // namespace

TEST_CASE(
    "raster_growing__one_raster_finds_front_and_windows_and_loses_what_stands_upright_on_it") {
  const Scene scene = spec_facade(0.02, 31);
  for (const char* json :
       {"{\"projection\": \"main\", \"pixel_m\": 0.02}",
        "{\"projection\": \"main\", \"pixel_m\": 0.05}", "{\"projection\": \"given\"}"}) {
    CAPTURE(json);
    const Segmentation s = segment_by("raster_growing", cloud_of(scene.points), json);
    has_front_and_windows(scene, s);
    for (const Segment& segment : s.segments) CHECK(std::fabs(segment.fit.plane.normal.y) > 0.9);
  }
}

TEST_CASE("raster_growing__rasters_of_all_directions_find_the_upright_sides_too") {
  const Scene scene = spec_facade(0.02, 32);
  for (const char* json : {"{}", "{\"pixel_m\": 0.02}", "{\"pixel_m\": 0.05}",
                           "{\"returns\": \"median\"}", "{\"grey_bits\": 16}"}) {
    CAPTURE(json);
    const Segmentation s = segment_by("raster_growing", cloud_of(scene.points), json);
    has_front_and_windows(scene, s);
    for (int face = 8; face <= 10; ++face) CHECK(best_match(scene, s, face).share > 0.9);
  }
}

TEST_CASE("raster_growing__of_many_points__large_planes_on_wide_pixels_and_the_small_ones_too") {
  const Scene scene = spec_facade(0.0145, 36);
  REQUIRE(scene.points.size() > 300000);
  const auto cloud = cloud_of(scene.points);
  const Segmentation s = segment_by("raster_growing", cloud, "{}", 1);
  has_front_and_windows(scene, s);
  for (int face = 8; face <= 11; ++face) CHECK(best_match(scene, s, face).share > 0.9);
  check_same(s, segment_by("raster_growing", cloud, "{}", 7), false);
}

TEST_CASE("raster_growing__few_bits_lose_what_lies_within_a_step") {
  const Scene scene = spec_facade(0.03, 33);
  const auto cloud = cloud_of(scene.points);
  const auto finds_window = [&](const char* json) {
    const Segmentation s = segment_by("raster_growing", cloud, json);
    const BestMatch wall = best_match(scene, s, 1), window = best_match(scene, s, 2);
    return window.label != wall.label && window.share > 0.9;
  };
  CHECK(finds_window("{\"grey_bits\": 8}"));  // steps of 5 mm: 1.2 m of depth
  CHECK_FALSE(finds_window("{\"grey_bits\": 2}"));
}

TEST_CASE("raster_growing__refuses_a_direction_that_is_none") {
  const auto cloud = cloud_of(spec_facade(0.2, 34).points);
  for (const char* json : {"{\"projection\": \"given\", \"direction\": [0, 0, 0]}",
                           "{\"projection\": \"given\", \"direction\": [0, 1]}"})
    CHECK_THROWS_AS(segment_by("raster_growing", cloud, json), Error);
}
