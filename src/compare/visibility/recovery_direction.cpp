// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Hidden points along a direction: the surface of the reference as a triangulated height field (a TIN).
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/numbers.h"
#include "base/parallel.h"
#include "base/serial.h"
#include "compare/visibility/recovery.h"
#include "geometry/delaunay2.h"
#include "spatial/triangles/tree.h"

namespace jalon {

namespace {

constexpr size_t kRecoveryDirectionGrain = 1 << 12;  // points a chunk
constexpr size_t kRecoveryPerLook = 1 << 16;  // points, cells or triangles: some milliseconds

/// Coordinates across (x, y) and along (z) the direction, from whole metres at a point.
class PlanFrame {
 public:
  PlanFrame(const Vec3& at, const Vec3& direction) : along_(direction) {
    for (int a = 0; a < 3; ++a) origin_[a] = std::floor(at[a]);
    const Vec3 other = std::abs(direction.x) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    across_ = normalized(cross(cross(direction, other), direction));
    aside_ = cross(direction, across_);
  }
  Vec3 of(const Vec3& p) const {
    const Vec3 q = p - origin_;
    return {dot(q, across_), dot(q, aside_), dot(q, along_)};
  }

 private:
  Vec3 origin_, along_, across_, aside_;
};

/// Square cells of the plane as sortable numbers; cells beyond 2^31 from the origin share the outermost.
class PlanCells {
 public:
  explicit PlanCells(double cell_m) : cell_m_(cell_m) {}
  uint64_t number(const Vec3& p, int columns = 0, int rows = 0) const {
    const auto part = [&](double x, int more) {
      const double k = std::clamp(std::floor(x / cell_m_) + more, -2147483648.0, 2147483647.0);
      return static_cast<uint64_t>(static_cast<int64_t>(k) + (int64_t{1} << 31));
    };
    return part(p.x, columns) << 32 | part(p.y, rows);
  }

 private:
  double cell_m_;
};

/// The cells of the given points and those around them, ascending.
std::vector<uint64_t> cells_near(const Cloud& cloud, std::span<const uint64_t> points,
                                 const PlanFrame& frame, const PlanCells& cells, Task& task) {
  std::vector<uint64_t> own;
  serial_for(task, points.size(), kRecoveryPerLook, [&](size_t begin, size_t end) {
    for (size_t k = begin; k < end; ++k)
      own.push_back(cells.number(frame.of(cloud.point(points[k]))));
  });
  serial_sort(task, own.begin(), own.end());
  own.erase(std::unique(own.begin(), own.end()), own.end());
  std::vector<uint64_t> near;
  for (const uint64_t number : own)
    for (int64_t column = -1; column <= 1; ++column)
      for (int64_t row = -1; row <= 1; ++row)
        near.push_back(number + static_cast<uint64_t>(column * (int64_t{1} << 32) + row));
  serial_sort(task, near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  return near;
}

/// The reference's points in these cells.
std::vector<Vec3> points_in(const Cloud& reference, const std::vector<uint64_t>& near,
                            const PlanFrame& frame, const PlanCells& cells, Task& task) {
  const size_t n = reference.size();
  std::vector<std::vector<Vec3>> parts((n + kRecoveryDirectionGrain - 1) / kRecoveryDirectionGrain);
  parallel_for(task, n, kRecoveryDirectionGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const Vec3 p = frame.of(reference.point(i));
      if (std::binary_search(near.begin(), near.end(), cells.number(p)))
        parts[begin / kRecoveryDirectionGrain].push_back(p);
    }
  });
  std::vector<Vec3> out;
  for (const auto& part : parts) out.insert(out.end(), part.begin(), part.end());
  return out;
}

/// Delaunay triangles in the plane whose edges are no longer than this there.
std::vector<std::array<uint32_t, 3>> short_triangles(const std::vector<Vec3>& points,
                                                     double longest_m, Task& task) {
  std::vector<Vec2> flat;
  serial_for(task, points.size(), kRecoveryPerLook, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) flat.push_back({points[i].x, points[i].y});
  });
  auto triangles = delaunay(flat, kDelaunayGrid_m, &task);
  size_t measured = 0;
  std::erase_if(triangles, [&](const std::array<uint32_t, 3>& t) {
    if (measured++ % kRecoveryPerLook == 0) task.checkpoint(1);
    return norm(flat[t[0]] - flat[t[1]]) > longest_m || norm(flat[t[1]] - flat[t[2]]) > longest_m ||
           norm(flat[t[2]] - flat[t[0]]) > longest_m;
  });
  return triangles;
}

}  // namespace

std::vector<double> heights_along(const Cloud& reference, const Cloud& compared,
                                  std::span<const uint64_t> points, const Vec3& direction,
                                  double radius_m, Task& task) {
  std::vector<double> heights(points.size(), kNaN);
  if (points.empty()) return heights;
  // 1. The part of the reference that can matter.
  const PlanFrame frame(compared.point(points[0]), direction);
  const PlanCells cells(radius_m);
  const auto surface = [&] {
    const ProgressSpan span(task, 0, 0.2);
    return points_in(reference, cells_near(compared, points, frame, cells, task), frame, cells,
                     task);
  }();
  if (surface.size() < 3) return heights;
  // 2. Its triangles.
  std::shared_ptr<const TriangleTree> tree;
  {
    const ProgressSpan span(task, 0.2, 0.9);
    tree = TriangleTree::build(surface, short_triangles(surface, radius_m, task), task);
  }
  double top = -std::numeric_limits<double>::infinity();
  for (const Vec3& p : surface) top = std::max(top, p.z);
  // 3. A ray down on it from above each point: in plan the triangles do not overlap.
  const ProgressSpan span(task, 0.9, 1);
  parallel_for(task, points.size(), kRecoveryDirectionGrain, [&](size_t begin, size_t end) {
    for (size_t k = begin; k < end; ++k) {
      const Vec3 p = frame.of(compared.point(points[k]));
      RayHit hit;
      if (tree->nearest({{p.x, p.y, top + 1}, {0, 0, -1}}, hit))
        heights[k] = p.z - (top + 1 - hit.t);
    }
  });
  return heights;
}

}  // namespace jalon
