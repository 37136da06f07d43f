// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cstdlib>
#include <map>

#include "solid/sweep.h"
#include "solid/sweep_contact.h"
#include "unit/solid/bodies.h"

using namespace jalon;
using namespace jalon::test;

namespace {

Task::Hooks sweep_threads(unsigned count) {
  Task::Hooks hooks;
  hooks.threads = count;
  return hooks;
}

struct Pose {
  brute::Quaternion turn;
  Vec3 at;
};

/// A gauge of one to three bodies, a few poses, some points and triangles around the path.
struct Scene {
  std::vector<Body> bodies;
  std::vector<ConvexPiece> pieces;
  std::vector<Pose> poses;
  std::vector<Transform> transforms;
  std::vector<double> xyz;
  std::vector<Vec3> vertices;
  std::vector<std::array<uint32_t, 3>> triangles;

  explicit Scene(uint64_t seed) {
    RandomStream random(seed, 7);
    const size_t count = 1 + seed % 3;
    for (size_t i = 0; i < count; ++i) {
      const auto kind = static_cast<int>(random.below(4));
      bodies.push_back(any_body(random, kind));
    }
    for (const Body& body : bodies) pieces.push_back(body.piece);
    Pose pose{brute::any_turn(random, 3), brute::any_vector(random, 2)};
    const size_t stops = 1 + seed % 4;  // one pose: a gauge that stands still
    for (size_t i = 0; i < stops; ++i) {
      poses.push_back(pose);
      transforms.push_back(frame_of(pose.turn, pose.at));
      if (seed % 5 != 0)
        pose.turn = brute::product(pose.turn, brute::any_turn(random, seed % 5 == 1 ? 2.5 : 0.3));
      pose.at += brute::any_vector(random, 4);
    }
    for (int i = 0; i < 30; ++i) {
      const Vec3 near = poses[random.below(stops)].at, p = near + brute::any_vector(random, 5);
      for (int k = 0; k < 3; ++k) xyz.push_back(p[k]);
    }
    for (uint32_t i = 0; i < 2; ++i) {
      const Vec3 near = poses[random.below(stops)].at, p = near + brute::any_vector(random, 5);
      for (int k = 0; k < 3; ++k)
        vertices.push_back(p + brute::any_vector(random, i % 2 ? 0.5 : 3));
      triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
  }

  Vec3 point(size_t i) const { return {xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]}; }

  // Least signed distance of an obstacle from all bodies between two poses.
  double truth(const std::array<Vec3, 3>& corners, size_t count, size_t interval) const {
    const Pose &a = poses[interval], &b = poses[std::min(interval + 1, poses.size() - 1)];
    double best = std::numeric_limits<double>::infinity();
    for (const Body& body : bodies)
      best = std::min(
          best, brute::least(
                    [&](double t) {
                      const brute::Rotation r = brute::rotation_of(brute::slerp(a.turn, b.turn, t));
                      const Vec3 at = a.at + (b.at - a.at) * t;
                      std::array<Vec3, 3> seen;
                      for (size_t k = 0; k < count; ++k) seen[k] = r.back(corners[k] - at);
                      if (count == 1) return body.distance(seen[0]);
                      return brute::least_on_triangle(body.distance, seen[0], seen[1], seen[2]);
                    },
                    count == 1 ? 400 : 60));
    return best;
  }
};

}  // namespace

TEST_CASE("sweep_gauge__equals_brute_force_on_200_random_scenes") {
  const char* sanitized = std::getenv("JALON_SANITIZED");
  const uint64_t scenes = sanitized != nullptr ? 10 : 200;
  double worst = 0;
  size_t compared = 0;
  for (uint64_t seed = 0; seed < scenes; ++seed) {
    const Scene scene(seed);
    Box3 box;
    for (size_t i = 0; i < scene.xyz.size() / 3; ++i) box.add(scene.point(i));
    Task task(sweep_threads(1));
    const auto octree = Octree::build(scene.xyz, enclosing_cube(box), task);
    const TriangleBoxes boxes(scene.vertices, scene.triangles, task);
    const SweepSettings settings{100, 100};  // everything is a place
    const SweepResult result = sweep_gauge(scene.pieces, scene.transforms,
                                           {octree.get(), scene.xyz, &boxes}, settings, task);

    std::map<std::pair<int, uint32_t>, double> least;
    const size_t intervals = std::max<size_t>(1, scene.poses.size() - 1);
    REQUIRE(result.intervals.size() == intervals);
    for (size_t i = 0; i < intervals; ++i) {
      double all = std::numeric_limits<double>::infinity();
      const auto note = [&](int kind, uint32_t index, double value) {
        all = std::min(all, value);
        const auto [at, fresh] = least.try_emplace({kind, index}, value);
        at->second = std::min(at->second, value);
      };
      for (uint32_t p = 0; p < scene.xyz.size() / 3; ++p)
        note(1, p, scene.truth({scene.point(p)}, 1, i));
      for (uint32_t t = 0; t < scene.triangles.size(); ++t)
        note(2, t, scene.truth(boxes.corners(t), 3, i));
      worst = std::max(worst, std::abs(result.intervals[i].clearance_m - all));
      CHECK(result.near_counts[i] == scene.xyz.size() / 3 + scene.triangles.size());
    }
    REQUIRE(result.places.size() == least.size());
    for (const SweepPlace& place : result.places) {
      const double error = std::abs(place.clearance_m - least.at({int(place.kind), place.index}));
      worst = std::max(worst, error);
      CHECK(norm(place.obstacle - place.gauge) ==
            doctest::Approx(std::abs(place.clearance_m)).epsilon(1e-6).scale(0));
      ++compared;
    }
  }
  MESSAGE("FIGURE swept clearance against brute force, " << scenes << " random scenes, " << compared
                                                         << " obstacles: worst difference " << worst
                                                         << " m");
  CHECK(worst < 1e-6);
}

TEST_CASE("sweep_gauge__meets_a_thin_pole_between_two_far_poses") {
  // 200 m from pose to pose; a pole of 1 cm stands half way, a hair inside the gauge's side or a hair outside.
  for (const double beside : {0.9995, 1.0005}) {
    std::vector<double> xyz;
    for (int i = 0; i < 200; ++i)
      for (const double v : {100.003, beside, 0.01 * i}) xyz.push_back(v);
    const std::vector<ConvexPiece> gauge{ConvexPiece::box(Transform{}, {1, 2, 3})};
    Transform far;
    far.m[3] = 200;
    const std::vector<Transform> poses{Transform{}, far};
    Task task;
    Box3 box;
    for (size_t i = 0; i < xyz.size(); i += 3) box.add({xyz[i], xyz[i + 1], xyz[i + 2]});
    const auto octree = Octree::build(xyz, enclosing_cube(box), task);
    const SweepResult result =
        sweep_gauge(gauge, poses, {octree.get(), xyz, nullptr}, {0, 1}, task);
    REQUIRE(result.intervals.size() == 1);
    CHECK(result.intervals[0].clearance_m == doctest::Approx(beside - 1).epsilon(1e-6).scale(0));
    CHECK(result.intervals[0].time == doctest::Approx(0.5).epsilon(0.01).scale(0));
    CHECK(result.places.size() == (beside < 1 ? 151 : 0));  // up to the gauge's height of 1.5 m
  }
}

TEST_CASE("sweep_gauge__meets_what_only_a_turn_brings_near") {
  // A beam of 10 m turns by a right angle about its middle: its ends sweep over a pole that both poses leave alone.
  const std::vector<ConvexPiece> gauge{ConvexPiece::box(Transform{}, {10, 0.1, 1})};
  const std::vector<Transform> poses{frame_of({1, 0, 0, 0}, {}),
                                     frame_of({std::sqrt(0.5), 0, 0, std::sqrt(0.5)}, {})};
  const double r = 4.99 / std::sqrt(2.0);
  const std::vector<Vec3> vertices{{r, r, -0.2}, {r + 1e-3, r, -0.2}, {r, r, 0.2}};
  Task task;
  const TriangleBoxes boxes(vertices, {{0, 1, 2}}, task);
  const SweepResult result = sweep_gauge(gauge, poses, {nullptr, {}, &boxes}, {0, 1}, task);
  REQUIRE(result.places.size() == 1);
  CHECK(result.places[0].time == doctest::Approx(0.5).epsilon(0.05).scale(0));
  // Deepest where the end and the long side of the beam are equally far.
  const double truth = brute::least(
      [](double t) {
        const double a = t * 0.02;
        return std::max(4.99 * std::cos(a) - 5, 4.99 * std::sin(a) - 0.05);
      },
      100);
  CHECK(result.places[0].clearance_m == doctest::Approx(truth).epsilon(1e-4).scale(0));
}

TEST_CASE("sweep_gauge__gives_the_same_bits_for_any_number_of_threads_and_far_from_the_origin") {
  Scene scene(3);
  const auto on_grid = [](double v) { return std::round(v * 1024) / 1024; };
  for (double& v : scene.xyz) v = on_grid(v);
  for (Transform& t : scene.transforms)
    for (const size_t i : {3u, 7u, 11u}) t.m[i] = on_grid(t.m[i]);
  SweepResult first;
  for (int turn = 0; turn < 3; ++turn) {
    std::vector<double> xyz = scene.xyz;
    std::vector<Transform> poses = scene.transforms;
    const Vec3 shift = turn == 2 ? Vec3{652000, 6861000, 35} : Vec3{};
    Box3 box;
    for (size_t i = 0; i < xyz.size(); ++i) xyz[i] += shift[int(i % 3)];
    for (size_t i = 0; i < xyz.size(); i += 3) box.add({xyz[i], xyz[i + 1], xyz[i + 2]});
    for (Transform& t : poses)
      for (size_t i = 0; i < 3; ++i) t.m[4 * i + 3] += shift[int(i)];
    Task task(sweep_threads(turn == 1 ? 4 : 1));
    const auto octree = Octree::build(xyz, enclosing_cube(box), task);
    const SweepResult result =
        sweep_gauge(scene.pieces, poses, {octree.get(), xyz, nullptr}, {2, 5}, task);
    if (turn == 0) first = result;
    REQUIRE(result.places.size() == first.places.size());
    for (size_t i = 0; i < first.places.size(); ++i) {
      CHECK(result.places[i].index == first.places[i].index);
      CHECK(result.places[i].clearance_m == first.places[i].clearance_m);
      CHECK(result.places[i].time == first.places[i].time);
    }
    for (size_t i = 0; i < first.intervals.size(); ++i)
      CHECK(result.intervals[i].clearance_m == first.intervals[i].clearance_m);
  }
}
