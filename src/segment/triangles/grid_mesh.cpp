// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/triangles/grid_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/parallel.h"
#include "cloud/neighbour_planes.h"

namespace jalon {

namespace {

constexpr double kGridSearchInSpacings = 3;  // as of local triangles
constexpr size_t kGridPlacesPerChunk = 1 << 13;

// Half the edge of the largest square window of k places at most, 3 x 3 at least: a wider one is rough all over parts
// of a few rows, which then have no seeds.
size_t half_window(uint32_t k) {
  size_t half = 1;
  while ((2 * half + 3) * (2 * half + 3) <= k) ++half;
  return half;
}

// f(row, column) of the places within half a window that have points.
template <class F>
void for_window(const ScanGrid& grid, size_t row, size_t column, size_t half, F&& f) {
  const size_t last_row = std::min<size_t>(row + half, grid.rows - 1);
  const size_t last_column = std::min<size_t>(column + half, grid.columns - 1);
  for (size_t r = row - std::min(row, half); r <= last_row; ++r)
    for (size_t c = column - std::min(column, half); c <= last_column; ++c)
      if (const uint32_t point = grid.at(r, c); point != kNoPoint) f(point);
}

size_t rows_per_chunk(const ScanGrid& grid) {
  return std::max<size_t>(1, kGridPlacesPerChunk / std::max<size_t>(1, grid.columns));
}

// Median distance of the neighbours about a place; 0 where there is none.
double spacing_at(const Octree& tree, const ScanGrid& grid, size_t row, size_t column) {
  const uint32_t own = grid.at(row, column);
  std::array<double, 9> distances{};
  size_t count = 0;
  for_window(grid, row, column, 1, [&](uint32_t point) {
    if (point != own) distances[count++] = norm(tree.local(point) - tree.local(own));
  });
  if (count == 0) return 0;
  std::nth_element(distances.begin(), distances.begin() + count / 2, distances.begin() + count);
  return distances[count / 2];
}

using TriangleParts = std::vector<std::vector<TriangleCorners>>;

std::vector<TriangleCorners> joined(TriangleParts parts) {
  std::vector<TriangleCorners> triangles;
  size_t count = 0;
  for (const auto& part : parts) count += part.size();
  triangles.reserve(count);
  for (auto& part : parts) {
    triangles.insert(triangles.end(), part.begin(), part.end());
    part = {};
  }
  return triangles;
}

class GridMesher {
 public:
  GridMesher(const Octree& tree, const MeshRule& rule, std::vector<float>& roughness_m)
      : tree_(tree),
        rule_(rule),
        half_(half_window(rule.k)),
        roughness_m_(roughness_m),
        longest_m_(tree.size(), 0) {}

  // Longest edge and roughness about each point of the grid.
  void look_around(const ScanGrid& grid, Task& task) {
    const double step = tree_.grid_step();
    parallel_for(task, grid.rows, rows_per_chunk(grid), [&](size_t begin, size_t end) {
      NeighbourPlanes planes(tree_, [&](const NeighbourPlane& plane) {
        if (plane.normal == nullptr) return;
        const Symmetric3& m = *plane.scatter;
        const double squares = plane.variation * (m[0] + m[3] + m[5]);
        const double freedom = std::max(1.0, static_cast<double>(plane.count) - 3);
        roughness_m_[plane.position] =
            static_cast<float>(step * std::sqrt(std::max(0.0, squares) / freedom));
      });
      std::vector<uint32_t> near;
      for (size_t r = begin; r < end; ++r)
        for (size_t c = 0; c < grid.columns; ++c) {
          const uint32_t own = grid.at(r, c);
          if (own == kNoPoint) continue;
          const double longest = rule_.search_m > 0
                                     ? rule_.search_m
                                     : kGridSearchInSpacings * spacing_at(tree_, grid, r, c);
          longest_m_[own] = static_cast<float>(longest);
          near.clear();
          for_window(grid, r, c, half_, [&](uint32_t point) {
            if (squared_norm(tree_.local(point) - tree_.local(own)) <= longest * longest)
              near.push_back(point);
          });
          planes.add(own, near.data(), near.size());
        }
      planes.flush();
    });
  }

  // In the order of the grid.
  TriangleParts triangles(const ScanGrid& grid, Task& task) const {
    if (grid.rows < 2 || grid.columns < 2) return {};
    const size_t rows = grid.rows - 1, per_chunk = rows_per_chunk(grid);
    TriangleParts parts((rows + per_chunk - 1) / per_chunk);
    parallel_for(task, rows, per_chunk, [&](size_t begin, size_t end) {
      std::vector<TriangleCorners> found;
      for (size_t r = begin; r < end; ++r)
        for (size_t c = 0; c + 1 < grid.columns; ++c)
          add_square({grid.at(r, c), grid.at(r, c + 1), grid.at(r + 1, c), grid.at(r + 1, c + 1)},
                     found);
      parts[begin / per_chunk] = {found.begin(), found.end()};  // as large as they are
    });
    return parts;
  }

 private:
  double squared(uint32_t a, uint32_t b) const {
    return squared_norm(tree_.local(b) - tree_.local(a));
  }

  // Corners 0 and 3 lie across, and so do 1 and 2.
  void add_square(const std::array<uint32_t, 4>& p, std::vector<TriangleCorners>& found) const {
    const auto missing = static_cast<size_t>(std::count(p.begin(), p.end(), kNoPoint));
    if (missing > 1) return;
    if (missing == 1) {
      std::array<uint32_t, 3> own{};
      std::copy_if(p.begin(), p.end(), own.begin(), [](uint32_t q) { return q != kNoPoint; });
      return add(own[0], own[1], own[2], found);
    }
    if (squared(p[0], p[3]) <= squared(p[1], p[2])) {
      add(p[0], p[1], p[3], found);
      add(p[0], p[3], p[2], found);
    } else {
      add(p[0], p[1], p[2], found);
      add(p[1], p[3], p[2], found);
    }
  }

  void add(uint32_t a, uint32_t b, uint32_t c, std::vector<TriangleCorners>& found) const {
    const double most =
        static_cast<double>(std::min({longest_m_[a], longest_m_[b], longest_m_[c]}));
    if (std::max({squared(a, b), squared(b, c), squared(c, a)}) <= most * most)
      found.push_back(ascending_corners(a, b, c));
  }

  const Octree& tree_;
  const MeshRule& rule_;
  size_t half_;
  std::vector<float>& roughness_m_;
  std::vector<float> longest_m_;  ///< edge at each point
};

}  // namespace

LocalMesh grid_mesh(const Octree& tree, std::span<const ScanGrid> grids, const MeshRule& rule,
                    Task& task) {
  LocalMesh mesh;
  mesh.roughness_m.assign(tree.size(), INFINITY);
  TriangleParts parts;
  {
    GridMesher mesher(tree, rule, mesh.roughness_m);
    for (const ScanGrid& grid : grids) {
      mesher.look_around(grid, task);
      for (auto& part : mesher.triangles(grid, task)) parts.push_back(std::move(part));
    }
  }
  take_triangles(mesh, joined(std::move(parts)), tree.size(), task);
  return mesh;
}

}  // namespace jalon
