// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "base/random.h"
#include "segment/surface/connectivity.h"

using namespace jalon;

namespace {

void grid(std::vector<Vec2>& out, double u0, double v0, int columns, int rows) {
  for (int i = 0; i < columns; ++i)
    for (int k = 0; k < rows; ++k) out.push_back({u0 + 0.1 * i, v0 + 0.1 * k});
}

}  // namespace

TEST_CASE("the largest region is kept, with pieces across a gap and without") {
  std::vector<Vec2> points;
  grid(points, 0, 0, 20, 20);     // 400 pixels
  grid(points, 2.45, 0, 10, 20);  // 200 more behind a gap of 0.5 m
  grid(points, 9, 9, 18, 30);     // 540, alone
  CHECK(largest_region(points, {0.15, 0, 0.05, 0}).members.size() == 540);
  const Region joined = largest_region(points, {0.15, 0.7, 0.05, 0});
  CHECK(joined.members.size() == 600);
  CHECK(joined.members.front() == 0);
  CHECK(joined.area_m2 == doctest::Approx(6.0).epsilon(0.15));
}

TEST_CASE("fragments below the minimum area do not ride along") {
  std::vector<Vec2> points;
  grid(points, 0, 0, 20, 20);
  grid(points, 2.2, 0, 1, 2);  // 0.02 m2 at 0.3 m
  CHECK(largest_region(points, {0.15, 0.7, 0.05, 0}).members.size() == 400);
  CHECK(largest_region(points, {0.15, 0.7, 0, 0}).members.size() == 402);
}

TEST_CASE("the pixel follows the spacing but never falls below the tolerance") {
  SurfaceSettings settings;
  Task task;
  const auto pixel_of = [&](size_t n, float spacing) {
    return connectivity_pixel(
        settings, n, [&](size_t) { return spacing; }, task);
  };
  CHECK(pixel_of(0, 0) == settings.distance_tolerance_m);
  CHECK(pixel_of(50, 0.001f) == settings.distance_tolerance_m);
  CHECK(pixel_of(50, 0.1f) == doctest::Approx(0.2).scale(0));
  settings.pixel_m = 0.07;
  CHECK(pixel_of(50, 0.1f) == 0.07);
}

TEST_CASE("an image by all threads is that by one, pixel by pixel") {
  RandomStream random(4, 0);
  std::vector<Vec2> points;
  for (int i = 0; i < 100000; ++i)
    points.push_back({1e5 + 30 * random.uniform(), -7 + 9 * random.uniform()});
  grid(points, 1e5, 2, 30, 7);  // on borders of pixels
  for (const uint32_t threads : {1u, 3u})
    for (const uint32_t margin : {0u, 2u}) {
      Task::Hooks hooks;
      hooks.threads = threads;
      Task task(hooks);
      const Raster one = bounded_raster(points, 0.1, margin),
                   all = bounded_raster(points, 0.1, margin, task);
      CHECK(all.pixels == one.pixels);
      CHECK(all.columns == one.columns);
      CHECK(all.origin == one.origin);
      CHECK(all.pixel_m == one.pixel_m);
    }
}
