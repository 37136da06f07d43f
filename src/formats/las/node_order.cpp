// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/las/node_order.h"

#include <algorithm>
#include <compare>
#include <utility>
#include <vector>

#include "base/parallel.h"

namespace jalon::las {

namespace {

/// Before it by time, by place in the cloud among equals; times that are none have a place as well.
struct Measured {
  double time = 0;
  uint32_t point = 0;
  bool operator<(const Measured& b) const {
    const std::strong_ordering order = std::strong_order(time, b.time);
    return order != 0 ? order < 0 : point < b.point;
  }
};

template <class T>
void order_node(std::span<uint32_t> points, std::span<const T> times) {
  const auto has_first_time = [&](uint32_t p) { return times[p] == times[points.front()]; };
  if (std::ranges::all_of(points, has_first_time)) return;
  std::vector<Measured> measured;
  measured.reserve(points.size());
  for (const uint32_t p : points) measured.push_back({static_cast<double>(times[p]), p});
  std::ranges::sort(measured, [](const Measured& a, const Measured& b) { return a < b; });
  std::ranges::transform(measured, points.begin(), &Measured::point);
}

}  // namespace

void order_by_time(CopcTree& tree, const Column& times, Task& task) {
  visit(times.info().type, [&](auto zero) {
    const auto values = times.values<decltype(zero)>();
    parallel_chunks(task, tree.nodes.size(), [&](size_t n) {
      const CopcTree::Node& node = tree.nodes[n];
      order_node(std::span(tree.order).subspan(node.first, node.count), values);
    });
  });
}

}  // namespace jalon::las
