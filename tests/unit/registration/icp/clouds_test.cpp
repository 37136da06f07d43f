// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Poses between the caller's coordinates and between the clouds' own frames, by where they put points.

#include <doctest/doctest.h>

#include <cmath>

#include "geometry/rigid_motion.h"
#include "registration/icp/clouds.h"
#include "unit/cloud/clouds.h"

using namespace jalon;
using namespace jalon::test;

namespace {

// The frames are all that poses need of the surfaces.
struct Framed {
  Cloud reference, moving;
  IcpClouds clouds;

  Framed(const std::vector<Vec3>& r, const std::vector<Vec3>& m)
      : reference(cloud_of(r)), moving(cloud_of(m)) {
    Task task;
    clouds.reference.tree = reference.octree(task);
    clouds.moving.tree = moving.octree(task);
  }
};

const Vec3 kElsewhere{-417, 52, 9};

// An ulp of 7 million metres is 1e-9 m, a step of the trees' grids less than 1e-8 m.
constexpr double kRounding_m = 2e-8;

}  // namespace

TEST_CASE("icp_clouds__both_forms_of_a_pose_put_every_point_at_the_same_place") {
  const auto points = random_points(50, 9, 1);
  const Framed f(shifted(points, kFar), shifted(points, kElsewhere));
  const Transform pose = motion_about({}, {0.2, -0.7, 1.9}, kFar);
  const Transform local = f.clouds.to_local(pose);
  const Vec3 reference_origin = f.clouds.reference.tree->cube().origin;
  const auto order = f.clouds.moving.tree->order();
  for (uint32_t i = 0; i < 50; ++i) {
    const Vec3 there = reference_origin + local.point(f.clouds.moving.place(i));
    CHECK(norm(there - pose.point(f.moving.point(order[i]))) < kRounding_m);
  }
}

TEST_CASE("icp_clouds__there_and_back_is_the_same_pose") {
  const auto points = random_points(50, 9, 2);
  const Framed f(shifted(points, kElsewhere), shifted(points, kFar));
  const Transform pose = motion_about(kFar, {0.01, -0.02, 0.3}, kElsewhere - kFar);
  const Transform back = f.clouds.to_world(f.clouds.to_local(pose));
  const Vec3 place = kFar + Vec3{4, 5, 6};
  CHECK(norm(back.point(place) - pose.point(place)) < kRounding_m);
  for (size_t i = 0; i < 12; ++i)
    if (i % 4 != 3) CHECK(back.m[i] == pose.m[i]);
}

TEST_CASE("icp_clouds__shifts_of_both_by_whole_metres_change_no_local_pose") {
  const auto a = random_points(50, 9, 3), b = random_points(50, 9, 4);
  const Framed here(a, b), far(shifted(a, kFar), shifted(b, kFar));
  const Transform pose = motion_about({4, 5, 6}, {0.3, 0.2, -0.1}, {0.5, 0.25, -0.125});
  const Transform pose_far = motion_about({}, {}, kFar) * pose * motion_about({}, {}, -kFar);
  const Transform local = here.clouds.to_local(pose), local_far = far.clouds.to_local(pose_far);
  for (size_t i = 0; i < 12; ++i) CHECK(std::abs(local.m[i] - local_far.m[i]) < kRounding_m);
  // Where the clouds lie on each other as they come, the frames differ by their origins alone.
  const Framed apart(a, shifted(b, kElsewhere));
  const Vec3 t = apart.clouds.to_local({}).translation();
  CHECK(t == apart.clouds.moving.tree->cube().origin - apart.clouds.reference.tree->cube().origin);
}
