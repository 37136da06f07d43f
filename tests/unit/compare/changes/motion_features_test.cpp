// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/changes/motion_features.h"

#include <doctest/doctest.h>

#include "unit/compare/changes/told_epochs.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr Vec3 kMotionBoxSize{0.8, 0.55, 0.4}, kMotionBoxFrom{-0.5, -0.4, 0};

// Of the thing that the largest region of the epoch after is a part of; empty where no motion may explain it.
ChangeFeatures motion_features_of(const ToldEpochs& epochs) {
  Task task;
  const ObjectMotionJob job = epochs.job(task);
  const auto& regions = epochs.after.regions.regions;
  REQUIRE_FALSE(regions.empty());
  Change change;
  ChangedObject whole =
      whole_object(epochs.before, epochs.after, {}, regions[0].indices, job.tolerance_m, task);
  REQUIRE(motion_of_whole(job, std::move(whole), change));
  set_motion_features(job, change, change.features);
  return change.features;
}

}  // namespace

TEST_CASE("motion_features__of_a_box_that_was_pushed_tell_that_it_left_a_place_and_still_stands") {
  const ChangeFeatures f =
      motion_features_of({floor_with({{kMotionBoxFrom, kMotionBoxSize}}, 21),
                          floor_with({{kMotionBoxFrom + Vec3{0.3, 0.2, 0}, kMotionBoxSize}}, 22)});
  CHECK(f[kFeatureTilt] < 0.05);
  CHECK(f[kFeatureStayBest] > f[kFeatureWorst] + 1);
  CHECK(f[kFeatureLikeExtents] > std::log(0.9));
  CHECK(f[kFeatureWayOfSize] ==
        doctest::Approx(std::log(0.36 / norm(kMotionBoxSize))).epsilon(0.1).scale(0));
  CHECK(f[kFeatureWhole] == 1);
  CHECK(f[kFeatureJudged] == 1);
}

TEST_CASE("motion_features__tell_how_much_of_the_way_turns_a_thing_off_its_support") {
  const ToldEpochs epochs(floor_with({{kMotionBoxFrom, kMotionBoxSize}}, 23),
                          floor_with({{kMotionBoxFrom, kMotionBoxSize}}, 24));
  Task task;
  Change change;
  change.motion.way_m = 0.2;
  change.motion.tilt_m = 0.15;
  change.object.before = {0, 1, 2};
  change.object.after = {0, 1, 2};
  set_motion_features(epochs.job(task), change, change.features);
  CHECK(change.features[kFeatureTilt] == doctest::Approx(0.75));
  CHECK(change.features[kFeatureTiltOfSize] ==
        doctest::Approx(0.75 * change.features[kFeatureWayOfSize]));
}

TEST_CASE("motion_features__of_few_points_are_unsure") {
  const ToldEpochs epochs(floor_with({{kMotionBoxFrom, kMotionBoxSize}}, 25),
                          floor_with({{kMotionBoxFrom, kMotionBoxSize}}, 26));
  Task task;
  const auto worst_of = [&](size_t points) {
    Change change;
    change.object.before = {0, 1, 2};
    change.object.after = {0, 1, 2};
    change.motion.forth = change.motion.back = {points, points};
    set_motion_features(epochs.job(task), change, change.features);
    return change.features[kFeatureWorst];
  };
  CHECK(worst_of(0) == doctest::Approx(std::log(0.25)));
  CHECK(worst_of(1000) < worst_of(50));
}
