// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/settle/planes_of_lines.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "cloud/spread.h"

namespace jalon {

namespace {

constexpr size_t kAsked = 40;          // points of a plane: a share of so many is sure to 8 %
constexpr size_t kLeastTold = 8;       // of them, by which anything is told
constexpr double kShareOfLines = 0.5;  // of those: most of the plane is lines
constexpr uint32_t kNeighbours = 16;
constexpr double kOwnNeighbours = 0.5;  // of a line that is dense along itself
constexpr double kLeastEdge =
    4;                          // tolerances: in smaller cells a slab as thick as it is no surface
constexpr int kMostLevels = 5;  // cells up to 16 times as wide: lines that far apart show nothing
constexpr size_t kMostLooked = 512;  // points of a cell: they tell its plane
// Standard deviations. A full square has 0.29 of its edge; half of that is a surface and no line. Noise, and a surface
// that bends, are a third of it at most.
constexpr double kLeastWidth = 0.15, kMostThickness = 1.0 / 3;
constexpr double kLineWidth = 0.1;  // of the edge
constexpr double kOther = 0.8;      // cosine: planes of 37 degrees are two

Eigen3 extents_of(const SegmentScene& scene, size_t count, auto&& position_of) {
  Moments moments;
  moments.reference = scene.local(position_of(0));
  const size_t step = count / kMostLooked + 1;
  for (size_t i = 0; i < count; i += step) moments.add(scene.local(position_of(i)));
  return symmetric_eigen(moments.covariance());
}

double deviation(double variance) { return std::sqrt(std::max(0.0, variance)); }

// Whether a line of points runs through it that is all the plane's own: an edge or a narrow strip, which lines cross,
// has neighbours beside it.
bool is_on_own_line(const SegmentScene& scene, const Surface& surface, uint32_t position,
                    std::vector<Neighbour>& found, std::vector<Neighbour>& theirs) {
  const Octree& tree = *scene.tree;
  found.resize(std::min<size_t>(kNeighbours, scene.size()));
  tree.knn_positions(tree.cube().origin + tree.local(position), static_cast<uint32_t>(found.size()),
                     found);
  const auto own = std::ranges::count_if(found, [&](const Neighbour& n) {
    return std::ranges::binary_search(surface.positions, n.index);
  });
  return static_cast<double>(own) >= kOwnNeighbours * static_cast<double>(found.size()) &&
         lies_in_line(tree, found, theirs);
}

enum class Around { kUnknown, kLine, kSurface };

// What the plane is around one of its points: a line, where its own points in a cell are one, and the others there fill
// another plane or none at all.
Around around(const SegmentScene& scene, const Surface& surface, const Octree::Cell& cell,
              double edge_m) {
  const Eigen3 all = extents_of(scene, cell.count,
                                [&](size_t i) { return static_cast<uint32_t>(cell.first + i); });
  const double width = deviation(all.values[1]);
  if (width < kLeastWidth * edge_m) return Around::kUnknown;
  const auto begin = std::ranges::lower_bound(surface.positions, cell.first),
             end = std::lower_bound(begin, surface.positions.end(), cell.first + cell.count);
  const Eigen3 own = extents_of(scene, static_cast<size_t>(end - begin),
                                [&](size_t i) { return begin[static_cast<ptrdiff_t>(i)]; });
  if (deviation(own.values[1]) >= kLineWidth * edge_m) return Around::kSurface;
  const bool is_flat = deviation(all.values[0]) <= kMostThickness * width;
  return is_flat && std::abs(dot(all.vectors[0], surface.plane.normal)) > kOther ? Around::kSurface
                                                                                 : Around::kLine;
}

// Among the cells that the scene has looked at, where there are such: they are sooner found than among all points.
Octree::Cell cell_around(const SegmentScene& scene, int level, uint32_t position) {
  if (!scene.cell_firsts.empty() && level >= scene.coarse_level && level <= scene.fine_level)
    return scene.cell_around(level, position);
  return scene.tree->cell(level, scene.tree->code(position) >> (3 * (kMaxLevel - level)));
}

// What is told around some points of a plane.
struct Told {
  size_t points = 0;
  std::vector<uint32_t> in_lines;  ///< of them, those with a line around
};

Told told_around(const SegmentScene& scene, const Surface& surface) {
  const Octree& tree = *scene.tree;
  const double least_edge_m = kLeastEdge * scene.settings.distance_tolerance_m;
  const int finest = std::clamp(
      static_cast<int>(std::floor(std::log2(tree.cube().edge / least_edge_m))), 0, kMaxLevel);
  const size_t step = surface.positions.size() / kAsked + 1;
  Told told;
  for (size_t i = step / 2; i < surface.positions.size(); i += step) {
    const uint32_t position = surface.positions[i];
    Around found = Around::kUnknown;
    for (int level = finest; found == Around::kUnknown && level > 0 && level > finest - kMostLevels;
         --level) {
      const Octree::Cell cell = cell_around(scene, level, position);
      found = around(scene, surface, cell, std::ldexp(tree.cube().edge, -level));
    }
    told.points += found != Around::kUnknown;
    if (found == Around::kLine) told.in_lines.push_back(position);
  }
  return told;
}

// Neighbours of neighbours cost most: they are asked for only as long as they can decide.
bool is_of_lines(const SegmentScene& scene, const Surface& surface) {
  const Told told = told_around(scene, surface);
  if (told.points < kLeastTold) return false;
  const auto are_most = [&](size_t lines) {
    return static_cast<double>(lines) > kShareOfLines * static_cast<double>(told.points);
  };
  std::vector<Neighbour> neighbours, theirs;
  size_t lines = 0, may_be = told.in_lines.size();
  for (const uint32_t position : told.in_lines) {
    if (are_most(lines) || !are_most(may_be)) break;
    if (is_on_own_line(scene, surface, position, neighbours, theirs)) ++lines;
    else --may_be;
  }
  return are_most(lines);
}

}  // namespace

void drop_planes_of_lines(SegmentScene& scene, std::vector<Surface>& surfaces, Task& task) {
  std::vector<uint8_t> drops(surfaces.size());
  parallel_for(task, surfaces.size(), 1, [&](size_t s, size_t) {
    drops[s] = surfaces[s].is_plane() && is_of_lines(scene, surfaces[s]);
  });
  if (std::ranges::find(drops, 1) == drops.end()) return;
  for (size_t s = 0; s < surfaces.size(); ++s)
    if (drops[s] != 0)
      for (const uint32_t position : surfaces[s].positions) scene.owner[position] = 0;
  size_t next = 0;
  std::erase_if(surfaces, [&](const Surface&) { return drops[next++] != 0; });
}

}  // namespace jalon
