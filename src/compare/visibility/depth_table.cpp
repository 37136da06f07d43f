// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/visibility/depth_table.h"

#include "base/error.h"
#include "base/numbers.h"
#include "base/table_columns.h"

namespace jalon {

DepthMap station_depth_map(const Cloud& cloud, uint64_t station, const DepthSettings& settings,
                           Task& task) {
  settings.check();
  if (station >= cloud.stations.size())
    fail(Status::kInvalidArgument, "station %llu of a cloud with %zu stations",
         static_cast<unsigned long long>(station), cloud.stations.size());
  const Station& s = cloud.stations[station];
  if (!s.has_pose) fail(Status::kInvalidArgument, "station \"%.100s\" has no pose", s.name.c_str());
  return DepthMap::build(cloud, s, {}, settings, task);
}

FieldTable depth_table(const DepthMap& map) {
  FieldTable t;
  const auto cells = map.cells();
  const AngularGrid& grid = map.grid();
  std::vector<uint8_t> fill(cells.size());
  std::vector<double> horizontal(cells.size()), vertical(cells.size());
  for (size_t c = 0; c < cells.size(); ++c) {
    fill[c] = static_cast<uint8_t>(map.fill(c));
    horizontal[c] = grid.horizontal_of(static_cast<uint32_t>(c % grid.columns));
    vertical[c] = grid.vertical_of(static_cast<uint32_t>(c / grid.columns));
  }
  add_column<float>(t, cells, "range", "m", "of the surface; NaN: empty",
                    [](const DepthMap::Cell& c) { return c.range_m > 0 ? c.range_m : kFloatNaN; });
  add_column<uint8_t>(t, fill, "fill", "", "0 empty, 1 measured, 2 from neighbours",
                      [](uint8_t f) { return f; });
  add_column<uint32_t>(t, map.counts(), "points", "", "in the cell", [](uint32_t n) { return n; });
  add_column<uint32_t>(t, cells, "nearest", "", "nearest point of the cell; 4294967295: none",
                       [](const DepthMap::Cell& c) { return c.point; });
  const auto same = [](double angle) { return angle; };
  add_column<double>(t, horizontal, "horizontal", "rad", "of the centre, clockwise from +Y", same);
  add_column<double>(t, vertical, "vertical", "rad", "of the centre, from the horizon", same);
  return t;
}

}  // namespace jalon
