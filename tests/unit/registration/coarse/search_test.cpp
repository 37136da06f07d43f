// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// The search among candidates that are given, of scenes whose pose is known.

#include <doctest/doctest.h>

#include "registration/coarse/search.h"
#include "unit/registration/coarse_surfaces.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr double kCell_m = 0.5;

struct Twice {
  CoarseSurface reference, moving;
};

Twice sampled_twice(const SampledScene& scene) {
  return {described_surface(scene.sample(4000, 0.003, 1), kCell_m),
          described_surface(scene.sample(4000, 0.003, 2), kCell_m)};
}

// Of samples that lie on each other.
Transform true_pose(const Twice& s) { return between_surfaces({}, s.reference, s.moving); }

CoarseSearch searched(
    const Twice& s, const std::vector<PoseCandidate>& candidates,
    const PoseFilter& is_wanted = [](const Transform&) { return true; }) {
  Task task;
  return search_poses(s.reference, s.moving, candidates, is_wanted, task);
}

PoseCandidate off_by(const Twice& s, const Vec3& turn, const Vec3& shift, PoseSource source) {
  const Transform truth = true_pose(s);
  return {motion_about(truth.point(s.moving.centroid), turn, shift) * truth, source};
}

}  // namespace

TEST_CASE("search_poses__settles_on_the_truth_among_wrong_candidates") {
  const Twice room = sampled_twice(furnished_room());
  using enum PoseSource;
  const auto found = searched(
      room, {off_by(room, {0, 0, 1.6}, {}, kPlanes),
             off_by(room, {0.03, 0.02, -0.04}, {0.3, 0.2, -0.3}, kFeatures),
             off_by(room, {0, 0, 3.14}, {}, kPlanes), off_by(room, {}, {1, 2, 0}, kStart)});
  REQUIRE_FALSE(found.poses.empty());
  CHECK(found.poses[0].source == kFeatures);
  // Cells' planes are good to some hundredths of a cell; a tenth is far below what ICP begins with.
  CHECK(farthest_apart(found.poses[0].T_reference_moving, true_pose(room), room.moving) <
        0.1 * kCell_m);
  const PoseJudge judge(room.reference, room.moving, 100);
  for (size_t i = 1; i < found.poses.size(); ++i) {
    CHECK(found.poses[i].overlap.score() <= found.poses[i - 1].overlap.score());
    for (size_t k = 0; k < i; ++k)
      CHECK(judge.difference(found.poses[i].T_reference_moving, found.poses[k].T_reference_moving) >
            4 * kCell_m);
  }
}

TEST_CASE("search_poses__gives_only_poses_that_are_wanted") {
  const Twice room = sampled_twice(bare_room());
  // Half a turn lays the room on itself: with a filter that alone is left.
  const std::vector<PoseCandidate> both{
      off_by(room, {0, 0, 0.02}, {0.1, 0.1, 0}, PoseSource::kPlanes),
      off_by(room, {0, 0, 3.1}, {0.1, 0, 0}, PoseSource::kPlanes)};
  const PoseFilter is_turned = [](const Transform& T) { return T.m[0] < 0; };
  const CoarseSearch found = searched(room, both, is_turned);
  REQUIRE_FALSE(found.poses.empty());
  for (const RankedPose& pose : found.poses) CHECK(is_turned(pose.T_reference_moving));
  CHECK(found.poses[0].overlap.count > 0.9);
  const PoseFilter never = [](const Transform&) { return false; };
  CHECK(searched(room, both, never).poses.empty());
  CHECK(searched(room, {}).poses.empty());
}

TEST_CASE("search_poses__slides_show_that_a_corridor_is_one") {
  const Twice hall = sampled_twice(corridor());
  const auto found = searched(hall, {off_by(hall, {}, {0.1, 0.1, 0.1}, PoseSource::kStart)});
  REQUIRE(found.poses.size() >= 2);
  CHECK(found.poses[0].source == PoseSource::kStart);
  const Transform truth = true_pose(hall);
  bool slid = false;
  for (const RankedPose& pose : found.poses) {
    const Vec3 off =
        pose.T_reference_moving.point(hall.moving.centroid) - truth.point(hall.moving.centroid);
    slid = slid || (pose.source == PoseSource::kSlide && std::abs(off.x) > 4 * kCell_m &&
                    std::hypot(off.y, off.z) < kCell_m);
  }
  CHECK(slid);
}

TEST_CASE("search_poses__leaves_out_what_lies_across_the_other_surface") {
  // A saddle crosses a floor along two lines; beside these heights up to half a cell come evenly: 0.29 cells rms.
  const auto ground = [](double bend, uint64_t seed) {
    std::vector<Vec3> out = random_points(3000, 9, seed);
    for (Vec3& p : out) p.z = bend * (std::pow(p.x - 4.5, 2) - std::pow(p.y - 4.5, 2));
    return described_surface(out, kCell_m);
  };
  const Twice saddles{ground(0.03, 31), ground(0.03, 32)}, across{ground(0, 33), ground(0.03, 34)};
  const auto as_they_lie = [](const Twice& s) {
    return searched(s, {{true_pose(s), PoseSource::kStart}});
  };
  const CoarseSearch found = as_they_lie(saddles);
  REQUIRE_FALSE(found.poses.empty());
  CHECK(found.poses[0].overlap.count > 0.9);
  for (const RankedPose& pose : as_they_lie(across).poses) CHECK(pose.overlap.count < 0.02);
}
