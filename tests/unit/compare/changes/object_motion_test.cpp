// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/changes/object_motion.h"

#include <doctest/doctest.h>

#include <cmath>

#include "base/random.h"
#include "unit/compare/changes/epochs.h"

using namespace jalon;
using namespace jalon::test;

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

namespace {

std::vector<Vec3> floor_with_block(const Vec3& foot_corner, const Vec3& size, uint64_t stream) {
  RandomStream random(8, stream);
  std::vector<Vec3> points;
  add_sheet(points, {-1.8, -1.8, 0}, {3.6, 0, 0}, {0, 3.6, 0}, random);
  add_box(points, foot_corner, size, random);
  constexpr double kNoise_m = 0.002;
  for (Vec3& p : points)
    for (int c = 0; c < 3; ++c) p[c] += kNoise_m * random.normal();
  return points;
}

// Of the largest region of the epoch after, or of that before where there is none.
bool moved(const TwoEpochs& epochs, Change& out) {
  Task task;
  const auto& after = epochs.after.regions.regions;
  const auto& before = epochs.before.regions.regions;
  REQUIRE(after.size() + before.size() > 0);
  ChangedObject whole = whole_object(
      epochs.before, epochs.after, after.empty() ? before[0].indices : std::vector<uint32_t>{},
      after.empty() ? std::vector<uint32_t>{} : after[0].indices, kApart_m / 2, task);
  return motion_of_whole(
      {epochs.before, epochs.after, kApart_m / 2, kApart_m, kApart_m, {}, {}, task},
      std::move(whole), out);
}

}  // namespace

TEST_CASE("motion_of_whole__of_a_block_that_was_pushed_tells_how_far") {
  const Vec3 size{0.8, 0.55, 0.4}, by{0.3, 0.2, 0};
  Change change;
  REQUIRE(moved({floor_with_block({-0.5, -0.4, 0}, size, 1),
                 floor_with_block(Vec3{-0.5, -0.4, 0} + by, size, 2)},
                change));
  CHECK(change.change_class == ChangeClass::kDisplacementOverlap);
  CHECK(norm(change.match.displacement - by) < 0.005);
  CHECK(change.explained > 0.75);
}

TEST_CASE("motion_of_whole__is_no_block_that_became_lower") {
  Change change;
  CHECK_FALSE(moved({floor_with_block({-0.5, -0.4, 0}, {0.8, 0.55, 0.9}, 3),
                     floor_with_block({-0.5, -0.4, 0}, {0.8, 0.55, 0.45}, 4)},
                    change));
}
