// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Closed-form motions and the judge of poses, on surfaces whose overlap is counted.

#include <doctest/doctest.h>

#include <cmath>

#include "registration/coarse/pose.h"
#include "unit/registration/coarse_surfaces.h"

using namespace jalon;
using namespace jalon::test;

namespace {

double squares_left(const std::vector<Vec3>& from, const std::vector<Vec3>& to,
                    const Transform& pose) {
  double sum = 0;
  for (size_t i = 0; i < from.size(); ++i) sum += squared_norm(pose.point(from[i]) - to[i]);
  return sum;
}

CoarseSurface with_features(const Cells& cells) {
  CoarseSurface s = cells.surface();
  Task task;
  describe_features(s, 4.3, 1000, task);
  return s;
}

Cells corner_of_three() {
  return Cells()
      .sheet({0.5, 0.5, 0}, {1, 0, 0}, {0, 1, 0}, 12, 9)
      .sheet({0, 0.5, 0.5}, {0, 1, 0}, {0, 0, 1}, 9, 7)
      .sheet({0.5, 0, 0.5}, {1, 0, 0}, {0, 0, 1}, 12, 7);
}

}  // namespace

TEST_CASE("closest_motion__gives_a_motion_back_and_stays_a_rotation_where_points_are_mirrored") {
  for (uint64_t draw = 0; draw < 10; ++draw) {
    const Transform truth = random_start(draw, true);
    auto from = random_points(draw % 2 ? 4 : 12, 5, draw);
    if (draw == 4)
      for (Vec3& p : from) p.z = 2;  // flat
    const Transform found = closest_motion(from, moved_points(from, truth));
    for (size_t i = 0; i < 12; ++i) CHECK(std::abs(found.m[i] - truth.m[i]) < 1e-11);
    std::vector<Vec3> mirrored;
    for (const Vec3& p : from) mirrored.push_back({-p.x, p.y, p.z});
    CHECK(closest_motion(from, mirrored).determinant() == doctest::Approx(1));
  }
  const std::vector<Vec3> one{{1, 2, 3}}, other{{-4, 0, 2}};
  const Transform single = closest_motion(one, other);
  CHECK(single.determinant() == doctest::Approx(1));
  CHECK(norm(single.point(one[0]) - other[0]) < 1e-12);
}

TEST_CASE("closest_motion__no_small_motion_leaves_smaller_squares") {
  const auto from = random_points(9, 5, 21), noise = random_points(9, 0.5, 22);
  auto to = moved_points(from, random_start(6, true));
  for (size_t i = 0; i < to.size(); ++i) to[i] += noise[i];
  const Transform found = closest_motion(from, to);
  const double least = squares_left(from, to, found);
  for (int k = 0; k < 12; ++k) {
    Vec3 turn, shift;
    (k < 6 ? turn : shift)[k % 3] = k % 6 < 3 ? 1e-3 : -1e-3;
    CHECK(squares_left(from, to, motion_about(to[0], turn, shift) * found) > least);
  }
}

TEST_CASE("pose_judge__counts_what_lies_on_the_other_surface") {
  const CoarseSurface room = with_features(corner_of_three());
  const PoseJudge same(room, room, 10000);
  const SurfaceOverlap all = same.overlap({}, 1.5, 0.5),
                       none = same.overlap(motion_about({}, {}, {99, 0, 0}), 1.5, 0.5);
  CHECK(all.of_moving == 1);
  CHECK(all.of_reference == 1);
  CHECK(all.score() == 1);
  CHECK(all.salient == 1);
  CHECK(all.pairs == 2 * room.size());
  CHECK(all.rms_m == 0);
  CHECK(none.score() == 0);
  CHECK(none.pairs == 0);
  // A sheet of 60 and the same beside one of 40 cells, too far up for its cells to meet.
  const Cells one = Cells().sheet({}, {1, 0, 0}, {0, 1, 0}, 10, 6);
  const CoarseSurface few = with_features(one);
  const CoarseSurface more =
      with_features(Cells(one).sheet({0, 0, 9}, {1, 0, 0}, {0, 1, 0}, 10, 4));
  const SurfaceOverlap part =
      PoseJudge(few, more, 10000).overlap(motion_about({}, {}, {0, 0, 0.3}), 1.5, 0.5);
  CHECK(part.of_moving == doctest::Approx(0.6));
  CHECK(part.of_reference == 1);
  CHECK(part.count == doctest::Approx(120.0 / 160));
  CHECK(part.rms_m == doctest::Approx(0.3));
  CHECK(PoseJudge(few, more, 10000).overlap(motion_about({}, {}, {0, 0, 0.6}), 1.5, 0.5).pairs ==
        0);
}

TEST_CASE("pose_judge__settles_where_planes_hold_and_stays_where_nothing_does") {
  const CoarseSurface room = with_features(corner_of_three());
  const Transform off = motion_about(room.centroid, {0.05, -0.04, 0.03}, {0.6, -0.4, 0.5});
  const PoseJudge judge(room, room, 10000);
  // The damping of 1e-4 leaves so much of each step to the next; fourteen leave nothing.
  const Transform back = judge.settled(off, 4, 1.2, 14).T_reference_moving;
  CHECK(judge.difference(back, {}) < 1e-6);
  const CoarseSurface sheet = with_features(Cells().sheet({}, {1, 0, 0}, {0, 1, 0}, 12, 12));
  const SettledPose slid =
      PoseJudge(sheet, sheet, 10000).settled(motion_about({}, {}, {0.3, 0.2, 0.5}), 4, 1.2, 8);
  const Vec3 left = slid.T_reference_moving.point({});
  CHECK(norm(left - Vec3{0.3, 0.2, 0}) < 1e-6);
  CHECK(slid.fixed[21] == 0);  // shifts along x and y
  CHECK(slid.fixed[28] == 0);
  CHECK(slid.fixed[35] == doctest::Approx(144));  // every cell, weight 1
}

TEST_CASE("pose_judge__difference_is_that_of_the_corners_of_a_cube_of_the_extent") {
  const CoarseSurface room = with_features(corner_of_three());
  const PoseJudge judge(room, room, 100);
  const Transform pose = random_start(2, true), shift = motion_about({}, {}, {3, -4, 12});
  CHECK(judge.difference(pose, shift * pose) == doctest::Approx(13));
  // Corners lie sqrt(2 / 3) of the extent off each axis of the cube.
  const Transform turn = motion_about(room.centroid, {0, 0, 0.8}, {});
  CHECK(judge.difference({}, turn) ==
        doctest::Approx(2 * std::sin(0.4) * std::sqrt(2.0 / 3) * room.extent_m));
}
