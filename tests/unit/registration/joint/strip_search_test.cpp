// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/joint/strip_search.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace jalon;

namespace {

// A strip 1.5 m wide and 9 m high at y = 0, seen from y = -8; its wall is elsewhere.
struct OneStrip {
  StripScene scene;
  JointPoints points;
  JointSettings settings;

  OneStrip() {
    scene.strips = {{0, 0, {0, -1}, 0}};
    scene.blocks = scene.facades = 1;
    const Vec3 p{0, 0, 0}, way{1.5, 0, 0}, up{0, 0, 9};
    scene.corners = {p, p + way, p + way + up, p, p + way + up, p + up};
    scene.face_of = {0, 0}, scene.strip_of_face = {0}, scene.block_of_face = {0};
    settings.sigma_block_x_m = settings.sigma_block_y_m = settings.sigma_facade_m = 0.01;
    settings.sigma_strip_m = 2;
  }
  void surface(double y, double from_m, double to_m, double from_x = 0) {
    for (double x = from_x + 0.25; x < from_x + 1.5; x += 0.5)
      for (double z = from_m; z < to_m; z += 0.25) {
        const Vec3 at{x, y, z}, from{x, -8, 3};
        points.at.push_back(at), points.origin.push_back(from);
        points.direction.push_back(normalized(at - from));
        points.plan_covariance_m2.push_back({1e-4, 0, 1e-4});
        points.normal.push_back({0, 1});
        points.index.push_back(static_cast<uint32_t>(points.index.size()));
      }
  }
  /// A second strip, as long and as high, at this place; it looks the same way.
  void rival(double y, double from_x = 0) {
    const auto first = static_cast<uint32_t>(scene.strips.size());
    scene.strips.push_back({0, 0, {0, -1}, -y});
    const Vec3 p{from_x, y, 0}, way{1.5, 0, 0}, up{0, 0, 9};
    for (const Vec3& c : {p, p + way, p + way + up, p, p + way + up, p + up})
      scene.corners.push_back(c);
    scene.face_of.insert(scene.face_of.end(), {first, first});
    scene.strip_of_face.push_back(first), scene.block_of_face.push_back(0);
  }
  FoundStrips all() const {
    Task task;
    return find_strips(points, scene, settings, task);
  }
  double found() const { return all().offsets_m[0]; }
};

}  // namespace

TEST_CASE("find_strips__metres_before_or_behind_its_wall__finds_the_wall") {
  for (const double y : {-4.0, -0.7, 2.5}) {
    OneStrip strip;
    strip.surface(y, 0.5, 8.5);
    CHECK(strip.found() == doctest::Approx(-y));  // its normal points to -y
  }
}

TEST_CASE("find_strips__behind_a_hoarding__finds_the_wall_and_not_what_stands_before_it") {
  OneStrip strip;
  strip.surface(-3, 0, 5);
  CHECK(strip.found() == doctest::Approx(3));
  strip.surface(0.5, 6.5, 9);  // beams that pass over it
  CHECK(strip.found() == doctest::Approx(-0.5));
}

TEST_CASE("find_strips__with_no_wall_within_reach_or_of_another_turn__leaves_it") {
  OneStrip far, turned;
  far.surface(10.5, 0.5, 8.5);
  CHECK(far.found() == 0);
  turned.surface(-1, 0.5, 8.5);
  for (Vec2& n : turned.points.normal) n = {1, 0};
  CHECK(turned.found() == 0);
}

TEST_CASE(
    "find_strips__with_one_wall_for_two_strips__gives_it_to_none_or_to_the_far_likelier_one") {
  // 3.9 m before one strip and 4.3 m before the other, which hides the former in truth.
  OneStrip two;
  two.rival(0.4);
  two.surface(-3.9, 0.5, 8.5);
  FoundStrips found = two.all();
  CHECK(found.is_doubtful == std::vector<bool>{true, true});
  CHECK(found.offsets_m == std::vector<double>{0, 0});
  // 0.2 m before one: for the other the wall stands 8.2 m off, e^8 times less likely.
  OneStrip near;
  near.rival(8);
  near.surface(-0.2, 0.5, 8.5);
  found = near.all();
  CHECK(!found.is_doubtful[0]);
  CHECK(found.is_doubtful[1]);
  CHECK(found.offsets_m[0] == doctest::Approx(0.2));
  CHECK(found.offsets_m[1] == 0);
  // 4.7 m before one, 6.2 m before the other: three strips in a thousand are off by more than three sigmas.
  OneStrip rare;
  rare.rival(1.5);
  rare.surface(-4.7, 0.5, 8.5);
  CHECK(rare.all().is_doubtful == std::vector<bool>{true, true});
  // Beside each other, or each with its own wall: no rivals.
  OneStrip beside;
  beside.rival(0.4, 2);
  beside.surface(-3.9, 0.5, 8.5);
  CHECK(!beside.all().is_doubtful[0]);
}

TEST_CASE("find_strips__on_a_wall_that_is_nearer_to_another_than_its_own__doubts_it") {
  // 4.9 m before the first, 2.4 m before the second, which sees a larger wall 6.8 m behind it.
  OneStrip two;
  two.rival(-2.5, 0.7);
  two.surface(-4.9, 0.5, 6);
  CHECK(two.all().is_doubtful[0]);
  two.surface(4.3, 0.5, 8.5, 1.3);
  CHECK(two.all().is_doubtful[0]);
  // One that stands on its own wall, 0.8 m behind it, is no rival.
  OneStrip near;
  near.rival(-2.5, 0.7);
  near.surface(-4.9, 0.5, 6);
  near.surface(-1.7, 0.5, 8.5, 1.3);
  CHECK(!near.all().is_doubtful[0]);
}

TEST_CASE("find_strips__whose_beams_put_it_metres_elsewhere__is_on_another_surface") {
  OneStrip strip;
  strip.surface(-0.5, 0.5, 8.5);
  const FoundStrips found = strip.all();
  CHECK(!found.is_elsewhere(0, 0.6));
  CHECK(found.is_elsewhere(0, 4.7));
  strip.settings.sigma_facade_m = 1;  // nothing was searched for
  CHECK(!strip.all().is_elsewhere(0, 4.7));
}

TEST_CASE("find_strips__with_a_wall_farther_off_than_points_are_accepted__doubts_it") {
  OneStrip strip;
  strip.surface(-7, 0.5, 8.5);
  CHECK(strip.found() == 0);
  CHECK(strip.all().is_doubtful == std::vector<bool>{true});
}

TEST_CASE("find_strips__that_are_as_sure_as_the_rest__leaves_them") {
  OneStrip strip;
  strip.surface(-1, 0.5, 8.5);
  CHECK(is_strip_search_wanted(strip.points, strip.settings));
  strip.settings.sigma_facade_m = 1;
  CHECK(!is_strip_search_wanted(strip.points, strip.settings));
  CHECK(strip.found() == 0);
}
