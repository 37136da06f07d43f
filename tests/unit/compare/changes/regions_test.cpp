// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

#include "base/random.h"
#include "compare/changes/regions.h"
#include "compare/distance/distance.h"

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
  for (size_t i = 0; i < plate.xyz.size(); ++i)
    xyz.data()[i] = plate.xyz[i] + shift[static_cast<int>(i % 3)];
  Comparison made;
  made.cloud = std::make_shared<const Cloud>(make_cloud(std::move(xyz)));
  made.points.set(
      make_column<double>({"distance", ElementType::kFloat64, 1, "m", ""}, plate.distance));
  return made;
}

// 10 x 10 m of ground with two lifted squares of 1 m2 and 4 m2, far from each other, at random places.
Plate two_squares(uint64_t seed) {
  RandomStream random(seed, 0);
  Plate plate;
  for (int i = 0; i < 100000; ++i) {
    const double x = 10 * random.uniform(), y = 10 * random.uniform();
    const bool small = x > 1 && x < 2 && y > 1 && y<2, large = x> 5 && x < 7 && y > 5 && y < 7;
    const double d = small ? -0.1 : large ? 0.3 : 0.004;
    plate.add(x, y, d, d);
  }
  return plate;
}

ChangeRegions regions_of(const Comparison& comparison, unsigned threads = 1,
                         double threshold_m = 0.05, const Cloud* reference = nullptr) {
  RegionSettings settings;
  settings.threshold_m = threshold_m;
  Task::Hooks hooks;
  hooks.threads = threads;
  Task task(hooks);
  return change_regions(comparison, settings, task, reference);
}

using Height = double (*)(double x, double y);

// 20 x 12 m of a slope with what lies on it or is missing, at random places, 3 mm of noise, against that slope.
double slope(double x, double y) { return 100 + 0.2 * x - 0.1 * y; }
CloudPtr terrain(Height height, uint64_t seed) {
  RandomStream random(seed, 0);
  Plate plate;
  for (int i = 0; i < 200000; ++i) {
    const double x = 20 * random.uniform(), y = 12 * random.uniform();
    plate.add(x, y, slope(x, y) + height(x, y) + 0.003 * random.normal(), 0);
  }
  return comparison_of(plate).cloud;
}
Comparison compared(Height height, uint64_t seed, CloudPtr& reference) {
  reference = terrain([](double, double) { return 0.0; }, seed);
  DistanceSettings settings;
  settings.local_model = LocalModelKind::kPlane;
  Task task;
  return compare_distance(reference, terrain(height, seed + 1), settings, task);
}
double heap(double x, double y) { return std::max(0.0, 1 - std::hypot(x - 5, y - 6) / 3); }
double pit(double x, double y) {
  return -0.8 * std::max(0.0, 1 - (std::pow(x - 14, 2) + std::pow(y - 6, 2)) / 9);
}
double slab(double x, double y) { return x > 6 && x < 12 && y > 3 && y < 8 ? 0.1 : 0; }

// A box of 1 x 1 x 2 m on a floor of 5 x 5 m, all but its underside, 5000 points a m2.
Plate standing_box(bool with_box) {
  RandomStream random(7, with_box ? 1 : 0);
  Plate plate;
  const auto add = [&](double width, double height, auto&& at) {
    for (int i = 0; i < 5000 * width * height; ++i) {
      const double along = width * random.uniform(), up = height * random.uniform();
      const Vec3 p = at(along, up);
      plate.add(p.x, p.y, p.z, 0);
    }
  };
  add(5, 5, [&](double u, double v) {
    const bool under = with_box && u > 2 && u < 3 && v > 2 && v < 3;
    return under ? Vec3{u, v, 2} : Vec3{u, v, 0};
  });
  if (!with_box) return plate;
  add(1, 2, [](double u, double v) { return Vec3{2 + u, 2, v}; });
  add(1, 2, [](double u, double v) { return Vec3{2 + u, 3, v}; });
  add(1, 2, [](double u, double v) { return Vec3{2, 2 + u, v}; });
  add(1, 2, [](double u, double v) { return Vec3{3, 2 + u, v}; });
  return plate;
}

}  // namespace

TEST_CASE("regions__volumes_of_a_heap_a_pit_and_a_slab_are_right_to_three_percent") {
  struct Row {
    const char* name;
    Height height;
    double volume_m3;
  };
  // On a slope distances are across, and so is the height of what lies on it.
  const Row rows[] = {{"heap", heap, std::numbers::pi * 9 / 3},
                      {"pit", pit, 0.8 * std::numbers::pi * 9 / 2},
                      {"slab", slab, 6 * 5 * 0.1}};
  for (const Row& row : rows) {
    CloudPtr reference;
    const Comparison plain = compared(row.height, 11, reference);
    const ChangeRegions told = regions_of(plain, 2, 0.02, reference.get()),
                        alone = regions_of(plain, 2, 0.02);
    REQUIRE(told.regions.size() >= 1);
    const double by_points = told.regions[0].volume_m3, by_plane = alone.regions[0].volume_m3;
    MESSAGE("FIGURE volume of a " << std::string(row.name) << " of " << row.volume_m3
                                  << " m3: " << by_points << " by nearest points, " << by_plane
                                  << " by its plane");
    CHECK(std::abs(by_points / row.volume_m3 - 1) < 0.03);  // at steps the discs lean
    CHECK(std::abs(by_plane / row.volume_m3 - 1) < 0.015);
  }
}

TEST_CASE("regions__volume_of_a_standing_box_is_that_below_its_top") {
  const Comparison before = comparison_of(standing_box(false)),
                   after = comparison_of(standing_box(true));
  Task task;
  const Comparison made = compare_distance(before.cloud, after.cloud, {}, task);
  const ChangeRegions found = regions_of(made, 1, 0.05, before.cloud.get());
  REQUIRE(found.regions.size() == 1);
  MESSAGE("FIGURE volume of a standing box of 2 m3: " << found.regions[0].volume_m3);
  CHECK(std::abs(found.regions[0].volume_m3 / 2 - 1) < 0.03);
}

TEST_CASE("regions__finds_two_lifted_squares_with_area_distance_and_box") {
  const ChangeRegions found = regions_of(comparison_of(two_squares(1)));
  REQUIRE(found.regions.size() == 2);
  MESSAGE("FIGURE areas of squares of 4 and 1 m2: " << found.regions[0].area_m2 << ", "
                                                    << found.regions[1].area_m2);
  CHECK(found.regions[0].area_m2 == doctest::Approx(4).epsilon(0.03).scale(0));
  CHECK(found.regions[1].area_m2 == doctest::Approx(1).epsilon(0.05).scale(0));
  CHECK(found.regions[0].mean_m == doctest::Approx(0.3));
  CHECK(found.regions[1].extreme_m == doctest::Approx(-0.1).scale(0));
  CHECK(found.regions[0].box.min.x == doctest::Approx(5).epsilon(0.01).scale(0));
  CHECK(found.regions[0].box.max.y == doctest::Approx(7).epsilon(0.01).scale(0));
  CHECK(norm(found.regions[0].centroid - Vec3{6, 6, 0.3}) < 0.02);
}

TEST_CASE("regions__are_the_same_for_any_threads_and_on_a_national_grid") {
  const Plate plate = two_squares(2);
  const ChangeRegions here = regions_of(comparison_of(plate));
  const ChangeRegions threads = regions_of(comparison_of(plate), 3);
  CHECK(here.labels == threads.labels);
  CHECK(here.regions[0].area_m2 == threads.regions[0].area_m2);
  CHECK(here.regions[0].centroid == threads.regions[0].centroid);
  Plate snapped = plate;
  for (double& v : snapped.xyz) v = std::round(v * 1024) / 1024;
  const ChangeRegions local = regions_of(comparison_of(snapped));
  const ChangeRegions grid = regions_of(comparison_of(snapped, {652000, 6861000, 100}));
  CHECK(local.labels == grid.labels);
  CHECK(local.regions[0].area_m2 == grid.regions[0].area_m2);
}

TEST_CASE("regions__of_an_unchanged_cloud_are_none_and_small_ones_are_dropped") {
  Plate plate;
  for (int i = 0; i < 100; ++i) plate.add(i, 0, 0, 0.001);
  CHECK(regions_of(comparison_of(plate)).regions.empty());
  for (int i = 0; i < 9; ++i) plate.add(200 + 0.01 * i, 0, 0, 1);
  const ChangeRegions found = regions_of(comparison_of(plate));
  CHECK(found.regions.empty());
  CHECK(found.changed[105] == 1);
  CHECK(found.labels[105] == 0);
}
