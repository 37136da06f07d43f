// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/picks/picks.h"

#include <doctest/doctest.h>

#include <numbers>

#include "base/error.h"
#include "segment/result/facade.h"
#include "unit/segment/scenes.h"

namespace jalon {
namespace {

using namespace test;

constexpr int kColumn = 3, kSphere = 4, kLean = 5;
const Vec3 kShift{652000, 6861000, 40};

// A wall of two panels 1 m apart, a sill before it, a column, a leaning pipe and a ball, 3 mm noise.
Scene yard() {
  Scene scene;
  RandomStream random(11, 2);
  scene.rectangle(1, {0, 0, 0}, {6, 0, 0}, {0, 0, 4}, 24000, 0.003, random);
  scene.rectangle(2, {7, 0, 0}, {3, 0, 0}, {0, 0, 4}, 12000, 0.003, random);
  const auto noisy = [&](int face, const Vec3& p, const Vec3& n) {
    scene.points.push_back(p + 0.003 * random.normal() * n);
    scene.faces.push_back(face);
  };
  const Vec3 lean = normalized(Vec3{0.3, 0.1, 1});
  const auto e = across(lean);
  for (int i = 0; i < 6000; ++i) {
    const double a = 2 * std::numbers::pi * random.uniform(), h = random.uniform();
    const Vec3 n{std::cos(a), std::sin(a), 0}, m = std::cos(a) * e[0] + std::sin(a) * e[1];
    noisy(kColumn, Vec3{2, -2, 3 * h} + 0.25 * n, n);
    noisy(kLean, Vec3{5, -3, 0} + 3 * h * lean + 0.15 * m, m);
    const Vec3 u = normalized(Vec3{random.normal(), random.normal(), random.normal()});
    noisy(kSphere, Vec3{8, -3, 0.9} + 0.9 * u, u);
  }
  scene.outliers({-1, -5, -0.5}, {11, 1, 4.5}, 2000, random);
  return scene;
}

PickSettings pick_params(const char* json = "{}") {
  ParamSet params("pick", pick_rows());
  params.from_json(json);
  return settings_from<PickSettings>(params);
}

std::vector<Vec3> shifted(std::vector<Vec3> picks) {
  for (Vec3& p : picks) p += kShift;
  return picks;
}

double share_of(const Scene& scene, const Segmentation& s, int face, uint32_t label) {
  return static_cast<double>(overlap(scene, s, face, label)) /
         static_cast<double>(std::count(scene.faces.begin(), scene.faces.end(), face));
}

TEST_CASE("with_pick__four_picks__plane_inside_their_polygon") {
  const Scene scene = yard();
  const CloudPtr cloud = cloud_of(scene.points, kShift);
  Task task;
  const Segmentation start = empty_segmentation(cloud, task);
  CHECK(start.segments.empty());
  const auto picks = shifted({{1, 0, 1}, {4, 0, 1}, {4, 0, 3}, {1, 0, 3}});
  const Segmentation s = with_pick(start, PrimitiveType::kPlane, picks, pick_params(), task);
  REQUIRE(s.segments.size() == 1);
  const Segment& wall = s.segments[0];
  CHECK(overlap(scene, s, 1, 1) == doctest::Approx(6000).epsilon(0.05));  // 6 of 24 m2
  CHECK(overlap(scene, s, 2, 1) == 0);
  CHECK(std::fabs(wall.fit.plane.normal.y) > 0.999999);
  CHECK(std::fabs(wall.fit.plane.distance(Vec3{3, 0, 2} + kShift)) < 0.0005);
  CHECK(wall.area_m2 == doctest::Approx(6).epsilon(0.05));
  CHECK(wall.orientation == Orientation::kParallel);
  CHECK(start.segments.empty());  // the undo
  CHECK(overlap(scene, start, 1, 1) == 0);
  // Picks in an order that crosses itself: their hull.
  const auto crossed = shifted({{1, 0, 1}, {4, 0, 3}, {4, 0, 1}, {1, 0, 3}});
  CHECK(with_pick(start, PrimitiveType::kPlane, crossed, pick_params(), task).segments[0].fit.n ==
        wall.fit.n);
}

TEST_CASE("with_pick__seed__grows_to_the_panel_and_over_gaps_when_told") {
  const Scene scene = yard();
  const CloudPtr cloud = cloud_of(scene.points, kShift);
  Task task;
  const Segmentation start = empty_segmentation(cloud, task);
  const auto seed = shifted({{1, 0, 1}});
  const Segmentation near = with_pick(start, PrimitiveType::kPlane, seed, pick_params(), task);
  CHECK(share_of(scene, near, 1, 1) > 0.99);
  CHECK(overlap(scene, near, 2, 1) == 0);
  const Segmentation wide =
      with_pick(start, PrimitiveType::kPlane, seed, pick_params("{\"gap_m\":1.2}"), task);
  CHECK(share_of(scene, wide, 2, 1) > 0.99);
  // The next pick takes what remains; the last segment is its own undo.
  const Segmentation both =
      with_pick(near, PrimitiveType::kPlane, shifted({{8, 0, 1}}), pick_params(), task);
  REQUIRE(both.segments.size() == 2);
  CHECK(share_of(scene, both, 1, 1) > 0.99);
  CHECK(share_of(scene, both, 2, 2) > 0.99);
  const Cloud rest = remaining_points(both, task);
  CHECK(rest.size() == cloud->size() - both.segments[0].fit.n - both.segments[1].fit.n);
}

TEST_CASE("with_pick__spheres_and_cylinders__found_from_picks_and_normals") {
  const Scene scene = yard();
  const CloudPtr cloud = cloud_of(scene.points, kShift);
  Task task;
  Segmentation s = empty_segmentation(cloud, task);
  const double r = 0.9 * std::sqrt(0.5);
  s = with_pick(s, PrimitiveType::kSphere,
                shifted({{8.9, -3, 0.9}, {8, -2.1, 0.9}, {8, -3, 1.8}, {8 - r, -3 - r, 0.9}}),
                pick_params(), task);
  s = with_pick(s, PrimitiveType::kCylinder,
                shifted({{2.25, -2, 0.5}, {2, -1.75, 1.5}, {1.75, -2, 2}}), pick_params(), task);
  const Vec3 lean = normalized(Vec3{0.3, 0.1, 1});
  const auto e = across(lean);
  const Vec3 axis = Vec3{5, -3, 0} + 1.5 * lean;
  s = with_pick(s, PrimitiveType::kCylinder,
                shifted({axis + 0.15 * e[0], axis + 0.4 * lean + 0.15 * e[1]}), pick_params(),
                task);
  REQUIRE(s.segments.size() == 3);
  CHECK(norm(s.segments[0].sphere.sphere.centre - kShift - Vec3{8, -3, 0.9}) < 0.0005);
  CHECK(s.segments[0].sphere.sphere.radius == doctest::Approx(0.9).epsilon(0.0005).scale(0));
  CHECK(share_of(scene, s, kSphere, 1) > 0.98);
  CHECK(s.segments[0].area_m2 ==
        doctest::Approx(4 * std::numbers::pi * 0.81).epsilon(0.1).scale(0));
  CHECK(s.segments[1].cylinder.cylinder.radius == doctest::Approx(0.25).epsilon(0.002).scale(0));
  CHECK(s.segments[1].cylinder.cylinder.direction == Vec3{0, 0, 1});
  CHECK(s.segments[1].length_u_m == doctest::Approx(3).epsilon(0.01));
  CHECK(share_of(scene, s, kColumn, 2) > 0.98);
  CHECK(s.segments[2].cylinder.cylinder.radius == doctest::Approx(0.15).epsilon(0.005).scale(0));
  CHECK(dot(s.segments[2].cylinder.cylinder.direction, lean) > 0.99999);
  CHECK(share_of(scene, s, kLean, 3) > 0.98);
  CHECK(s.segments[2].orientation == Orientation::kNone);
  const std::string text = primitive_text(s);
  CHECK(text.substr(0, 2) == "2 ");
  CHECK(std::count(text.begin(), text.end(), '\n') == 3);
}

TEST_CASE("with_pick__minimal_surface__leaves_small_pieces_out") {
  Scene scene;
  RandomStream random(3, 4);
  scene.rectangle(1, {0, 0, 0}, {2, 0, 0}, {0, 0, 2}, 8000, 0.002, random);
  scene.rectangle(2, {3, 0, 1}, {0.08, 0, 0}, {0, 0, 0.08}, 40, 0.002, random);
  const CloudPtr cloud = cloud_of(scene.points);
  Task task;
  const std::vector<Vec3> picks{{-0.1, 0, -0.1}, {4, 0, -0.1}, {4, 0, 2.1}, {-0.1, 0, 2.1}};
  const Segmentation start = empty_segmentation(cloud, task);
  const Segmentation all =
      with_pick(start, PrimitiveType::kPlane, picks, pick_params("{\"min_area_m2\":0}"), task);
  CHECK(overlap(scene, all, 2, 1) == 40);
  const Segmentation large =
      with_pick(start, PrimitiveType::kPlane, picks, pick_params("{\"min_area_m2\":0.1}"), task);
  CHECK(overlap(scene, large, 2, 1) == 0);
  CHECK(overlap(scene, large, 1, 1) == 8000);
}

TEST_CASE("with_pick__bad_picks__documented_status") {
  const CloudPtr cloud = cloud_of(yard().points);
  Task task;
  const Segmentation start = empty_segmentation(cloud, task);
  const auto status = [&](PrimitiveType type, const std::vector<Vec3>& picks) {
    try {
      with_pick(start, type, picks, pick_params(), task);
    } catch (const Error& error) {
      return error.status();
    }
    return Status::kOk;
  };
  const Vec3 a{1, 0, 1}, b{2, 0, 1}, c{3, 0, 1}, d{1, 0, 2}, air{3, -20, 9};
  CHECK(status(PrimitiveType::kPlane, {}) == Status::kInsufficientData);
  CHECK(status(PrimitiveType::kPlane, {a, b}) == Status::kInsufficientData);
  CHECK(status(PrimitiveType::kPlane, {a, b, c}) == Status::kDegenerate);
  CHECK(status(PrimitiveType::kPlane, {air, air + a, air + d}) == Status::kInsufficientData);
  CHECK(status(PrimitiveType::kSphere, {a}) == Status::kInsufficientData);
  CHECK(status(PrimitiveType::kSphere, {a, b, c, d}) == Status::kDegenerate);
  CHECK(status(PrimitiveType::kCylinder, {a}) == Status::kInsufficientData);
  CHECK(status(PrimitiveType::kCylinder, {a, d}) !=
        Status::kOk);  // normals parallel but for the noise
  CHECK(status(PrimitiveType::kCylinder, {a, a, a}) == Status::kDegenerate);
}

}  // namespace
}  // namespace jalon
