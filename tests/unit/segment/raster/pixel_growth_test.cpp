// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/raster/pixel_growth.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "unit/segment/made_scene.h"

using namespace jalon;

namespace {

// 40 x 20 pixels of 0.1 m seen from above; depth(u, v), NaN = empty.
template <class F>
DepthImage image_of(F&& depth) {
  DepthImage image;
  image.axes = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  image.pixel_m = 0.1;
  image.columns = 40;
  image.rows = 20;
  for (uint32_t r = 0; r < image.rows; ++r)
    for (uint32_t c = 0; c < image.columns; ++c) {
      const double u = 0.1 * (c + 0.5), v = 0.1 * (r + 0.5), g = depth(u, v);
      image.pixels.push_back({static_cast<float>(u), static_cast<float>(v),
                              static_cast<float>(std::isnan(g) ? 0 : g)});
      image.occupied.push_back(std::isnan(g) ? 0 : 1);
    }
  return image;
}

size_t pixels_of(const PixelRegions& regions, uint32_t label) {
  return static_cast<size_t>(std::count(regions.labels.begin(), regions.labels.end(), label));
}

}  // namespace

TEST_CASE("pixel_growth__parts_a_step_and_a_bend") {
  Task task;
  const PixelRule rule{.tolerance_m = 0.025};
  const PixelRegions step =
      grow_pixels(image_of([](double u, double) { return u < 2 ? 0.0 : 0.1; }), rule, task);
  REQUIRE(step.planes.size() == 2);
  CHECK(pixels_of(step, 1) == 400);
  CHECK(pixels_of(step, 2) == 400);
  const PixelRegions bend = grow_pixels(
      image_of([](double u, double) { return std::max(0.0, u - 2) * 0.5; }), rule, task);
  REQUIRE(bend.planes.size() == 2);
  CHECK(norm(cross(bend.planes[1].normal, normalized({-0.5, 0, 1}))) < 0.02);
}

TEST_CASE("pixel_growth__leaves_steep_planes_to_another_image") {
  Task task;
  const DepthImage image = image_of([](double u, double) { return 1.2 * u; });
  CHECK(grow_pixels(image, {.tolerance_m = 0.025}, task).planes.empty());
}

TEST_CASE("pixel_growth__crosses_empty_pixels_as_far_as_it_may") {
  Task task;
  const DepthImage image = image_of([](double u, double) { return u > 2 && u < 2.2 ? NAN : 0.0; });
  CHECK(grow_pixels(image, {.tolerance_m = 0.025, .reach_pixels = 2}, task).planes.size() == 2);
  CHECK(grow_pixels(image, {.tolerance_m = 0.025, .reach_pixels = 3}, task).planes.size() == 1);
}

TEST_CASE("pixel_growth__keeps_no_region_below_the_least") {
  Task task;
  const DepthImage image =
      image_of([](double u, double v) { return u < 0.5 && v < 0.5 ? 0.0 : NAN; });
  CHECK(grow_pixels(image, {.tolerance_m = 0.025, .least_pixels = 25}, task).planes.size() == 1);
  CHECK(grow_pixels(image, {.tolerance_m = 0.025, .least_pixels = 26}, task).planes.empty());
}
