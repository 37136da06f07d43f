// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "solid/surface.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

#include "base/serial.h"

namespace jalon {

namespace {

using Triangles = std::vector<std::array<uint32_t, 3>>;

/// Corners of a volume that is tried for convexity: every corner against every triangle.
constexpr size_t kMostConvexCorners = 512;
/// Of the extent: flat sides of several triangles are flat only this far.
constexpr double kFlat = 1e-9;
constexpr size_t kSidesPerLook = 1 << 14;        // each is looked up among all
constexpr size_t kSurfaceRowsPerLook = 1 << 16;  // of vertices or triangles; each is read once

// For each vertex the first that has the same place.
std::vector<uint32_t> merged(const std::vector<Vec3>& vertices, Task& task) {
  std::vector<uint32_t> order(vertices.size()), first(vertices.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&](uint32_t i) {
    return std::tie(vertices[i].x, vertices[i].y, vertices[i].z);
  };
  serial_sort(task, order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
    return key(a) < key(b) || (key(a) == key(b) && a < b);
  });
  serial_for(task, order.size(), kSurfaceRowsPerLook, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i)
      first[order[i]] =
          i > 0 && key(order[i]) == key(order[i - 1]) ? first[order[i - 1]] : order[i];
  });
  return first;
}

bool encloses(const std::vector<Vec3>& vertices, const Triangles& triangles, Task& task) {
  const std::vector<uint32_t> corner = merged(vertices, task);
  std::vector<std::pair<uint32_t, uint32_t>> sides;
  sides.reserve(3 * triangles.size());
  serial_for(task, triangles.size(), kSurfaceRowsPerLook, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const auto& t = triangles[i];
      const std::array<uint32_t, 3> c{corner[t[0]], corner[t[1]], corner[t[2]]};
      if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) continue;
      for (size_t k = 0; k < 3; ++k) sides.emplace_back(c[k], c[(k + 1) % 3]);
    }
  });
  serial_sort(task, sides.begin(), sides.end());
  if (sides.empty() || std::adjacent_find(sides.begin(), sides.end()) != sides.end()) return false;
  size_t looked_up = 0;
  return std::all_of(sides.begin(), sides.end(), [&](const auto& side) {
    if (looked_up++ % kSidesPerLook == 0) task.checkpoint(0);
    return std::binary_search(sides.begin(), sides.end(), std::pair{side.second, side.first});
  });
}

double volume(const std::vector<Vec3>& vertices, const Triangles& triangles) {
  double sum = 0;
  const Vec3 origin = vertices[triangles[0][0]];
  for (const auto& t : triangles)
    sum +=
        dot(vertices[t[0]] - origin, cross(vertices[t[1]] - origin, vertices[t[2]] - origin)) / 6;
  return sum;
}

// The hull of a closed surface whose corners all lie behind all of its triangles.
std::optional<ConvexPiece> convex_of(const std::vector<Vec3>& vertices, const Triangles& triangles,
                                     Task& task) {
  std::vector<Vec3> corners;
  std::vector<uint32_t> used;
  for (const auto& t : triangles) used.insert(used.end(), t.begin(), t.end());
  serial_sort(task, used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  if (used.size() > kMostConvexCorners) return std::nullopt;
  Box3 box;
  for (const uint32_t v : used) {
    corners.push_back(vertices[v]);
    box.add(vertices[v]);
  }
  const double flat = kFlat * norm(box.max - box.min);
  for (const auto& t : triangles) {
    const Vec3 a = vertices[t[0]],
               normal = normalized(cross(vertices[t[1]] - a, vertices[t[2]] - a));
    for (const Vec3& p : corners)
      if (dot(normal, p - a) > flat) return std::nullopt;
  }
  return ConvexPiece::hull(corners);
}

}  // namespace

PartSurface::PartSurface(std::vector<Vec3> vertices, Triangles triangles, Task& task) {
  closed_ = encloses(vertices, triangles, task);
  if (closed_) {
    const double inside = volume(vertices, triangles);
    closed_ = inside != 0;
    if (inside < 0)
      for (auto& t : triangles) std::swap(t[1], t[2]);
  }
  if (closed_) convex_ = convex_of(vertices, triangles, task);
  nearest_ = NearestTriangles::build(vertices, triangles, task);
  boxes_ = std::make_unique<const TriangleBoxes>(std::move(vertices), std::move(triangles), task);
}

}  // namespace jalon
