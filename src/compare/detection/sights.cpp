// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/detection/sights.h"

#include <cmath>

#include "base/parallel.h"

namespace jalon {

namespace {

// A surface that is looked along, beyond 84 degrees, does not tell before from behind.
constexpr double kLeastCosine = 0.1;
constexpr int kAround = 1;         // cells to either side of the one that a place lies in
constexpr int kLeastMeasured = 7;  // of the nine

}  // namespace

Sights::Sights(const Cloud& cloud, Task& task) : cloud_(&cloud) {
  DepthSettings settings;
  settings.rule = CellRule::kNearest;
  settings.fill_passes = 0;  // an empty cell was not measured
  std::vector<const Station*> stations;
  for (const Station& station : cloud.stations)
    if (station.count > 0) stations.push_back(&station);
  maps_.resize(stations.size());
  // Much of a map is made by one thread.
  parallel_chunks(task, stations.size(), [&](size_t k) {
    maps_[k] = DepthMap::build(cloud, *stations[k], {}, settings, task);
  });
  for (const Station* station : stations) places_.push_back(station->pose.point({}));
}

PlaceSight Sights::look(const DepthMap& map, const Vec3& station, const Vec3& place,
                        const Vec3& normal, double margin_m) const {
  AngularGrid::Place at;
  if (!map.grid().locate(map.sighting(place), at)) return PlaceSight::kUnknown;
  // What was measured about that direction, against the plane of the place's surface, so that slant costs nothing.
  const Vec3 back = normalized(station - place);
  const double cosine = dot(normal, back);
  const Vec3 facing = std::abs(cosine) < kLeastCosine ? back : cosine < 0 ? -normal : normal;
  const AngularGrid& grid = map.grid();
  int measured = 0, before = 0, behind = 0;
  for (int j = -kAround; j <= kAround; ++j)
    for (int i = -kAround; i <= kAround; ++i) {
      const int64_t row = int64_t{at.row} + j;
      int64_t column = int64_t{at.column} + i;
      if (grid.is_closed) column = (column + grid.columns) % grid.columns;
      if (row < 0 || row >= grid.rows || column < 0 || column >= grid.columns) continue;
      const DepthCell& cell = map.cell(static_cast<uint32_t>(column), static_cast<uint32_t>(row));
      if (cell.point == kNoPoint) continue;
      ++measured;
      const double off = dot(facing, cloud_->point(cell.point) - place);
      before += off > margin_m ? 1 : 0;
      behind += off < -margin_m ? 1 : 0;
    }
  if (measured > before + behind) return PlaceSight::kSurface;
  if (measured < kLeastMeasured) return PlaceSight::kUnknown;
  if (behind == measured) return PlaceSight::kThrough;
  return before == measured ? PlaceSight::kHidden : PlaceSight::kUnknown;
}

PlaceSight Sights::look(const Vec3& place, const Vec3& normal, double margin_m) const {
  bool through = false, hidden = false;
  for (size_t k = 0; k < maps_.size(); ++k) {
    const PlaceSight seen = look(maps_[k], places_[k], place, normal, margin_m);
    if (seen == PlaceSight::kSurface) return seen;
    through = through || seen == PlaceSight::kThrough;
    hidden = hidden || seen == PlaceSight::kHidden;
  }
  return through ? PlaceSight::kThrough : hidden ? PlaceSight::kHidden : PlaceSight::kUnknown;
}

}  // namespace jalon
