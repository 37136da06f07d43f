// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// The growth of one pick against the points that lie on its surface, are free and belong together, by brute force.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "segment/picks/growth.h"
#include "unit/compare/refusal.h"
#include "unit/segment/curved_scenes.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr double kPickNoise_m = 0.003;
const Vec3 kPickGrid{652000, 6861000, 40};

// A wall, and a ball and a column before it.
struct PickedYard {
  Scene scene;
  CloudPtr cloud;
  std::vector<uint32_t> labels;
  Task task;

  PickedYard() {
    RandomStream random(2, 13);
    scene.rectangle(1, {0, 0, 0}, {4, 0, 0}, {0, 0, 3}, 8000, kPickNoise_m, random);
    add_ball(scene, 2, {{1, -2, 1}, 0.5}, -1, 4000, kPickNoise_m, random);
    add_pipe(scene, 3, {{{3, -2, 1}, {0, 0, 1}, 0.2}, 2}, 4000, kPickNoise_m, random);
    cloud = cloud_of(scene.points, kPickGrid);
    labels.assign(scene.points.size(), 0);
  }
  PickScene with(std::vector<Vec3> picks, const PickSettings& settings = {}) const {
    return {*cloud, labels, kPickGrid, settings, std::move(picks)};
  }
  size_t count_in(const Picked& picked, int face) const {
    return static_cast<size_t>(std::count_if(picked.members.begin(), picked.members.end(),
                                             [&](uint32_t i) { return scene.faces[i] == face; }));
  }
};

}  // namespace

TEST_CASE("pick_growth__plane_of_a_polygon__every_free_point_near_it_inside_and_no_other") {
  PickedYard yard;
  for (size_t i = 0; i < yard.labels.size(); i += 3) yard.labels[i] = 4;  // another segment's
  const Picked picked =
      pick_plane(yard.with({{1, 0, 0.5}, {3, 0, 0.5}, {3, 0, 2}, {1, 0, 2}}), yard.task);
  const PickScene scene = yard.with({});
  std::vector<uint32_t> expected;
  for (uint32_t i = 0; i < yard.labels.size(); ++i) {
    const Vec3 p = scene.local(i);
    if (yard.labels[i] == 0 && p.x > 1 && p.x < 3 && p.z > 0.5 && p.z < 2 &&
        std::fabs(picked.segment.distance(p)) <= scene.setting.primitive.tolerance_m)
      expected.push_back(i);
  }
  CHECK(picked.members == expected);
  CHECK(picked.segment.fit.n == expected.size());
  const Picked crossed = pick_plane(  // an order that crosses itself: the hull
      yard.with({{1, 0, 0.5}, {3, 0, 2}, {3, 0, 0.5}, {1, 0, 2}}), yard.task);
  CHECK(crossed.members == expected);
  CHECK(picked.segment.length_u_m ==
        doctest::Approx(2).epsilon(0.02).scale(0));  // the last of 2 000 points
  CHECK(picked.segment.length_v_m ==
        doctest::Approx(1.5).epsilon(0.02).scale(0));  // is within 2 spacings
}

TEST_CASE("pick_growth__sphere_and_cylinder__the_free_points_of_the_picked_one_alone") {
  PickedYard yard;
  for (size_t i = 0; i < yard.labels.size(); i += 4) yard.labels[i] = 9;
  const Picked ball =
      pick_sphere(yard.with({{1.5, -2, 1}, {1, -1.5, 1}, {1, -2, 1.5}, {0.5, -2, 1}}), yard.task);
  const Picked column =
      pick_cylinder(yard.with({{3.2, -2, 0.5}, {3, -1.8, 1}, {2.8, -2, 1.5}}), yard.task);
  for (const auto& [picked, face] : {std::pair{&ball, 2}, std::pair{&column, 3}}) {
    CHECK(yard.count_in(*picked, face) == picked->members.size());
    CHECK(picked->members.size() >= 2950);  // of 3 000
    for (const uint32_t i : picked->members) CHECK(yard.labels[i] == 0);
  }
  // 3 000 points with 3 mm noise; a sphere's centre and radius are right to a few of sigma / sqrt(n).
  const double sigma = kPickNoise_m / std::sqrt(3000.0);
  CHECK(norm(ball.segment.sphere.sphere.centre - Vec3{1, -2, 1}) < 10 * sigma);
  CHECK(std::fabs(ball.segment.sphere.sphere.radius - 0.5) < 5 * sigma);
  CHECK(std::fabs(column.segment.cylinder.cylinder.radius - 0.2) < 5 * sigma);
}

TEST_CASE("pick_growth__a_seed_stops_at_the_points_of_others") {
  PickedYard yard;
  // A band of taken points 0.5 m wide, more than gap_m, parts the wall.
  for (size_t i = 0; i < yard.labels.size(); ++i)
    if (yard.scene.faces[i] == 1 && std::fabs(yard.scene.points[i].x - 2) < 0.25)
      yard.labels[i] = 1;
  const Picked left = pick_plane(yard.with({{1, 0, 1.5}}), yard.task);
  CHECK(left.members.size() > 3300);  // 1.75 x 3 m of 8 000 points on 12 m2: 3 500 +- 45
  for (const uint32_t i : left.members) CHECK(yard.scene.points[i].x < 2);
  PickSettings wide;
  wide.gap_m = 0.7;
  const Picked both = pick_plane(yard.with({{1, 0, 1.5}}, wide), yard.task);
  CHECK(both.members.size() > 6800);
}

TEST_CASE("pick_growth__what_picks_cannot_give_is_named") {
  PickedYard yard;
  PickSettings narrow;
  narrow.primitive.max_radius_m = 0.25;
  PickSettings strict, large, many;
  strict.primitive.tolerance_m = 0.001;
  large.min_area_m2 = 20;
  many.min_points = 10000;
  const auto fails = [&](auto pick, const std::vector<Vec3>& picks, const PickSettings& settings,
                         Status status, const char* named) {
    CAPTURE(named);
    CHECK(refuses([&] { pick(yard.with(picks, settings), yard.task); }, status, named));
  };
  fails(pick_plane, {{1, -1, 1.5}}, {}, Status::kInsufficientData, "from the seed");
  fails(pick_plane, {{1, 0, 1}, {2, 0, 1}}, {}, Status::kInsufficientData, "2 picks");
  fails(pick_plane, {{1, 0, 1}, {2, 0, 1}, {3, 0, 1}}, {}, Status::kDegenerate, "one line");
  fails(pick_sphere, {{1.5, -2, 1}, {1, -1.5, 1}, {1, -2, 1.5}, {0.5, -2, 1}}, narrow,
        Status::kDegenerate, "0.25");
  fails(pick_sphere, {{1, 0, 1}, {2, 0, 1}, {3, 0, 1}}, {}, Status::kInsufficientData, "3 picks");
  fails(pick_cylinder, {{1, 0, 1}}, {}, Status::kInsufficientData, "1 picks");
  fails(pick_plane, {{1, 0, 1.5}}, strict, Status::kDegenerate, "from a plane");
  fails(pick_plane, {{1, 0, 1.5}}, large, Status::kInsufficientData, "20 m2");
  fails(pick_plane, {{1, 0, 1.5}}, many, Status::kInsufficientData, "gather");
  for (size_t i = 0; i < yard.labels.size(); ++i) yard.labels[i] = i % 3 != 0;
  fails(pick_plane, {{1, 0, 1.5}}, {}, Status::kInsufficientData, "half of them");
  std::fill(yard.labels.begin(), yard.labels.end(), 1u);
  fails(pick_plane, {{1, 0, 1.5}}, {}, Status::kInsufficientData, "free");
  fails(pick_plane, {{1, 0, 1}, {2, 0, 1}, {2, 0, 2}}, {}, Status::kInsufficientData,
        "0 free points");
}
