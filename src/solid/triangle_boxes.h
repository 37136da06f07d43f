// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/task.h"
#include "geometry/vec.h"
#include "spatial/octree/walk.h"

namespace jalon {

/// Triangles of obstacles with a binary tree of boxes, halved along the longest axis of the centres. Immutable.
class TriangleBoxes {
 public:
  TriangleBoxes(std::vector<Vec3> vertices, std::vector<std::array<uint32_t, 3>> triangles,
                Task& task);

  size_t size() const { return triangles_.size(); }
  std::array<Vec3, 3> corners(uint32_t triangle) const {
    const auto& t = triangles_[triangle];
    return {vertices_[t[0]], vertices_[t[1]], vertices_[t[2]]};
  }
  std::span<const Vec3> vertices() const { return vertices_; }
  std::span<const std::array<uint32_t, 3>> triangles() const { return triangles_; }

  struct Nearest {
    double squared_m2 = 0;
    Vec3 point;
    uint32_t triangle = 0;
  };
  /// The triangle nearest to p, ties by index; false when none is within max_distance (closed).
  bool nearest(const Vec3& p, double max_distance_m, Nearest& out) const;

  /// As walk_octree: enter(ball, key) opens a box, triangle(index) gets those of the leaves.
  template <class Enter, class Found>
  void walk(Enter&& enter, Found&& found) const {
    if (nodes_.empty()) return;
    std::vector<uint32_t> stack;
    double key = 0;
    if (enter(ball_of(nodes_[0]), key)) stack.push_back(0);
    while (!stack.empty()) {
      const Node& node = nodes_[stack.back()];
      stack.pop_back();
      if (node.count > 0) {
        for (uint32_t i = 0; i < node.count; ++i) found(order_[node.first + i]);
        continue;
      }
      double keys[2];
      bool near[2];
      for (uint32_t k = 0; k < 2; ++k) near[k] = enter(ball_of(nodes_[node.first + k]), keys[k]);
      const uint32_t later = near[0] && near[1] && keys[1] < keys[0] ? 0 : 1;
      if (near[later]) stack.push_back(node.first + later);
      if (near[1 - later]) stack.push_back(node.first + 1 - later);
    }
  }

 private:
  struct Node {
    Box3 box;
    uint32_t first = 0,
             count = 0;  ///< count 0: children first, first + 1; else triangles of order_
  };
  static BoundingBall ball_of(const Node& node) {
    return {(node.box.min + node.box.max) * 0.5,
            norm(node.box.max - node.box.min) * 0.5 + octree_walk::kRounding_m};
  }
  void split(uint32_t node, uint32_t begin, uint32_t end, const std::vector<Box3>& boxes,
             Task& task);

  std::vector<Vec3> vertices_;
  std::vector<std::array<uint32_t, 3>> triangles_;
  std::vector<uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace jalon
