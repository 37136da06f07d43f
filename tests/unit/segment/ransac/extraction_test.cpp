// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// From a candidate to a plane: its points, owners and sigma against those of the scene.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "unit/segment/curved_scenes.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr double kPanelNoise_m = 0.004;

// A wall, a panel 0.2 m behind it, and a coplanar piece of the wall 2 m further on.
Scene wall_panel_piece() {
  Scene out;
  RandomStream random(1, 24);
  out.rectangle(1, {0, 0, 0}, {3, 0, 0}, {0, 0, 2}, 6000, kPanelNoise_m, random);
  out.rectangle(2, {0, 0.2, 0}, {3, 0, 0}, {0, 0, 2}, 3000, kPanelNoise_m, random);
  out.rectangle(3, {5, 0, 0}, {1, 0, 0}, {0, 0, 2}, 2000, kPanelNoise_m, random);
  return out;
}

// The wall's plane as a draw sees it: through its middle, 1.5 degrees off.
Candidate wall_candidate(const MadeScene& made) {
  const Vec3 middle = Vec3{1.5, 0, 1} - made.scene.origin;
  Candidate out;
  double nearest = INFINITY;
  for (uint32_t p = 0; p < made.scene.size(); ++p)
    if (const double d = norm(made.scene.local(p) - middle); d < nearest) {
      nearest = d;
      out.seed = p;
    }
  out.plane.normal = normalized(Vec3{0.026, 1, 0.01});
  out.plane.offset = dot(out.plane.normal, middle);
  return out;
}

}  // namespace

TEST_CASE("extract_surface__takes_the_connected_wall_and_what_a_slanted_draw_missed_of_it") {
  const Scene scene = wall_panel_piece();
  for (const bool connectivity : {true, false}) {
    SurfaceSettings settings;
    settings.connectivity = connectivity;
    MadeScene made(scene.points, settings);
    PointPool pool(made.scene, made.task);
    Surface found;
    REQUIRE(extract_surface(made.scene, pool, {}, wall_candidate(made), 6, made.task, found));
    CHECK(made.shared(scene.faces, 1, found) >= 5990);  // of 6 000; 25 mm are 6 sigma
    CHECK(made.shared(scene.faces, 2, found) == 0);
    if (connectivity) CHECK(made.shared(scene.faces, 3, found) == 0);
    else CHECK(made.shared(scene.faces, 3, found) >= 1990);
    CHECK(std::is_sorted(found.positions.begin(), found.positions.end()));
    CHECK(pool.free_points() == scene.points.size() - found.positions.size());
    for (uint32_t p = 0; p < made.scene.size(); ++p)
      CHECK((made.scene.owner[p] == 6) ==
            std::binary_search(found.positions.begin(), found.positions.end(), p));
    // sigma / (rms width sqrt(n)) = 0.004 / (0.58 sqrt(6000)) rad about the long side: 0.09 mrad; five of these.
    CHECK(std::fabs(found.plane.normal.y) > std::cos(4.5e-4));
    CHECK(found.area_m2 ==
          doctest::Approx(connectivity ? 6 : 8).epsilon(0.1).scale(0));  // whole pixels
  }
}

TEST_CASE("extract_surface__what_is_too_small_or_of_another_class_is_noted_and_takes_nothing") {
  const Scene scene = wall_panel_piece();
  SurfaceSettings settings;
  settings.min_points = 6500;
  MadeScene made(scene.points, settings);
  PointPool pool(made.scene, made.task);
  const Candidate candidate = wall_candidate(made);
  Surface found;
  CHECK_FALSE(extract_surface(made.scene, pool, {}, candidate, 1, made.task, found));
  CHECK(made.scene.rejections[candidate.seed] >= 1);
  CHECK(pool.free_points() == scene.points.size());
  CHECK(std::count(made.scene.owner.begin(), made.scene.owner.end(), 0u) == 11000);
  made.scene.settings.min_points = 50;
  OrientationPass level;
  level.wanted = Orientation::kHorizontal;
  level.tolerance_rad = 0.0174533;
  CHECK_FALSE(extract_surface(made.scene, pool, level, candidate, 1, made.task, found));
  CHECK(extract_surface(made.scene, pool, {}, candidate, 1, made.task, found));
}

TEST_CASE("settled_sigma__is_the_noise_of_the_wall_and_infinite_where_there_is_none") {
  const Scene scene = wall_panel_piece();
  MadeScene made(scene.points);
  const PointPool pool(made.scene, made.task);
  Candidate candidate = wall_candidate(made);
  // Noise cut at 3 sigma has 0.987 of its sigma; 6 000 points tell it to 1 / sqrt(2 n) = 0.9 %. Four of these.
  CHECK(settled_sigma(made.scene, pool, candidate, made.task) ==
        doctest::Approx(0.987 * kPanelNoise_m).epsilon(0.04).scale(0));
  candidate.plane.offset += 0.1;  // half way to the panel
  CHECK(std::isinf(settled_sigma(made.scene, pool, candidate, made.task)));
  CHECK(std::count(made.scene.owner.begin(), made.scene.owner.end(), 0u) == 11000);
}

TEST_CASE("extraction__reach_roughness_and_width_follow_the_tolerance_unless_normals_are_off") {
  SurfaceSettings settings;  // 25 mm
  CHECK(core_reach(settings, 0.004) == doctest::Approx(0.012).scale(0));
  CHECK(core_reach(settings, 0) == doctest::Approx(0.0025).scale(0));
  CHECK(core_reach(settings, 1) == 0.025);
  CHECK_FALSE(too_rough(settings, 0.025 / 2.58));          // noise within a tolerance of 99 %
  CHECK(too_rough(settings, 0.025 * std::sqrt(1.0 / 3)));  // evenly spread over it
  RandomStream random(3, 24);
  const auto strip = [&](double width_m, size_t count) {
    Scene scene;
    scene.rectangle(1, {0, 0, 0}, {width_m, 0, 0}, {0, 0, 2}, count, 0.003, random);
    PlaneFit fit;
    REQUIRE(fit_plane(scene.points, fit));
    return fit;
  };
  const PlaneFit column = strip(0, 500), reveal = strip(0.15, 100);
  CHECK_FALSE(wide_enough(settings, column));
  CHECK(wide_enough(settings, reveal));
  CHECK_FALSE(wide_enough(settings, strip(0.15, 12)));    // 44 mm sqrt(12) fix it to 3 degrees
  CHECK_FALSE(wide_enough(settings, strip(0.03, 5000)));  // as narrow as the noise
  settings.normals = NormalSource::kNone;                 // the plain method
  CHECK(wide_enough(settings, column));
  CHECK_FALSE(too_rough(settings, 0.025));
  CHECK(core_reach(settings, 0.004) == 0.025);
}

TEST_CASE("flat_points__keep_distances_of_planes_and_unroll_pipes") {
  Scene scene;
  RandomStream random(4, 24);
  scene.rectangle(1, {0, 0, 0}, {2, 1, 0}, {0, 0, 1}, 300, 0, random);
  const Cylinder pipe{{4, 0, 0.5}, {0, 0, 1}, 0.5};
  add_pipe(scene, 2, {pipe, 1, 3}, 300, 0, random);
  MadeScene made(scene.points);
  const Surface wall = made.surface(scene.faces, 1, 1);
  const Surface round = curved_surface(made, scene.faces, 2, Curved(pipe));
  const auto flat = flat_points(made.scene, wall, made.task),
             unrolled = flat_points(made.scene, round, made.task);
  const auto e = across(pipe.direction);
  const auto angle = [&](const Vec3& p) {
    const Vec3 d = p - pipe.point;
    const double a = std::atan2(dot(d, e[1]), dot(d, e[0]));
    return a < -0.1 ? a + kFullTurn_rad : a;
  };
  for (size_t i = 1; i < 300; ++i) {
    const Vec3 a = scene.points[made.point(wall.positions[i])],
               b = scene.points[made.point(wall.positions[i - 1])];
    CHECK(norm(flat[i] - flat[i - 1]) == doctest::Approx(norm(a - b)).epsilon(1e-6));
    const Vec3 c = scene.points[made.point(round.positions[i])],
               d = scene.points[made.point(round.positions[i - 1])];
    CHECK(norm(unrolled[i] - unrolled[i - 1]) ==
          doctest::Approx(std::hypot(0.5 * (angle(c) - angle(d)), c.z - d.z)).epsilon(1e-6));
  }
}
