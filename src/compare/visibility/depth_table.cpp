// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/visibility/depth_table.h"

#include "base/error.h"
#include "base/numbers.h"
#include "base/parallel.h"

namespace jalon {

namespace {

constexpr double kMapShare = 0.8;  // of the time; the rest for what is made of it

}  // namespace

DepthMap station_depth_map(const Cloud& cloud, uint64_t station, const DepthSettings& settings,
                           Task& task) {
  settings.check();
  if (station >= cloud.stations.size())
    fail(Status::kInvalidArgument, "station %llu of a cloud with %zu stations",
         static_cast<unsigned long long>(station), cloud.stations.size());
  const Station& s = cloud.stations[station];
  if (!s.has_pose) fail(Status::kInvalidArgument, "station \"%.100s\" has no pose", s.name.c_str());
  const ProgressSpan span(task, 0, kMapShare);
  return DepthMap::build(cloud, s, {}, settings, task);
}

FieldTable depth_table(const DepthMap& map, Task& task) {
  constexpr size_t kDepthTableGrain = 1 << 14;  // cells
  const AngularGrid& grid = map.grid();
  FieldTable t;
  const auto column = [&](auto zero, const char* name, const char* unit, const char* meaning) {
    using T = decltype(zero);
    const auto made = std::make_shared<Column>(
        FieldInfo{name, element_type_of<T>(), 1, unit, meaning}, grid.size());
    t.set(made);
    return made->template values<T>();
  };
  const auto range = column(float{}, "range", "m", "of the surface; NaN: empty");
  const auto fill = column(uint8_t{}, "fill", "", "0 empty, 1 measured, 2 from neighbours");
  const auto points = column(uint32_t{}, "points", "", "in the cell");
  const auto nearest =
      column(uint32_t{}, "nearest", "", "nearest point of the cell; 4294967295: none");
  const auto horizontal = column(double{}, "horizontal", "rad", "of the centre, clockwise from +Y");
  const auto vertical = column(double{}, "vertical", "rad", "of the centre, from the horizon");
  const ProgressSpan span(task, kMapShare, 1);
  parallel_for(task, grid.size(), kDepthTableGrain, [&](size_t begin, size_t end) {
    for (size_t c = begin; c < end; ++c) {
      const auto x = static_cast<uint32_t>(c % grid.columns),
                 y = static_cast<uint32_t>(c / grid.columns);
      const DepthCell& cell = map.cell(x, y);
      range[c] = cell.range_m > 0 ? cell.range_m : kFloatNaN;
      fill[c] = static_cast<uint8_t>(map.fill(x, y));
      points[c] = map.count(x, y);
      nearest[c] = cell.point;
      horizontal[c] = grid.horizontal_of(x);
      vertical[c] = grid.vertical_of(y);
    }
  });
  return t;
}

}  // namespace jalon
