// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "solid/triangle_boxes.h"

#include <algorithm>
#include <numeric>

#include "solid/nearest_point.h"

namespace jalon {

namespace {

constexpr uint32_t kLeafTriangles = 4;

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
                             std::vector<std::array<uint32_t, 3>> triangles)
    : vertices_(std::move(vertices)), triangles_(std::move(triangles)), order_(triangles_.size()) {
  std::iota(order_.begin(), order_.end(), 0u);
  std::vector<Box3> boxes(triangles_.size());
  for (size_t i = 0; i < boxes.size(); ++i)
    for (const uint32_t v : triangles_[i]) boxes[i].add(vertices_[v]);
  if (triangles_.empty()) return;
  nodes_.emplace_back();
  split(0, 0, static_cast<uint32_t>(order_.size()), boxes);
}

void TriangleBoxes::split(uint32_t node, uint32_t begin, uint32_t end,
                          const std::vector<Box3>& boxes) {
  Box3 box, centres;
  for (uint32_t i = begin; i < end; ++i) {
    box += boxes[order_[i]];
    centres.add((boxes[order_[i]].min + boxes[order_[i]].max) * 0.5);
  }
  nodes_[node].box = box;
  if (end - begin <= kLeafTriangles) {
    nodes_[node].first = begin;
    nodes_[node].count = end - begin;
    return;
  }
  const Vec3 size = centres.max - centres.min;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](uint32_t a, uint32_t b) {
                     const double ca = boxes[a].min[axis] + boxes[a].max[axis],
                                  cb = boxes[b].min[axis] + boxes[b].max[axis];
                     return ca != cb ? ca < cb : a < b;
                   });
  const auto first = static_cast<uint32_t>(nodes_.size());
  nodes_[node].first = first;
  nodes_.resize(nodes_.size() + 2);
  split(first, begin, middle, boxes);
  split(first + 1, middle, end, boxes);
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
