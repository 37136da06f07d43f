// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/icp/icp.h"

#include <doctest/doctest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <string>

#include "base/error.h"
#include "geometry/rigid_motion.h"
#include "unit/registration/real_scans.h"
#include "unit/registration/registration_scenes.h"

using namespace jalon;

namespace {

constexpr double kDegree = std::numbers::pi / 180;

Registration run(const Cloud& reference, const Cloud& moving, const Transform& start = {},
                 unsigned threads = 1, const IcpSettings& settings = {}) {
  Task::Hooks hooks;
  hooks.threads = threads;
  Task task(hooks);
  return register_icp(std::make_shared<const Cloud>(reference),
                      std::make_shared<const Cloud>(moving), start, settings, task);
}

double first(const FieldTable& table, const char* column) {
  return table.require(column).number(0);
}

}  // namespace

TEST_CASE("icp__real_scans_land_within_a_centimetre_of_the_published_pose") {
  const test::RealScans scans;
  if (!scans.exist()) return;
  const Cloud target = scans.target(), source = scans.source();
  const Transform truth = scans.pose();
  IcpSettings as_published = test::RealScans::as_published();
  const auto check = [&](const char* what, const IcpSettings& settings, double most_m,
                         double most_deg) {
    const Registration r = run(target, source, {}, 1, settings);
    const Transform error = r.pose * inverse(truth);
    const double off_m = norm(error.point(r.centre) - r.centre),
                 turn_deg = norm(rotation_vector(error)) / kDegree;
    MESSAGE("FIGURE icp real scans, " << std::string(what) << ": " << 1000 * off_m << " mm, "
                                      << turn_deg << " deg, " << r.iterations
                                      << " iterations, kept " << first(r.summary, "kept"));
    CHECK(r.converged);
    CHECK(off_m < most_m);
    CHECK(turn_deg < most_deg);
    CHECK(r.unobservable == 0);
  };
  check("point to plane as published", as_published, 0.01, 0.05);
  check("point to plane, defaults", {}, 0.03, 0.25);
  as_published.metric = IcpMetric::kPlaneToPlane;
  as_published.max_angle_rad = std::numbers::pi / 4;
  check("plane to plane as published", as_published, 0.01, 0.06);
  as_published.metric = IcpMetric::kPointToPoint;
  check("point to point", as_published, 0.06, 0.4);
}

TEST_CASE("icp__every_metric_and_kernel_finds_the_pose") {
  const Transform moved = motion_about({3, 2, 1}, {0.01, -0.02, 0.03}, {0.1, -0.05, 0.04});
  const Cloud reference = scenes::sampled(scenes::room(), 21, {}, 12000);
  const Cloud moving = scenes::sampled(scenes::room(), 22, moved, 12000);
  using enum IcpMetric;
  using enum KernelKind;
  for (const IcpMetric metric : {kPointToPoint, kPointToPlane, kPlaneToPlane})
    for (const KernelKind kernel : {kNone, kTukey, kCauchy, kHuber}) {
      IcpSettings settings{.metric = metric, .kernel = kernel};
      if (kernel == kHuber) settings.trim_percent = 10;
      const Registration r = run(reference, moving, {}, 1, settings);
      const Transform error = r.pose * moved;
      INFO("metric " << static_cast<int>(metric) << ", kernel " << static_cast<int>(kernel));
      CHECK(r.converged);
      CHECK(norm(error.point(r.centre) - r.centre) < (metric == kPointToPoint ? 0.02 : 0.001));
      CHECK(norm(rotation_vector(error)) < (metric == kPointToPoint ? 0.01 : 0.001));
      CHECK(r.covariance[35] > 0);
    }
}

TEST_CASE("icp__gives_the_same_bits_with_any_number_of_threads_and_on_a_national_grid") {
  const scenes::Scene room = scenes::room();
  const Transform moved = motion_about({3, 2, 1}, {0.01, -0.02, 0.03}, {0.1, -0.05, 0.04});
  // On a grid of 2^-20 m, so that a shift by whole metres changes no coordinate.
  const auto snapped = [&](uint64_t seed, const Transform& motion, const Vec3& shift) {
    const Cloud cloud = scenes::sampled(room, seed, motion);
    Buffer<double> xyz(cloud.xyz().size());
    for (size_t i = 0; i < xyz.size(); ++i)
      xyz[i] = std::ldexp(std::nearbyint(std::ldexp(cloud.xyz()[i], 20)), -20) +
               shift[static_cast<int>(i % 3)];
    return make_cloud(std::move(xyz));
  };
  const Registration one = run(snapped(1, {}, {}), snapped(2, moved, {}), {}, 1);
  CHECK(one.converged);
  for (const unsigned threads : {2u, 7u}) {
    const Registration other = run(snapped(1, {}, {}), snapped(2, moved, {}), {}, threads);
    CHECK(other.pose.m == one.pose.m);
    CHECK(other.covariance == one.covariance);
  }
  const Vec3 grid{652000, 6861000, 35};
  const Registration far = run(snapped(1, {}, grid), snapped(2, moved, grid), {}, 1);
  for (size_t i = 0; i < 12; ++i)
    if (i % 4 != 3) CHECK(far.pose.m[i] == one.pose.m[i]);
  CHECK(far.covariance == one.covariance);
  CHECK(norm((far.centre - one.centre) - grid) == 0);
  CHECK(norm(far.pose.point(far.centre) - grid - one.pose.point(one.centre)) < 4e-9);
}

TEST_CASE("icp__leaves_a_cloud_that_lies_on_itself_where_it_is") {
  const Cloud corner = scenes::sampled(scenes::street_corner(), 3);
  const Registration r = run(corner, corner);
  CHECK(r.converged);
  CHECK(norm(r.pose.point(r.centre) - r.centre) < 1e-9);
  CHECK(norm(rotation_vector(r.pose)) < 1e-9);
}

TEST_CASE("icp__too_little_in_common_is_a_result_that_says_so") {
  const Cloud corner = scenes::sampled(scenes::street_corner(), 3);
  Transform away;
  away.m = {1, 0, 0, 300, 0, 1, 0, 0, 0, 0, 1, 0};
  Task task;
  const Registration r = run(corner, transformed(corner, away, task));
  CHECK(!r.converged);
  CHECK(r.stopped == StopReason::kTooFewPairs);
  CHECK(std::isnan(r.covariance[0]));
  CHECK_THROWS_AS(run(corner, scenes::sampled(scenes::room(), 1, {}, 10)), Error);
}

TEST_CASE("icp__keeps_the_start_where_nothing_fixes_the_pose") {
  for (const scenes::Scene& scene : {scenes::corridor(), scenes::one_plane()}) {
    const Transform moved = motion_about({5, 1, 1}, {0.004, -0.003, 0.002}, {0.02, 0.01, -0.02});
    const Registration r = run(scenes::sampled(scene, 5), scenes::sampled(scene, 6, moved));
    CHECK(r.converged);
    CHECK(r.unobservable == scene.open_directions);
    CHECK(std::isnan(r.covariance[0]));
    // Along the corridor or in the plane, where 20 mm were put in; the turns that are fixed move other points by some.
    CHECK(std::abs(r.pose.point({5, 1, 1}).x - 5) < 0.006);
  }
}
