// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Lights parted by mullions and transoms, and windows parted by piers.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/random.h"
#include "modelling/evidence/joined_lights.h"
#include "unit/modelling/painted_cells.h"
#include "unit/modelling/walls.h"

using namespace jalon;
using painted::rectangle;

namespace {

constexpr double kLightCell_m = 0.05;

// Bars of frames, which stand back with the panes, between the lights.
std::vector<OpeningShape> lights(std::vector<OpeningShape> shapes) {
  return joined_lights(std::move(shapes),
                       painted::cells_of(130, 60, WallState::kThrough, kLightCell_m));
}

// Two lights a few columns apart, and what the cells between them are.
size_t windows_about(const CellBox& bar, WallState state) {
  WallCells cells = painted::cells_of(60, 60, WallState::kOn, kLightCell_m);
  painted::paint(cells, {10, 10, 37, 40}, WallState::kThrough);
  painted::paint(cells, bar, state);
  return joined_lights({rectangle(10, 22, 10, 40), rectangle(25, 37, 10, 40)}, cells).size();
}

// Two lights of 70 cm, side by side or one over the other, about a bar of points flush with the wall: this broad, its
// middle this far from the middle of a cell, 4 cm from point to point in cells of 8.8 cm; in all its cells but those
// that an edge only touches.
size_t windows_about_points(double broad_m, double off_m, bool is_upright, uint64_t seed) {
  constexpr double kCell_m = 0.088, kAt_m = 12.5 * kCell_m;
  constexpr uint32_t kFirst = 4,
                     kLines = 20;  // columns of the lights' ends and rows that they cross
  RandomStream random(seed, 1);
  const double low_m = kAt_m + off_m - broad_m / 2;
  WallCells cells = painted::cells_of(26, 26, WallState::kOn, kCell_m);
  painted::paint(cells, {kFirst, 3, 21, 3 + kLines}, WallState::kThrough);
  std::vector<Vec3> points;
  const auto count = static_cast<size_t>(broad_m * kLines * kCell_m / (0.04 * 0.04));
  for (size_t i = 0; i < count; ++i) {
    const Vec2 at{low_m + broad_m * random.uniform(), (3 + kLines * random.uniform()) * kCell_m};
    points.push_back({at.u, 0.005 * random.normal(), at.v});
    painted::paint(
        cells,
        {static_cast<uint32_t>(at.u / kCell_m), static_cast<uint32_t>(at.v / kCell_m),
         static_cast<uint32_t>(at.u / kCell_m) + 1, static_cast<uint32_t>(at.v / kCell_m) + 1},
        WallState::kOn);
  }
  const double right = std::floor(low_m / kCell_m), left = std::ceil((low_m + broad_m) / kCell_m);
  std::vector<OpeningShape> shapes{rectangle(kFirst, right, 3, 3 + kLines),
                                   rectangle(left, 21, 3, 3 + kLines)};
  if (!is_upright) {
    WallCells turned = cells;
    for (uint32_t r = 0; r < cells.rows; ++r)
      for (uint32_t c = 0; c < cells.columns; ++c)
        turned.states[size_t{c} * cells.columns + r] = cells.at(c, r);
    cells = turned;
    for (Vec3& p : points) std::swap(p.x, p.z);
    for (OpeningShape& shape : shapes) {
      std::swap(shape.sizes[0], shape.sizes[2]);
      std::swap(shape.sizes[1], shape.sizes[3]);
    }
  }
  const Segmentation segmentation = walls::segmentation_of({points});
  std::vector<uint32_t> indices(points.size());
  std::iota(indices.begin(), indices.end(), 0u);
  return joined_lights(shapes, cells, {segmentation.cloud.get(), indices}).size();
}

}  // namespace

TEST_CASE("joined_lights__on_both_sides_of_a_mullion_are_one_window_whatever_their_order") {
  const OpeningShape left = rectangle(10, 22, 10, 40), right = rectangle(24, 36, 11, 39);
  for (const auto& order : {std::vector{left, right}, {right, left}}) {
    const auto out = lights(order);
    REQUIRE(out.size() == 1);
    CHECK(out[0].sizes == rectangle(10, 36, 10, 40).sizes);
  }
}

TEST_CASE("joined_lights__on_both_sides_of_a_pier_stay_two_windows") {
  CHECK(lights({rectangle(10, 30, 10, 40), rectangle(36, 56, 10, 40)}).size() == 2);  // 25 cm
  CHECK(lights({rectangle(10, 30, 10, 40), rectangle(33, 53, 10, 40)}).size() == 1);  // 10 cm
  // As narrow a bar, but too wide for slits beside it.
  CHECK(lights({rectangle(10, 14, 10, 40), rectangle(17, 21, 10, 40)}).size() == 2);
}

TEST_CASE("joined_lights__parted_by_the_wall_itself_from_foot_to_head_are_two_windows") {
  CHECK(windows_about({22, 10, 25, 40}, WallState::kOn) == 2);
  CHECK(windows_about({22, 10, 25, 30}, WallState::kOn) == 1);     // a post with a gap over it
  CHECK(windows_about({22, 10, 25, 40}, WallState::kStrip) == 1);  // a leaf flush with the wall
  CHECK(windows_about({22, 10, 24, 40}, WallState::kOn) == 1);     // no broader than a frame
}

TEST_CASE("joined_lights__one_over_the_other_are_parted_by_the_wall_as_those_side_by_side") {
  for (const WallState state : {WallState::kOn, WallState::kThrough}) {
    WallCells cells = painted::cells_of(60, 60, WallState::kOn, kLightCell_m);
    painted::paint(cells, {10, 10, 40, 37}, WallState::kThrough);
    painted::paint(cells, {10, 22, 40, 25}, state);
    CHECK(joined_lights({rectangle(10, 40, 10, 22), rectangle(10, 40, 25, 37)}, cells).size() ==
          (state == WallState::kOn ? 2u : 1u));
  }
}

TEST_CASE(
    "joined_lights__half_a_brick_parts_them_and_a_mullion_that_touches_as_many_cells_does_not") {
  for (const bool is_upright : {true, false})
    for (const double off_m : {-0.04, -0.01, 0.0, 0.02, 0.044})
      for (uint64_t seed = 1; seed <= 10; ++seed) {
        CAPTURE(is_upright);
        CAPTURE(off_m);
        CHECK(windows_about_points(0.15, off_m, is_upright, seed) == 2);
        CHECK(windows_about_points(0.10, off_m, is_upright, seed) == 1);
        CHECK(windows_about_points(0.07, off_m, is_upright, seed) == 1);
      }
}

TEST_CASE("joined_lights__panels_between_posts_as_broad_as_each_other_are_not_parted_by_piers") {
  // Three panels between four posts of 15 cm, and the same three in a wall that goes on for half a metre.
  for (const uint32_t beside : {3u, 10u}) {
    WallCells cells = painted::cells_of(42 + 2 * beside, 60, WallState::kOn, kLightCell_m);
    std::vector<OpeningShape> shapes;
    for (const uint32_t k : {0u, 1u, 2u}) {
      const uint32_t c = beside + 15 * k;
      painted::paint(cells, {c, 10, c + 12, 40}, WallState::kThrough);
      shapes.push_back(rectangle(c, c + 12, 10, 40));
    }
    CAPTURE(beside);
    CHECK(joined_lights(shapes, cells).size() == (beside == 3 ? 1u : 3u));
  }
}

TEST_CASE("joined_lights__garages_wider_than_lights_stay_apart_whatever_is_between_them") {
  CHECK(lights({rectangle(10, 60, 0, 44), rectangle(62, 112, 0, 44)}).size() == 2);  // 2.5 m
  CHECK(lights({rectangle(10, 35, 0, 44), rectangle(37, 62, 0, 44)}).size() == 1);   // 1.25 m
}

TEST_CASE("joined_lights__need_the_same_foot_and_head_and_upright_sides") {
  CHECK(lights({rectangle(10, 22, 10, 40), rectangle(24, 36, 14, 40)}).size() == 2);
  CHECK(lights({rectangle(10, 22, 10, 40), rectangle(24, 36, 10, 36)}).size() == 2);
  const OpeningShape arch{ShapeKind::kArch, {24, 36, 10, 40, 6, 0}};
  CHECK(lights({rectangle(10, 22, 10, 40), arch}).size() == 2);
  CHECK(lights({}).empty());
}

TEST_CASE("joined_lights__a_lattice_of_mullions_and_transoms_is_one_window") {
  std::vector<OpeningShape> panes;
  for (const double u : {10.0, 24.0, 38.0})
    for (const double v : {5.0, 27.0}) panes.push_back(rectangle(u, u + 12, v, v + 20));
  std::reverse(panes.begin(), panes.begin() + 3);
  const auto out = lights(panes);
  REQUIRE(out.size() == 1);
  CHECK(out[0].sizes == rectangle(10, 50, 5, 47).sizes);
}
