// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/las/node_order.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace jalon;

namespace {

/// Two nodes: of the points 5, 3, 0 and of 4, 2, 1.
las::CopcTree two_nodes() {
  las::CopcTree tree;
  tree.order = {5, 3, 0, 4, 2, 1};
  tree.nodes = {{{}, 0, 3}, {{1, 0, 0, 0}, 3, 3}};
  return tree;
}

std::vector<uint32_t> ordered(const std::vector<double>& times) {
  las::CopcTree tree = two_nodes();
  Column column({"gps_time", ElementType::kFloat64, 1}, times.size());
  std::ranges::copy(times, static_cast<double*>(column.raw()));
  Task task;
  las::order_by_time(tree, column, task);
  return tree.order;
}

}  // namespace

TEST_CASE("node_order__points_of_a_node_follow_their_times_and_no_node_takes_those_of_another") {
  CHECK(ordered({1, 2, 3, 4, 5, 6}) == std::vector<uint32_t>{0, 3, 5, 1, 2, 4});
}

TEST_CASE("node_order__points_of_one_time_follow_the_cloud_and_nodes_of_one_time_stay") {
  CHECK(ordered({7, 1, 1, 7, 0, 3}) == std::vector<uint32_t>{5, 0, 3, 4, 1, 2});
  CHECK(ordered({7, 1, 1, 7, 1, 7}) == two_nodes().order);
}

TEST_CASE("node_order__times_that_are_none_come_last_and_in_the_same_order_each_time") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(ordered({nan, nan, 2, 9, 1, nan}) == std::vector<uint32_t>{3, 0, 5, 4, 2, 1});
}
