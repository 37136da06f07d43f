// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Seeds of region growing against scenes of known walls and clutter; bends against surfaces of known radius.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "segment/growing/flatness.h"
#include "unit/segment/scenes.h"

using namespace jalon;
using namespace jalon::test;

namespace {

struct FlatnessScene {
  CloudPtr cloud;
  Task task;
  SegmentScene scene;
  GrowingPoints points;

  explicit FlatnessScene(const std::vector<Vec3>& xyz)
      : cloud(cloud_of(xyz)),
        scene(indexed_scene(*cloud, GrowingSettings{}.surface, task)),
        points(points_to_grow(scene, GrowingSettings{}, task)) {}

  /// Index in the cloud of the first point of a leaf.
  uint32_t first_of(size_t leaf) const {
    return scene.order[points.position(points.leaf_first()[leaf])];
  }
};

// A quiet wall, a noisier one at right angles to it, and a cloud of scatter beside them.
Scene walls_and_scatter() {
  Scene out;
  RandomStream random(3, 11);
  out.rectangle(1, {0, 0, 0}, {3, 0, 0}, {0, 0, 2}, 4000, 0.001, random);
  out.rectangle(2, {-1, 1, 0}, {0, 3, 0}, {0, 0, 2}, 4000, 0.006, random);
  out.outliers({6, 0, 0}, {8, 2, 2}, 2500, random);
  return out;
}

// Whether points of z = height(x, y) over the rectangle are judged bent.
template <class F>
bool bent(double half_x_m, double half_y_m, F&& height) {
  RandomStream random(5, 11);
  std::vector<Vec3> xyz;
  for (int i = 0; i < 1500; ++i) {
    const double x = half_x_m * (2 * random.uniform() - 1),
                 y = half_y_m * (2 * random.uniform() - 1);
    xyz.push_back({x, y, height(x, y) + 0.001 * random.normal()});
  }
  const FlatnessScene made(xyz);
  std::vector<uint32_t> members(made.points.tree->size());
  Moments moments;
  for (uint32_t i = 0; i < members.size(); ++i) {
    members[i] = i;
    moments.add(made.points.tree->local(i));
  }
  PlaneFit fit;
  REQUIRE(fit_plane(moments, fit));
  return is_bent(fit, made.points, members);
}

}  // namespace

TEST_CASE("flatness__seeds_stand_on_walls_with_their_normals_and_never_among_scatter") {
  const Scene scene = walls_and_scatter();
  FlatnessScene made(scene.points);
  const auto seeds = seeds_by_flatness(made.scene, made.points, made.task);
  size_t on[3] = {0, 0, 0}, leaves[3] = {0, 0, 0};
  for (size_t leaf = 0; leaf < made.points.leaves(); ++leaf)
    ++leaves[scene.faces[made.first_of(leaf)]];
  for (const uint32_t leaf : seeds) {
    const int face = scene.faces[made.first_of(leaf)];
    ++on[face];
    PlaneFit fit;
    REQUIRE(seed_plane(made.scene, made.points, leaf, fit));
    if (face == 0) continue;
    // 12 points with an rms width of 5 cm or more: 6 mm / (0.05 sqrt(12)) = 2 degrees; four of these.
    const Vec3& n = fit.plane.normal;
    CHECK(std::fabs(face == 1 ? n.y : n.x) > std::cos(0.14));
  }
  CHECK(on[0] == 0);
  CHECK(2 * on[1] > leaves[1]);
  CHECK(on[2] > 0);
}

TEST_CASE("flatness__the_quietest_wall_seeds_first") {
  const Scene scene = walls_and_scatter();
  FlatnessScene made(scene.points);
  const auto seeds = seeds_by_flatness(made.scene, made.points, made.task);
  REQUIRE(seeds.size() > 20);
  double before = 0;
  for (const uint32_t leaf : seeds) {
    PlaneFit fit;
    REQUIRE(seed_plane(made.scene, made.points, leaf, fit));
    CHECK(static_cast<float>(fit.sigma) >= static_cast<float>(before));
    before = fit.sigma;
  }
  // 1 mm against 6 mm, a sigma of 12 points is right to a fifth: none of the noisy wall may come among the first.
  for (size_t i = 0; i < 20; ++i) CHECK(scene.faces[made.first_of(seeds[i])] == 1);
}

TEST_CASE("flatness__points_that_are_taken_give_no_seed") {
  const Scene scene = walls_and_scatter();
  FlatnessScene made(scene.points);
  for (size_t p = 0; p < made.scene.size(); ++p)
    made.scene.owner[p] = scene.faces[made.scene.order[p]] == 1 ? 7 : 0;
  const auto seeds = seeds_by_flatness(made.scene, made.points, made.task);
  CHECK_FALSE(seeds.empty());
  for (const uint32_t leaf : seeds) {
    const auto first = made.points.leaf_first();
    size_t free = 0;
    for (size_t i = first[leaf]; i < first[leaf + 1]; ++i)
      free += made.scene.owner[made.points.position(i)] == 0;
    CHECK(free >= 5);
  }
  std::fill(made.scene.owner.begin(), made.scene.owner.end(), 1u);
  CHECK(seeds_by_flatness(made.scene, made.points, made.task).empty());
}

TEST_CASE("flatness__beside_a_step_a_leaf_seeds_its_own_side") {
  Scene steps;
  RandomStream random(7, 11);
  steps.rectangle(1, {0, 0, 0}, {1, 0, 0}, {0, 0, 2}, 1400, 0.002, random);
  steps.rectangle(2, {1, 0.06, 0}, {1, 0, 0}, {0, 0, 2}, 1400, 0.002, random);
  FlatnessScene made(steps.points);
  const auto face_of = [&](size_t leaf) { return steps.faces[made.first_of(leaf)]; };
  size_t beside = 0, seeding = 0;
  for (size_t leaf = 0; leaf < made.points.leaves(); ++leaf) {
    const auto near = made.points.graph.of(leaf);
    if (std::none_of(near.begin(), near.end(),
                     [&](uint32_t other) { return face_of(other) != face_of(leaf); }))
      continue;
    ++beside;
    PlaneFit fit;
    if (!seed_plane(made.scene, made.points, leaf, fit)) continue;
    ++seeding;
    const Vec3 own = steps.points[made.first_of(leaf)] - made.scene.origin;
    CHECK(std::fabs(fit.plane.distance(own)) < 0.012);  // six sigma; the other side is 60 mm off
  }
  REQUIRE(beside > 20);
  CHECK(2 * seeding > beside);  // some leaves hold points of both sides
}

TEST_CASE("flatness__slabs_and_noise_as_wide_as_a_leaf_seed_nothing") {
  const auto seeds = [](double side_m, double sigma_m) {
    Scene slab;
    RandomStream random(8, 11);
    slab.rectangle(1, {0, 0, 0}, {side_m, 0, 0}, {0, side_m, 0}, 2500, sigma_m, random);
    FlatnessScene made(slab.points);
    return seeds_by_flatness(made.scene, made.points, made.task).size();
  };
  CHECK(seeds(40, 0.003) > 80);  // 0.8 m apart: of some 250 leaves
  CHECK(seeds(40, 0.050) < 10);  // flat, but four times as thick as a seed may be; few by chance
  CHECK(seeds(0.5, 0.010) < 3);  // within the tolerance, but 1 cm apart
}

TEST_CASE("flatness__a_surface_is_bent_when_it_turns_by_more_than_20_degrees_end_to_end") {
  // z = x^2 / (2 R) turns by 2 half_x / R; the limit is 0.35 rad. Along the longer side, the shorter one, and twisted.
  const auto arch = [](double radius_m) {
    return [radius_m](double x, double) { return x * x / (2 * radius_m); };
  };
  CHECK_FALSE(bent(0.5, 0.3, [](double, double) { return 0.0; }));
  for (const double half_y_m : {0.1, 1.0}) {
    CHECK_FALSE(bent(0.3, half_y_m, arch(0.6 / 0.25)));
    CHECK(bent(0.3, half_y_m, arch(0.6 / 0.45)));
  }
  CHECK_FALSE(bent(0.5, 0.4, [](double x, double y) { return 0.25 * x * y; }));
  CHECK(bent(0.5, 0.4, [](double x, double y) { return 0.6 * x * y; }));
}
