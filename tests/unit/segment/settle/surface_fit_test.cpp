// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/settle/surface_fit.h"

#include <doctest/doctest.h>

#include "unit/segment/made_scene.h"

using namespace jalon;
using namespace jalon::test;

namespace {

Scene wall(size_t count) {
  Scene out;
  RandomStream random(1, 7);
  out.rectangle(1, {0, 0, 0}, {3, 0, 0}, {0, 0, 3}, count, 0.005, random);
  return out;
}

}  // namespace

TEST_CASE("surface_fit__fit_core_is_least_squares_that_outliers_do_not_move") {
  Scene scene = wall(3000);
  for (int i = 0; i < 60; ++i) {  // two per cent at the edge of the tolerance, on one side
    scene.points.push_back({0.5 + 0.03 * i, 0.0245, 2.5});
    scene.faces.push_back(1);
  }
  MadeScene made(scene.points);
  Surface surface = made.surface(scene.faces, 1, 1);
  surface.sigma_m = 0.005;
  PlaneFit fit;
  REQUIRE(fit_core(made.scene, surface, made.task, fit));
  CHECK(fit.n <= 3000);
  CHECK(fit.sigma == doctest::Approx(0.005).epsilon(0.06).scale(0));
  const Vec3 middle = Vec3{1.5, 0, 1.5} - made.scene.origin;
  CHECK(std::fabs(fit.plane.distance(middle)) < 4 * 0.005 / std::sqrt(3000.0));
}

TEST_CASE("surface_fit__refit_takes_plane_sigma_and_area_from_the_points") {
  const Scene scene = wall(3000);
  MadeScene made(scene.points);
  auto surfaces = made.surfaces(scene.faces, 1);
  surfaces[0].area_m2 = 0;
  surfaces[0].plane.offset += 0.002;
  CHECK_FALSE(refit_surfaces(made.scene, surfaces, made.task));
  REQUIRE(surfaces.size() == 1);
  CHECK(surfaces[0].area_m2 == doctest::Approx(9).epsilon(0.1));
  CHECK(surfaces[0].sigma_m == doctest::Approx(0.005).epsilon(0.06).scale(0));
}

TEST_CASE("surface_fit__refit_of_many_points_is_by_a_part_of_them_and_as_true") {
  const Scene scene = wall(140000);
  MadeScene made(scene.points);
  auto surfaces = made.surfaces(scene.faces, 1);
  REQUIRE(is_large(surfaces[0]));
  const Plane by_all = surfaces[0].plane;
  surfaces[0].plane.offset += 0.002;
  CHECK_FALSE(refit_surfaces(made.scene, surfaces, made.task));
  REQUIRE(surfaces.size() == 1);
  CHECK(surfaces[0].positions.size() == 140000);
  CHECK(surfaces[0].area_m2 == doctest::Approx(9.61));  // 31 x 31 pixels
  CHECK(surfaces[0].sigma_m == doctest::Approx(0.005).epsilon(0.02).scale(0));
  const Vec3 middle = Vec3{1.5, 0, 1.5} - made.scene.origin;
  CHECK(std::fabs(surfaces[0].plane.distance(middle) - by_all.distance(middle)) <
        4 * 0.005 / std::sqrt(65536.0));
}

TEST_CASE("surface_fit__refit_drops_what_is_small_rough_or_bent_and_frees_its_points") {
  Scene scene = wall(3000);
  RandomStream random(3, 7);
  scene.rectangle(2, {6, 0, 0}, {1, 0, 0}, {0, 0, 1}, 49, 0.003, random);  // below min_points
  scene.rectangle(3, {9, 0, 0}, {1, 0, 0}, {0, 0, 1}, 800, 0.03, random);  // as thick as clutter
  for (int i = 0; i < 1500; ++i) {                                         // an arc of radius 0.6 m
    const double angle = 0.5 * (random.uniform() - 0.5);
    scene.points.push_back({12 + 0.6 * std::sin(angle),
                            0.6 * std::cos(angle) + 0.001 * random.normal(), random.uniform()});
    scene.faces.push_back(4);
  }
  MadeScene made(scene.points);
  auto surfaces = made.surfaces(scene.faces, 4);
  CHECK(refit_surfaces(made.scene, surfaces, made.task));
  REQUIRE(surfaces.size() == 1);
  CHECK(surfaces[0].positions.size() == 3000);
  for (size_t p = 0; p < made.scene.size(); ++p)
    CHECK(made.scene.owner[p] == (scene.faces[made.point(p)] == 1 ? 1u : 0u));
}

TEST_CASE("surface_fit__a_plane_of_which_few_points_came_or_went_keeps_its_fit") {
  const Scene scene = wall(3000);
  MadeScene made(scene.points);
  auto surfaces = made.surfaces(scene.faces, 1);
  refit_surfaces(made.scene, surfaces, made.task);
  const double fitted = surfaces[0].plane.offset;
  surfaces[0].plane.offset += 0.002;
  surfaces[0].sharing.fresh = false;
  surfaces[0].sharing.moved = 3;
  refit_surfaces(made.scene, surfaces, made.task);
  CHECK(surfaces[0].plane.offset == fitted + 0.002);
  CHECK_FALSE(surfaces[0].sharing.fresh);
  surfaces[0].sharing.moved = 4;
  refit_surfaces(made.scene, surfaces, made.task);
  CHECK(std::fabs(surfaces[0].plane.offset - fitted) < 1e-4);
  CHECK(surfaces[0].sharing.fresh);
  CHECK(surfaces[0].sharing.moved == 0);
}
