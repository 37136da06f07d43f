// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/triangles/side.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <vector>

#include "base/random.h"

using namespace jalon;

namespace {

using triangle_tree::Node;

/// Up to four triangles in one leaf below one root, as the tree of the room would hold them.
class OneLeaf {
 public:
  /// Corners anticlockwise seen from the front; their coordinates within +-100.
  explicit OneLeaf(std::initializer_list<std::array<Vec3, 3>> triangles) {
    for (const auto& corners : triangles) add(corners);
    block_.corners = corners_.data();
    for (uint32_t i = 0; i < triangle_tree::kWidth; ++i) {
      for (int row = 0; row < 6; ++row)
        node_.bounds[row][i] = (row % 2 == 0) == (i == 0) ? -100.0f : 100.0f;
      node_.child[i] = 0;
      node_.count[i] = i == 0 ? block_.count : 0;
    }
  }
  OneLeaf(const OneLeaf&) = delete;
  ClosestOfTriangle closest(const Vec3& p, uint32_t lane = 0) const {
    return closest_of(block_, lane, p);
  }
  SideOfSurface side(const Vec3& p, uint32_t lane = 0) const {
    return side_of_surface({{&node_, &block_, nullptr}, nullptr, 10}, block_, lane,
                           closest(p, lane));
  }

 private:
  // A leaf keeps the corners of a triangle in ascending order, and whether that turned it over.
  void add(const std::array<Vec3, 3>& corners) {
    std::array<size_t, 3> order = {0, 1, 2};
    std::sort(order.begin(), order.end(), [&](size_t a, size_t b) {
      const Vec3 &p = corners[a], &q = corners[b];
      return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : p.z < q.z;
    });
    const uint32_t lane = block_.count++;
    uint8_t* const places[3] = {block_.a, block_.b, block_.c};
    for (size_t k = 0; k < 3; ++k) {
      places[k][lane] = static_cast<uint8_t>(corners_.size());
      for (int axis = 0; axis < 3; ++axis) corners_.push_back(corners[order[k]][axis]);
    }
    const bool even = (order[1] + 3 - order[0]) % 3 == 1;
    if (!even) block_.turned |= 1u << lane;
    block_.triangle[lane] = lane;
  }

  std::vector<double> corners_;
  TriangleBlock block_{};
  Node node_{};
};

const std::array<Vec3, 3> kRight = {Vec3{0, 0, 0}, Vec3{4, 0, 0}, Vec3{0, 4, 0}};  // front: +z

void check_foot(const ClosestOfTriangle& closest, TriangleFeature feature, const Vec3& foot) {
  CHECK(closest.feature == feature);
  CHECK(norm(closest.foot - foot) < 1e-12);
}

}  // namespace

TEST_CASE("closest_of__face_side_and_corner_of_a_right_triangle_are_those_of_the_closed_form") {
  const OneLeaf leaf({kRight});
  check_foot(leaf.closest({1, 1, 3}), TriangleFeature::kFace, {1, 1, 0});
  check_foot(leaf.closest({1, 1, -3}), TriangleFeature::kFace, {1, 1, 0});
  check_foot(leaf.closest({2, -1, 5}), TriangleFeature::kSide, {2, 0, 0});
  check_foot(leaf.closest({4, 4, 1}), TriangleFeature::kSide, {2, 2, 0});
  check_foot(leaf.closest({-1, 3, 0}), TriangleFeature::kSide, {0, 3, 0});
  check_foot(leaf.closest({-2, -3, 1}), TriangleFeature::kCorner, {0, 0, 0});
  check_foot(leaf.closest({9, -1, 0}), TriangleFeature::kCorner, {4, 0, 0});
  check_foot(leaf.closest({-1, 9, 2}), TriangleFeature::kCorner, {0, 4, 0});
}

TEST_CASE("closest_of__no_place_of_the_triangle_is_nearer_than_the_foot") {
  RandomStream random(6, 0);
  const auto anywhere = [&] {
    const double x = random.uniform(), y = random.uniform(), z = random.uniform();
    return Vec3{10 * x - 5, 10 * y - 5, 10 * z - 5};
  };
  for (int trial = 0; trial < 200; ++trial) {
    const std::array<Vec3, 3> k = {anywhere(), anywhere(), anywhere()};
    const OneLeaf leaf({k});
    const Vec3 p = anywhere();
    const ClosestOfTriangle closest = leaf.closest(p);
    CHECK(norm(closest.foot + closest.above - p) < 1e-12);
    constexpr int kSteps = 20;
    for (int i = 0; i <= kSteps; ++i)
      for (int j = 0; i + j <= kSteps; ++j) {
        const Vec3 place = k[0] + (k[1] - k[0]) * (double{1} * i / kSteps) +
                           (k[2] - k[0]) * (double{1} * j / kSteps);
        REQUIRE(norm(place - p) >= norm(closest.above) - 1e-12);
      }
  }
}

TEST_CASE("side_of_surface__above_a_face_is_certain_and_beyond_its_border_is_said_to_be") {
  for (const bool reversed : {false, true}) {
    const OneLeaf leaf({reversed ? std::array<Vec3, 3>{kRight[0], kRight[2], kRight[1]} : kRight});
    for (const double z : {2.0, -2.0}) {
      const SideOfSurface face = leaf.side({1, 1, z}), border = leaf.side({-1, 1, z});
      CHECK(face.is_behind == ((z < 0) != reversed));
      CHECK(face.basis == TriangleSide::kCertain);
      CHECK(border.is_behind == face.is_behind);
      CHECK(border.basis == TriangleSide::kBorder);
    }
  }
}

TEST_CASE("side_of_surface__at_a_ridge_both_triangles_decide_unless_they_run_opposite_ways") {
  // A roof with its ridge along y at the top, seen from outside; what is below it is behind.
  const Vec3 front{0, 0, 3}, back{0, 4, 3}, left{-3, 2, 0}, right{3, 2, 0};
  const OneLeaf roof({{left, front, back}, {right, back, front}});
  const Vec3 above{0.1, 2, 4}, below{-0.5, 2, 1.5};
  CHECK(roof.closest(above, 0).feature == TriangleFeature::kSide);
  for (const uint32_t lane : {0u, 1u}) {
    const SideOfSurface over = roof.side(above, lane);
    CHECK_FALSE(over.is_behind);
    CHECK(over.basis == TriangleSide::kCertain);
  }
  CHECK(roof.side(below, 0).is_behind);
  const OneLeaf twisted({{left, front, back}, {right, front, back}});
  CHECK(twisted.side(above, 0).basis == TriangleSide::kInconsistent);
  CHECK_FALSE(twisted.side(above, 0).is_behind);
  CHECK(twisted.side(above, 1).is_behind);
}
