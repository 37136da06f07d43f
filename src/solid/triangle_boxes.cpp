// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "solid/triangle_boxes.h"

#include <algorithm>
#include <numeric>

#include "base/serial.h"
#include "solid/nearest_point.h"

namespace jalon {

namespace {

constexpr uint32_t kLeafTriangles = 4;
constexpr size_t kTrianglesPerLook = 1 << 16;    // some milliseconds
constexpr size_t kComparisonsPerLook = 1 << 16;  // the same, where boxes lie anywhere in memory

double squared_distance(const Vec3& p, const Box3& box) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    const double out = std::max({box.min[i] - p[i], p[i] - box.max[i], 0.0});
    sum += out * out;
  }
  return sum;
}

}  // namespace

TriangleBoxes::TriangleBoxes(std::vector<Vec3> vertices,
                             std::vector<std::array<uint32_t, 3>> triangles, Task& task)
    : vertices_(std::move(vertices)), triangles_(std::move(triangles)), order_(triangles_.size()) {
  std::iota(order_.begin(), order_.end(), 0u);
  std::vector<Box3> boxes(triangles_.size());
  serial_for(task, boxes.size(), kTrianglesPerLook, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i)
      for (const uint32_t v : triangles_[i]) boxes[i].add(vertices_[v]);
  });
  if (triangles_.empty()) return;
  nodes_.emplace_back();
  split(0, 0, static_cast<uint32_t>(order_.size()), boxes, task);
}

void TriangleBoxes::split(uint32_t node, uint32_t begin, uint32_t end,
                          const std::vector<Box3>& boxes, Task& task) {
  Box3 box, centres;
  const auto add = [&](uint32_t triangle) {
    box += boxes[triangle];
    centres.add((boxes[triangle].min + boxes[triangle].max) * 0.5);
  };
  const auto add_all = [&](size_t from, size_t to) {
    for (size_t i = from; i < to; ++i) add(order_[begin + i]);
  };
  if (end - begin < kTrianglesPerLook) add_all(0, end - begin);
  else serial_for(task, end - begin, kTrianglesPerLook, add_all);
  nodes_[node].box = box;
  if (end - begin <= kLeafTriangles) {
    nodes_[node].first = begin;
    nodes_[node].count = end - begin;
    return;
  }
  const Vec3 size = centres.max - centres.min;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const uint32_t middle = begin + (end - begin) / 2;
  size_t compared = 0;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](uint32_t a, uint32_t b) {
                     if (++compared % kComparisonsPerLook == 0) task.checkpoint(0);
                     const double ca = boxes[a].min[axis] + boxes[a].max[axis],
                                  cb = boxes[b].min[axis] + boxes[b].max[axis];
                     return ca != cb ? ca < cb : a < b;
                   });
  const auto first = static_cast<uint32_t>(nodes_.size());
  nodes_[node].first = first;
  nodes_.resize(nodes_.size() + 2);
  split(first, begin, middle, boxes, task);
  split(first + 1, middle, end, boxes, task);
}

bool TriangleBoxes::nearest(const Vec3& p, double max_distance_m, Nearest& out) const {
  double limit = max_distance_m * max_distance_m;
  bool found = false;
  struct Visit {
    double squared;
    uint32_t node;
  };
  std::array<Visit, 64> stack;  // halves: at most 32 levels, one sibling waits on each
  size_t depth = 0;
  if (!nodes_.empty()) stack[depth++] = {squared_distance(p, nodes_[0].box), 0};
  while (depth > 0) {
    const Visit visit = stack[--depth];
    if (visit.squared > limit) continue;
    const Node& node = nodes_[visit.node];
    for (uint32_t i = 0; i < node.count; ++i) {
      const uint32_t t = order_[node.first + i];
      const auto [a, b, c] = corners(t);
      const Vec3 q = nearest_on_triangle(p, a, b, c);
      const double squared = squared_norm(p - q);
      if (squared > limit || (found && squared == limit && t > out.triangle)) continue;
      limit = squared;
      out = {squared, q, t};
      found = true;
    }
    if (node.count > 0) continue;
    const Visit a{squared_distance(p, nodes_[node.first].box), node.first};
    const Visit b{squared_distance(p, nodes_[node.first + 1].box), node.first + 1};
    stack[depth++] = a.squared < b.squared ? b : a;
    stack[depth++] = a.squared < b.squared ? a : b;
  }
  return found;
}

}  // namespace jalon
