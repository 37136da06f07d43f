// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// The sequence of surfaces on a room corner with a ball: all of them, the best first, each point of one.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "segment/ransac/sequence.h"
#include "unit/segment/curved_scenes.h"

using namespace jalon;
using namespace jalon::test;

namespace {

// Floor, two walls, a ball; faces by falling size; scatter.
Scene corner_with_ball() {
  Scene out;
  RandomStream random(1, 30);
  out.rectangle(1, {0, 0, 0}, {4, 0, 0}, {0, 3, 0}, 6000, 0.003, random);
  out.rectangle(2, {0, 0, 0.05}, {4, 0, 0}, {0, 0, 2}, 4000, 0.003, random);
  out.rectangle(3, {0, 0.05, 0.05}, {0, 3, 0}, {0, 0, 2}, 3000, 0.003, random);
  add_ball(out, 4, {{2, 1.5, 1}, 0.5}, -1, 2000, 0.003, random);
  out.outliers({0, 0, 0}, {4, 3, 2}, 400, random);
  return out;
}

size_t points_of_face(const Scene& scene, int face) {
  return static_cast<size_t>(std::count(scene.faces.begin(), scene.faces.end(), face));
}

// The face that most of a surface's points are of.
int face_of(const MadeScene& made, const Scene& scene, const Surface& surface) {
  int best = 0;
  for (int face = 1; face <= 4; ++face)
    if (made.shared(scene.faces, face, surface) > made.shared(scene.faces, best, surface))
      best = face;
  return best;
}

}  // namespace

TEST_CASE("extract_sequence__every_surface_once_the_one_of_most_points_first") {
  const Scene scene = corner_with_ball();
  for (uint64_t seed = 1; seed <= 2; ++seed) {
    MadeScene made(scene.points, all_primitives());
    made.scene.draw.seed = seed;
    const auto surfaces = extract_sequence(made.scene, made.task);
    CAPTURE(seed);
    REQUIRE(surfaces.size() == 4);
    for (size_t s = 0; s < 4; ++s) {
      const int face = static_cast<int>(s) + 1;
      CHECK(face_of(made, scene, surfaces[s]) == face);
      CHECK(surfaces[s].curved.is_sphere() == (face == 4));
      CHECK(static_cast<double>(made.shared(scene.faces, face, surfaces[s])) >
            0.97 *
                static_cast<double>(points_of_face(scene, face)));  // some at the edges are others'
      for (const uint32_t p : surfaces[s].positions) CHECK(made.scene.owner[p] == s + 1);
    }
    size_t owned = 0;
    for (const Surface& surface : surfaces) owned += surface.positions.size();
    CHECK(owned + static_cast<size_t>(
                      std::count(made.scene.owner.begin(), made.scene.owner.end(), 0u)) ==
          scene.points.size());
  }
}

TEST_CASE("extract_sequence__planes_alone_leave_the_ball_and_max_planes_ends_it") {
  const Scene scene = corner_with_ball();
  MadeScene planes(scene.points), one(scene.points);
  one.scene.draw.max_planes = 1;
  const auto all = extract_sequence(planes.scene, planes.task);
  REQUIRE(all.size() >= 3);
  for (size_t s = 0; s < all.size(); ++s) {  // strips of the ball are left to the last fit
    CHECK(all[s].is_plane());
    CHECK(face_of(planes, scene, all[s]) == std::min(static_cast<int>(s) + 1, 4));
  }
  const auto first = extract_sequence(one.scene, one.task);
  REQUIRE(first.size() == 1);
  CHECK(face_of(one, scene, first[0]) == 1);
}

TEST_CASE("extract_sequence__classes_come_in_the_order_asked_for_and_others_not_at_all") {
  const Scene scene = corner_with_ball();
  MadeScene made(scene.points);
  made.scene.order = orientation_order("vertical horizontal");
  const auto surfaces = extract_sequence(made.scene, made.task);
  REQUIRE(made.scene.axes.has_value());
  REQUIRE(surfaces.size() == 2);
  CHECK(face_of(made, scene, surfaces[0]) == 3);  // at right angles to the larger wall
  CHECK(face_of(made, scene, surfaces[1]) == 1);
}

TEST_CASE("extract_sequence__small_planes_are_missed_no_more_often_than_the_probability_says") {
  Scene scene;
  RandomStream random(3, 30);
  scene.outliers({-3, -5, -4}, {7, 5, 6}, 12000, random);  // so thin that it holds no surface
  for (int k = 0; k < 4; ++k)
    scene.rectangle(2, {1.3 * k, -0.5, 0.5}, {0.6, 0, 0}, {0, 0, 0.6}, 300, 0.003, random);
  SurfaceSettings settings;
  settings.min_points = 200;
  size_t missed = 0;
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    MadeScene made(scene.points, settings);
    made.scene.draw.seed = seed;
    const auto surfaces = extract_sequence(made.scene, made.task);
    for (const Surface& surface : surfaces) CHECK(made.shared(scene.faces, 2, surface) > 280);
    missed += 4 - std::min<size_t>(4, surfaces.size());
  }
  CHECK(missed <= 2);  // of 20; 1 in 100 is expected, three are 1 in 1 000
}

TEST_CASE("extract_sequence__scatter_and_too_few_points_give_nothing") {
  Scene scatter, few;
  RandomStream random(2, 30);
  scatter.outliers({0, 0, 0}, {3, 3, 3}, 3000, random);
  few.rectangle(1, {0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 49, 0.003, random);  // below min_points
  for (const Scene* scene : {&scatter, &few}) {
    MadeScene made(scene->points);
    CHECK(extract_sequence(made.scene, made.task).empty());
    CHECK(static_cast<size_t>(std::count(made.scene.owner.begin(), made.scene.owner.end(), 0u)) ==
          scene->points.size());
  }
}
