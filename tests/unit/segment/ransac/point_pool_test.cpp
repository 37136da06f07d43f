// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// The pool's counts and collections against all points one by one; its pieces against the shares of 64 parts.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "segment/ransac/curved_hypotheses.h"
#include "unit/segment/curved_scenes.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr double kPoolReach_m = 0.03;
constexpr double kFloatSlack_m = 1e-5;  // coordinates of a few metres in floats, squared and back

Scene pool_cloud(size_t count) {
  Scene out;
  RandomStream random(1, 29);
  out.rectangle(1, {0, 0, 0}, {3, 0, 0}, {0, 0, 2}, count / 2, 0.01, random);
  out.outliers({0, -1, 0}, {3, 2, 2}, count - count / 2, random);
  return out;
}

// Free points that lie within reach by this distance.
template <class Distance>
std::set<uint32_t> within(const MadeScene& made, double reach_m, Distance&& distance) {
  std::set<uint32_t> out;
  for (uint32_t p = 0; p < made.scene.size(); ++p)
    if (made.scene.owner[p] == 0 && std::fabs(distance(made.scene.local(p))) <= reach_m)
      out.insert(p);
  return out;
}

// What the pool finds holds all that is surely within the reach and nothing that is surely not; slots ascend.
template <class Distance>
void check_slots(const MadeScene& made, const PointPool& pool, const std::vector<uint32_t>& slots,
                 Distance&& distance) {
  CHECK(std::is_sorted(slots.begin(), slots.end()));
  std::set<uint32_t> found;
  for (const uint32_t slot : slots) found.insert(pool.position(slot));
  CHECK(found.size() == slots.size());
  const auto sure = within(made, kPoolReach_m - kFloatSlack_m, distance),
             most = within(made, kPoolReach_m + kFloatSlack_m, distance);
  CHECK(std::includes(found.begin(), found.end(), sure.begin(), sure.end()));
  CHECK(std::includes(most.begin(), most.end(), found.begin(), found.end()));
}

Box3 box_of_all() {
  Box3 box;
  box.add({-100, -100, -100});
  box.add({100, 100, 100});
  return box;
}

}  // namespace

TEST_CASE("point_pool__counts_and_collects_what_lies_near_a_plane_a_ball_or_a_pipe") {
  const Scene scene = pool_cloud(12000);
  SurfaceSettings settings = all_primitives();
  settings.normals = NormalSource::kNone;
  MadeScene made(scene.points, settings);
  for (size_t p = 0; p < made.scene.size(); p += 5) made.scene.owner[p] = 2;
  const PointPool pool(made.scene, made.task);
  CHECK(pool.free_points() == 9600);
  RandomStream random(2, 29);
  for (int round = 0; round < 20; ++round) {
    const Vec3 at = made.scene.local(random.below(made.scene.size()));
    const Vec3 n = normalized(Vec3{random.normal(), random.normal(), random.normal()});
    const Plane plane{n, dot(n, at)};
    const Curved ball(Sphere{at, 0.1 + random.uniform()}),
        pipe(Cylinder{at, n, 0.5 * random.uniform()});
    const PlaneTest test = made.scene.test(plane, kPoolReach_m, 0);
    const auto flat = pool.collect(test, box_of_all(), made.task);
    check_slots(made, pool, flat, [&](const Vec3& p) { return plane.distance(p); });
    size_t counted = 0;
    for (size_t piece = 0; piece < PointPool::kPieces; ++piece)
      counted += pool.count(piece, test, made.task);
    CHECK(counted == flat.size());
    for (const Curved& curved : {ball, pipe}) {
      const CurvedTest round_test = curved_test(made.scene, curved, 0, kPoolReach_m);
      const auto slots = pool.collect(round_test, made.task);
      check_slots(made, pool, slots, [&](const Vec3& p) { return curved.distance(p); });
      counted = 0;
      for (size_t piece = 0; piece < PointPool::kPieces; ++piece)
        counted += pool.count(piece, round_test, made.task);
      CHECK(counted == slots.size());
    }
  }
}

TEST_CASE("point_pool__a_box_and_removed_points_leave_out_what_they_should") {
  const Scene scene = pool_cloud(4000);
  MadeScene made(scene.points);
  PointPool pool(made.scene, made.task);
  const Plane wall{{0, 1, 0}, -made.scene.origin.y};
  const PlaneTest test = made.scene.test(wall, kPoolReach_m, 0);
  Box3 left = box_of_all();
  left.max.x = 1.5;  // of the local frame
  const auto all = pool.collect(test, box_of_all(), made.task);
  auto boxed = pool.collect(test, left, made.task);
  std::vector<uint32_t> expected;
  for (const uint32_t slot : all)
    if (pool.point(slot).x <= 1.5) expected.push_back(slot);
  CHECK(boxed == expected);
  REQUIRE(expected.size() > 500);
  pool.remove(boxed, made.task);
  CHECK(pool.free_points() == 4000 - boxed.size());
  CHECK(pool.built_points() == 4000);
  CHECK(pool.points_upto(PointPool::kPieces - 1) == pool.free_points());
  CHECK(pool.collect(test, left, made.task).empty());
  CHECK(pool.collect(test, box_of_all(), made.task).size() == all.size() - boxed.size());
}

TEST_CASE("point_pool__pieces_are_random_shares_of_1_3_12_and_48_in_64_of_a_large_pool") {
  MadeScene small(pool_cloud(8000).points), large(pool_cloud(20000).points);
  const PointPool whole(small.scene, small.task), split(large.scene, large.task);
  CHECK(whole.points_upto(PointPool::kPieces - 2) == 0);  // counted at once
  CHECK(whole.points_upto(PointPool::kPieces - 1) == 8000);
  const double upto[] = {1.0 / 64, 4.0 / 64, 16.0 / 64, 1};
  for (size_t piece = 0; piece < PointPool::kPieces; ++piece) {
    const double mean = 20000 * upto[piece], sigma = std::sqrt(mean * (1 - upto[piece]));
    CHECK(std::fabs(static_cast<double>(split.points_upto(piece)) - mean) <= 5 * sigma);
  }
  std::set<uint32_t> positions;  // each point once, whatever the piece
  for (uint32_t slot = 0; slot < split.slots(); ++slot)
    if (const uint32_t p = split.position(slot); p != kNoPoint) {
      positions.insert(p);
      // Floats of at most 3 m.
      CHECK(norm(split.point(slot) - large.scene.local(p)) < 4 * 0x1p-24 * 3);
    }
  CHECK(positions.size() == 20000);
}

TEST_CASE("point_pool__counts_large_pieces_alike_with_any_number_of_threads") {
  MadeScene made(pool_cloud(400000).points);
  const PointPool pool(made.scene, made.task);
  const Plane wall{{0, 1, 0}, -made.scene.origin.y};
  const PlaneTest test = made.scene.test(wall, kPoolReach_m, 0);
  Task many(Task::Hooks{.threads = 3});
  size_t counted = 0;
  for (size_t piece = 0; piece < PointPool::kPieces; ++piece) {
    const uint32_t alone = pool.count(piece, test, made.task);
    CHECK(pool.count(piece, test, many) == alone);
    counted += alone;
  }
  CHECK(counted == pool.collect(test, box_of_all(), many).size());
  CHECK(counted > 190000);
}
