// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "unit/cloud/clouds.h"

namespace jalon {
namespace {

using namespace test;

enum Kind : uint8_t { kFacade, kUnwanted, kGround };

/// Unwanted points, built by hand: a 30 x 12 m wall in y = 0 with window reveals
/// 0.25 m deep, a balcony and a cornice, three trees and two cars 3-7 m in front (y < 0), ghosts
/// 0.8-6 m behind; turned by 37 degrees and put on a map grid.
struct Scene {
  std::vector<Vec3> points;
  std::vector<uint8_t> kinds;
  RandomStream random{71, 0};

  void add(const Vec3& p, Kind kind) {
    points.push_back({p.x, p.y + 0.005 * random.normal(), p.z});
    kinds.push_back(kind);
  }
  double between(double a, double b) { return a + (b - a) * random.uniform(); }
  void facade() {
    for (int i = 0; i < 60000; ++i) {
      const double x = between(0, 30), z = between(0.5, 12);
      const bool window = std::fmod(x, 3) > 1 && std::fmod(x, 3) < 2.2 && std::fmod(z, 3) > 1 &&
                          std::fmod(z, 3) < 2.5;
      if (window && random.uniform() < 0.7) continue;
      add({x, window ? 0.25 : 0, z}, kFacade);
    }
    for (int i = 0; i < 3000; ++i) add({between(0, 30), between(-1.2, 0), 12}, kFacade);  // cornice
    for (int i = 0; i < 2000; ++i)
      add({between(12, 16), between(-1.5, 0), 3}, kFacade);  // balcony floor
  }
  void obstacles() {
    for (const double x : {4.0, 14.0, 25.0})
      for (int i = 0; i < 3000; ++i) {
        Vec3 d{random.normal(), random.normal(), random.normal()};
        d = normalized(d) * 1.5;
        add({x + d.x, -5 + d.y, 4 + d.z}, kUnwanted);
      }
    for (const double x : {8.0, 20.0})
      for (int i = 0; i < 3000; ++i)
        add({between(x, x + 4.2), between(-6, -4.2), between(0.3, 1.5)}, kUnwanted);
  }
  void ghosts() {
    for (int i = 0; i < 4000; ++i) {
      const double x = 3 * std::floor(between(0, 10)) + between(1, 2.2);
      const double z = 3 * std::floor(between(0, 4)) + between(1, 2.5);
      add({x, between(0.8, 6), z}, kUnwanted);
    }
  }
  void ground() {
    for (int i = 0; i < 20000; ++i) add({between(0, 30), between(-8, -0.2), 0.2}, kGround);
  }
  Cloud cloud() const {
    std::vector<Vec3> placed;
    const double c = std::cos(0.6458), s = std::sin(0.6458);
    for (const Vec3& p : points)
      placed.push_back(Vec3{c * p.x - s * p.y, s * p.x + c * p.y, p.z} + kFar);
    return cloud_of(placed);
  }
};

double share_kept(const Scene& scene, const std::vector<uint8_t>& mask, Kind kind) {
  double n = 0, kept = 0;
  for (size_t i = 0; i < mask.size(); ++i) {
    if (scene.kinds[i] != kind) continue;
    ++n;
    kept += mask[i];
  }
  return kept / n;
}

TEST_CASE("interest__facade_with_trees_cars_and_ghosts__recall_99_and_95_percent_removed") {
  Scene scene;
  scene.facade();
  scene.obstacles();
  scene.ghosts();
  Task task;
  for (const int64_t seed : {1, 2, 3}) {
    InterestSettings set;
    set.seed = seed;
    const auto mask = points_of_interest(scene.cloud(), set, task);
    const double recall = share_kept(scene, mask, kFacade),
                 removed = 1 - share_kept(scene, mask, kUnwanted);
    MESSAGE("seed ", seed, ": recall ", recall, ", unwanted removed ", removed);
    CHECK(recall >= 0.99);
    CHECK(removed >= 0.95);
  }
}

TEST_CASE("interest__ground__goes_on_demand") {
  Scene scene;
  scene.facade();
  scene.obstacles();
  scene.ground();
  Task task;
  InterestSettings set;
  const auto with = points_of_interest(scene.cloud(), set, task);
  CHECK(share_kept(scene, with, kGround) > 0.1);
  set.remove_ground = true;
  const auto without = points_of_interest(scene.cloud(), set, task);
  CHECK(share_kept(scene, without, kGround) < 0.05);
  CHECK(share_kept(scene, without, kFacade) >= 0.99);
}

TEST_CASE("interest__the_side_of_the_scanner__comes_from_viewpoint_or_station") {
  Scene scene;
  scene.facade();
  scene.ghosts();  // without obstacles in front the crowd lies behind
  Cloud cloud = scene.cloud();
  const double c = std::cos(0.6458), s = std::sin(0.6458);
  const Vec3 stand = Vec3{c * 15 + s * 20, s * 15 - c * 20, 1.7} + kFar;
  Task task;
  InterestSettings set;
  set.viewpoint = {stand.x, stand.y, stand.z};
  const auto by_viewpoint = points_of_interest(cloud, set, task);
  CHECK(share_kept(scene, by_viewpoint, kFacade) >= 0.99);
  CHECK(1 - share_kept(scene, by_viewpoint, kUnwanted) >= 0.95);
  Transform pose;
  pose.m[3] = stand.x;
  pose.m[7] = stand.y;
  pose.m[11] = stand.z;
  cloud.stations = {{"S", true, pose, 0, cloud.size()}};
  CHECK(points_of_interest(cloud, InterestSettings{}, task) == by_viewpoint);
}

TEST_CASE("interest__threads__the_same_choice_and_degenerate_input_a_status") {
  Scene scene;
  scene.facade();
  scene.obstacles();
  Task one(threads(1)), seven(threads(7));
  const InterestSettings set{};
  CHECK(points_of_interest(scene.cloud(), set, one) ==
        points_of_interest(scene.cloud(), set, seven));
  CHECK(status_of([&] {
          points_of_interest(cloud_of({{1, 1, 1}, {2, 2, 2}}), set, one);
        }) == Status::kInsufficientData);
  CHECK(status_of([&] {
          points_of_interest(cloud_of(std::vector<Vec3>(99, Vec3{1, 2, 3})), set, one);
        }) == Status::kDegenerate);
}

}  // namespace
}  // namespace jalon
