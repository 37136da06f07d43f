// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Edge lengths of a triangulation and their knee.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/random.h"
#include "geometry/delaunay2.h"
#include "modelling/contour/long_edges.h"

using namespace jalon;

namespace {

/// A square of grid points with a square hole.
std::vector<Vec2> grid_with_hole() {
  std::vector<Vec2> out;
  for (int r = 0; r < 30; ++r)
    for (int c = 0; c < 30; ++c)
      if (!(r > 10 && r < 20 && c > 10 && c < 20)) out.push_back({0.1 * c, 0.1 * r});
  return out;
}

}  // namespace

TEST_CASE("long_edges__each_edge_has_its_length_once_ascending") {
  const std::vector<Vec2> points{{0, 0}, {3, 0}, {3, 4}, {0, 4}};
  const std::vector<Triangle2> triangles{{0, 1, 2}, {0, 2, 3}};
  CHECK(edge_lengths(points, triangles) == std::vector<double>{3, 3, 4, 4, 5});
  CHECK(edge_lengths(points, {}).empty());
}

TEST_CASE("long_edges__ends_of_edges_above_the_threshold_are_the_points_of_both_contours") {
  const auto points = grid_with_hole();
  const auto triangles = delaunay(points);
  const auto found = long_edge_points(points, triangles, 0.25);
  CHECK(std::is_sorted(found.begin(), found.end()));
  CHECK(std::adjacent_find(found.begin(), found.end()) == found.end());
  for (const uint32_t i : found) {  // beside the hole: the grid has no long edge elsewhere
    const Vec2& p = points[i];
    CHECK(p.u > 0.95);
    CHECK(p.u < 2.05);
    CHECK(p.v > 0.95);
    CHECK(p.v < 2.05);
  }
  std::set<uint32_t> ends;
  for (const Triangle2& t : triangles)
    for (size_t k = 0; k < 3; ++k)
      if (norm(points[t[k]] - points[t[(k + 1) % 3]]) > 0.25) ends.insert({t[k], t[(k + 1) % 3]});
  CHECK(std::vector<uint32_t>(ends.begin(), ends.end()) == found);
  CHECK(found.size() > 4);
  CHECK(long_edge_points(points, triangles, 10).empty());
}

TEST_CASE("long_edges__the_threshold_parts_a_grids_edges_from_those_across_gaps") {
  const auto points = grid_with_hole();
  const auto lengths = edge_lengths(points, delaunay(points));
  const double threshold_m = long_edge_threshold(lengths, 0.1);
  CHECK(threshold_m >= kLeastSpacings * 0.1);
  CHECK(threshold_m <= kMostSpacings * 0.1);
  // Of a curve that bends between the limits, where it bends.
  std::vector<double> bent(500, 0.1);
  for (int i = 1; i <= 500; ++i) bent.push_back(0.1 + 0.0004 * i);
  bent.insert(bent.end(), {0.9, 0.95, 0.97});
  CHECK(long_edge_threshold(bent, 0.1) == doctest::Approx(0.3).epsilon(0.02).scale(0));
}

TEST_CASE("long_edges__the_threshold_keeps_its_limits_and_is_3_spacings_without_edges") {
  CHECK(long_edge_threshold({}, 0.1) == doctest::Approx(0.3));
  CHECK(long_edge_threshold(std::vector<double>(50, 0.1), 0.1) == doctest::Approx(0.2));
  std::vector<double> wide(50, 0.1);
  wide.resize(500, 0.8);
  CHECK(long_edge_threshold(wide, 0.1) == doctest::Approx(0.5));
}
