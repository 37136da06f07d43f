// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "base/parallel.h"
#include "cloud/neighbourhoods.h"
#include "cloud/normals_parts.h"
#include "geometry/delaunay2.h"

namespace jalon {

namespace {

/// Girardeau-Montaut 2006, A.2 (b): with fewer points a larger neighbourhood is taken.
constexpr size_t kMinPoints = 6;
/// Points of that larger neighbourhood about the cell's centre.
constexpr uint32_t kWider = 16;
/// Mean number of points a cell that the automatic level aims at: enough that few triangles touch
/// the border, few enough that a cell stays nearly flat. (The source's level 5 example had far
/// more points a cell, and shows the cell borders.)
constexpr double kPointsPerCell = 30;
/// Snapping step of a cell's triangulation as a share of its size: finer than any scanner's noise.
constexpr double kGridShare = 0x1p-24;
constexpr size_t kCellsPerChunk = 128;

/// Memory of one chunk of cells.
struct NormalsTriangulationScratch {
  std::vector<uint32_t> members;  // sorted positions; the cell's own come first
  std::vector<Vec3> points, sums;
  std::vector<Vec2> flat;
  std::vector<Neighbour> found;
  Delaunay delaunay;
};

/// Deepest level whose occupied cells hold kPointsPerCell points on average.
int automatic_level(const Octree& tree, Task& task) {
  const auto counts = tree.cell_counts(task);
  const double most_cells = static_cast<double>(tree.size()) / kPointsPerCell;
  int level = 0;
  while (level < kMaxLevel &&
         static_cast<double>(counts[static_cast<size_t>(level) + 1]) <= most_cells)
    ++level;
  return level;
}

bool frame_of(const std::vector<Vec3>& points, PrincipalFrame& frame) {
  Moments moments;
  moments.reference = points.front();
  for (const Vec3& p : points) moments.add(p);
  return points.size() >= kMinPoints && principal_frame(moments, frame);
}

/// To whole micrometres or so, which add to a map coordinate without rounding: the same neighbours
/// wherever the cloud lies.
Vec3 rounded(const Vec3& p) {
  constexpr double kStep = 0x1p-20;
  return {std::round(p.x / kStep) * kStep, std::round(p.y / kStep) * kStep,
          std::round(p.z / kStep) * kStep};
}

/// (a)-(c): the cell's points and, when they are too few or on a line, those about its centre.
bool gather(const Octree& tree, const std::vector<uint32_t>& position_of, const Octree::Cell& cell,
            NormalsTriangulationScratch& s, PrincipalFrame& frame) {
  s.members.resize(cell.count);
  s.points.resize(cell.count);
  Vec3 sum;
  for (size_t i = 0; i < cell.count; ++i) {
    s.members[i] = static_cast<uint32_t>(cell.first + i);
    s.points[i] = tree.local(cell.first + i);
    sum += s.points[i];
  }
  if (frame_of(s.points, frame)) return true;
  const Vec3 centre = tree.cube().origin + rounded(sum / static_cast<double>(cell.count));
  s.found.resize(kWider + std::min<size_t>(cell.count, kWider));
  const size_t n = tree.knn(centre, static_cast<uint32_t>(s.found.size()), s.found);
  for (size_t i = 0; i < n; ++i) {
    const uint32_t position = position_of[s.found[i].index];
    if (position >= cell.first && position < cell.first + cell.count) continue;
    s.members.push_back(position);
    s.points.push_back(tree.local(position));
  }
  return frame_of(s.points, frame);
}

/// (d)-(g): project, triangulate, add up the cross products of the triangles.
void accumulate(const PrincipalFrame& frame, NormalsTriangulationScratch& s) {
  s.flat.resize(s.points.size());
  double size = 0;
  for (size_t i = 0; i < s.points.size(); ++i) {
    const Vec3 d = s.points[i] - frame.centre;
    s.flat[i] = {dot(d, frame.u), dot(d, frame.v)};
    size = std::max({size, std::fabs(s.flat[i].u), std::fabs(s.flat[i].v)});
  }
  s.sums.assign(s.points.size(), Vec3{});
  if (!(size > 0)) return;
  for (const auto& t : s.delaunay.run(s.flat, size * kGridShare)) {
    const Vec3& a = s.points[t[0]];
    const Vec3 twice_area = cross(s.points[t[1]] - a, s.points[t[2]] - a);
    for (const uint32_t corner : t) s.sums[corner] += twice_area;
  }
}

}  // namespace

std::shared_ptr<Column> triangulation_normals(const Octree& tree, Task& task) {
  auto column = new_normal_column(tree.size());
  const auto out = column->values<float>();
  const auto order = tree.order();
  std::vector<Octree::Cell> cells;
  std::vector<uint32_t> position_of(tree.size());
  {
    ProgressSpan span(task, 0, 0.1);
    cells = tree.cells(automatic_level(tree, task), task);
    parallel_for(task, tree.size(), 1 << 16, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) position_of[order[i]] = static_cast<uint32_t>(i);
    });
  }
  ProgressSpan span(task, 0.1, 1);
  parallel_for(task, cells.size(), kCellsPerChunk, [&](size_t begin, size_t end) {
    NormalsTriangulationScratch scratch;
    for (size_t c = begin; c < end; ++c) {
      PrincipalFrame frame;
      const bool flat = gather(tree, position_of, cells[c], scratch, frame);
      if (flat) accumulate(frame, scratch);
      for (size_t i = 0; i < cells[c].count; ++i) {
        Vec3 n{kNaN, kNaN, kNaN};
        // A point that is in no triangle (a duplicate in the plane) takes the plane's normal.
        if (flat) n = squared_norm(scratch.sums[i]) > 0 ? normalized(scratch.sums[i]) : frame.n;
        float* to = out.data() + 3 * size_t{order[cells[c].first + i]};
        to[0] = static_cast<float>(n.x);
        to[1] = static_cast<float>(n.y);
        to[2] = static_cast<float>(n.z);
      }
    }
  });
  return column;
}

}  // namespace jalon
