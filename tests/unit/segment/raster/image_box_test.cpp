// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/raster/image_box.h"

#include <doctest/doctest.h>

#include <numeric>

#include "unit/segment/made_scene.h"

using namespace jalon;
using namespace jalon::test;

namespace {

const ImageAxes kDownward{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
constexpr double kBoxPixel_m = 0.05;

Scene floor_of(double edge_m, size_t points) {
  Scene scene;
  RandomStream random(8, 3);
  scene.rectangle(1, {0, 0, 0}, {edge_m, 0, 0}, {0, edge_m, 0}, points, 0.002, random);
  return scene;
}

std::vector<uint32_t> far_of(MadeScene& made) {
  std::vector<uint32_t> all(made.scene.size());
  std::iota(all.begin(), all.end(), 0u);
  return far_candidates(made.scene, all, kDownward, kBoxPixel_m, made.task);
}

}  // namespace

TEST_CASE("far_candidates__are_the_stray_points_for_which_the_image_had_wider_pixels") {
  Scene scene = floor_of(4, 16000);
  for (const Vec3& stray : {Vec3{5000, 0, 0}, Vec3{0, -90, 3}, Vec3{2, 2, 4000}}) {
    scene.points.push_back(stray);
    scene.faces.push_back(2);
  }
  MadeScene made(scene.points);
  const std::vector<uint32_t> far = far_of(made);
  REQUIRE(far.size() == 3);
  CHECK(std::ranges::is_sorted(far));
  for (const uint32_t i : far) CHECK(scene.faces[made.point(i)] == 2);
  made.scene.owner[far[1]] = 1;
  CHECK(far_of(made).size() == 2);
}

TEST_CASE("far_candidates__are_none_where_all_fit_into_one_image_or_all_are_wide_apart") {
  Scene near = floor_of(4, 16000);
  near.points.push_back({9, 0, 0});
  MadeScene small(near.points);
  CHECK(far_of(small).empty());
  MadeScene wide(floor_of(400, 16000).points);
  CHECK(far_of(wide).empty());
  std::ranges::fill(small.scene.owner, 1u);
  CHECK(far_of(small).empty());
}
