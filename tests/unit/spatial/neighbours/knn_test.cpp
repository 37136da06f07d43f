// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cstring>

#include "spatial/neighbours/ball_kernel.h"
#include "spatial/neighbours/knn_kernel.h"
#include "spatial/octree/impl.h"
#include "spatial/octree/octree.h"
#include "unit/spatial/octree_fixture.h"

using namespace jalon;
using namespace jalon::test;

namespace {

void check_equal(std::span<const Neighbour> found, const std::vector<Neighbour>& expected) {
  for (size_t j = 0; j < found.size(); ++j) {
    const bool there = j < expected.size();
    REQUIRE(found[j].index == (there ? expected[j].index : kNoPoint));
    if (there) REQUIRE(found[j].squared_distance == expected[j].squared_distance);
  }
}

// Some points of the cloud, points near it, inside the cube but far, and far outside.
std::vector<Vec3> queries_of(const std::vector<double>& xyz, size_t count) {
  RandomStream random(9, 1);
  std::vector<Vec3> out;
  for (size_t n = 0; n < count; ++n) {
    const Vec3 p = point(xyz, random.below(xyz.size() / 3));
    const Vec3 step{random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5};
    const double size[] = {0, 0.1, 15, 500};
    out.push_back(p + step * size[n % 4]);
  }
  return out;
}

void check_all(const std::vector<double>& xyz, uint32_t k, size_t every) {
  const auto tree = build(xyz);
  const AllNeighbours all = all_knn(*tree, k);
  for (size_t i = 0; i < tree->size(); i += every) {
    const auto expected = brute_force(xyz, point(xyz, i), k);
    for (size_t j = 0; j < k; ++j) {
      REQUIRE(all.index[i * k + j] == (j < expected.size() ? expected[j].index : kNoPoint));
      if (j < expected.size())
        REQUIRE(all.squared[i * k + j] ==
                doctest::Approx(expected[j].squared_distance).epsilon(1e-4));
    }
  }
}

}  // namespace

TEST_CASE("knn__equals_brute_force_at_every_level_wherever_the_query_lies") {
  const auto xyz = street(4000);
  const auto tree = build(xyz);
  const auto queries = queries_of(xyz, 120);
  Task task(threads(2));
  for (const uint32_t k : {1u, 6u, 20u}) {
    std::vector<std::vector<Neighbour>> expected;
    for (const Vec3& q : queries) expected.push_back(brute_force(xyz, q, k));
    std::vector<Neighbour> found(queries.size() * k);
    for (size_t i = 0; i < queries.size(); ++i) {
      REQUIRE(tree->knn(queries[i], k, found) == k);
      check_equal({found.data(), k}, expected[i]);
    }
    for (const int level : {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 21}) {
      knn_at_level(*tree, queries, k, level, task, found);
      for (size_t i = 0; i < queries.size(); ++i)
        check_equal({found.data() + i * k, k}, expected[i]);
    }
  }
}

TEST_CASE("knn__nearest_within_a_reach_equals_brute_force") {
  const auto xyz = street(4000);
  const auto tree = build(xyz);
  for (const Vec3& q : queries_of(xyz, 400)) {
    const Neighbour nearest = brute_force(xyz, q, 1)[0];
    const double distance = std::sqrt(nearest.squared_distance);
    for (const double reach : {0.0, 0.05, 0.5, distance, 2 * distance, 1e9}) {
      Neighbour found{-1, kNoPoint};
      const bool expected = nearest.squared_distance <= reach * reach;
      REQUIRE(tree->nearest_within(q, reach, found) == expected);
      if (expected) REQUIRE(found.index == nearest.index);
      if (expected) REQUIRE(found.squared_distance == nearest.squared_distance);
      if (!expected) REQUIRE(found.index == kNoPoint);
    }
    Neighbour found{-1, kNoPoint};
    REQUIRE_FALSE(tree->nearest_within(q, -1, found));
  }
}

TEST_CASE("knn__fewer_points_than_asked_for_are_filled_up") {
  const auto xyz = street(5);
  const auto tree = build(xyz);
  Task task;
  const std::vector<Vec3> queries{{1, 2, 3}, {-100, 5, 5}};
  std::vector<Neighbour> found(2 * 9);
  for (const int level : {1, 7, 21}) {
    knn_at_level(*tree, queries, 9, level, task, found);
    for (size_t i = 0; i < 2; ++i)
      check_equal({found.data() + 9 * i, 9}, brute_force(xyz, queries[i], 9));
  }
  check_all(xyz, 9, 1);
}

TEST_CASE("knn__of_all_points_equals_brute_force") {
  for (const uint32_t k : {1u, 2u, 6u, 16u, 20u, 50u}) check_all(street(6000), k, 7);
  check_all(street(700), 256, 50);
}

TEST_CASE("knn__of_all_points_equals_brute_force_on_grids_full_of_ties") {
  check_all(street(5000, 2, 0.1), 16, 7);    // a grid that the fixed point cannot hold
  check_all(street(5000, 2, 0.125), 16, 7);  // one that it can
  check_all(street(5000, 2, 4.0), 10, 101);  // hundreds of duplicates
  auto far = street(4000, 6, 0.01);
  for (size_t i = 0; i < far.size(); ++i)
    far[i] += i % 3 == 0 ? 652000.37 : i % 3 == 1 ? 6861000.91 : 0;
  check_all(far, 16, 7);
}

TEST_CASE("knn__of_all_points_holds_for_uneven_clouds") {
  std::vector<double> xyz;
  RandomStream random(4, 0);
  for (int i = 0; i < 4000; ++i)  // spacing grows from a micrometre to kilometres
    for (int axis = 0; axis < 3; ++axis) {
      const int exponent = static_cast<int>(random.below(30)) - 20;
      xyz.push_back(std::ldexp(random.uniform(), exponent));
    }
  xyz.insert(xyz.end(), {1e5, -1e5, 3e4});
  check_all(xyz, 16, 7);
}

TEST_CASE("knn__of_all_points_takes_masses_of_duplicates") {
  std::vector<double> xyz;
  for (int i = 0; i < 150000; ++i)
    for (int axis = 0; axis < 3; ++axis)
      xyz.push_back(i % 3 == 0 ? 0.1 : i % 3 == 1 ? 652000.7 : 7);
  const auto tree = build(xyz);
  const auto all = all_knn(*tree, 4);
  for (size_t i = 0; i < tree->size(); ++i)
    for (size_t j = 0; j < 4; ++j) REQUIRE(all.index[4 * i + j] == i % 3 + 3 * j);
}

TEST_CASE("knn__is_the_same_for_any_number_of_threads") {
  const auto xyz = street(30000);
  const auto tree = build(xyz);
  const auto one = all_knn(*tree, 16, 1);
  CHECK(one == all_knn(*tree, 16, 2));
  CHECK(one == all_knn(*tree, 16, 7));
}

TEST_CASE("knn__vector_kernels_give_the_same_bits") {
#if defined(__x86_64__)
  if (!__builtin_cpu_supports("avx2")) {
    MESSAGE("skipped: this processor has no AVX2");
    return;
  }
  const auto xyz = street(20000);
  const auto tree = build(xyz);
  const OctreeView& view = tree->impl().view;
  auto a = std::make_unique<Candidates>(), b = std::make_unique<Candidates>();
  RandomStream random(8, 0);
  for (int n = 0; n < 200; ++n) {
    const size_t centre = random.below(tree->size());
    const auto reach = static_cast<int32_t>(random.below(uint64_t{1} << 26));
    GridBox box;
    const int32_t at[3] = {view.x[centre], view.y[centre], view.z[centre]};
    for (int axis = 0; axis < 3; ++axis) {
      box.lo[axis] = std::max(0, at[axis] - reach);
      box.hi[axis] = static_cast<int32_t>(std::min<int64_t>(0x7fffffff, int64_t{at[axis]} + reach));
    }
    const bool fits = gather_candidates_baseline(view, box, *a);
    REQUIRE(fits == gather_candidates_avx2(view, box, *b));
    if (!fits) continue;
    REQUIRE(a->count == b->count);
    REQUIRE(std::memcmp(a->position, b->position, a->count * sizeof(uint32_t)) == 0);
    REQUIRE(std::memcmp(a->z, b->z, a->count * sizeof(int32_t)) == 0);
    KnnGroup group, other;
    group.count = 1 + static_cast<uint32_t>(random.below(kMostQueries));
    group.k = 1 + static_cast<uint32_t>(random.below(30));
    group.index_bits = 11;
    group.covered = 0x1p50f;
    group.tie_slope = 0x1p-11f;
    group.tie_root = 7;
    group.tie_floor = 13;
    for (uint32_t q = 0; q < kMostQueries; ++q) {
      const size_t i = std::min(centre + std::min(q, group.count - 1), tree->size() - 1);
      group.x[q] = view.x[i];
      group.y[q] = view.y[i];
      group.z[q] = view.z[i];
    }
    std::vector<uint32_t> keys((group.k + 1) * kMostQueries), other_keys(keys.size());
    other = group;
    group.keys = keys.data();
    other.keys = other_keys.data();
    knn_group_baseline(*a, group);
    knn_group_avx2(*b, other);
    REQUIRE(group.incomplete == other.incomplete);
    REQUIRE(group.ambiguous == other.ambiguous);
    for (size_t j = 0; j <= group.k; ++j)
      for (size_t q = 0; q < group.count; ++q)
        REQUIRE(keys[j * kMostQueries + q] == other_keys[j * kMostQueries + q]);
  }
#endif
}

TEST_CASE("radius__equals_brute_force_for_queries_and_for_all_points") {
  for (const double grid : {0.0, 0.1}) {
    const auto xyz = street(4000, 1, grid);
    const auto tree = build(xyz);
    for (const double radius : {0.0, 0.4, 3.0}) {
      const auto expect = [&](const Vec3& q) {
        std::vector<uint32_t> out;
        for (size_t i = 0; i < tree->size(); ++i)
          if (squared_norm(point(xyz, i) - q) <= radius * radius)
            out.push_back(static_cast<uint32_t>(i));
        return out;
      };
      std::vector<Neighbour> found;
      for (const Vec3& q : queries_of(xyz, 80)) {
        tree->radius(q, radius, found);
        std::vector<uint32_t> indices;
        for (const Neighbour& n : found) indices.push_back(n.index);
        REQUIRE(indices == expect(q));
      }
      std::vector<std::vector<uint32_t>> all(tree->size());
      Task task(threads(2));
      tree->for_each_ball(radius, task, [&](const Octree::BallBatch& b) {
        for (size_t i = 0; i < b.count; ++i) {
          auto& mine = all[tree->order()[b.first + i]];
          for (uint32_t n = b.offsets[i]; n < b.offsets[i + 1]; ++n)
            mine.push_back(tree->order()[b.neighbours[n]]);
          std::sort(mine.begin(), mine.end());
        }
      });
      for (size_t i = 0; i < all.size(); i += 13) REQUIRE(all[i] == expect(point(xyz, i)));
    }
  }
}

TEST_CASE("ball__vector_kernels_give_the_same_bits_and_batches_any_number_of_threads") {
  const auto xyz = street(20000);
  const auto tree = build(xyz);
  const auto balls = [&](unsigned count) {
    std::vector<std::vector<uint32_t>> all(tree->size());
    Task task(threads(count));
    tree->for_each_ball(0.7, task, [&](const Octree::BallBatch& b) {
      for (size_t i = 0; i < b.count; ++i)
        all[b.first + i].assign(b.neighbours + b.offsets[i], b.neighbours + b.offsets[i + 1]);
    });
    return all;
  };
  CHECK(balls(1) == balls(7));
#if defined(__x86_64__)
  if (!__builtin_cpu_supports("avx2")) {
    MESSAGE("skipped: this processor has no AVX2");
    return;
  }
  const OctreeView& view = tree->impl().view;
  constexpr size_t kRoom = 3000;
  std::vector<int32_t> x(kRoom + 16), y = x, z = x;
  std::vector<uint32_t> position(kRoom + 16), inside = position, other = position;
  std::vector<float> squared(kRoom + 16), other_squared = squared;
  RandomStream random(8, 1);
  for (int n = 0; n < 100; ++n) {
    BallCandidates c{x.data(), y.data(), z.data(), position.data(), 0, kRoom};
    const size_t at = random.below(tree->size());
    const int32_t p[3] = {view.x[at], view.y[at], view.z[at]};
    constexpr int32_t kReach = 1 << 25;
    GridBox box;
    for (int axis = 0; axis < 3; ++axis) {
      box.lo[axis] = std::max(0, p[axis] - kReach);
      box.hi[axis] = std::min(0x7fffffff - kReach, p[axis]) + kReach;
    }
    REQUIRE(gather_ball_candidates_avx2(view, box, c));
    const Ball ball{p[0], p[1], p[2], 0x1p48f, 0x1p49f};
    size_t unsure = 0, other_unsure = 0;
    const size_t count = points_in_ball_avx2(c, ball, inside.data(), squared.data(), unsure);
    c.count = 0;
    REQUIRE(gather_ball_candidates_baseline(view, box, c));
    REQUIRE(count ==
            points_in_ball_baseline(c, ball, other.data(), other_squared.data(), other_unsure));
    REQUIRE(unsure == other_unsure);
    REQUIRE(
        std::equal(inside.begin(), inside.begin() + static_cast<ptrdiff_t>(count), other.begin()));
    REQUIRE(std::memcmp(squared.data(), other_squared.data(), count * sizeof(float)) == 0);
  }
#endif
}
