// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/evidence/wall_cells.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "base/parallel.h"
#include "modelling/evidence/cell_classes.h"
#include "modelling/evidence/set_back.h"
#include "modelling/plane/lone_points.h"
#include "modelling/plane/point_block.h"
#include "modelling/plane/point_stations.h"
#include "modelling/plane/spacing.h"

namespace jalon {

namespace {

constexpr double kCellSpacings = 2.2;
constexpr double kMostCells = 4e6;
constexpr double kMarginCells = 2;
constexpr double kWallCellsSigmas = 4;
constexpr double kFlat = 0.05;  // sine of rays too flat for the plane to say where they cross it
constexpr double kAlmost_m = 0.008, kAlmostSigmas = 2;
// Rooms seen through windows lie two to four times as far as the wall, at a slant: their points stand so much wider.
constexpr double kLoneSpacings = 10;
constexpr double kSameWayCosine = 0.966;  // 15 degrees
constexpr size_t kWallCellsPointsPerChunk = 1 << 15;

// A source on its way through the cloud. Marks are set by many threads: OR is the same in any order.
struct Sight {
  WallCells out;
  std::vector<uint8_t> marks;
  HeightSums heights{0};
  uint32_t own = 0;
  double almost_m = 0;               ///< farther behind the plane than noise puts its own points
  std::vector<uint8_t> is_parallel;  ///< by label
  std::vector<uint8_t> is_slanted;   ///< by label: planes that are not parallel, as roofs

  void mark(const Vec2& p, uint8_t what) {
    mark_cell((p.u - out.origin.u) / out.cell_m, (p.v - out.origin.v) / out.cell_m, what);
  }
  // height_m: of a point on the plane.
  void mark_cell(double column, double row, uint8_t what, double height_m = 0) {
    if (!(column >= 0 && row >= 0 && column < out.columns && row < out.rows)) return;
    const size_t k = static_cast<size_t>(row) * out.columns + static_cast<size_t>(column);
    uint8_t& cell = marks[k];
    if (what == kMarkOn) heights.add(k, height_m);
    if ((std::atomic_ref<uint8_t>(cell).load(std::memory_order_relaxed) & what) != what)
      std::atomic_ref<uint8_t>(cell).fetch_or(what, std::memory_order_relaxed);
  }
  // Of a point within the plane's thickness.
  uint8_t mark_within(uint32_t label, double w) const {
    if (label == 0 || label == own) return kMarkOn;
    if (is_parallel[label] == 0 || std::fabs(w) <= almost_m) return kMarkFlush;
    return w < 0 ? kMarkBehind : kMarkRelief;
  }
  double height_of(const Vec3& p) const {
    return dot(p - out.frame.origin, out.frame.normal) - out.frame.height;
  }
};

Sight prepared(const Segmentation& segmentation, const CellSource& source,
               const CellSetting& setting, Task& task) {
  const Cloud& cloud = *segmentation.cloud;
  Sight sight;
  sight.own = source.label;
  sight.almost_m = std::max(kAlmost_m, kAlmostSigmas * source.sigma_m);
  sight.is_parallel.assign(segmentation.segments.size() + 1, 0);
  sight.is_slanted = sight.is_parallel;
  for (const Segment& segment : segmentation.segments) {
    if (!segment.has_plane()) continue;
    const bool is_parallel =
        std::fabs(dot(segment.fit.plane.normal, source.frame.normal)) >= kSameWayCosine;
    (is_parallel ? sight.is_parallel : sight.is_slanted)[segment.label] = 1;
  }
  WallCells& out = sight.out;
  out.frame = source.frame;
  out.on_m = std::max(setting.on_m, kWallCellsSigmas * source.sigma_m);
  std::vector<Vec2> points;
  RingBox box;
  for (const uint32_t i : source.points) {
    points.push_back(source.frame.project(cloud.point(i)));
    box.add(points.back());
  }
  out.spacing_m = typical_spacing(points, task);
  if (!(out.spacing_m > 0)) return sight;
  const double most = std::sqrt(box.width() * box.height() / kMostCells);
  out.cell_m = std::max(kCellSpacings * stepped_length(out.spacing_m), most);
  const double margin = kMarginCells * out.cell_m;
  out.origin = box.low - Vec2{margin, margin};
  out.columns = static_cast<uint32_t>(std::ceil((box.width() + 2 * margin) / out.cell_m));
  out.rows = static_cast<uint32_t>(std::ceil((box.height() + 2 * margin) / out.cell_m));
  sight.marks.assign(static_cast<size_t>(out.columns) * out.rows, 0);
  sight.heights = HeightSums(sight.marks.size());
  return sight;
}

// Within which a point that tells something has another one: of the wall with the most points.
double lone_distance(const std::vector<Sight>& sights, std::span<const CellSource> sources) {
  size_t most = 0;
  double spacing_m = 0;
  for (size_t s = 0; s < sights.size(); ++s)
    if (sources[s].points.size() > most) {
      most = sources[s].points.size();
      spacing_m = sights[s].out.spacing_m;
    }
  return kLoneSpacings * stepped_length(spacing_m);
}

// Where the ray from the eye to the point crosses the plane, and on which side it ends.
void look_along_ray(Sight& sight, const Vec3& eye, const Vec3& p, double w) {
  const double height = sight.height_of(eye), fall = height - w;
  if (height <= sight.out.on_m || fall < kFlat * norm(p - eye)) return;
  const Vec3 crossing = eye + (p - eye) * (height / fall);
  sight.mark(sight.out.frame.project(crossing), w < 0 ? kMarkBehind : kMarkBefore);
}

// What a point at height w says of the cell that it lies before or behind; 0: nothing.
uint8_t mark_across(const Sight& sight, const CellSetting& setting, double w, uint32_t label,
                    bool has_eye) {
  if (std::fabs(w) <= sight.out.on_m) return sight.mark_within(label, w);
  uint8_t what = 0;
  if (w > 0 && w <= setting.relief_m)
    what = sight.is_slanted[label] != 0 ? kMarkProud : kMarkRelief;
  else if (w > 0 && w <= setting.proud_m)
    what = sight.is_parallel[label] != 0 ? kMarkProud | kMarkParallel : kMarkProud;
  if (has_eye) return what;
  return what | (w > 0 ? kMarkBefore : w >= -setting.behind_m ? kMarkBehind : kMarkDeep);
}

// Some points and what one sight makes of them.
struct SightBlock {
  PointBlock points;
  const Station* stations[PointBlock::kMost];
  bool has_rays = false;  // that pass cells far from their points
  double w[PointBlock::kMost], column[PointBlock::kMost], row[PointBlock::kMost];

  void find_stations(PointStations& seen_from) {
    has_rays = false;
    for (size_t k = 0; k < points.count(); ++k) {
      stations[k] = seen_from.of(points.index(k));
      has_rays = has_rays || stations[k] != nullptr;
    }
  }
  bool is_apart(const WallCells& cells, const CellSetting& setting) const {
    if (has_rays) return false;
    const FrameBox box = points.bounds(cells.frame);
    return box.highest < -setting.deep_m || box.lowest > setting.before_m ||
           box.high.u < cells.origin.u || box.high.v < cells.origin.v ||
           box.low.u > cells.origin.u + cells.cell_m * cells.columns ||
           box.low.v > cells.origin.v + cells.cell_m * cells.rows;
  }
  void place(const WallCells& cells) {
    points.heights(cells.frame, w);
    points.project(cells.frame, column, row);
    const Vec2 origin = cells.origin;
    const double cell_m = cells.cell_m;
    for (size_t k = 0; k < PointBlock::kMost; ++k) {
      column[k] = (column[k] - origin.u) / cell_m;
      row[k] = (row[k] - origin.v) / cell_m;
    }
  }
};

void look_at(Sight& sight, const CellSetting& setting, const Cloud& cloud,
             std::span<const uint32_t> labels, const LonePoints& lone, SightBlock& block) {
  block.place(sight.out);
  for (size_t k = 0; k < block.points.count(); ++k) {
    const Station* station = block.stations[k];
    const size_t i = block.points.index(k);
    const double w = block.w[k];
    const bool has_eye = station != nullptr;
    if (!has_eye && (w < -setting.deep_m || w > setting.before_m)) continue;
    if (std::fabs(w) > sight.out.on_m && lone.has(i)) continue;
    const uint8_t what = mark_across(sight, setting, w, labels[i], has_eye);
    if (what != 0) sight.mark_cell(block.column[k], block.row[k], what, w);
    if (has_eye && std::fabs(w) > sight.out.on_m)
      look_along_ray(sight, station->pose.translation(), cloud.point(i), w);
  }
}

}  // namespace

std::vector<WallCells> wall_cells(const Segmentation& segmentation,
                                  std::span<const CellSource> sources, const CellSetting& setting,
                                  Task& task) {
  const Cloud& cloud = *segmentation.cloud;
  const auto labels = segmentation.labels->values<uint32_t>();
  // 1. The cells of each plane.
  std::vector<Sight> sights(sources.size());
  parallel_for(task, sources.size(), 1, [&](size_t begin, size_t end) {
    for (size_t s = begin; s < end; ++s)
      sights[s] = prepared(segmentation, sources[s], setting, task);
  });
  // 2. What the points show of each.
  const LonePoints lone(cloud, labels, lone_distance(sights, sources), task);
  const size_t n = sources.empty() ? 0 : cloud.size();
  // Blocks of neighbours are apart from most walls. Rays go far: their points stay in their stations' order.
  const auto tree = n != 0 && cloud.stations.empty() ? cloud.octree(task) : nullptr;
  const auto order = tree != nullptr ? tree->order() : std::span<const uint32_t>{};
  parallel_for(task, n, kWallCellsPointsPerChunk, [&](size_t begin, size_t end) {
    PointStations stations(cloud);
    SightBlock block;
    for (size_t first = begin; first < end; first += PointBlock::kMost) {
      block.points.fill(cloud, order, first, std::min(PointBlock::kMost, end - first));
      block.find_stations(stations);
      for (Sight& sight : sights)
        if (!sight.marks.empty() && !block.is_apart(sight.out, setting))
          look_at(sight, setting, cloud, labels, lone, block);
    }
  });
  // 3. One state a cell.
  std::vector<WallCells> out;
  parallel_for(task, sights.size(), 1, [&](size_t begin, size_t end) {
    for (size_t s = begin; s < end; ++s) {
      WallCells& cells = sights[s].out;
      cells.set_back = mark_set_back(sights[s].heights, cells, sights[s].marks, task);
      sights[s].heights = HeightSums(0);
      classify_cells(sights[s].marks, cells, task);
    }
  });
  for (Sight& sight : sights) out.push_back(std::move(sight.out));
  return out;
}

}  // namespace jalon
