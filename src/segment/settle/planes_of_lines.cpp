// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/settle/planes_of_lines.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

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
// Tolerances: a slab of two, evenly filled, deviates by 0.58. Noise stays within it, and what is wider has a width.
constexpr double kWidestNoise = 0.58;
// Share of a cloud's points. Scans by tripods have at most 0.08, of far ground or of frames alone; turns of spinning
// heads 0.2 to 1.
constexpr double kMostInLines = 0.12;
constexpr double kOther = 0.8;  // cosine: planes of 37 degrees are two

Eigen3 extents_of(const SegmentScene& scene, size_t count, auto&& position_of) {
  Moments moments;
  moments.reference = scene.local(position_of(0));
  const size_t step = count / kMostLooked + 1;
  for (size_t i = 0; i < count; i += step) moments.add(scene.local(position_of(i)));
  return symmetric_eigen(moments.covariance());
}

double deviation(double variance) { return std::sqrt(std::max(0.0, variance)); }

// The points nearest to one of the plane's, its own first; how many of them are.
size_t own_of_nearest(const SegmentScene& scene, const Surface& surface, uint32_t position,
                      std::vector<Neighbour>& found) {
  const Octree& tree = *scene.tree;
  found.resize(std::min<size_t>(kNeighbours, scene.size()));
  tree.knn_positions(tree.cube().origin + tree.local(position), static_cast<uint32_t>(found.size()),
                     found);
  const auto others = std::stable_partition(found.begin(), found.end(), [&](const Neighbour& n) {
    return std::ranges::binary_search(surface.positions, n.index);
  });
  return static_cast<size_t>(others - found.begin());
}

// Standard deviation of points across the line that they follow one after the other, however it bends: of each from the
// chord of the two beside it, divided by what their own deviations add (Gasser, Sroka & Jennen-Steinmetz 1986).
double deviation_across_line(const SegmentScene& scene, std::span<const Neighbour> points) {
  struct Place {
    double along, across;
  };
  const Eigen3 extents =
      extents_of(scene, points.size(), [&](size_t i) { return points[i].index; });
  std::vector<Place> line;
  for (const Neighbour& n : points) {
    const Vec3 at = scene.local(n.index);
    line.push_back({dot(at, extents.vectors[2]), dot(at, extents.vectors[1])});
  }
  std::ranges::sort(line, {}, [](const Place& p) { return std::pair(p.along, p.across); });
  double sum = 0;
  size_t count = 0;
  for (size_t i = 1; i + 1 < line.size(); ++i) {
    const double gap = line[i + 1].along - line[i - 1].along;
    const double next = gap > 0 ? (line[i].along - line[i - 1].along) / gap : 0.5, last = 1 - next;
    const double apart = last * line[i - 1].across + next * line[i + 1].across - line[i].across;
    sum += apart * apart / (last * last + next * next + 1);
    ++count;
  }
  return std::sqrt(sum / static_cast<double>(std::max<size_t>(count, 1)));
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

enum class Spanned { kBySurface, kByStrip, kByLines };

// What spans a plane: lines where most of its points lie in one that is dense along itself and all the plane's own (an
// edge, which lines cross, has neighbours beside it). Wider than noise makes a line it is a narrow strip: joinery, of
// which a scan has two rows. Neighbours of neighbours cost most: they are asked for only as long as they can decide.
Spanned spanned(const SegmentScene& scene, const Surface& surface) {
  const Told told = told_around(scene, surface);
  const auto are_most = [&](size_t lines) {
    return static_cast<double>(lines) > kShareOfLines * static_cast<double>(told.points);
  };
  if (told.points < kLeastTold || !are_most(told.in_lines.size())) return Spanned::kBySurface;
  std::vector<Neighbour> neighbours, theirs;
  double across_m = 0;
  size_t dense = 0, lines = 0, may_be = told.in_lines.size();
  for (const uint32_t position : told.in_lines) {
    const size_t own = own_of_nearest(scene, surface, position, neighbours);
    const bool is_dense =
        static_cast<double>(own) >= kOwnNeighbours * static_cast<double>(neighbours.size());
    if (is_dense) {
      ++dense;
      across_m += deviation_across_line(scene, std::span(neighbours).first(own));
    }
    if (are_most(lines)) continue;
    if (is_dense && lies_in_line(*scene.tree, neighbours, theirs)) ++lines;
    else if (!are_most(--may_be)) return Spanned::kBySurface;
  }
  const double widest_m = kWidestNoise * scene.settings.distance_tolerance_m;
  return across_m >= widest_m * static_cast<double>(dense) ? Spanned::kByStrip : Spanned::kByLines;
}

}  // namespace

void drop_planes_of_lines(SegmentScene& scene, std::vector<Surface>& surfaces, Task& task) {
  std::vector<Spanned> by(surfaces.size(), Spanned::kBySurface);
  parallel_for(task, surfaces.size(), 1, [&](size_t s, size_t) {
    if (surfaces[s].is_plane()) by[s] = spanned(scene, surfaces[s]);
  });
  // Where all of a cloud is lines, as of a spinning head, so are its narrow strips: of its noise or over rough things.
  if (std::ranges::find(by, Spanned::kByStrip) != by.end() &&
      spread_of(*scene.tree, kNeighbours, task).in_lines > kMostInLines)
    std::ranges::replace(by, Spanned::kByStrip, Spanned::kByLines);
  if (std::ranges::find(by, Spanned::kByLines) == by.end()) return;
  for (size_t s = 0; s < surfaces.size(); ++s)
    if (by[s] == Spanned::kByLines)
      for (const uint32_t position : surfaces[s].positions) scene.owner[position] = 0;
  size_t next = 0;
  std::erase_if(surfaces, [&](const Surface&) { return by[next++] == Spanned::kByLines; });
}

}  // namespace jalon
