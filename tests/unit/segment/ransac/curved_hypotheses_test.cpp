// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Draws of spheres and cylinders on scenes of one shape; the inlier test against angles and distances made by hand.
#include <doctest/doctest.h>

#include <cmath>

#include "base/numbers.h"
#include "segment/ransac/curved_hypotheses.h"
#include "unit/segment/curved_scenes.h"

using namespace jalon;
using namespace jalon::test;

namespace {

// The draws of a scene that give a candidate.
std::vector<Candidate> drawn(MadeScene& made, uint64_t draws) {
  const PointPool pool(made.scene, made.task);
  std::vector<Candidate> out;
  Candidate candidate;
  for (uint64_t i = 0; i < draws; ++i)
    if (draw_curved(made.scene, pool, i, made.task, candidate)) out.push_back(candidate);
  return out;
}

SurfaceSettings only(Primitives primitives) {
  SurfaceSettings settings;
  settings.primitives = primitives;
  settings.max_radius_m = kWidest_m;
  return settings;
}

}  // namespace

TEST_CASE("curved_test__takes_points_by_distance_and_by_the_angle_of_their_normal") {
  RandomStream random(1, 23);
  MadeScene made({{0, 0, 0}, {1, 1, 1}, {2, 0, 1}}, all_primitives());
  const double tolerance_m = 0.025, edge_m = 0.1,
               turn_rad = made.scene.settings.normal_tolerance_rad;
  for (int round = 0; round < 50; ++round) {
    const Vec3 axis = normalized(Vec3{random.normal(), random.normal(), random.normal()});
    const Cylinder pipe{{0.1, 0.2, 0.3}, axis, 0.2 + 0.5 * random.uniform()};
    const double most_rad = turn_rad + edge_m / (2 * pipe.radius);
    const auto e = across(axis);
    std::vector<float> columns(6 * kBlockPoints);
    std::vector<int> expected(kBlockPoints, -1);  // 1 in, 0 out, -1 too near to tell in floats
    for (size_t i = 0; i < kBlockPoints; ++i) {
      const double a = kFullTurn_rad * random.uniform(), off = 0.1 * (random.uniform() - 0.5),
                   turn = std::numbers::pi / 2 * random.uniform();
      const Vec3 out = std::cos(a) * e[0] + std::sin(a) * e[1];
      const Vec3 p = pipe.point + random.uniform() * axis + (pipe.radius + off) * out;
      const double side = random.uniform() < 0.5 ? -1 : 1;  // normals have no sign
      const Vec3 n = side * (std::cos(turn) * out + std::sin(turn) * axis);
      const bool unknown = i % 8 == 0;
      for (size_t k = 0; k < 3; ++k) {
        columns[k * kBlockPoints + i] = static_cast<float>(p[static_cast<int>(k)]);
        columns[(3 + k) * kBlockPoints + i] =
            unknown ? kFloatNaN : static_cast<float>(n[static_cast<int>(k)]);
      }
      if (std::fabs(std::fabs(off) - tolerance_m) < 1e-5 || std::fabs(turn - most_rad) < 1e-4)
        continue;
      expected[i] = std::fabs(off) < tolerance_m && (unknown || turn < most_rad);
    }
    const float* c = columns.data();
    const PointColumns block{c,
                             c + kBlockPoints,
                             c + 2 * kBlockPoints,
                             c + 3 * kBlockPoints,
                             c + 4 * kBlockPoints,
                             c + 5 * kBlockPoints};
    uint32_t mask[kBlockPoints / 32];
    mark_curved(block, curved_test(made.scene, Curved(pipe), edge_m, tolerance_m), mask);
    for (size_t i = 0; i < kBlockPoints; ++i)
      if (expected[i] >= 0)
        CHECK((mask[i / 32] >> (i % 32) & 1) == static_cast<uint32_t>(expected[i]));
  }
}

TEST_CASE("curved_test__where_a_cell_turns_by_a_right_angle_no_normal_is_asked") {
  MadeScene made({{0, 0, 0}, {1, 1, 1}, {2, 0, 1}}, all_primitives());
  std::vector<float> x(kBlockPoints, kFloatNaN), zero(kBlockPoints, 0), one(kBlockPoints, 1);
  x[0] = 0.05f;  // on the pipe of 5 cm, with a normal along the axis; on the axis itself
  x[1] = 0.0f;
  const PointColumns block{x.data(),    zero.data(), zero.data(),
                           zero.data(), zero.data(), one.data()};
  const Curved pipe(Cylinder{{0, 0, 0}, {0, 0, 1}, 0.05});
  const auto count = [&](double edge_m, double tolerance_m) {
    return count_curved_baseline(block, curved_test(made.scene, pipe, edge_m, tolerance_m));
  };
  CHECK(count(0, 0.025) == 0);
  CHECK(count(0.2, 0.025) == 1);
  CHECK(count(0.2, 0.06) == 2);  // a tolerance beyond the radius reaches the axis
}

TEST_CASE("curved_inconsistent__normals_of_another_surface_and_only_while_they_are_asked_for") {
  Scene scene;
  RandomStream random(2, 23);
  const Cylinder pipe{{0.5, 0.5, 1}, {0, 0, 1}, 0.4};
  add_pipe(scene, 1, {pipe, 2}, 4000, 0.002, random);
  for (const NormalSource source : {NormalSource::kCells, NormalSource::kNone}) {
    SurfaceSettings settings = all_primitives();
    settings.normals = source;
    const MadeScene made(scene.points, settings);
    const Curved own = to_local(made, Curved(pipe));
    Cylinder through = pipe;  // whose axis goes through the pipe's wall
    through.point += Vec3{0.4, 0, 0};
    const Curved other = to_local(made, Curved(through));
    size_t wrong = 0, told = 0, at_right_angles = 0;
    for (size_t p = 0; p < made.scene.size(); ++p) {
      wrong += curved_inconsistent(made.scene, own, p);
      const Vec3 out = scene.points[made.point(p)] - pipe.point;
      const Vec3 away = scene.points[made.point(p)] - through.point;
      const Vec3 a = normalized(Vec3{out.x, out.y, 0}), b = normalized(Vec3{away.x, away.y, 0});
      if (std::fabs(dot(a, b)) > 0.2) continue;
      ++at_right_angles;
      told += curved_inconsistent(made.scene, other, p);
    }
    REQUIRE(at_right_angles > 50);
    CHECK(wrong * 100 < made.scene.size());
    if (source == NormalSource::kCells) CHECK(told * 10 > 9 * at_right_angles);
    else CHECK(told == 0);
  }
}

TEST_CASE("draw_curved__draws_on_a_ball_or_pipe_give_it_and_on_a_wall_nothing") {
  Scene ball, pipe, wall;
  RandomStream random(3, 23);
  const Sphere globe{{1, 1, 1}, 0.7};
  const Cylinder column{{1, 1, 1}, normalized(Vec3{0.1, 0.2, 1}), 0.3};
  add_ball(ball, 1, globe, -1, 4000, 0.002, random);
  add_pipe(pipe, 1, {column, 2}, 4000, 0.002, random);
  wall.rectangle(1, {0, 0, 0}, {2, 0, 0}, {0, 0, 2}, 4000, 0.004, random);
  MadeScene globes(ball.points, only(Primitives::kPlanesAndSpheres)),
      columns(pipe.points, only(Primitives::kPlanesAndCylinders)),
      walls(wall.points, all_primitives());
  const auto spheres = drawn(globes, 400), cylinders = drawn(columns, 400);
  CHECK(spheres.size() >= 50);  // one in eight, as the sequence of draws reckons
  CHECK(cylinders.size() >= 50);
  CHECK(drawn(walls, 400).empty());
  size_t good = 0;
  for (const Candidate& c : spheres) {
    REQUIRE(c.curved.is_sphere());
    good += std::fabs(c.curved.radius / globe.radius - 1) < 0.1;
    CHECK(globes.scene.owner[c.seed] == 0);
  }
  CHECK(2 * good > spheres.size());
  good = 0;
  for (const Candidate& c : cylinders) {
    REQUIRE(c.curved.type == PrimitiveType::kCylinder);
    good += std::fabs(c.curved.radius / column.radius - 1) < 0.1 &&
            std::fabs(dot(c.curved.axis, column.direction)) > std::cos(0.1);
  }
  CHECK(2 * good > cylinders.size());
  const auto again = drawn(globes, 400);  // a draw is a function of its number
  REQUIRE(again.size() == spheres.size());
  for (size_t i = 0; i < again.size(); ++i)
    CHECK(again[i].curved.radius == spheres[i].curved.radius);
}

TEST_CASE("draw_curved__of_a_pool_without_free_points_there_is_nothing_to_draw") {
  Scene ball;
  RandomStream random(4, 23);
  add_ball(ball, 1, {{1, 1, 1}, 0.7}, -1, 2000, 0.002, random);
  MadeScene made(ball.points, all_primitives());
  std::fill(made.scene.owner.begin(), made.scene.owner.end(), 1u);
  CHECK(drawn(made, 50).empty());
}
