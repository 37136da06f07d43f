// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/error.h"
#include "base/random.h"
#include "base/task.h"
#include "spatial/triangles/tree.h"
#include "unit/spatial/triangles/mesh.h"

using namespace jalon;
using namespace jalon::test;

namespace {

std::shared_ptr<const TriangleTree> ray_tree_of(const Mesh& mesh, unsigned threads = 0) {
  return built<TriangleTree>(mesh, threads);
}

Vec3 random_point(RandomStream& random, double size) {
  const double x = random.uniform(), y = random.uniform(), z = random.uniform();
  return {size * x, size * y, size * z};
}

/// Coordinates on the 2^-20 m grid, which any whole-metre shift keeps.
Vec3 ray_on_grid(const Vec3& p) {
  const auto snap = [](double x) { return std::nearbyint(x * 0x1.0p20) * 0x1.0p-20; };
  return {snap(p.x), snap(p.y), snap(p.z)};
}

/// Small and large triangles, needles, points, duplicates.
Mesh ray_mesh(size_t n, uint64_t seed, double size = 10) {
  Mesh mesh;
  RandomStream random(seed, 1);
  for (size_t i = 0; i < n; ++i) {
    const Vec3 a = random_point(random, size);
    const double reach = size * std::pow(10, -3 * random.uniform());
    const Vec3 b = a + random_point(random, reach), c = a + random_point(random, reach);
    switch (i % 10) {
      case 7:
        mesh.add(ray_on_grid(a), ray_on_grid(b), ray_on_grid(a + (b - a) * 0.5));
        break;  // a needle
      case 8:
        mesh.add(ray_on_grid(a), ray_on_grid(a), ray_on_grid(a));
        break;  // a point
      case 9:
        mesh.triangles.push_back(mesh.triangles.back());
        break;  // a duplicate
      default:
        mesh.add(ray_on_grid(a), ray_on_grid(b), ray_on_grid(c));
    }
  }
  return mesh;
}

/// Plain Moeller-Trumbore in long double: independent of the tree's own test.
bool meets(const Mesh& mesh, size_t i, const Ray& ray, long double& t, long double& margin) {
  using Number = long double;
  const auto& [ia, ib, ic] = mesh.triangles[i];
  const Vec3 &a = mesh.vertices[ia], &b = mesh.vertices[ib], &c = mesh.vertices[ic];
  const auto minus = [](const Vec3& p, const Vec3& q) {
    return std::array<Number, 3>{Number(p.x) - q.x, Number(p.y) - q.y, Number(p.z) - q.z};
  };
  const auto product = [](const std::array<Number, 3>& p, const std::array<Number, 3>& q) {
    return std::array<Number, 3>{p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2],
                                 p[0] * q[1] - p[1] * q[0]};
  };
  const auto inner = [](const std::array<Number, 3>& p, const std::array<Number, 3>& q) {
    return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
  };
  const auto e1 = minus(b, a), e2 = minus(c, a), d = minus(ray.direction, Vec3{}),
             s = minus(ray.origin, a);
  const auto p = product(d, e2), q = product(s, e1);
  const Number determinant = inner(e1, p);
  if (std::abs(determinant) < 1e-14L) return false;
  const Number u = inner(s, p) / determinant, v = inner(d, q) / determinant;
  margin = std::min({u, v, 1 - u - v});
  t = inner(e2, q) / determinant;
  return margin >= 0 && t >= ray.t_min && t <= ray.t_max;
}

Ray random_ray(RandomStream& random, double size) {
  const Vec3 from = ray_on_grid(random_point(random, 3 * size) - Vec3{size, size, size});
  return {from, ray_on_grid(random_point(random, size) - from)};
}

}  // namespace

TEST_CASE("triangle_tree__finds_the_triangle_that_a_search_of_all_finds") {
  const Mesh mesh = ray_mesh(3000, 5);
  const auto tree = ray_tree_of(mesh);
  CHECK(tree->size() == mesh.triangles.size());
  RandomStream random(5, 2);
  size_t hits = 0, doubtful = 0;
  for (int i = 0; i < 3000; ++i) {
    const Ray ray = random_ray(random, 10);
    bool expected = false, near_edge = false;
    long double best = 0;
    for (size_t k = 0; k < mesh.triangles.size(); ++k) {
      long double t = 0, margin = 1;
      const bool met = meets(mesh, k, ray, t, margin);
      near_edge = near_edge || std::abs(margin) < 1e-9L;
      if (met && (!expected || t < best)) best = t;
      expected = expected || met;
    }
    if (near_edge) {
      ++doubtful;
      continue;
    }
    RayHit hit;
    const bool found = tree->nearest(ray, hit);
    REQUIRE(found == expected);
    REQUIRE(tree->occluded(ray) == expected);
    if (!found) continue;
    ++hits;
    long double t = 0, margin = 0;
    REQUIRE(meets(mesh, hit.triangle, ray, t, margin));
    REQUIRE(std::abs(static_cast<double>(best) - hit.t) < 1e-12);
  }
  MESSAGE(hits << " of 3000 rays hit, " << doubtful << " within 1e-9 of an edge left out");
  CHECK(hits > 1500);
  CHECK(doubtful < 300);
}

TEST_CASE("triangle_tree__takes_the_lowest_index_of_equal_triangles") {
  Mesh mesh;
  for (int i = 0; i < 40; ++i) mesh.add({0, 0, 1}, {1, 0, 1}, {0, 1, 1});
  const auto tree = ray_tree_of(mesh);
  RayHit hit;
  REQUIRE(tree->nearest({{0.25, 0.25, 0}, {0, 0, 1}}, hit));
  CHECK(hit.triangle == 0);
  CHECK(hit.t == 1);
}

TEST_CASE("triangle_tree__lets_no_ray_through_shared_edges_and_corners") {
  // A closed, bumpy grid below rays that aim exactly at its corners, its edges, and anywhere.
  constexpr uint32_t kSide = 40;
  Mesh mesh;
  RandomStream random(11, 1);
  for (uint32_t j = 0; j <= kSide; ++j)
    for (uint32_t i = 0; i <= kSide; ++i)
      mesh.vertices.push_back({0.1 * i + 0.03 * random.uniform(), 0.1 * j + 0.03 * random.uniform(),
                               0.2 * random.uniform()});
  for (uint32_t j = 0; j < kSide; ++j)
    for (uint32_t i = 0; i < kSide; ++i) {
      const uint32_t a = j * (kSide + 1) + i, b = a + kSide + 1;
      mesh.triangles.push_back({a, a + 1, b});
      mesh.triangles.push_back({b + 1, b, a + 1});
    }
  const auto tree = ray_tree_of(mesh);
  size_t missed = 0, rays = 0;
  const auto shoot = [&](const Vec3& from, const Vec3& at) {
    RayHit hit;
    ++rays;
    missed += tree->nearest({from, at - from}, hit) ? 0 : 1;
  };
  for (int pass = 0; pass < 20; ++pass)
    for (uint32_t j = 1; j < kSide; ++j)
      for (uint32_t i = 1; i < kSide; ++i) {
        const uint32_t a = j * (kSide + 1) + i;
        const Vec3 from = mesh.vertices[a] + Vec3{random.uniform() - 0.5, random.uniform() - 0.5,
                                                  3 + random.uniform()};
        shoot(from, mesh.vertices[a]);
        const double s = random.uniform();
        shoot(from, mesh.vertices[a] * s + mesh.vertices[a + 1] * (1 - s));
        shoot(from, mesh.vertices[a] * s + mesh.vertices[a + kSide + 1] * (1 - s));
        shoot(from, mesh.vertices[a + 1] * s + mesh.vertices[a + kSide + 1] * (1 - s));
      }
  // Straight down, edges on the ray's own axes.
  Mesh flat;
  flat.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  flat.triangles = {{0, 1, 2}, {0, 2, 3}};
  const auto square = ray_tree_of(flat);
  for (const double x : {0.0, 0.25, 0.5, 1.0})
    for (const double y : {0.0, 0.25, 0.5, 1.0}) {
      RayHit hit;
      CHECK(square->nearest({{x, y, 2}, {0, 0, -1}}, hit));
      CHECK(hit.t == 2);
    }
  MESSAGE(missed << " of " << rays << " rays at edges and corners slipped through");
  CHECK(missed == 0);
}

TEST_CASE("triangle_tree__respects_the_interval_of_the_ray") {
  Mesh mesh;
  for (double z = 1; z <= 5; ++z) mesh.add({-1, -1, z}, {3, -1, z}, {-1, 3, z});
  const auto tree = ray_tree_of(mesh);
  RayHit hit;
  REQUIRE(tree->nearest({{0, 0, 0}, {0, 0, 2}, 1.0, 10}, hit));  // z = 2 is at t = 1, closed
  CHECK(hit.triangle == 1);
  REQUIRE(tree->nearest({{0, 0, 0}, {0, 0, 2}, 1.25, 1.5}, hit));
  CHECK(hit.triangle == 2);
  CHECK_FALSE(tree->nearest({{0, 0, 0}, {0, 0, 2}, 1.6, 1.9}, hit));
  CHECK_FALSE(tree->occluded({{0, 0, 0}, {0, 0, 1}, 0, 0.999}));
  CHECK(tree->occluded({{0, 0, 0}, {0, 0, 1}, 0, 1}));
  CHECK_FALSE(tree->occluded({{0, 0, 6}, {0, 0, 1}}));
}

TEST_CASE(
    "triangle_tree__gives_the_same_bits_after_a_shift_by_whole_metres_and_on_any_number_of_"
    "threads") {
  const Mesh mesh = ray_mesh(40000, 21, 50);  // above the size of one subtree
  const Vec3 shift{652000, 6861000, 35};
  const auto one = ray_tree_of(mesh, 1), two = ray_tree_of(mesh, 2), seven = ray_tree_of(mesh, 7);
  const auto far = ray_tree_of(mesh.shifted(shift), 2);
  CHECK(far->origin() - one->origin() == shift);
  RandomStream random(21, 2);
  size_t hits = 0;
  for (int i = 0; i < 20000; ++i) {
    const Ray ray = random_ray(random, 50);
    RayHit a, b, c, d;
    const bool found = one->nearest(ray, a);
    REQUIRE(two->nearest(ray, b) == found);
    REQUIRE(seven->nearest(ray, c) == found);
    REQUIRE(far->nearest({ray.origin + shift, ray.direction}, d) == found);
    if (!found) continue;
    ++hits;
    REQUIRE((a.t == b.t && a.t == c.t && a.t == d.t));
    REQUIRE((a.triangle == b.triangle && a.triangle == c.triangle && a.triangle == d.triangle));
  }
  CHECK(hits > 10000);
}

TEST_CASE("triangle_tree__survives_impossible_meshes_and_rays") {
  const double inf = std::numeric_limits<double>::infinity(),
               nan = std::numeric_limits<double>::quiet_NaN();
  RayHit hit;
  const auto none = ray_tree_of({});
  CHECK(none->size() == 0);
  CHECK(none->local_bounds().empty());
  CHECK_FALSE(none->nearest({{0, 0, 0}, {0, 0, 1}}, hit));

  Mesh points;
  for (int i = 0; i < 20000; ++i)
    points.add({1, 2, 3}, {1, 2, 3}, {1, 2, 3});  // all centres equal: split by count
  CHECK_FALSE(ray_tree_of(points)->nearest({{0, 0, 0}, {1, 2, 3}}, hit));

  Mesh spiral;  // sizes over 60 octaves: very uneven splits
  for (int i = 0; i < 60; ++i) {
    const double s = std::ldexp(1, -i);
    for (int k = 0; k < 40; ++k) spiral.add({s, 0, 0}, {s, s, 0}, {s, 0, s});
  }
  CHECK(ray_tree_of(spiral)->nearest({{-1, 0.125, 0.125}, {1, 0, 0}}, hit));

  Mesh one;
  one.add({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const auto tree = ray_tree_of(one);
  for (const Vec3& d : {Vec3{0, 0, 0}, Vec3{nan, 0, 1}, Vec3{0, inf, 1}})
    CHECK_FALSE(tree->nearest({{0.2, 0.2, 1}, d}, hit));
  CHECK_FALSE(tree->nearest({{nan, 0, 0}, {0, 0, 1}}, hit));
  CHECK_FALSE(tree->nearest({{1e300, 1e300, 1}, {0, 0, -1}}, hit));
  CHECK_FALSE(tree->nearest({{0.2, 0.2, 1}, {0, 0, -1}, 5, 4}, hit));
  CHECK(tree->nearest({{0.2, 0.2, 1}, {0, 0, -1e-300}}, hit));
  CHECK(tree->nearest({{0.2, 0.2, 1e7}, {0, 0, -1}}, hit));
  CHECK(tree->nearest({{0.2, 0.2, 1}, {-0.0, 0.0, -1}}, hit));
  CHECK_FALSE(tree->nearest({{-5, 0.2, 0}, {1, 0, 0}},
                            hit));  // in the triangle's own plane: no area is seen

  Mesh vast;
  vast.add({0, 0, 0}, {2e9, 0, 0}, {0, 1, 0});
  CHECK_THROWS_AS(ray_tree_of(vast), Error);
}

TEST_CASE("triangle_tree__stops_when_cancelled") {
  const Mesh mesh = ray_mesh(100000, 3);
  std::atomic<bool> cancel{true};
  Task::Hooks hooks;
  hooks.cancel = &cancel;
  Task task(hooks);
  CHECK_THROWS_AS(TriangleTree::build(mesh.vertices, mesh.triangles, task), Error);
}

TEST_CASE("triangle_tree__speed") {
  using Clock = std::chrono::steady_clock;
  const auto since = [](Clock::time_point t) {
    return std::chrono::duration<double>(Clock::now() - t).count();
  };
  constexpr uint32_t kSide = 500;  // a rough terrain of 500 000 triangles on 50 x 50 m
  Mesh mesh;
  RandomStream random(9, 1);
  for (uint32_t j = 0; j <= kSide; ++j)
    for (uint32_t i = 0; i <= kSide; ++i)
      mesh.vertices.push_back(
          {0.1 * i, 0.1 * j,
           2 * std::sin(0.02 * i) * std::sin(0.03 * j) + 0.05 * random.uniform()});
  for (uint32_t j = 0; j < kSide; ++j)
    for (uint32_t i = 0; i < kSide; ++i) {
      const uint32_t a = j * (kSide + 1) + i, b = a + kSide + 1;
      mesh.triangles.push_back({a, a + 1, b});
      mesh.triangles.push_back({b + 1, b, a + 1});
    }
  const auto start = Clock::now();
  const auto tree = ray_tree_of(mesh);
  const double build_s = since(start);
  const auto cast = Clock::now();
  size_t hits = 0;
  for (int j = 0; j < 1000; ++j)
    for (int i = 0; i < 1000; ++i) {
      RayHit hit;
      const double az = 0.006 * i, el = -1.2e-3 * j;
      hits += tree->nearest(
          {{25, 25, 5}, {std::cos(az) * std::cos(el), std::sin(az) * std::cos(el), std::sin(el)}},
          hit);
    }
  const double cast_s = since(cast);
  MESSAGE("terrain of " << mesh.triangles.size() << " triangles: built in " << 1e3 * build_s
                        << " ms, "
                        << static_cast<double>(tree->memory_bytes()) /
                               static_cast<double>(mesh.triangles.size())
                        << " B each; " << 1 / cast_s << " M rays/s a thread, " << hits << " hits");
  CHECK(hits > 500000);
}
