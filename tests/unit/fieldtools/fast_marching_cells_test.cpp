// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// The cells of a front and their neighbours against all pairs of cells.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "fieldtools/fast_marching_cells.h"
#include "unit/cloud/clouds.h"
#include "unit/compare/refusal.h"

using namespace jalon;
using namespace jalon::test;

namespace {

std::array<int32_t, 3> cell_by_force(const Vec3& p, double cell_m) {
  return {static_cast<int32_t>(std::floor(p.x / cell_m)),
          static_cast<int32_t>(std::floor(p.y / cell_m)),
          static_cast<int32_t>(std::floor(p.z / cell_m))};
}

// Some points all over a box on both sides of zero, others crowded on a sheet.
Cloud scattered_and_sheet() {
  auto points = shifted(random_points(500, 4, 1), {-2, -2, -2});
  for (const Vec3& p : random_points(500, 2, 2)) points.push_back({p.x, p.y, 0.01 * p.z});
  return cloud_of(points);
}

}  // namespace

TEST_CASE("surface_cells__each_point_in_its_cell_each_cell_once_in_order_with_its_centroid") {
  const Cloud cloud = scattered_and_sheet();
  Task task;
  const SurfaceCells cells = surface_cells(cloud.xyz(), 0.3, task);
  std::vector<int> seen(cloud.size(), 0);
  std::set<std::array<int32_t, 3>> occupied;
  for (uint32_t c = 0; c < cells.size(); ++c) {
    occupied.insert(cells.numbers[c]);
    Vec3 sum;
    for (const uint32_t i : cells.points(c)) {
      ++seen[i];
      sum += cloud.point(i);
      CHECK(cell_by_force(cloud.point(i), 0.3) == cells.numbers[c]);
    }
    REQUIRE_FALSE(cells.points(c).empty());
    CHECK(norm(cells.centroid(c) - sum / static_cast<double>(cells.points(c).size())) < 1e-12);
    if (c == 0) continue;
    const auto &a = cells.numbers[c - 1], &b = cells.numbers[c];  // z counts most
    CHECK(std::array{a[2], a[1], a[0]} < std::array{b[2], b[1], b[0]});
  }
  CHECK(occupied.size() == cells.size());
  CHECK(std::count(seen.begin(), seen.end(), 1) == 1000);
}

TEST_CASE("surface_cells__neighbours_are_the_occupied_ones_among_26_for_any_threads") {
  const Cloud cloud = scattered_and_sheet();
  Task one(threads(1)), seven(threads(7));
  for (const double cell_m : {0.11, 0.3, 1.0, 10.0}) {
    const SurfaceCells cells = surface_cells(cloud.xyz(), cell_m, one);
    for (uint32_t c = 0; c < cells.size(); ++c) {
      std::vector<uint32_t> expected;
      for (uint32_t d = 0; d < cells.size(); ++d) {
        int32_t apart = 0;
        for (size_t k = 0; k < 3; ++k)
          apart = std::max(apart, std::abs(cells.numbers[c][k] - cells.numbers[d][k]));
        if (apart == 1) expected.push_back(d);
      }
      const auto found = cells.neighbours(c);
      REQUIRE(std::equal(found.begin(), found.end(), expected.begin(), expected.end()));
      for (const uint32_t d : found) CHECK(cells.touch(c, d));
    }
    const SurfaceCells other = surface_cells(cloud.xyz(), cell_m, seven);
    CHECK(other.around == cells.around);
    CHECK(other.first == cells.first);
  }
}

TEST_CASE("surface_cells__no_points_one_point_and_cells_too_small_for_the_extent") {
  Task task;
  CHECK(surface_cells({}, 1, task).size() == 0);
  const std::vector<double> one{-0.5, 0.5, 7};
  const SurfaceCells single = surface_cells(one, 1, task);
  REQUIRE(single.size() == 1);
  CHECK(single.numbers[0] == std::array<int32_t, 3>{-1, 0, 7});
  CHECK(single.neighbours(0).empty());
  const std::vector<double> far{0, 0, 0, 1e4, 0, 0};
  CHECK(refuses([&] { surface_cells(far, 1e-6, task); }, Status::kLimit, "too small"));
}
