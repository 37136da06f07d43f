// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/neighbours/nearest_by_grid.h"

#include <doctest/doctest.h>

#include "base/random.h"

using namespace jalon;

namespace {

struct Tree {
  Buffer<double> xyz;
  std::shared_ptr<const Octree> octree;
  explicit Tree(const std::vector<Vec3>& points) : xyz(3 * points.size()) {
    Box3 box;
    for (size_t i = 0; i < points.size(); ++i) {
      for (int c = 0; c < 3; ++c) xyz.data()[3 * i + static_cast<size_t>(c)] = points[i][c];
      box.add(points[i]);
    }
    Task task;
    octree = Octree::build(xyz, enclosing_cube(box), task);
  }
};

std::vector<Vec3> scattered(size_t n, const Vec3& origin) {
  RandomStream random(4, 1);
  std::vector<Vec3> out(n);
  for (Vec3& p : out) {
    for (int c = 0; c < 3; ++c) p[c] = 8 * random.uniform();
    p += origin;
  }
  return out;
}

// Octree::knn against all distances sorted.
void check_against_all(const std::vector<Vec3>& points, const Vec3& q, uint32_t k) {
  const Tree tree(points);
  std::vector<Neighbour> all;
  for (size_t i = 0; i < points.size(); ++i)
    all.push_back({squared_norm(points[i] - q), static_cast<uint32_t>(i)});
  std::sort(all.begin(), all.end(), [](const Neighbour& a, const Neighbour& b) {
    return a.squared_distance < b.squared_distance ||
           (a.squared_distance == b.squared_distance && a.index < b.index);
  });
  std::vector<Neighbour> found(k);
  REQUIRE(tree.octree->knn(q, k, found) == std::min<size_t>(k, points.size()));
  for (size_t j = 0; j < std::min<size_t>(k, points.size()); ++j) {
    CHECK(found[j].index == all[j].index);
    CHECK(found[j].squared_distance == all[j].squared_distance);
  }
}

}  // namespace

TEST_CASE("nearest_by_grid__orders_scattered_points_as_their_doubles_do") {
  for (const Vec3& origin : {Vec3{}, Vec3{998000, 6542000, 150}}) {
    const std::vector<Vec3> points = scattered(3000, origin);
    const Tree tree(points);
    const Octree::Impl& impl = tree.octree->impl();
    size_t ordered = 0;
    for (size_t i = 0; i < 200; ++i) {
      const int32_t query[3] = {impl.x[i], impl.y[i], impl.z[i]};
      uint32_t to[32], exact[32];
      if (!nearest_by_grid(impl, query, false, 32, to)) continue;
      ++ordered;
      REQUIRE(impl.nearest_of_place(impl.exact_point(i), 32, exact) == 32);
      CHECK(std::equal(to, to + 32, exact));
    }
    CHECK(ordered > 190);
  }
}

TEST_CASE("nearest_by_grid__cannot_order_points_that_are_equally_near") {
  const Tree tree({{0, 0, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 2.5, 0}, {0, 0, 3.75}});
  const Octree::Impl& impl = tree.octree->impl();
  for (size_t i = 0; i < 5; ++i) {
    if (!(impl.exact_point(i) == Vec3{})) continue;
    const int32_t query[3] = {impl.x[i], impl.y[i], impl.z[i]};
    uint32_t to[3];
    CHECK_FALSE(nearest_by_grid(impl, query, true, 3, to));
  }
}

TEST_CASE("knn__of_places_in_and_out_of_the_cube_equals_brute_force") {
  const std::vector<Vec3> points = scattered(700, {});
  for (const Vec3& q : {Vec3{4, 4, 4}, Vec3{0.1, 7.9, 3}, Vec3{-3, 4, 4}, Vec3{20, 20, 20}})
    for (const uint32_t k : {1u, 2u, 32u, 256u, 300u, 700u, 900u}) check_against_all(points, q, k);
}

TEST_CASE("knn__of_a_lattice_takes_equally_near_points_by_index") {
  std::vector<Vec3> points;
  for (int i = 0; i < 9; ++i)
    for (int j = 0; j < 9; ++j) points.push_back({0.25 * i, 0.25 * j, 0});
  check_against_all(points, {1, 1, 0}, 13);
  check_against_all(points, {1.1, 0.9, 0.3}, 13);
}
