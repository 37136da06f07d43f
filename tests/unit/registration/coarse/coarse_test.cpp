// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/coarse/coarse.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "unit/registration/coarse_scenes.h"

using namespace jalon;
using namespace jalon::test;

namespace {

struct Case {
  CloudPtr reference, moving;
};

constexpr size_t kPoints = 30'000;
constexpr double kNoise_m = 0.003;

// Fewer cells than by default: half the time.
constexpr CoarseSettings kFewerCells{.cells = 10000};

Registration registered(const Case& c, const CoarseSettings& settings = kFewerCells,
                        const Transform& start = {}, unsigned threads = 0) {
  Task::Hooks hooks;
  hooks.threads = threads;
  Task task(hooks);
  return register_coarse(c.reference, c.moving, start, settings, task);
}

CloudPtr shared_cloud(const std::vector<Vec3>& points) {
  return std::make_shared<const Cloud>(cloud_of(points));
}

std::vector<Vec3> moved(std::vector<Vec3> points, const Transform& by) {
  for (Vec3& p : points) p = by.point(p);
  return points;
}

// Two samples of a scene, the second moved by the start.
Case case_of(const SampledScene& scene, const Transform& start, uint64_t draw,
             const SampledScene::Keep& keep_reference = {},
             const SampledScene::Keep& keep_moving = {}) {
  return {shared_cloud(scene.sample(kPoints, kNoise_m, 2 * draw + 1, keep_reference)),
          shared_cloud(moved(scene.sample(kPoints, kNoise_m, 2 * draw + 2, keep_moving), start))};
}

double value_of(const Registration& r, const char* name) {
  return r.summary.require(name).values<double>()[0];
}

struct Miss {
  double shift_m, turn_rad;
};
// How far the pose is off the one that undoes the start, at a place of the scene.
Miss miss(const Registration& r, const Transform& start, const Vec3& place) {
  const Transform off = r.pose * start;
  return {norm(off.point(place) - place), norm(rotation_vector(off))};
}

void check_found(const Registration& r, const Transform& start, const Vec3& place) {
  const Miss off = miss(r, start, place);
  CHECK(r.converged);
  CHECK(r.stopped == StopReason::kConverged);
  CHECK(off.shift_m < value_of(r, "cell"));
  CHECK(off.turn_rad < 0.01);
}

uint64_t draws() { return std::getenv("JALON_FULL") ? 20 : std::getenv("JALON_SANITIZED") ? 1 : 2; }
/// Where a scene and not the start makes the case.
uint64_t repeats() { return std::getenv("JALON_FULL") ? 20 : 1; }

}  // namespace

TEST_CASE("coarse__finds_any_turn_and_shift") {
  for (uint64_t draw = 0; draw < 2 * draws(); draw += 2)
    for (const bool any_axis : {false, true}) {
      if (draws() == 2 && any_axis != (draw == 2)) continue;  // one of each by default
      const Transform start = random_start(draw, any_axis);
      const Registration room = registered(case_of(furnished_room(), start, draw));
      check_found(room, start, {3, 2.5, 1});
      const Registration street = registered(case_of(street_corner(), start, draw));
      check_found(street, start, {0, 0, 2});
      MESSAGE("FIGURE coarse, scores and those of the second pose: room "
              << value_of(room, "score") << " " << value_of(room, "second_score") << ", street "
              << value_of(street, "score") << " " << value_of(street, "second_score"));
    }
}

TEST_CASE("coarse__needs_no_planes") {
  for (uint64_t draw = 0; draw < repeats(); ++draw) {
    const Transform start = random_start(draw);
    const Case c{shared_cloud(rolling_ground(kPoints, kNoise_m, 2 * draw + 1)),
                 shared_cloud(moved(rolling_ground(kPoints, kNoise_m, 2 * draw + 2), start))};
    check_found(registered(c), start, {30, 30, 1});
  }
}

TEST_CASE("coarse__finds_the_pose_of_clouds_that_share_less_than_half") {
  // Laid on each other wrongly, ground and facades would cover more of each other than they truly do.
  for (uint64_t draw = 0; draw < repeats(); ++draw) {
    const Transform start = random_start(draw);
    const Case c = case_of(
        street_corner(), start, draw, [](const Vec3& p) { return p.x < 8; },
        [](const Vec3& p) { return p.x > -2; });
    const Registration r = registered(c);
    check_found(r, start, {3, 0, 2});
    CHECK(value_of(r, "overlap_moving") < 0.5);
  }
}

TEST_CASE("coarse__asks_less_likeness_of_a_pose_that_stands_out") {
  const Transform start = random_start(1);
  const Case c = case_of(street_corner(), start, 1);
  const Registration sure = registered(c);
  REQUIRE(value_of(sure, "second_score") < 0.55 * value_of(sure, "score"));
  // A little more than its places are alike: too much to ask of a pose among equals, not of this one.
  CoarseSettings strict = kFewerCells;
  strict.min_likeness_percent = std::min(100.0, 101 * value_of(sure, "likeness"));
  check_found(registered(c, strict), start, {3, 0, 2});
}

TEST_CASE("coarse__calls_symmetric_scenes_ambiguous") {
  for (uint64_t draw = 0; draw < repeats(); ++draw) {
    const Transform start = random_start(draw);
    for (const SampledScene& scene : {bare_room(), corridor(), one_plane()}) {
      const Registration r = registered(case_of(scene, start, draw));
      CHECK_FALSE(r.converged);
      CHECK(r.stopped == StopReason::kAmbiguous);
      CHECK(r.summary.require("ambiguous").values<uint8_t>()[0] == 1);
      CHECK(value_of(r, "second_score") > 0.85 * value_of(r, "score"));
      CHECK(r.iteration_log.require("score").values<double>().size() > 1);
    }
  }
}

TEST_CASE("coarse__names_the_directions_that_nothing_holds") {
  const Transform start = random_start(1);
  const auto weak = [&](const SampledScene& scene) {
    return registered(case_of(scene, start, 1)).unobservable;
  };
  CHECK(weak(bare_room()) == 0);
  CHECK(weak(corridor()) == 1);
  CHECK(weak(one_plane()) == 3);
}

TEST_CASE("coarse__finds_nothing_in_clouds_of_different_places") {
  const Transform start = random_start(2);
  const SampledScene other_room = SampledScene()
                                      .box({0, 0, 0}, {7, 4.2, 3})
                                      .box({1, 2, 0}, {2, 1, 1})
                                      .box({4, 1, 0}, {1, 1, 2});
  const Case rooms{shared_cloud(furnished_room().sample(kPoints, kNoise_m, 1)),
                   shared_cloud(moved(other_room.sample(kPoints, kNoise_m, 2), start))};
  const Case ends = case_of(
      street_corner(), start, 2, [](const Vec3& p) { return p.x < -2; },
      [](const Vec3& p) { return p.x > 5; });
  const Case unlike{shared_cloud(street_corner().sample(kPoints, kNoise_m, 1)),
                    shared_cloud(moved(furnished_room().sample(kPoints, kNoise_m, 2), start))};
  for (const Case& c : {rooms, ends, unlike}) {
    const Registration r = registered(c);
    CHECK(r.stopped == StopReason::kNothingFound);
    CHECK_FALSE(r.converged);
    CHECK(r.pose.m == Transform{}.m);
  }
}

TEST_CASE("coarse__limits_decide_between_poses_that_fit_alike") {
  const Case c = case_of(bare_room(), rotation_by({0, 0, 0.2}), 3);
  CoarseSettings settings = kFewerCells;
  settings.max_turn_rad = 0.5;
  const Registration r = registered(c, settings);
  check_found(r, rotation_by({0, 0, 0.2}), {3, 2.5, 1});
  settings.max_shift_m = 0.001;
  CHECK(registered(c, settings).stopped == StopReason::kNothingFound);
}

TEST_CASE("coarse__keeps_clouds_upright_on_demand") {
  CoarseSettings settings = kFewerCells;
  settings.gravity = true;
  const Transform start = random_start(4);
  const Registration r = registered(case_of(bare_room(), start, 4), settings);
  CHECK(r.stopped == StopReason::kAmbiguous);  // half a turn about the vertical remains
  const auto poses = r.iteration_log.require("pose").values<double>();
  for (size_t i = 0; i < poses.size(); i += 12) CHECK(poses[i + 10] > 0.99);
}

TEST_CASE("coarse__is_the_same_wherever_the_clouds_lie") {
  const Transform start = random_start(5);
  const Case here = case_of(street_corner(), start, 5);
  const auto far_cloud = [](const CloudPtr& cloud) {
    std::vector<Vec3> points;
    for (size_t i = 0; i < cloud->size(); ++i) points.push_back(cloud->point(i) + kFar);
    return shared_cloud(points);
  };
  const Case far{far_cloud(here.reference), far_cloud(here.moving)};
  const Registration a = registered(here), b = registered(far);
  CHECK(b.converged);
  const Vec3 place = start.point({0, 0, 2});
  CHECK(norm(b.pose.point(place + kFar) - kFar - a.pose.point(place)) < 1e-3);
}

TEST_CASE("coarse__gives_the_same_bits_with_any_number_of_threads") {
  const Case c = case_of(furnished_room(), random_start(6), 6);
  const Registration one = registered(c, kFewerCells, {}, 1);
  for (const unsigned threads : {2u, 7u}) {
    const Registration other = registered(c, kFewerCells, {}, threads);
    CHECK(std::memcmp(one.pose.m.data(), other.pose.m.data(), sizeof one.pose.m) == 0);
    CHECK(value_of(one, "second_score") == value_of(other, "second_score"));
  }
}

TEST_CASE("coarse__refuses_what_shows_no_shape") {
  const CloudPtr room = shared_cloud(furnished_room().sample(1000, kNoise_m, 1));
  const auto status = [&](const CloudPtr& moving) {
    return status_of([&] { registered({room, moving}); });
  };
  CHECK(status(shared_cloud({})) == Status::kInsufficientData);
  CHECK(status(shared_cloud(furnished_room().sample(40, kNoise_m, 2))) ==
        Status::kInsufficientData);
  CHECK(status(shared_cloud(std::vector<Vec3>(1000, Vec3{1, 2, 3}))) == Status::kInsufficientData);
}
