// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/detection/found_stations.h"

#include <doctest/doctest.h>

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

}  // namespace

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
