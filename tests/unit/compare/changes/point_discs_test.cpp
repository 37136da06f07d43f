// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Discs of points, against the area and the normal of the surfaces that the points were drawn on.
#include "compare/changes/point_discs.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>

#include "spatial/voxels/components.h"
#include "unit/cloud/clouds.h"

using namespace jalon;
using namespace jalon::test;

namespace {

std::vector<PointDisc> discs_of(const Cloud& cloud, const std::vector<uint64_t>& rows) {
  Task task;
  return point_discs(cloud, rows, task);
}

std::vector<uint64_t> all_of(const Cloud& cloud) {
  std::vector<uint64_t> rows(cloud.size());
  std::iota(rows.begin(), rows.end(), uint64_t{0});
  return rows;
}

double area_of(const std::vector<PointDisc>& discs) {
  double sum = 0;
  for (const PointDisc& disc : discs) sum += disc.area_m2();
  return sum;
}

// n points of a rectangle of this size in a plane that leans by 3 in 4.
std::vector<Vec3> leaning(size_t n, double width, double length, uint64_t seed) {
  RandomStream random(seed, 0);
  std::vector<Vec3> points;
  for (size_t i = 0; i < n; ++i) {
    const double u = width * random.uniform(), v = length * random.uniform();
    points.push_back({u, 0.8 * v, 0.6 * v});
  }
  return points;
}

}  // namespace

TEST_CASE("point_discs__add_up_to_the_area_and_stand_across_the_normal") {
  // The 16 neighbours of a point scatter its area by a quarter and those of 16 points are much the same: 1 / sqrt(n)
  // of the sum, 1 %; three times, and 0.3 % of the law for random places.
  const Cloud random = cloud_of(leaning(10000, 4, 3, 1));
  const auto discs = discs_of(random, all_of(random));
  CHECK(area_of(discs) == doctest::Approx(12).epsilon(0.033).scale(0));
  double worst = 0;
  for (const PointDisc& disc : discs)
    worst = std::max(worst, 1 - std::abs(dot(disc.normal(), Vec3{0, -0.6, 0.8})));
  CHECK(worst < 1e-6);  // float
  std::vector<Vec3> square;
  for (int i = 0; i < 60; ++i)
    for (int j = 0; j < 60; ++j) square.push_back({0.5 * i, 0.5 * j, 1});
  const Cloud lattice = cloud_of(square);
  // Inside: the disc of each is its cell of the lattice.
  const auto middle = discs_of(lattice, {60 * 30 + 30, 60 * 15 + 40});
  for (const PointDisc& disc : middle)
    CHECK(disc.area_m2() == doctest::Approx(0.25).epsilon(0.005).scale(0));
}

TEST_CASE("point_discs__are_those_of_the_whole_cloud_and_grow_with_it") {
  std::vector<Vec3> points = leaning(4000, 4, 3, 2);
  const Cloud whole = cloud_of(points);
  const auto all = discs_of(whole, all_of(whole));
  const std::vector<uint64_t> rows = {7, 3999, 100, 0};
  const auto some = discs_of(whole, rows);
  for (size_t i = 0; i < rows.size(); ++i) {
    CHECK(some[i].radius_m == all[rows[i]].radius_m);
    CHECK(some[i].across == all[rows[i]].across);
  }
  for (Vec3& p : points) p *= 4;  // a power of two: the same digits
  const Cloud large = cloud_of(points);
  const auto grown = discs_of(large, all_of(large));
  for (size_t i = 0; i < all.size(); ++i) REQUIRE(grown[i].radius_m == 4 * all[i].radius_m);
}

TEST_CASE("point_discs__of_one_point_two_and_a_line_have_no_normal") {
  const Cloud one = cloud_of({{1, 2, 3}}), two = cloud_of({{0, 0, 0}, {0, 0, 2}});
  std::vector<Vec3> row;
  for (int i = 0; i < 40; ++i) row.push_back({0.25 * i, 0, 0});
  const Cloud line = cloud_of(row), equal = cloud_of(std::vector<Vec3>(30, Vec3{1, 1, 1}));
  CHECK(discs_of(one, {0})[0].radius_m == 0);
  CHECK(discs_of(equal, {5})[0].radius_m == 0);
  for (const Cloud& cloud : {one, two, line, equal})
    for (const PointDisc& disc : discs_of(cloud, all_of(cloud))) {
      CHECK(disc.normal() == Vec3{});
      CHECK(std::isfinite(disc.radius_m));
    }
  CHECK(discs_of(two, {1})[0].radius_m > 0);
}

TEST_CASE("joining_distance__connects_one_surface_and_parts_two_that_lie_four_of_it_apart") {
  std::vector<Vec3> points = leaning(5000, 4, 3, 3);
  const double cell_m = joining_distance(discs_of(cloud_of(points), {}));
  CHECK(cell_m == 1e-6);  // of nothing: small, but cells have an edge
  const Cloud surface = cloud_of(points);
  const double joining_m = joining_distance(discs_of(surface, all_of(surface)));
  for (const Vec3& p : leaning(5000, 4, 3, 4)) points.push_back(p + Vec3{4 + 4 * joining_m, 0, 0});
  Task task;
  // Gaps above 2 sqrt(3) cells always part.
  const Components found =
      connected_components(cloud_of(points).xyz(), {}, joining_m, Connectivity3::k26, 1, task);
  REQUIRE(found.count() == 2);
  CHECK(found.point_counts[1] == 5000);
  CHECK(found.point_counts[2] == 5000);
}

TEST_CASE("radius_quantile__takes_the_radius_of_that_rank") {
  std::vector<PointDisc> discs(5);
  for (size_t i = 0; i < 5; ++i) discs[i].radius_m = static_cast<float>((i * 3) % 5 + 1);
  CHECK(radius_quantile(discs, 0) == 1);
  CHECK(radius_quantile(discs, 0.5) == 3);
  CHECK(radius_quantile(discs, 0.9) == 4);
  CHECK(radius_quantile(discs, 1) == 5);
  CHECK(radius_quantile({}, 0.5) == 0);
}
