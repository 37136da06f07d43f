// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/evidence/wall_cells.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "base/parallel.h"
#include "modelling/evidence/cell_classes.h"
#include "modelling/plane/point_stations.h"
#include "modelling/plane/ring_tools.h"
#include "modelling/plane/spacing.h"

namespace jalon {

namespace {

constexpr double kCellSpacings = 2.2;
constexpr double kMostCells = 4e6;
constexpr double kMarginCells = 2;
constexpr double kWallCellsSigmas = 4;
constexpr double kFlat = 0.05;  // sine of rays too flat for the plane to say where they cross it
constexpr double kAlmost_m = 0.008, kAlmostSigmas = 2;
constexpr double kSameWayCosine = 0.966;  // 15 degrees
constexpr size_t kWallCellsPointsPerChunk = 1 << 15;

// A source on its way through the cloud. Marks are set by many threads: OR is the same in any order.
struct Sight {
  WallCells out;
  std::vector<uint8_t> marks;
  uint32_t own = 0;
  double almost_m = 0;               ///< farther behind the plane than noise puts its own points
  std::vector<uint8_t> is_parallel;  ///< by label

  void mark(const Vec2& p, uint8_t what) {
    const double c = (p.u - out.origin.u) / out.cell_m, r = (p.v - out.origin.v) / out.cell_m;
    if (!(c >= 0 && r >= 0 && c < out.columns && r < out.rows)) return;
    uint8_t& cell = marks[static_cast<size_t>(r) * out.columns + static_cast<size_t>(c)];
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
  for (const Segment& segment : segmentation.segments)
    sight.is_parallel[segment.label] =
        segment.has_plane() &&
        std::fabs(dot(segment.fit.plane.normal, source.frame.normal)) >= kSameWayCosine;
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
  out.cell_m = std::max(kCellSpacings * out.spacing_m, most);
  const double margin = kMarginCells * out.cell_m;
  out.origin = box.low - Vec2{margin, margin};
  out.columns = static_cast<uint32_t>(std::ceil((box.width() + 2 * margin) / out.cell_m));
  out.rows = static_cast<uint32_t>(std::ceil((box.height() + 2 * margin) / out.cell_m));
  sight.marks.assign(static_cast<size_t>(out.columns) * out.rows, 0);
  return sight;
}

// Where the ray from the eye to the point crosses the plane, and on which side it ends.
void look_along_ray(Sight& sight, const Vec3& eye, const Vec3& p, double w) {
  const double height = sight.height_of(eye), fall = height - w;
  if (height <= sight.out.on_m || fall < kFlat * norm(p - eye)) return;
  const Vec3 crossing = eye + (p - eye) * (height / fall);
  sight.mark(sight.out.frame.project(crossing), w < 0 ? kMarkBehind : kMarkBefore);
}

void look_at(Sight& sight, const CellSetting& setting, const Vec3& p, uint32_t label,
             const Vec3* eye) {
  const double w = sight.height_of(p), on = sight.out.on_m;
  if (eye == nullptr && (w < -setting.deep_m || w > setting.before_m)) return;
  if (std::fabs(w) <= on) {
    sight.mark(sight.out.frame.project(p), sight.mark_within(label, w));
    return;
  }
  if (w > 0 && w <= setting.relief_m) sight.mark(sight.out.frame.project(p), kMarkRelief);
  else if (w > 0 && w <= setting.proud_m)
    sight.mark(sight.out.frame.project(p),
               sight.is_parallel[label] != 0 ? kMarkProud | kMarkParallel : kMarkProud);
  if (eye != nullptr) look_along_ray(sight, *eye, p, w);
  else
    sight.mark(sight.out.frame.project(p), w > 0                    ? kMarkBefore
                                           : w >= -setting.behind_m ? kMarkBehind
                                                                    : kMarkDeep);
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
  const size_t n = sources.empty() ? 0 : cloud.size();
  parallel_for(task, n, kWallCellsPointsPerChunk, [&](size_t begin, size_t end) {
    PointStations stations(cloud);
    for (size_t i = begin; i < end; ++i) {
      const Vec3 p = cloud.point(i);
      const Station* station = stations.of(i);
      Vec3 eye;
      if (station != nullptr) eye = station->pose.translation();
      for (Sight& sight : sights)
        if (!sight.marks.empty())
          look_at(sight, setting, p, labels[i], station != nullptr ? &eye : nullptr);
    }
  });
  // 3. One state a cell.
  std::vector<WallCells> out;
  parallel_for(task, sights.size(), 1, [&](size_t begin, size_t end) {
    for (size_t s = begin; s < end; ++s) classify_cells(sights[s].marks, sights[s].out, task);
  });
  for (Sight& sight : sights) out.push_back(std::move(sight.out));
  return out;
}

}  // namespace jalon
