// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "base/error.h"
#include "solid/surface_depth.h"
#include "solid/surface_pair.h"
#include "solid/surface_points.h"
#include "unit/solid/bodies.h"

using namespace jalon;
using namespace jalon::test;

namespace {

using Triangles = std::vector<std::array<uint32_t, 3>>;

/// The sides of a box as twelve triangles, outward.
struct Block {
  brute::Quaternion turn;
  Vec3 at, size;
  std::vector<Vec3> vertices;
  Triangles triangles{{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};

  explicit Block(RandomStream& random, double spread)
      : turn(brute::any_turn(random, 3)),
        at(brute::any_vector(random, spread)),
        size(brute::any_vector(random, 0.8) + Vec3{1, 1, 1}) {
    for (const Vec3& p : box_corners(size)) vertices.push_back(brute::rotation_of(turn)(p) + at);
  }
  double distance(const Vec3& p) const {
    return brute::box(size)(brute::rotation_of(turn).back(p - at));
  }
};

// Least distance of two triangles: corners against the other's inside, sides against sides, 0 where a side pierces.
double brute_pair(const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b) {
  double best = std::numeric_limits<double>::infinity();
  const auto from_triangle = [](const std::array<Vec3, 3>& t, const Vec3& p) {
    return brute::least_on_triangle([&](const Vec3& q) { return norm(p - q); }, t[0], t[1], t[2]);
  };
  for (size_t i = 0; i < 3; ++i) {
    const Vec3 from = a[i], along = a[(i + 1) % 3] - a[i];
    best = std::min(
        best,
        brute::valley([&](double t) { return from_triangle(b, from + along * t); }, 0, 1, 45));
    best = std::min(best, from_triangle(a, b[i]));
  }
  return best;
}

}  // namespace

TEST_CASE("clearance_of_points__equals_brute_force_on_random_blocks") {
  RandomStream random(11, 0);
  double worst = 0;
  for (int scene = 0; scene < 200; ++scene) {
    const Block block(random, 3);
    std::vector<double> xyz;
    const double spread = scene % 2 ? 2 : 8;
    for (int i = 0; i < 300; ++i) {
      const Vec3 p = brute::any_vector(random, spread);
      for (int k = 0; k < 3; ++k) xyz.push_back(p[k]);
    }
    Box3 box;
    double least = std::numeric_limits<double>::infinity();
    std::vector<std::pair<uint32_t, double>> near;
    uint64_t inside = 0;
    for (uint32_t i = 0; i < 300; ++i) {
      const Vec3 p{xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]};
      box.add(p);
      const double d = block.distance(p);
      least = std::min(least, d);
      inside += d < 0;
      if (d <= 0.5) near.emplace_back(i, d);
    }
    Task task;
    const PartSurface surface(block.vertices, block.triangles, task);
    REQUIRE(surface.is_closed());
    CHECK(surface.convex().has_value());
    const auto octree = Octree::build(xyz, enclosing_cube(box), task);
    const PointClearance found = clearance_of_points(surface, *octree, xyz, 0.5, task);
    worst = std::max(worst, std::abs(found.least.distance_m - least));
    CHECK(found.inside == inside);
    REQUIRE(found.near.size() == near.size());
    for (size_t i = 0; i < near.size(); ++i) {
      CHECK(found.near[i].point == near[i].first);
      worst = std::max(worst, std::abs(found.near[i].distance_m - near[i].second));
    }
  }
  MESSAGE(
      "FIGURE clearance of clouds from closed parts, 200 random scenes: worst difference from "
      "brute force "
      << worst << " m");
  CHECK(worst < 1e-6);
}

TEST_CASE("surface__without_a_side_is_open_and_turned_inside_out_is_turned_back") {
  RandomStream random(12, 0);
  Block block(random, 1);
  Task task;
  Triangles inward = block.triangles;
  for (auto& t : inward) std::swap(t[0], t[1]);
  const PartSurface turned(block.vertices, inward, task);
  CHECK(turned.is_closed());
  CHECK(turned.nearest().nearest(block.at).is_behind);
  block.triangles.pop_back();
  CHECK_FALSE(PartSurface(block.vertices, block.triangles, task).is_closed());
}

TEST_CASE("depth_in__of_two_blocks_equals_a_search_and_does_not_need_convexity") {
  RandomStream random(13, 0);
  double worst = 0;
  for (int scene = 0; scene < 60; ++scene) {
    const Block a(random, 1), b(random, 0.7);
    Task task;
    const PartSurface first(a.vertices, a.triangles, task), second(b.vertices, b.triangles, task);
    double truth = 0;
    for (const auto& t : a.triangles)
      truth = std::max(
          truth, -brute::least_on_triangle([&](const Vec3& p) { return b.distance(p); },
                                           a.vertices[t[0]], a.vertices[t[1]], a.vertices[t[2]]));
    worst = std::max(worst, std::abs(depth_in(first, second, 0.005, task).depth_m - truth));
    if (scene >= 10) continue;
    // The same volume and a small block far away: closed, not convex.
    std::vector<Vec3> vertices = b.vertices;
    Triangles triangles = b.triangles;
    for (const Vec3& v : a.vertices) vertices.push_back(v * 0.1 + Vec3{50, 0, 0});
    for (auto t : a.triangles) {
      for (uint32_t& v : t) v += 8;
      triangles.push_back(t);
    }
    const PartSurface both(vertices, triangles, task);
    REQUIRE(both.is_closed());
    REQUIRE_FALSE(both.convex().has_value());
    const double depth = depth_in(first, both, 0.01, task).depth_m;
    CHECK(depth <= truth + 1e-7);
    CHECK(depth >= truth - 0.01);
  }
  MESSAGE("FIGURE depth of a block in a block, 60 random scenes: worst difference from brute force "
          << worst << " m");
  CHECK(worst < 1e-6);
}

#ifdef JALON_WITH_FCL

TEST_CASE("clearance_of_surfaces__equals_brute_force_on_random_blocks") {
  RandomStream random(14, 0);
  double worst = 0;
  int meeting = 0;
  for (int scene = 0; scene < 200; ++scene) {
    const Block a(random, 1), b(random, scene % 2 ? 2.5 : 1);
    Task task;
    const PartSurface first(a.vertices, a.triangles, task), second(b.vertices, b.triangles, task);
    const PairClearance found = clearance_of_surfaces(first, second, {0.4, 0.005}, task);
    // Two convex bodies: one's distance over the other's sides is convex.
    double apart = std::numeric_limits<double>::infinity();
    for (const auto& t : a.triangles)
      apart = std::min(
          apart, brute::least_on_triangle([&](const Vec3& p) { return b.distance(p); },
                                          a.vertices[t[0]], a.vertices[t[1]], a.vertices[t[2]]));
    for (const auto& t : b.triangles)
      apart = std::min(
          apart, brute::least_on_triangle([&](const Vec3& p) { return a.distance(p); },
                                          b.vertices[t[0]], b.vertices[t[1]], b.vertices[t[2]]));
    CHECK(found.meet == (apart <= 0));
    meeting += found.meet;
    const double value = found.meet ? -found.depth_m : found.least.distance_m;
    worst = std::max(worst, std::abs(value - apart));
    if (!found.meet)
      CHECK(norm(found.least.first_point - found.least.second_point) ==
            doctest::Approx(apart).epsilon(1e-6));
    for (const NearTriangle& near : found.near) {
      CHECK(near.distance_m <= 0.4);
      CHECK(std::abs(a.distance(near.first_point)) < 1e-9);
      CHECK(std::abs(b.distance(near.second_point)) < 1e-9);
    }
  }
  MESSAGE("FIGURE clearance of two closed parts, 200 random scenes, "
          << meeting
          << " meeting: worst difference from "
             "brute force "
          << worst << " m");
  CHECK(worst < 1e-6);
}

TEST_CASE("clearance_of_surfaces__of_open_triangles_equals_brute_force") {
  RandomStream random(15, 0);
  double worst = 0;
  for (int scene = 0; scene < 60; ++scene) {
    std::vector<std::array<Vec3, 3>> sets[2];
    std::vector<Vec3> vertices[2];
    Triangles triangles[2];
    for (int k = 0; k < 2; ++k)
      for (uint32_t i = 0; i < 3; ++i) {
        const Vec3 at = brute::any_vector(random, 3);
        sets[k].push_back(
            {at, at + brute::any_vector(random, 1), at + brute::any_vector(random, 1)});
        for (const Vec3& v : sets[k].back()) vertices[k].push_back(v);
        triangles[k].push_back({3 * i, 3 * i + 1, 3 * i + 2});
      }
    double truth = std::numeric_limits<double>::infinity();
    for (const auto& a : sets[0])
      for (const auto& b : sets[1]) truth = std::min({truth, brute_pair(a, b), brute_pair(b, a)});
    Task task;
    const PairClearance found =
        clearance_of_surfaces(PartSurface(vertices[0], triangles[0], task),
                              PartSurface(vertices[1], triangles[1], task), {0, 0.005}, task);
    worst = std::max(worst, std::abs(found.least.distance_m - truth));
    CHECK(std::isnan(found.depth_m));
  }
  CHECK(worst < 1e-6);
}

#endif
