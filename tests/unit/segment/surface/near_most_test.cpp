// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/surface/near_most.h"

#include <doctest/doctest.h>

#include <vector>

#include "base/random.h"

using namespace jalon;

namespace {

std::vector<Vec3> box_of(size_t count, Vec3 corner, uint64_t seed) {
  RandomStream random(seed, 0);
  std::vector<Vec3> out;
  for (size_t i = 0; i < count; ++i)
    out.push_back(corner + Vec3{8 * random.uniform(), 4 * random.uniform(), 2 * random.uniform()});
  return out;
}

}  // namespace

TEST_CASE("near_most__holds_all_of_an_evenly_filled_box_and_of_points_on_one_plane") {
  std::vector<Vec3> points = box_of(1000, {}, 1);
  for (Vec3& p : points) p.z = p.x > 4 ? 1 : p.z;
  const Box3 box = box_near_most(points);
  for (const Vec3& p : points) CHECK(box.contains(p));
  for (Vec3& p : points) p.y = 3;
  const Box3 flat = box_near_most(points);
  for (const Vec3& p : points) CHECK(flat.contains(p));
}

TEST_CASE("near_most__leaves_out_stray_points_and_a_smaller_heap_far_off") {
  std::vector<Vec3> points = box_of(1000, {}, 2);
  for (const Vec3& p : box_of(200, {300, 0, 0}, 3)) points.push_back(p);
  points.push_back({0, -5000, 0});
  points.push_back({4, 2, 90});
  const Box3 box = box_near_most(points);
  for (size_t i = 0; i < points.size(); ++i) CHECK(box.contains(points[i]) == (i < 1000));
}
