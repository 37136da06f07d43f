// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// From candidates to spheres and cylinders: points, owners and shapes against those of the scene.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "segment/ransac/curved_extraction.h"
#include "unit/segment/curved_scenes.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr double kBarrelNoise_m = 0.003;
constexpr int kBarrel = 2, kGlobe = 3;
const Cylinder kBarrelShape{{1, 1, 0.8}, {0, 0, 1}, 0.3};
const Sphere kGlobeShape{{3, 1, 0.8}, 0.5};

Scene floor_barrel_globe() {
  Scene out;
  RandomStream random(1, 22);
  out.rectangle(1, {0, 0, 0}, {4, 0, 0}, {0, 2, 0}, 6000, kBarrelNoise_m, random);
  add_pipe(out, kBarrel, {kBarrelShape, 1}, 3000, kBarrelNoise_m, random);
  add_ball(out, kGlobe, kGlobeShape, -1, 3000, kBarrelNoise_m, random);
  return out;
}

uint32_t first_of(const MadeScene& made, const std::vector<int>& faces, int face) {
  uint32_t p = 0;
  while (faces[made.point(p)] != face) ++p;
  return p;
}

Candidate candidate_of(const MadeScene& made, uint32_t seed, const Curved& world) {
  Candidate out;
  out.curved = to_local(made, world);
  out.seed = seed;
  return out;
}

}  // namespace

TEST_CASE("extract_curved__a_candidate_that_is_off_settles_on_its_surface_and_takes_it") {
  const Scene scene = floor_barrel_globe();
  MadeScene made(scene.points, all_primitives());
  PointPool pool(made.scene, made.task);
  Cylinder barrel = kBarrelShape;
  barrel.point += Vec3{0.006, -0.004, 0};
  barrel.direction = normalized(Vec3{0.01, 0.01, 1});
  barrel.radius += 0.004;
  Sphere globe = kGlobeShape;
  globe.centre += Vec3{-0.004, 0.004, 0.004};
  uint32_t owner = 4;
  for (const auto& [face, shape] :
       {std::pair{kBarrel, Curved(barrel)}, std::pair{kGlobe, Curved(globe)}}) {
    Surface found;
    const size_t before = pool.free_points();
    const Candidate from = candidate_of(made, first_of(made, scene.faces, face), shape);
    REQUIRE(extract_curved(made.scene, pool, from, ++owner, made.task, found));
    CHECK(found.curved.type == shape.type);
    CHECK(made.shared(scene.faces, face, found) >= 2940);  // of 3 000
    CHECK(found.positions.size() <= 3060);
    CHECK(std::is_sorted(found.positions.begin(), found.positions.end()));
    CHECK(pool.free_points() == before - found.positions.size());
    for (const uint32_t p : found.positions) CHECK(made.scene.owner[p] == owner);
    CHECK(static_cast<size_t>(std::count(made.scene.owner.begin(), made.scene.owner.end(),
                                         owner)) == found.positions.size());
    // 2 048 points settle the shape: sigma / sqrt(n) = 0.07 mm, five of these.
    CHECK(std::fabs(found.curved.radius - (face == kBarrel ? 0.3 : 0.5)) < 3.5e-4);
    CHECK(found.sigma_m == doctest::Approx(kBarrelNoise_m).epsilon(0.08).scale(0));
  }
}

TEST_CASE("extract_curved__what_is_no_curved_surface_is_noted_and_takes_nothing") {
  const Scene scene = floor_barrel_globe();
  SurfaceSettings settings = all_primitives();
  MadeScene made(scene.points, settings);
  PointPool pool(made.scene, made.task);
  const uint32_t seed = first_of(made, scene.faces, 1);
  // A wide cylinder that lies along the floor: a plane fits its points as well.
  const Candidate lying = candidate_of(made, seed, Curved(Cylinder{{2, 1, -2}, {1, 0, 0}, 2}));
  Surface found;
  CHECK_FALSE(extract_curved(made.scene, pool, lying, 1, made.task, found));
  CHECK(made.scene.curved_rejections[seed] == 1);
  CHECK(made.scene.rejections[seed] == 0);  // planes may still start there
  CHECK(found.positions.empty());
  Scene slat;  // clean, but it turns by less than twice the normal tolerance
  RandomStream random(4, 22);
  add_pipe(slat, kBarrel, {kBarrelShape, 1, 0.7}, 1500, kBarrelNoise_m, random);
  MadeScene narrow(slat.points, settings);
  PointPool own(narrow.scene, narrow.task);
  CHECK_FALSE(extract_curved(narrow.scene, own, candidate_of(narrow, 700, Curved(kBarrelShape)), 1,
                             narrow.task, found));
  CHECK(narrow.scene.curved_rejections[700] >= 1);
  settings.min_points = 3200;  // more than the barrel has
  MadeScene strict(scene.points, settings);
  PointPool all(strict.scene, strict.task);
  const uint32_t on_barrel = first_of(strict, scene.faces, kBarrel);
  const Candidate barrel = candidate_of(strict, on_barrel, Curved(kBarrelShape));
  CHECK_FALSE(extract_curved(strict.scene, all, barrel, 1, strict.task, found));
  CHECK(all.free_points() == scene.points.size());
  CHECK(std::count(strict.scene.owner.begin(), strict.scene.owner.end(), 0u) == 12000);
}

TEST_CASE("fit_curved_core__robust__outliers_on_one_side_do_not_move_the_radius") {
  Scene scene;
  RandomStream random(2, 22);
  add_pipe(scene, kBarrel, {kBarrelShape, 1}, 3000, kBarrelNoise_m, random);
  Cylinder rust = kBarrelShape;
  rust.radius += 0.018;  // six sigma off, within the tolerance
  add_pipe(scene, kBarrel, {rust, 1}, 90, 0, random);
  MadeScene made(scene.points, all_primitives());
  const Surface surface = curved_surface(made, scene.faces, kBarrel, Curved(kBarrelShape));
  Segment fitted;
  REQUIRE(fit_curved_core(made.scene, surface, true, made.task, fitted));
  // All points together would put it 90 / 3090 x 18 mm = 0.52 mm out; sigma / sqrt(3000) is 0.055 mm.
  CHECK(std::fabs(fitted.cylinder.cylinder.radius - 0.3) < 4 * 5.5e-5);
  Segment core;  // without weights: what is further off than 3 sigma is left out
  REQUIRE(fit_curved_core(made.scene, surface, false, made.task, core));
  CHECK(std::fabs(core.cylinder.cylinder.radius - 0.3) < 4 * 5.5e-5);
  CHECK(fitted.length_u_m == doctest::Approx(1).epsilon(0.01).scale(0));
  CHECK(fitted.area_m2 ==
        doctest::Approx(kFullTurn_rad * 0.3).epsilon(0.1).scale(0));  // whole pixels
}

TEST_CASE("refit_curved__shape_sigma_and_area_from_the_points_or_false") {
  const Scene scene = floor_barrel_globe();
  MadeScene made(scene.points, all_primitives());
  Cylinder off = kBarrelShape;
  off.radius += 0.005;
  Surface barrel = curved_surface(made, scene.faces, kBarrel, Curved(off));
  REQUIRE(refit_curved(made.scene, barrel, made.task));
  CHECK(std::fabs(barrel.curved.radius - 0.3) < 3.5e-4);
  CHECK(barrel.sigma_m == doctest::Approx(kBarrelNoise_m).epsilon(0.08).scale(0));
  CHECK(barrel.area_m2 == doctest::Approx(kFullTurn_rad * 0.3).epsilon(0.1).scale(0));
  Surface few = barrel;
  few.positions.clear();
  for (size_t i = 0; i < 49; ++i)
    few.positions.push_back(barrel.positions[61 * i]);  // min_points 50
  CHECK_FALSE(refit_curved(made.scene, few, made.task));
  Scene strip;
  RandomStream random(3, 22);
  add_pipe(strip, kBarrel, {kBarrelShape, 1, 0.6}, 1500, kBarrelNoise_m, random);
  MadeScene narrow(strip.points, all_primitives());
  Surface flat = curved_surface(narrow, strip.faces, kBarrel, Curved(kBarrelShape));
  CHECK_FALSE(refit_curved(narrow.scene, flat, narrow.task));  // turns by less than 50 degrees
}
