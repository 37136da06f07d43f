// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// The surfaces that ICP sees: planes that touch bent ones, and patches of both clouds on which a pose settles.

#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <memory>
#include <numbers>

#include "base/random.h"
#include "geometry/rigid_motion.h"
#include "registration/icp/icp.h"
#include "registration/surface/planes.h"
#include "unit/registration/registration_scenes.h"

using namespace jalon;

namespace {

constexpr double kRadius_m = 0.2, kHeight_m = 4, kPatchesNoise_m = 0.002;

// A column over flat ground, where most points are: these tell the noise.
Cloud column_over_ground(size_t points) {
  RandomStream random(5, 3);
  Buffer<double> xyz(3 * 3 * points);
  for (size_t i = 0; i < 3 * points; ++i) {
    const double angle = 2 * std::numbers::pi * random.uniform(), z = kHeight_m * random.uniform();
    const double column[3] = {kRadius_m * std::cos(angle), kRadius_m * std::sin(angle), z};
    const double ground[3] = {angle, 2 * std::numbers::pi * random.uniform(), -1};
    for (size_t c = 0; c < 3; ++c)
      xyz[3 * i + c] = (i < points ? column : ground)[c] + kPatchesNoise_m * random.normal();
  }
  return make_cloud(std::move(xyz));
}

Registration registered(const scenes::Scene& scene, uint64_t run, const Transform& truth,
                        const IcpSettings& settings) {
  Task::Hooks hooks;
  hooks.threads = 1;
  Task task(hooks);
  return register_icp(
      std::make_shared<const Cloud>(scenes::sampled(scene, 2 * run + 1)),
      std::make_shared<const Cloud>(scenes::sampled(scene, 2 * run + 2, inverse(truth))), {},
      settings, task);
}

double patches_of(const Registration& r) { return r.summary.require("patches").number(0); }

}  // namespace

TEST_CASE("icp_patches__planes_touch_a_column_instead_of_cutting_through_it") {
  Task task;
  const Cloud cloud = column_over_ground(2000);
  const SurfacePlanes planes = surface_planes(cloud.octree(task), 16, task);
  size_t all = 0, flat = 0, touching = 0;
  double turn2 = 0, height = 0, height2 = 0;
  for (size_t i = 0; i < planes.size(); ++i) {
    const Vec3 place = planes.tree->cube().origin + planes.place(i);
    if (place.z < -0.5) continue;
    ++all;
    if (!planes.flat(i)) continue;
    ++flat;
    touching += planes.planes[i].shape == SurfaceShape::kQuadric;
    const double distance = std::hypot(place.x, place.y);
    const Vec3 radial{place.x / distance, place.y / distance, 0}, normal = planes.planes[i].unit();
    const double side = dot(radial, normal) < 0 ? -1 : 1;
    turn2 += squared_norm(radial - normal * side);
    // The surface lies so far outside the point; the plane of it so far.
    const double off = side * double{planes.planes[i].height_m} - (kRadius_m - distance);
    height += off;
    height2 += off * off;
  }
  const auto n = static_cast<double>(flat);
  MESSAGE("FIGURE icp planes of a column: "
          << 100 * n / static_cast<double>(all) << " % have one, " << touching
          << " touch it, turned by " << std::sqrt(turn2 / n) << " rad, high by "
          << 1000 * height / n << " +- " << 1000 * std::sqrt(height2 / n) << " mm");
  CHECK(n >= 0.97 * static_cast<double>(all));
  CHECK(static_cast<double>(touching) >= 0.5 * n);
  CHECK(std::sqrt(turn2 / n) < 0.1);
  CHECK(std::abs(height / n) < 0.3 * kPatchesNoise_m);
  CHECK(std::sqrt(height2 / n) < kPatchesNoise_m);
}

TEST_CASE("icp_patches__a_pose_that_settles_on_them_is_nearer_than_one_of_pairs") {
  const IcpSettings of_pairs{
      .kernel = KernelKind::kNone};  // which nothing needs here: all noise is normal
  const Transform truth = motion_about({5, 5, 1}, {0.003, -0.002, 0.004}, {0.02, -0.01, 0.015});
  const uint64_t runs = std::getenv("JALON_FULL") != nullptr ? 60 : 20;
  double on_patches = 0, on_pairs = 0;
  for (uint64_t run = 0; run < runs; ++run) {
    const auto squared = [&](const Registration& r) {
      const Vec3 off = r.pose.point(r.centre) - truth.point(r.centre);
      return off.x * off.x + off.y * off.y;
    };
    const Registration settled = registered(scenes::room(), run, truth, {});
    const Registration not_settled = registered(scenes::room(), run, truth, of_pairs);
    CHECK(patches_of(settled) > 10);
    CHECK(patches_of(not_settled) == 0);
    on_patches += squared(settled);
    on_pairs += squared(not_settled);
  }
  const double n = static_cast<double>(runs);
  MESSAGE("FIGURE icp on patches: " << 1000 * std::sqrt(on_patches / n) << " mm, on pairs "
                                    << 1000 * std::sqrt(on_pairs / n) << " mm rms");
  CHECK(on_patches < on_pairs);
}
