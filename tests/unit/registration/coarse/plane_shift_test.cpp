// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "registration/coarse/plane_match.h"
#include "unit/registration/coarse_scenes.h"

using namespace jalon;
using namespace jalon::test;

namespace {

/// Walls of a room of 6 x 5 m, and its floor and ceiling where it has them.
std::vector<CoarsePlane> room(bool has_floor) {
  std::vector<CoarsePlane> out = {
      {{{1, 0, 0}, 0}, 500}, {{{1, 0, 0}, 6}, 490}, {{{0, 1, 0}, 0}, 600}, {{{0, 1, 0}, 5}, 590}};
  if (has_floor) {
    out.push_back({{{0, 0, 1}, 0}, 900});
    out.push_back({{{0, 0, 1}, 2.8}, 880});
  }
  return out;
}

/// The planes seen from a frame that T takes to the room's, with normals of either sign.
std::vector<CoarsePlane> seen(const std::vector<CoarsePlane>& planes, const Transform& T) {
  const Transform back = inverse(T);
  std::vector<CoarsePlane> out;
  for (const CoarsePlane& p : planes) {
    const Vec3 n = back.direction(p.plane.normal) * (out.size() % 2 ? 1.0 : -1.0);
    const Vec3 on = back.point(p.plane.normal * p.plane.offset);
    out.push_back({{n, dot(n, on)}, p.cells});
  }
  return out;
}

struct Case {
  Transform truth = random_start(2, true), rotation = truth;
  CoarseSurface reference, moving;
  Case() {
    rotation.m[3] = rotation.m[7] = rotation.m[11] = 0;
    reference.cell_m = moving.cell_m = 0.1;
    reference.centroid = {3.1, 2.4, 1.5};
    moving.centroid = inverse(truth).point({2.7, 2.9, 1.2});
  }
};

double apart(const Transform& a, const Transform& b, const Vec3& at) {
  return norm(a.point(at) - b.point(at));
}

}  // namespace

TEST_CASE("plane_poses__parallel_planes_vote_for_the_true_shift_first") {
  const Case c;
  const auto reference = room(true), moving = seen(reference, c.truth);
  const auto poses =
      plane_poses(c.rotation, {reference, moving, false}, c.reference, c.moving, {}, 8);
  REQUIRE(poses.size() == 8);
  CHECK(apart(poses[0], c.truth, c.moving.centroid) < 1e-9);
  for (const Transform& pose : poses)
    for (const size_t i : {0, 1, 2, 4, 5, 6, 8, 9, 10}) CHECK(pose.m[i] == c.rotation.m[i]);
  CHECK(plane_poses(c.rotation, {reference, moving, false}, c.reference, c.moving, {}, 3).size() ==
        3);
}

TEST_CASE("plane_poses__features_decide_along_what_no_plane_bounds") {
  Case c;
  const auto reference = room(false), moving = seen(reference, c.truth);
  std::vector<FeatureMatch> matches;
  for (const Vec3& p : random_points(12, 2, 3)) {
    matches.push_back({static_cast<uint32_t>(c.moving.points.size()),
                       static_cast<uint32_t>(c.reference.points.size()), 0});
    c.reference.points.push_back(p);
    c.moving.points.push_back(inverse(c.truth).point(p));
  }
  const auto poses =
      plane_poses(c.rotation, {reference, moving, false}, c.reference, c.moving, matches, 8);
  REQUIRE_FALSE(poses.empty());
  CHECK(apart(poses[0], c.truth, c.moving.centroid) < 1e-9);
  // Without a word on it the reference's middle is taken.
  const auto blind =
      plane_poses(c.rotation, {reference, moving, false}, c.reference, c.moving, {}, 8);
  REQUIRE_FALSE(blind.empty());
  CHECK(blind[0].point(c.moving.centroid).z == doctest::Approx(1.5));
}

TEST_CASE("plane_poses__need_planes_that_face_two_ways") {
  const Case c;
  const std::vector<CoarsePlane> one = {room(false)[0], room(false)[1]};
  const auto moving = seen(one, c.truth);
  CHECK(plane_poses(c.rotation, {one, moving, false}, c.reference, c.moving, {}, 8).empty());
  CHECK(plane_poses(c.rotation, {one, {}, false}, c.reference, c.moving, {}, 8).empty());
}
