// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <doctest/doctest.h>

#include "base/random.h"
#include "compare/regions.h"

using namespace jalon;

namespace {

struct Plate {
  std::vector<double> xyz, distance;
  void add(double x, double y, double z, double d) {
    xyz.insert(xyz.end(), {x, y, z});
    distance.push_back(d);
  }
};

Comparison comparison_of(const Plate& plate, const Vec3& shift = {}) {
  Buffer<double> xyz(plate.xyz.size());
  for (size_t i = 0; i < plate.xyz.size(); ++i) xyz.data()[i] = plate.xyz[i] + shift[static_cast<int>(i % 3)];
  Comparison made;
  made.cloud = std::make_shared<const Cloud>(make_cloud(std::move(xyz)));
  made.points.set(make_column<double>({"distance", ElementType::kFloat64, 1, "m", ""}, plate.distance));
  return made;
}

// 10 x 10 m of ground with two lifted squares of 1 m2 and 4 m2, far from each other, at random places.
Plate two_squares(uint64_t seed) {
  RandomStream random(seed, 0);
  Plate plate;
  for (int i = 0; i < 100000; ++i) {
    const double x = 10 * random.uniform(), y = 10 * random.uniform();
    const bool small = x > 1 && x < 2 && y > 1 && y < 2, large = x > 5 && x < 7 && y > 5 && y < 7;
    const double d = small ? -0.1 : large ? 0.3 : 0.004;
    plate.add(x, y, d, d);
  }
  return plate;
}

Regions regions_of(const Comparison& comparison, unsigned threads = 1) {
  ParamSet options("regions", regions_rows());
  Task::Hooks hooks;
  hooks.threads = threads;
  Task task(hooks);
  return change_regions(comparison, options, task);
}

}  // namespace

TEST_CASE("regions__finds_two_lifted_squares_with_area_distance_and_box") {
  const Regions found = regions_of(comparison_of(two_squares(1)));
  REQUIRE(found.regions.size() == 2);
  MESSAGE("FIGURE areas of squares of 4 and 1 m2: " << found.regions[0].area_m2 << ", " << found.regions[1].area_m2);
  CHECK(found.regions[0].area_m2 == doctest::Approx(4).epsilon(0.03));
  CHECK(found.regions[1].area_m2 == doctest::Approx(1).epsilon(0.05));
  CHECK(found.regions[0].mean_m == doctest::Approx(0.3));
  CHECK(found.regions[1].extreme_m == doctest::Approx(-0.1));
  CHECK(found.regions[0].box.min.x == doctest::Approx(5).epsilon(0.01));
  CHECK(found.regions[0].box.max.y == doctest::Approx(7).epsilon(0.01));
  CHECK(norm(found.regions[0].centroid - Vec3{6, 6, 0.3}) < 0.02);
}

TEST_CASE("regions__are_the_same_for_any_threads_and_on_a_national_grid") {
  const Plate plate = two_squares(2);
  const Regions here = regions_of(comparison_of(plate));
  const Regions threads = regions_of(comparison_of(plate), 3);
  CHECK(here.labels == threads.labels);
  CHECK(here.regions[0].area_m2 == threads.regions[0].area_m2);
  CHECK(here.regions[0].centroid == threads.regions[0].centroid);
  Plate snapped = plate;
  for (double& v : snapped.xyz) v = std::round(v * 1024) / 1024;
  const Regions local = regions_of(comparison_of(snapped));
  const Regions grid = regions_of(comparison_of(snapped, {652000, 6861000, 100}));
  CHECK(local.labels == grid.labels);
  CHECK(local.regions[0].area_m2 == grid.regions[0].area_m2);
}

TEST_CASE("regions__of_an_unchanged_cloud_are_none_and_small_ones_are_dropped") {
  Plate plate;
  for (int i = 0; i < 100; ++i) plate.add(i, 0, 0, 0.001);
  CHECK(regions_of(comparison_of(plate)).regions.empty());
  for (int i = 0; i < 9; ++i) plate.add(200 + 0.01 * i, 0, 0, 1);
  const Regions found = regions_of(comparison_of(plate));
  CHECK(found.regions.empty());
  CHECK(found.changed[105] == 1);
  CHECK(found.labels[105] == 0);
}
