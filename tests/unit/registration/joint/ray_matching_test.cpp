// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/joint/ray_matching.h"

#include <doctest/doctest.h>

#include "base/error.h"
#include "model/buildings/building_tree.h"
#include "registration/joint/strip_weights.h"
#include "unit/model/buildings/houses.h"

using namespace jalon;

namespace {

// A house 10 m wide and 6 m high with its front along x, at y = 0, seen from y < 0, and its roof.
struct Street {
  Model model;
  StripScene scene;
  JointPlaces still;

  explicit Street(bool occluders = true) {
    Model houses;
    add_house(houses, {{0, 0, 0}}, "one");
    Task task;
    const BuildingTree tree = building_tree(houses, {}, task);
    model = strip_model(tree);
    add_others(model, tree, houses);
    scene = strip_scene(model, occluders);
    still.trajectory = {{0, 0}, {0, 0}};
    still.model = {std::vector<Vec2>(scene.blocks), std::vector<double>(scene.facades, 0),
                   std::vector<double>(scene.strips.size(), 0)};
  }

  PointMatch match(const Vec3& from, const Vec3& point, const JointPlaces& places,
                   const JointSettings& settings = {}) const {
    JointPoints points;
    points.index = {0};
    points.at = {point}, points.origin = {from}, points.direction = {normalized(point - from)};
    points.times_s = {0.5}, points.places = {{0, 0.5}};
    points.plan_covariance_m2 = {{1e-4, 0, 1e-4}};
    Task task;
    return match_points(points, scene, places, settings, task)[0];
  }
};

}  // namespace

TEST_CASE("match_points__by_its_ray__finds_the_strip_and_how_far_it_is") {
  const Street street;
  const PointMatch hit = street.match({5, -8, 2}, {5, -0.4, 2}, street.still);
  CHECK(hit.state == MatchState::kMatched);
  CHECK(hit.distance_m == doctest::Approx(0.4));  // before the wall
  CHECK(dot(street.scene.strips[hit.strip].normal, {0, -1}) == doctest::Approx(1));
  // Moved: the point by 0.2 m away from the wall, the wall by 0.3 m towards it.
  JointPlaces moved = street.still;
  moved.trajectory = {{0, -0.2}, {0, -0.2}};
  for (double& facade : moved.model.facades) facade = 0.3;
  CHECK(street.match({5, -8, 2}, {5, -0.4, 2}, moved).distance_m == doctest::Approx(0.3));
}

// A strip from 3 m behind, brought before the front by 5 cm: the front's own strip was moved less.
TEST_CASE("match_points__of_two_strips_in_one_place__takes_the_one_that_was_moved_less") {
  StripScene scene;
  scene.strips = {{0, 0, {0, -1}, 0}, {0, 0, {0, -1}, -3}};
  scene.blocks = scene.facades = 1;
  for (uint32_t s = 0; s < 2; ++s) {
    const Vec3 p{0, s * 3.0, 0}, way{2, 0, 0}, up{0, 0, 9};
    for (const Vec3& c : {p, p + way, p + way + up, p, p + way + up, p + up})
      scene.corners.push_back(c);
    scene.face_of.insert(scene.face_of.end(), {s, s});
    scene.strip_of_face.push_back(s), scene.block_of_face.push_back(0);
  }
  JointPoints points;
  points.index = {0};
  points.at = {{1, 0, 2}}, points.origin = {{1, -8, 2}}, points.direction = {{0, 1, 0}};
  points.times_s = {0.5}, points.places = {{0, 0.5}};
  points.plan_covariance_m2 = {{1e-4, 0, 1e-4}};
  const auto met = [&](double moved_m) {
    Task task;
    const JointPlaces places{{{0, 0}, {0, 0}}, {{{0, 0}}, {0}, {0, moved_m}}};
    return match_points(points, scene, places, {}, task)[0].strip;
  };
  CHECK(met(0) == 0);
  CHECK(met(3.05) == 0);
  CHECK(met(3.5) == 1);  // no longer one place
}

TEST_CASE("match_points__tells_why_a_match_is_refused") {
  const Street street;
  CHECK(street.match({5, -8, 2}, {5, -8, 20}, street.still).state == MatchState::kNothing);
  CHECK(street.match({5, 2, 2}, {5, 0.1, 2}, street.still).state == MatchState::kBehind);
  CHECK(street.match({5, -8, 2}, {5, -7.5, 2}, street.still).state == MatchState::kFar);
  // From above the roof stands before the wall behind it.
  const Vec3 above{5, -1, 12}, wall{5, 7.9, 3};
  CHECK(street.match(above, wall, street.still).state == MatchState::kNothing);
  const Street open(false);
  CHECK(open.match(above, wall, open.still).state == MatchState::kBehind);
}

// 1 m for a block, 0.5 for a facade, 0.3 for a strip, 0.01 for the point: 1.1577 m.
TEST_CASE("match_points__accepts_by_the_propagated_sigmas") {
  const Street street;
  JointSettings normal;
  normal.bound = JointSettings::Bound::kNormal;
  CHECK(greatest_deviation({}) == doctest::Approx(2.9957).epsilon(1e-4));
  CHECK(greatest_deviation(normal) == doctest::Approx(1.95996).epsilon(1e-4));
  const auto state = [&](double before_m, const JointSettings& s) {
    return street.match({5, -8, 2}, {5, -before_m, 2}, street.still, s).state;
  };
  CHECK(state(3.46, {}) == MatchState::kMatched);
  CHECK(state(3.48, {}) == MatchState::kFar);
  CHECK(state(2.26, normal) == MatchState::kMatched);
  CHECK(state(2.28, normal) == MatchState::kFar);
}

TEST_CASE("strip_weights__of_a_van_before_a_wall__leave_it_out") {
  StripScene scene;
  scene.strips = {{0, 0, {0, -1}, 0}};
  JointPoints points;
  std::vector<PointMatch> matches;
  const auto add = [&](double before_m, double height_m, MatchState state) {
    points.at.push_back({0, -before_m, height_m});
    points.direction.push_back({0, 1, 0});
    matches.push_back({0, state, before_m});
  };
  for (int i = 0; i < 10; ++i) add(0.5 + 0.001 * i, 3 + 0.1 * i, MatchState::kMatched);
  for (int i = 0; i < 14; ++i) add(2.5, 0.1 * i, MatchState::kMatched);
  add(0.5, 3, MatchState::kFar);
  const std::vector<double> robust = strip_weights(points, scene, matches, {});
  JointSettings plain;
  plain.kernel = JointSettings::Kernel::kNone;
  const std::vector<double> alike = strip_weights(points, scene, matches, plain);
  for (size_t i = 0; i < 10; ++i) CHECK(robust[i] > 0.5);
  for (size_t i = 10; i < 24; ++i) {
    CHECK(robust[i] == 0);
    CHECK(alike[i] == 1);
  }
  CHECK(robust[24] == 0);
  CHECK(alike[24] == 0);
}

TEST_CASE("strip_scene__of_a_model_without_strips__is_refused") {
  Model houses;
  add_house(houses, {{0, 0, 0}}, "one");
  CHECK_THROWS_AS(strip_scene(houses, true), Error);
}
