// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Neighbours of two clouds against brute force, as they lie and around a corner.

#include <doctest/doctest.h>

#include <cmath>
#include <numeric>

#include "registration/icp/search.h"
#include "unit/registration/icp_problems.h"

using namespace jalon;
using namespace jalon::test;

namespace {

const Transform kPose = motion_about({1, 1, 1}, {0.1, 0.05, -0.08}, {0.1, 0, 0.05});

struct Both {
  Cloud reference, moving;
  IcpClouds clouds;
  Transform T_reference_moving;

  Both(const std::vector<Vec3>& r, const std::vector<Vec3>& m,
       const std::function<Vec3(const Vec3&)>& normal_at, const Transform& pose = kPose)
      : reference(cloud_of(r)), moving(cloud_of(m)) {
    clouds = {planes_by_hand(reference, normal_at), planes_by_hand(moving, normal_at)};
    T_reference_moving = clouds.to_local(pose);
  }
  double distance(uint32_t m, uint32_t r) const {
    return norm(T_reference_moving.point(clouds.moving.place(m)) - clouds.reference.place(r));
  }
};

Vec3 up(const Vec3&) { return {0, 0, 1}; }

std::vector<uint32_t> all_of(size_t n) {
  std::vector<uint32_t> out(n);
  std::iota(out.begin(), out.end(), 0u);
  return out;
}

// What is found for each point is the nearest of the candidates, or none within the distance.
template <class Distance>
void check_nearest(const Buffer<uint32_t>& found, const std::vector<uint32_t>& candidates,
                   double max_m, Distance distance) {
  constexpr double kGrid_m = 1e-7;  // places are rounded to the grids of two trees
  for (size_t i = 0; i < found.size(); ++i) {
    double least = INFINITY;
    for (const uint32_t c : candidates) least = std::min(least, distance(i, c));
    if (found[i] == kNoPoint) {
      CHECK(least > max_m - kGrid_m);
      continue;
    }
    CHECK(std::find(candidates.begin(), candidates.end(), found[i]) != candidates.end());
    CHECK(std::abs(distance(i, found[i]) - least) < kGrid_m);
    CHECK(least < max_m + kGrid_m);
  }
}

}  // namespace

TEST_CASE("icp_search__finds_the_nearest_both_ways_within_the_distance") {
  const Both both(random_points(250, 2, 1), random_points(200, 2, 2), up);
  const IcpLevel all;
  Task task;
  for (const double max_m : {0.15, 5.0}) {
    const auto found =
        IcpSearch(both.clouds, all, 0, task).find(both.T_reference_moving, max_m, task);
    REQUIRE(found.of_moving.size() == 200);
    REQUIRE(found.of_reference.size() == 250);
    check_nearest(found.of_moving, all_of(250), max_m,
                  [&](size_t m, uint32_t r) { return both.distance(static_cast<uint32_t>(m), r); });
    check_nearest(found.of_reference, all_of(200), max_m,
                  [&](size_t r, uint32_t m) { return both.distance(m, static_cast<uint32_t>(r)); });
  }
}

TEST_CASE("icp_search__of_a_level_knows_its_points_alone") {
  const Both both(random_points(250, 2, 3), random_points(200, 2, 4), up);
  IcpLevel level;
  for (uint32_t i = 3; i < 250; i += 7) level.reference.positions.push_back(i);
  for (uint32_t i = 1; i < 200; i += 5) level.moving.positions.push_back(i);
  Task task;
  const auto found = IcpSearch(both.clouds, level, 0, task).find(both.T_reference_moving, 9, task);
  REQUIRE(found.of_moving.size() == level.moving.positions.size());
  REQUIRE(found.of_reference.size() == level.reference.positions.size());
  check_nearest(found.of_moving, level.reference.positions, 9,
                [&](size_t i, uint32_t r) { return both.distance(level.moving.positions[i], r); });
  check_nearest(found.of_reference, level.moving.positions, 9, [&](size_t i, uint32_t m) {
    return both.distance(m, level.reference.positions[i]);
  });
}

TEST_CASE("icp_search__near_a_corner_takes_the_nearest_of_eight_that_faces_the_same_way") {
  // A floor and a wall, both a tenth as wide as the corner is long.
  std::vector<Vec3> r = random_points(200, 1, 5), m = random_points(200, 1, 6);
  for (auto* points : {&r, &m})
    for (size_t i = 0; i < points->size(); ++i) {
      const Vec3 p = (*points)[i];
      (*points)[i] = i % 2 == 0 ? Vec3{0, p.y, 0.1 * p.z} : Vec3{0.1 * p.x, p.y, 0};
    }
  const auto facing = [](const Vec3& p) { return p.x == 0 ? Vec3{1, 0, 0} : Vec3{0, 0, -1}; };
  const Both both(r, m, facing, {});
  const SurfacePlanes &reference = both.clouds.reference, &moving = both.clouds.moving;
  const IcpLevel all;
  Task task;
  constexpr double kMax_m = 0.4, kCosine = 0.8;
  const auto found =
      IcpSearch(both.clouds, all, kCosine, task).find(both.T_reference_moving, kMax_m, task);
  size_t turned = 0, none = 0;
  for (uint32_t i = 0; i < found.of_moving.size(); ++i) {
    std::vector<uint32_t> near = all_of(reference.size());
    std::sort(near.begin(), near.end(),
              [&](uint32_t a, uint32_t b) { return both.distance(i, a) < both.distance(i, b); });
    uint32_t expected = kNoPoint;
    for (size_t k = 0; k < 8 && expected == kNoPoint; ++k) {
      const Vec3 n = both.T_reference_moving.direction(moving.planes[i].unit());
      const bool fits = std::abs(dot(n, reference.planes[near[k]].unit())) >= kCosine;
      if (fits && both.distance(i, near[k]) <= kMax_m) expected = near[k];
    }
    CHECK(found.of_moving[i] == expected);
    turned += expected != kNoPoint && expected != near[0];
    none += expected == kNoPoint;
  }
  CHECK(turned > 5);
  CHECK(none < 100);
  for (uint32_t i = 0; i < found.of_reference.size(); ++i) {
    if (found.of_reference[i] == kNoPoint) continue;
    const Vec3 n = both.T_reference_moving.direction(moving.planes[found.of_reference[i]].unit());
    CHECK(std::abs(dot(n, reference.planes[i].unit())) >= kCosine);
  }
}
