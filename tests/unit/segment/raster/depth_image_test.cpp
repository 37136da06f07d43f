// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/raster/depth_image.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "unit/segment/made_scene.h"

using namespace jalon;
using namespace jalon::test;

namespace {

const ImageAxes kDown{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};  // seen from above

// A floor on a grid of 0.1 m and a table 1 m above a part of it, one point of it in the floor's place too.
std::vector<Vec3> floor_and_table() {
  std::vector<Vec3> points;
  const auto at = [](int i) { return 0.1 * i + (i == 0 ? 0 : 0.03); };  // on no pixel's border
  for (int i = 0; i < 20; ++i)
    for (int k = 0; k < 10; ++k) points.push_back({at(i), at(k), 0});
  for (int i = 0; i < 5; ++i)
    for (int k = 0; k < 5; ++k) points.push_back({at(i), at(k), 1});
  return points;
}

size_t at_depth(const DepthImage& image, float depth) {
  size_t count = 0;
  for (size_t p = 0; p < image.size(); ++p)
    count += image.occupied[p] != 0 && std::abs(image.pixels[p].g - depth) < 1e-4f;
  return count;
}

}  // namespace

TEST_CASE("depth_image__shows_the_nearest_or_the_middle_return") {
  MadeScene made(floor_and_table());
  RasterSettings settings;
  const DepthImage nearest = depth_image(made.scene, settings, kDown, 0.1, made.task);
  CHECK(std::count(nearest.occupied.begin(), nearest.occupied.end(), 1) == 200);
  CHECK(at_depth(nearest, 1) == 25);
  CHECK(at_depth(nearest, 0) == 175);
  settings.returns = PixelReturn::kMedian;
  const DepthImage middle = depth_image(made.scene, settings, kDown, 0.1, made.task);
  CHECK(at_depth(middle, 1) == 25);  // of two returns the nearer one
  const ImageAxes below{{1, 0, 0}, {0, 1, 0}, {0, 0, -1}};
  settings.returns = PixelReturn::kNearest;
  CHECK(at_depth(depth_image(made.scene, settings, below, 0.1, made.task), 0) == 200);
}

TEST_CASE("depth_image__grey_values_of_few_bits_are_steps_of_the_depth") {
  MadeScene made(floor_and_table());
  RasterSettings settings;
  settings.grey_bits = 2;
  const DepthImage image = depth_image(made.scene, settings, kDown, 0.1, made.task);
  CHECK(image.quantum_m == doctest::Approx(1.0 / 3));
  for (size_t p = 0; p < image.size(); ++p) {
    if (image.occupied[p] == 0) continue;
    const double steps = static_cast<double>(image.pixels[p].g) / image.quantum_m;
    CHECK(steps == doctest::Approx(std::round(steps)).epsilon(1e-5));
  }
}

TEST_CASE("depth_image__knows_free_points_only_and_no_more_pixels_than_they_pay_for") {
  MadeScene made(floor_and_table());
  const DepthImage fine = depth_image(made.scene, {}, kDown, 1e-5, made.task);
  CHECK(fine.size() <= (1u << 16));
  CHECK(fine.pixel_m > 1e-5);
  for (auto& owner : made.scene.owner) owner = 1;
  CHECK(depth_image(made.scene, {}, kDown, 0.1, made.task).size() == 0);
}

TEST_CASE("image_pixel__is_the_users_or_by_the_spacing") {
  MadeScene made(floor_and_table());
  for (auto& spacing : made.scene.spacing) spacing = 0.1f;
  CHECK(image_pixel_m(made.scene) == doctest::Approx(0.14));
  made.scene.settings.pixel_m = 0.07;
  CHECK(image_pixel_m(made.scene) == 0.07);
}
