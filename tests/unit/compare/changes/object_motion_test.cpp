// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/changes/object_motion.h"

#include <doctest/doctest.h>

#include <cmath>

#include "base/random.h"

using namespace jalon;

namespace {

/// Points drawn in a box of these half sides, turned about the upright.
std::vector<Vec3> in_box(const Vec3& half, double yaw_rad, const Vec3& centre, uint64_t seed) {
  RandomStream random(seed, 1);
  std::vector<Vec3> out;
  for (int i = 0; i < 3000; ++i) {
    const double u = half.x * (2 * random.uniform() - 1), v = half.y * (2 * random.uniform() - 1);
    const double w = half.z * (2 * random.uniform() - 1);
    out.push_back(centre + Vec3{std::cos(yaw_rad) * u - std::sin(yaw_rad) * v,
                                std::sin(yaw_rad) * u + std::cos(yaw_rad) * v, w});
  }
  return out;
}

bool twins(const Extents& gone, const Extents& come) {
  Task task;
  const Epoch none;
  return are_twins({none, none, 0.01, 0.05, 0.05, {}, {}, task}, gone, come);
}

}  // namespace

TEST_CASE("object_motion__extents_are_half_sides_however_the_box_is_turned_the_least_first") {
  for (const double yaw_rad : {0.0, 0.4, 1.3}) {
    const Extents found = extents_of(in_box({1.5, 0.5, 1}, yaw_rad, {700, 20, 3}, 3), {});
    CAPTURE(yaw_rad);
    CHECK(std::fabs(found[0] - 0.5) < 0.05);
    CHECK(std::fabs(found[1] - 1) < 0.05);
    CHECK(std::fabs(found[2] - 1.5) < 0.05);
  }
}

TEST_CASE("object_motion__a_box_elsewhere_is_a_twin_and_one_of_another_length_is_not") {
  const Extents box = extents_of(in_box({1.5, 0.5, 1}, 0.2, {}, 4), {});
  const Extents moved = extents_of(in_box({1.5, 0.5, 1}, 1.1, {9, 4, 0}, 5), {});
  const Extents longer = extents_of(in_box({3.5, 0.5, 1}, 1.1, {9, 4, 0}, 6), {});
  CHECK(twins(box, moved));
  CHECK(twins(moved, box));
  CHECK(!twins(box, longer));
  CHECK(!twins(longer, box));
}

TEST_CASE("object_motion__two_that_are_joined_keep_the_points_of_either_epoch") {
  ChangedObject gone, come;
  gone.before = {1, 2, 3};
  come.after = {7, 8};
  come.regions_after = {5};
  const ChangedObject both = joined(gone, come);
  CHECK(both.before == gone.before);
  CHECK(both.after == come.after);
  CHECK(both.regions_after == come.regions_after);
}
