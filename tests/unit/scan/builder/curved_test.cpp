// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <numbers>
#include <vector>

#include "unit/scan/scenes/built.h"

using namespace jalon;
using namespace jalon::test;

// Curved surfaces against the closed forms of the prism, the ball and the uniform law in a ball.

namespace {

constexpr double kPi = std::numbers::pi;

Model ball_of(int facets) {
  SceneBuilder out{Transform{}};
  out.sphere({2, -1, 3}, 0.9, facets);
  return out.take();
}

std::vector<Vec3> leaf_corners(uint64_t seed, int leaves) {
  SceneBuilder out{Transform{}};
  out.crown({2, -1, 3}, 1.5, leaves, 0.1, {seed, 4});
  return out.take().vertices;
}

}  // namespace

TEST_CASE("cylinder__is_the_side_of_a_regular_prism_that_looks_outward") {
  constexpr int kFacets = 24;
  const Vec3 foot{1, 2, 0.5};
  SceneBuilder out{Transform{}};
  CHECK(out.new_id() == 1);
  out.cylinder(foot, 0.25, 4, kFacets);
  const Model model = out.take();
  CHECK(model.faces.empty());
  CHECK(model.triangle_faces == std::vector<uint32_t>(2 * kFacets, 2));
  const double side = 2 * 0.25 * std::sin(kPi / kFacets);
  const Shell shell = shell_of(model, {}, foot);
  CHECK(std::abs(shell.area_m2 - kFacets * side * 4) < kRounding_m);
  CHECK(std::abs(open_edge_m(model) - 2 * kFacets * side) < 1e-8);  // open below and above
  for (const Vec3& v : model.vertices) {
    CHECK(std::abs(std::hypot(v.x - 1, v.y - 2) - 0.25) < 1e-15);
    CHECK((v.z == 0.5 || v.z == 4.5));
  }
  // Base times height; the lateral surface alone holds two thirds of it.
  const double base = kFacets * side * 0.25 * std::cos(kPi / kFacets) / 2;
  CHECK(std::abs(shell.volume_m3 - base * 4 * 2 / 3) < kRounding_m);
}

TEST_CASE("sphere__is_closed_and_nears_the_ball_by_the_square_of_its_facets") {
  double missing[2] = {};
  for (int k = 0; k < 2; ++k) {
    const Model model = ball_of(k == 0 ? 24 : 48);
    for (const Vec3& v : model.vertices) REQUIRE(std::abs(norm(v - Vec3{2, -1, 3}) - 0.9) < 1e-14);
    const Shell shell = shell_of(model, {}, {2, -1, 3});
    CHECK(norm(shell.vector_area) < kRounding_m);
    CHECK(open_edge_m(model) == 0);
    missing[k] = 4 * kPi * 0.9 * 0.9 * 0.9 / 3 - shell.volume_m3;
    CHECK(missing[k] > 0);  // inscribed, and its triangles look outward
  }
  // Chords leave an arc by the square of the angle; the next power is 1 + 1/100 of it.
  CHECK(missing[0] / missing[1] == doctest::Approx(4).epsilon(0.02));
}

TEST_CASE("relief__takes_corners_and_ids_as_told_and_looks_upward") {
  constexpr uint32_t kColumns = 5, kRows = 3;
  const auto height = [](double x, double y) { return 1 + 0.25 * x - 0.5 * y; };
  SceneBuilder out{Transform{}};
  out.relief(
      kColumns, kRows,
      [&](uint32_t i, uint32_t j) {
        const double x = 2.0 * i, y = 1.0 * j;
        return Vec3{x, y, height(x, y)};
      },
      [](uint32_t i, uint32_t j) { return 10 * j + i + 1; });
  const Model model = out.take();
  CHECK(model.vertices.size() == (kColumns + 1) * (kRows + 1));
  CHECK(model.triangles.size() == 2 * kColumns * kRows);
  for (uint32_t j = 0; j < kRows; ++j)
    for (uint32_t i = 0; i < kColumns; ++i) {
      const double x = 2 * i + 0.7, y = j + 0.6;
      const Hit hit = first_hit(model, {x, y, 50}, {0, 0, -1});
      REQUIRE(std::abs(50 - hit.distance - height(x, y)) < kRounding_m);  // the ground is a plane
      CHECK(hit.is_front);
      CHECK(model.triangle_faces[hit.triangle] == 10 * j + i + 1);
    }
  CHECK(std::abs(open_edge_m(model) - 2 * (10 * std::hypot(1, 0.25) + 3 * std::hypot(1, 0.5))) <
        1e-8);
}

TEST_CASE("crown__spreads_its_leaves_evenly_in_the_ball") {
  constexpr int kLeaves = 4000;
  const std::vector<Vec3> corners = leaf_corners(1, kLeaves);
  REQUIRE(corners.size() == 3 * kLeaves);
  Vec3 sum;
  double squares = 0;
  for (size_t i = 0; i < corners.size(); i += 3) {
    const Vec3 p = corners[i] - Vec3{2, -1, 3};  // one corner of each leaf: those are independent
    REQUIRE(norm(p) <= 1.5 + 0.1);
    REQUIRE(norm(corners[i + 1] - corners[i]) <= 2 * 0.1);  // both in the leaf's ball
    sum += p;
    squares += squared_norm(p);
  }
  // In a ball of radius R the mean square is 3/5 R2 and its variance (3/7 - 9/25) R4; a coordinate has R2/5.
  const double n = kLeaves, big = 1.5 * 1.5, small = 0.1 * 0.1;
  CHECK(std::abs(squares / n - 0.6 * (big + small)) < 5 * std::sqrt(0.0686 * big * big / n) * 1.01);
  for (int a = 0; a < 3; ++a) CHECK(std::abs(sum[a] / n) < 5 * std::sqrt((big + small) / 5 / n));
  CHECK(leaf_corners(1, 50) == std::vector<Vec3>(corners.begin(), corners.begin() + 150));
  CHECK(leaf_corners(2, 50) != leaf_corners(1, 50));
}
