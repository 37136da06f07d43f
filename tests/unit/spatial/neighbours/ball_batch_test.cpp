// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <atomic>
#include <map>

#include "base/error.h"
#include "unit/spatial/hostile_clouds.h"
#include "unit/spatial/octree_fixture.h"

using namespace jalon;
using namespace jalon::test;

namespace {

/// For each point, by the caller's index, the indices within the radius, ascending.
using Balls = std::vector<std::vector<uint32_t>>;

Balls all_balls(const Octree& tree, double radius, unsigned thread_count = 2) {
  Task task(threads(thread_count));
  Balls out(tree.size());
  tree.for_each_ball(radius, task, [&](const Octree::BallBatch& batch) {
    for (size_t i = 0; i < batch.count; ++i) {
      auto& own = out[tree.order()[batch.first + i]];
      for (uint32_t j = batch.offsets[i]; j < batch.offsets[i + 1]; ++j)
        own.push_back(tree.order()[batch.neighbours[j]]);
      std::sort(own.begin(), own.end());
    }
  });
  return out;
}

Balls by_brute_force(const std::vector<double>& xyz, double radius) {
  Balls out(xyz.size() / 3);
  for (size_t i = 0; i < out.size(); ++i)
    for (size_t j = 0; j < out.size(); ++j)
      if (squared_norm(point(xyz, j) - point(xyz, i)) <= radius * radius)
        out[i].push_back(static_cast<uint32_t>(j));
  return out;
}

}  // namespace

TEST_CASE("ball_batch__equals_brute_force_from_alone_to_everybody") {
  const auto xyz = street(1500);
  const auto tree = build(xyz);
  for (const double radius : {1e-9, 0.4, 3.0, 100.0}) {
    CAPTURE(radius);
    CHECK(all_balls(*tree, radius) == by_brute_force(xyz, radius));
  }
}

TEST_CASE("ball_batch__the_ball_is_closed_on_a_lattice") {
  std::vector<double> xyz;
  for (int i = 0; i < 7 * 7 * 7; ++i)
    for (const int c : {i % 7, i / 7 % 7, i / 49}) xyz.push_back(c);
  const auto tree = build(xyz);
  const size_t middle = 3 + 7 * 3 + 49 * 3;
  // 1 + 6 points within 1; 8 more at sqrt(3) and 12 at sqrt(2), then 6 at 2.
  CHECK(all_balls(*tree, 1)[middle].size() == 7);
  CHECK(all_balls(*tree, 0.99999)[middle].size() == 1);
  CHECK(all_balls(*tree, 2)[middle].size() == 33);
  CHECK(all_balls(*tree, 1.99999)[middle].size() == 27);
}

TEST_CASE("ball_batch__duplicates_are_in_each_other_s_balls_and_threads_change_nothing") {
  std::vector<double> xyz = street(600);
  for (size_t i = 0; i < 300; ++i)
    for (size_t axis = 0; axis < 3; ++axis) xyz[3 * i + axis] = 2.5;
  const auto tree = build(xyz);
  const Balls balls = all_balls(*tree, 0.01, 1);
  CHECK(balls == by_brute_force(xyz, 0.01));
  CHECK(balls[0].size() >= 300);
  CHECK(balls == all_balls(*tree, 0.01, 4));
}

TEST_CASE("ball_batch__equals_brute_force_where_the_grid_does_not_tell_points_apart") {
  for (const HostileCloud& cloud : hostile_clouds(800)) {
    CAPTURE(cloud.name);
    const auto tree = build(cloud.xyz);
    for (const double radius : {0.0, 1e-30, 2e-6, 0.3, 100.0}) {
      CAPTURE(radius);
      const Balls balls = all_balls(*tree, radius, 1);
      CHECK(balls == by_brute_force(cloud.xyz, radius));
      CHECK(balls == all_balls(*tree, radius, 3));
    }
  }
}

// The balls that are given by places hold what they hold otherwise, with the distances that they have otherwise.
TEST_CASE("ball_batch__of_crowds_gives_places_in_few_groups_with_the_same_points_and_distances") {
  constexpr size_t kPoints = 6000;
  size_t all_crowded = 0;
  for (const HostileCloud& cloud : hostile_clouds(kPoints)) {
    const auto tree = build(cloud.xyz);
    if (!tree->has_crowds()) continue;
    CAPTURE(cloud.name);
    for (const double radius : {1e-30, 0.7, 100.0}) {
      CAPTURE(radius);
      std::vector<std::map<uint32_t, float>> truth(kPoints);
      const auto list = [&](const Octree::BallBatch& batch, auto& out) {
        for (size_t i = 0; i < batch.count; ++i)
          for (uint32_t j = batch.offsets[i]; j < batch.offsets[i + 1]; ++j)
            if ((batch.first + i) % 50 == 0)
              out[batch.first + i][batch.neighbours[j]] = batch.squared[j];
      };
      Task task(threads(1));
      tree->for_each_ball(radius, task, [&](const auto& batch) { list(batch, truth); });
      std::vector<std::map<uint32_t, float>> found(kPoints);
      std::vector<int> times(kPoints, 0);
      size_t crowded = 0, groups = 0;
      tree->for_each_crowded_ball(
          radius, task,
          [&](const Octree::BallBatch& batch) {
            for (size_t i = 0; i < batch.count; ++i) ++times[batch.first + i];
            list(batch, found);
          },
          [&](const Octree::CrowdedBall& ball) {
            ++times[ball.point];
            ++crowded;
            groups += ball.groups.size();
            if (ball.point % 50 != 0) return;
            for (const Octree::PlaceGroup& group : ball.groups)
              for (uint32_t i = group.first; i < group.last; ++i)
                found[ball.point][i] = group.squared;
          });
      CHECK(std::count(times.begin(), times.end(), 1) == kPoints);
      CHECK(found == truth);
      all_crowded += crowded;
      if (radius < 1 && crowded > 0) CHECK(groups / crowded < kPoints * 2 / 3);
    }
  }
  CHECK(all_crowded > 10 * kPoints);
}

TEST_CASE("ball_batch__balls_by_ranges_hold_the_same_points_as_those_by_lists") {
  constexpr size_t kPoints = 6000;
  std::vector<HostileCloud> clouds = hostile_clouds(kPoints);
  clouds.push_back({"street", street(kPoints)});
  clouds.push_back({"equal", std::vector<double>(3 * kPoints, 0.25)});
  size_t all_ranged = 0, all_listed = 0;
  for (const HostileCloud& cloud : clouds) {
    CAPTURE(cloud.name);
    const auto tree = build(cloud.xyz);
    for (const double radius : {1e-30, 0.25, 6.0, 1e200}) {
      CAPTURE(radius);
      std::vector<std::vector<uint32_t>> truth(kPoints), found(kPoints);
      const auto list = [](const Octree::BallBatch& batch, auto& out) {
        for (size_t i = 0; i < batch.count; ++i)
          if ((batch.first + i) % 50 == 0)
            out[batch.first + i].assign(batch.neighbours + batch.offsets[i],
                                        batch.neighbours + batch.offsets[i + 1]);
      };
      Task task(threads(1));
      tree->for_each_ball(radius, task, [&](const auto& batch) { list(batch, truth); });
      std::vector<int> times(kPoints, 0);
      tree->for_each_ranged_ball(
          radius, task,
          [&](const Octree::BallBatch& batch) {
            for (size_t i = 0; i < batch.count; ++i) ++times[batch.first + i];
            all_listed += batch.count;
            list(batch, found);
          },
          [&](const Octree::RangedBall& ball) {
            ++times[ball.point];
            ++all_ranged;
            size_t count = 0;
            for (const Octree::PointRange& range : ball.ranges) count += range.last - range.first;
            CHECK(count == ball.count);
            if (ball.point % 50 != 0) return;
            for (const Octree::PointRange& range : ball.ranges)
              for (uint32_t i = range.first; i < range.last; ++i) found[ball.point].push_back(i);
          });
      CHECK(std::count(times.begin(), times.end(), 1) == kPoints);
      CHECK(found == truth);
    }
  }
  CHECK(all_ranged > 10 * kPoints);
  CHECK(all_listed > 10 * kPoints);
}

// What a cancel has to wait for: the neighbours that are handed on at once, not those of a chunk of leaves.
TEST_CASE("ball_batch__obeys_a_cancel_between_two_hand_overs_of_a_chunk") {
  const std::vector<double> xyz(3 * 6000, 0.25);  // 6000 neighbours a point, handed on at 2^17
  const auto tree = build(xyz);
  std::atomic<bool> cancel{false};
  Task::Hooks hooks = threads(1);
  hooks.cancel = &cancel;
  Task task(hooks);
  size_t points = 0;
  CHECK_THROWS_AS(tree->for_each_ball(1, task,
                                      [&](const Octree::BallBatch& batch) {
                                        points += batch.count;
                                        cancel = true;
                                      }),
                  Error);
  CHECK(points == 22);  // the first whose neighbours are 2^17 or more
}
