// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/detection/found_stations.h"

#include <doctest/doctest.h>

#include "unit/cloud/clouds.h"
#include "unit/compare/detection/room_scan.h"

using namespace jalon;
using namespace jalon::test;

namespace {

CloudPtr shuffled(const CloudPtr& cloud) {
  Task task;
  std::vector<uint64_t> order(cloud->size());
  for (size_t k = 0; k < order.size(); ++k) order[k] = k;
  RandomStream random(4, 4);
  for (size_t k = order.size(); k > 1; --k) std::swap(order[k - 1], order[random.below(k)]);
  return std::make_shared<const Cloud>(select(*cloud, order, task));
}

// Sweeps over level ground, from far to near in even angles: of each those of the 100 steps from first to last.
void sweep_ground(std::vector<Vec3>& points, const Vec3& from, double around_rad, int first,
                  int last, RandomStream& random) {
  constexpr double kFar_rad = 0.197, kStep_rad = 0.0048;  // 8 m off; to 2 m
  for (int k = first; k < last; ++k) {
    const double rho = from.z / std::tan(kFar_rad + kStep_rad * k) + 0.002 * random.normal();
    points.push_back({from.x + rho * std::sin(around_rad), from.y + rho * std::cos(around_rad), 0});
  }
}

}  // namespace

// Every other line of 12 points reaches from such a sweep into the next, and passes no scanner.
TEST_CASE("find_stations__a_coarse_scan_may_end_in_sweeps_that_are_short") {
  Task task;
  RandomStream random(5, 4);
  std::vector<Vec3> points;
  const Vec3 coarse{0, 0, 1.6}, fine{4, 3, 1.6};
  for (int k = 0; k < 100; ++k) sweep_ground(points, coarse, 0.05 * k, 0, 100, random);
  for (int k = 100; k < 125; ++k) sweep_ground(points, coarse, 0.05 * k, 30, 54, random);
  const size_t of_coarse = points.size();
  for (int k = 0; k < 600; ++k) sweep_ground(points, fine, 0.01 * k, 0, 100, random);
  const std::vector<Station> found = find_stations(cloud_of(points), task);
  REQUIRE(found.size() == 2);
  for (size_t k = 0; k < 2; ++k) {  // in plan: such steps are about even from any height
    const Vec3 off = found[k].pose.point({}) - (k == 0 ? coarse : fine);
    CHECK(std::hypot(off.x, off.y) < 0.03);
  }
  CHECK(std::abs(static_cast<double>(found[0].count) - static_cast<double>(of_coarse)) < 100);
  CHECK(found[0].count + found[1].count == points.size());
}

TEST_CASE("find_stations__tells_where_two_scanners_stood_and_which_points_are_whose") {
  Task task;
  const std::vector<Vec3> places{{-2.5, 1, 1.6}, {2, -1.5, 1.75}};
  const CloudPtr told = RoomScan{}.scan(places, 1);
  const std::vector<Station> found = find_stations(*without_stations(told), task);
  REQUIRE(found.size() == 2);
  for (size_t k = 0; k < 2; ++k) {
    CHECK(norm(found[k].pose.point({}) - places[k]) < 0.03);
    CHECK(std::abs(static_cast<double>(found[k].first) -
                   static_cast<double>(told->stations[k].first)) <
          0.01 * static_cast<double>(told->size()));
  }
  CHECK(found[1].first == found[0].count);
  CHECK(found[1].first + found[1].count == told->size());
}

TEST_CASE("find_stations__claims_none_for_points_in_any_order") {
  Task task;
  const CloudPtr cloud = shuffled(without_stations(RoomScan{}.scan({{0.5, 0.5, 1.6}}, 2)));
  CHECK(find_stations(*cloud, task).empty());
  CHECK(with_found_stations(cloud, task) == cloud);
}

TEST_CASE("with_found_stations__leaves_told_stations_alone") {
  Task task;
  const CloudPtr told = RoomScan{}.scan({{0.5, 0.5, 1.6}}, 3);
  CHECK(with_found_stations(told, task) == told);
  CHECK(has_all_stations(*told));
  const CloudPtr bare = without_stations(told);
  CHECK_FALSE(has_all_stations(*bare));
  const CloudPtr found = with_found_stations(bare, task);
  CHECK(has_all_stations(*found));
  CHECK(found->xyz_buffer == bare->xyz_buffer);
}
