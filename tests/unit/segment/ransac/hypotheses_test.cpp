// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Draws of planes on scenes of known walls, and bounds of their scores against the counts by brute force.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "unit/segment/made_scene.h"

using namespace jalon;
using namespace jalon::test;

namespace {

Scene wall_floor_and_scatter() {
  Scene out;
  RandomStream random(1, 26);
  out.rectangle(1, {0, 0, 0.1}, {3, 0, 0}, {0, 0, 2}, 5000, 0.003, random);
  out.rectangle(2, {0, -3, 0}, {3, 0, 0}, {0, 2.9, 0}, 5000, 0.003, random);
  out.outliers({0, -3, 0}, {3, 1, 3}, 1000, random);
  return out;
}

// Points of the pool within the tolerance of the plane whose normals do not disagree, in doubles.
size_t inliers_by_force(const SegmentScene& scene, const Plane& plane) {
  size_t count = 0;
  for (size_t p = 0; p < scene.size(); ++p)
    count += std::fabs(plane.distance(scene.local(p))) <= scene.settings.distance_tolerance_m &&
             !scene.inconsistent(p, plane.normal, scene.min_cosine());
  return count;
}

Plane random_plane(const SegmentScene& scene, RandomStream& random) {
  Plane out;
  out.normal = normalized(Vec3{random.normal(), random.normal(), random.normal()});
  out.offset = dot(out.normal, scene.local(random.below(scene.size())));
  return out;
}

}  // namespace

TEST_CASE("draw_candidate__a_quarter_of_the_draws_or_more_give_a_plane_and_it_is_a_true_one") {
  const Scene scene = wall_floor_and_scatter();
  MadeScene made(scene.points);
  const PointPool pool(made.scene, made.task);
  size_t drawn = 0, near = 0;
  constexpr uint64_t kDraws = 1000;
  for (uint64_t i = 0; i < kDraws; ++i) {
    Candidate c;
    if (!draw_candidate(made.scene, pool, {}, i, c)) continue;
    ++drawn;
    CHECK(norm(c.plane.normal) == doctest::Approx(1));
    const int face = scene.faces[made.point(c.seed)];
    const double turn = face == 2 ? c.plane.normal.z : c.plane.normal.y;
    near += face != 0 && std::fabs(turn) > std::cos(0.1);
    Candidate again;
    REQUIRE(draw_candidate(made.scene, pool, {}, i, again));  // a function of its number
    CHECK(again.seed == c.seed);
    CHECK(again.plane.offset == c.plane.offset);
  }
  CHECK(4 * drawn > kDraws);
  CHECK(near * 10 > 9 * drawn);
}

TEST_CASE("draw_candidate__a_pass_of_one_class_gives_planes_of_exactly_that_direction") {
  const Scene scene = wall_floor_and_scatter();
  MadeScene made(scene.points);
  const PointPool pool(made.scene, made.task);
  OrientationPass pass;
  pass.wanted = Orientation::kHorizontal;
  pass.tolerance_rad = 0.0174533;
  pass.draw_tolerance_rad = 0.26;
  size_t drawn = 0;
  for (uint64_t i = 0; i < 1000; ++i) {
    Candidate c;
    if (!draw_candidate(made.scene, pool, pass, i, c)) continue;
    ++drawn;
    CHECK(std::fabs(c.plane.normal.z) == 1);
    CHECK(std::fabs(c.plane.distance(made.scene.local(c.seed))) < 0.05);  // two tolerances
  }
  CHECK(drawn > 100);  // the floor has 5 of 11 points: 0.45 / 4 of the draws
  std::fill(made.scene.rejections.begin(), made.scene.rejections.end(), kMostRejections);
  Candidate none;  // where draws have led to nothing, none starts again
  for (uint64_t i = 0; i < 100; ++i) CHECK_FALSE(draw_candidate(made.scene, pool, pass, i, none));
}

TEST_CASE("draw_candidate__global_draws_go_through_three_points_well_apart") {
  const Scene scene = wall_floor_and_scatter();
  SurfaceSettings settings;
  settings.normals = NormalSource::kNone;
  MadeScene made(scene.points, settings);
  made.scene.draw.sampling = Sampling::kGlobal;
  const PointPool pool(made.scene, made.task);
  size_t on_wall = 0, drawn = 0;
  for (uint64_t i = 0; i < 500; ++i) {
    Candidate c;
    if (!draw_candidate(made.scene, pool, {}, i, c)) continue;
    ++drawn;
    CHECK(std::fabs(c.plane.distance(made.scene.local(c.seed))) < 1e-9);
    on_wall += inliers_by_force(made.scene, c.plane) > 4000;
  }
  // Three of the wall, or of the floor: 2 (5 / 11)^3 = 0.19, less those that lie so close together that noise turns
  // the plane.
  CHECK(drawn > 475);
  made.scene.settings.distance_tolerance_m = 0.75;  // 1.5 m apart in a box of 3 x 4 x 3 m
  size_t apart = 0;
  Candidate c;
  for (uint64_t i = 0; i < 500; ++i) apart += draw_candidate(made.scene, pool, {}, i, c);
  CHECK(apart < 250);
  CHECK(on_wall > 50);
  CHECK(on_wall < 130);  // 0.19 and four sigma
}

TEST_CASE("draw_candidate__of_a_pool_without_free_points_there_is_nothing_to_draw") {
  const Scene scene = wall_floor_and_scatter();
  for (const Sampling sampling : {Sampling::kLocal, Sampling::kGlobal}) {
    MadeScene made(scene.points);
    made.scene.draw.sampling = sampling;
    std::fill(made.scene.owner.begin(), made.scene.owner.end(), 1u);
    const PointPool pool(made.scene, made.task);
    CHECK(pool.slots() == 0);
    Candidate c;
    for (uint64_t i = 0; i < 50; ++i) CHECK_FALSE(draw_candidate(made.scene, pool, {}, i, c));
    score_roughly(made.scene, pool, c, made.task);
    CHECK(c.upper == 0);
  }
}

TEST_CASE(
    "score__all_pieces_give_the_count_and_bounds_before_hold_it_about_as_often_as_one_sigma") {
  const Scene scene = wall_floor_and_scatter();
  MadeScene made(scene.points);
  size_t held = 0, looked = 0;
  for (uint64_t seed = 1; seed <= 40; ++seed) {
    made.scene.draw.seed = seed;  // other pieces
    const PointPool pool(made.scene, made.task);
    RandomStream random(seed, 27);
    for (int i = 0; i < 4; ++i) {
      Candidate c;
      c.plane = random_plane(made.scene, random);
      const auto truth = static_cast<double>(inliers_by_force(made.scene, c.plane));
      for (size_t piece = 0; piece < PointPool::kPieces; ++piece) {
        score_next_piece(made.scene, pool, c, made.task);
        CHECK(c.lower <= c.upper);
        CHECK(c.lower >= c.found);
        if (piece != 1 && piece != 2) continue;
        ++looked;
        held += c.lower <= truth && truth <= c.upper;
      }
      CHECK(std::fabs(c.lower - truth) <= 2);  // floats at the edge of the tolerance
      CHECK(c.lower == c.upper);
    }
  }
  // 68 % of 320, of which the two pieces of a plane hang together: sigma is 3.7 %; four of these.
  const double share = static_cast<double>(held) / static_cast<double>(looked);
  CHECK(share > 0.53);
  CHECK(share < 0.92);  // intervals that always hold would say nothing
}

TEST_CASE("score_roughly__stops_when_the_bounds_are_narrow_or_the_plane_is_too_small") {
  const Scene scene = wall_floor_and_scatter();
  MadeScene made(scene.points);
  const PointPool pool(made.scene, made.task);
  Candidate floor, air;
  floor.plane = {{0, 0, 1}, -made.scene.origin.z};
  air.plane = {{0, 0, 1}, 10};
  score_roughly(made.scene, pool, floor, made.task);
  CHECK(floor.pieces < PointPool::kPieces);
  CHECK(floor.upper - floor.lower <= 0.2 * floor.estimate);
  CHECK(floor.estimate ==
        doctest::Approx(5000).epsilon(0.3));  // bounds are narrow to 20 %, one sigma
  score_roughly(made.scene, pool, air, made.task);
  CHECK(air.found == 0);
  CHECK(air.upper < 50);
  CHECK(air.pieces < PointPool::kPieces);
}
