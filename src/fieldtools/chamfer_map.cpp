// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/numbers.h"
#include "base/parallel.h"
#include "base/serial.h"
#include "base/setting_rows.h"
#include "fieldtools/chamfer.h"
#include "fieldtools/field_values.h"

namespace jalon {

namespace {

constexpr size_t kChamferMapGrain = 1 << 14;
constexpr double kAutomaticCells = 2e6;          // of the automatic cell size
constexpr double kChamferMapMostCells = 0x1p27;  // 0.8 GiB at the peak of either method
constexpr double kMostAlong = 20000;  // cells on an axis: thirds of a cell fit 16 bits along it

DistanceGrid grid_around(const Box3& box, double cell_m) {
  const Vec3 extent = box.max - box.min;
  if (cell_m == 0) {
    const double longest = std::max({extent.x, extent.y, extent.z, 1e-6});
    // Thin boxes fill fewer cells: no edge counts for less than a hundredth of the longest.
    double volume = 1;
    for (int i = 0; i < 3; ++i) volume *= std::max(extent[i], 0.01 * longest);
    cell_m = std::cbrt(volume / kAutomaticCells);
  }
  DistanceGrid grid;
  grid.lowest = box.min;
  grid.cell_m = cell_m;
  double cells = 1;
  for (int i = 0; i < 3; ++i) {
    const double along = std::floor(extent[i] / cell_m) + 1 + 2 * grid.margin;
    cells *= along;
    if (along > kMostAlong || cells > kChamferMapMostCells)
      fail(Status::kLimit, "the box of the clouds has too many cells of this size");
    grid.size[static_cast<size_t>(i)] = static_cast<uint32_t>(along);
  }
  return grid;
}

/// Cell of a point of the grid's box; margins keep rounding inside.
uint64_t cell_of(const DistanceGrid& grid, const Vec3& p) {
  const Vec3 at = grid.place(p);
  uint32_t number[3];
  for (int i = 0; i < 3; ++i)
    number[i] = static_cast<uint32_t>(
        std::clamp(at[i], 0.0, static_cast<double>(grid.size[static_cast<size_t>(i)] - 1)));
  return grid.index(number[0], number[1], number[2]);
}

Vec3 centre_offset(const DistanceGrid& grid, uint64_t cell) {
  const uint64_t x = cell % grid.size[0], y = cell / grid.size[0] % grid.size[1],
                 z = cell / (uint64_t{grid.size[0]} * grid.size[1]);
  const auto offset = [&](uint64_t n) {
    return (static_cast<double>(n) - grid.margin + 0.5) * grid.cell_m;
  };
  return {offset(x), offset(y), offset(z)};
}

/// The cells that hold points, and the distance of each centre from the nearest of its own.
struct Occupied {
  std::vector<uint64_t> cells;
  std::vector<float> starts;
};
Occupied occupied_cells(const DistanceGrid& grid, const Cloud& reference, Task& task) {
  struct Entry {
    uint64_t cell;
    float distance;
  };
  std::vector<Entry> entries(reference.size());
  parallel_for(task, entries.size(), kChamferMapGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const uint64_t cell = cell_of(grid, reference.point(i));
      const Vec3 away = reference.point(i) - grid.lowest - centre_offset(grid, cell);
      entries[i] = {cell, static_cast<float>(norm(away))};
    }
  });
  std::vector<float> nearest(grid.cells(), std::numeric_limits<float>::infinity());
  serial_for(task, entries.size(), kChamferMapGrain, [&](size_t begin, size_t end) {
    for (const Entry& e : std::span(entries).subspan(begin, end - begin))
      nearest[e.cell] = std::min(nearest[e.cell], e.distance);
  });
  Occupied out;
  serial_for(task, nearest.size(), kChamferMapGrain, [&](size_t begin, size_t end) {
    for (size_t c = begin; c < end; ++c)
      if (std::isfinite(nearest[c])) {
        out.cells.push_back(c);
        out.starts.push_back(nearest[c]);
      }
  });
  return out;
}

/// The map between the centres of its cells, by straight lines along each axis.
double interpolated(const DistanceMap& map, const Vec3& p) {
  const Vec3 at = map.grid.place(p);
  uint32_t low[3];
  double share[3];
  for (int i = 0; i < 3; ++i) {
    const auto axis = static_cast<size_t>(i);
    const double c = std::clamp(at[i] - 0.5, 0.0, static_cast<double>(map.grid.size[axis]) - 1.001);
    low[axis] = static_cast<uint32_t>(c);
    share[axis] = c - low[axis];
  }
  double sum = 0;
  for (uint32_t corner = 0; corner < 8; ++corner) {
    double weight = 1;
    uint32_t number[3];
    for (uint32_t axis = 0; axis < 3; ++axis) {
      const uint32_t upper = corner >> axis & 1;
      number[axis] = low[axis] + upper;
      weight *= upper != 0 ? share[axis] : 1 - share[axis];
    }
    sum += weight * double{map.distance_m[map.grid.index(number[0], number[1], number[2])]};
  }
  return sum;
}

void require_points(const Cloud& reference) {
  if (reference.size() == 0) fail(Status::kInsufficientData, "the reference has no points");
}

double limit_of(const DistanceMapSettings& settings) {
  return settings.max_distance_m > 0 ? settings.max_distance_m : std::numeric_limits<double>::max();
}

}  // namespace

std::span<const ParamRow> distance_map_rows() {
  using S = DistanceMapSettings;
  static constexpr auto kRows = setting_rows(
      choice_row<&S::method>(
          "method", "chamfer|fast_marching", "",
          "chamfer: whole steps of 3, 4 and 5 thirds of a cell, fast and coarse; fast_marching: "
          "the distance from the points themselves, read between cells"),
      number_row<&S::cell_m>("cell_m", 0, 1e6, "m", "",
                             "Edge of the grid cells; 0 = such that there are about two million"),
      number_row<&S::max_distance_m>("max_distance_m", 0, 1e9, "m", "",
                                     "Distances above it are no value; 0 = all"),
      string_row<&S::name>("name", "", "Name of the field of distances"));
  return kRows;
}

DistanceMap distance_map(const Cloud& reference, const Box3& box,
                         const DistanceMapSettings& settings, Task& task) {
  DistanceMap out;
  out.grid = grid_around(box, settings.cell_m);
  Occupied occupied;
  {
    ProgressSpan span(task, 0, 0.1);
    occupied = occupied_cells(out.grid, reference, task);
  }
  ProgressSpan span(task, 0.1, 1, "distance map");
  out.distance_m = settings.method == DistanceMapSettings::Method::kChamfer
                       ? chamfer_distances(out.grid, occupied.cells, task)
                       : marched_distances(out.grid, occupied.cells, occupied.starts, task);
  return out;
}

Cloud with_map_distance(const Cloud& compared, const Cloud& reference,
                        const DistanceMapSettings& settings, Task& task) {
  const std::string name = require_field_name(settings.name);
  require_points(reference);
  Box3 box = bounds(reference, task);
  if (compared.size() != 0) box += bounds(compared, task);
  const DistanceMap map = distance_map(reference, box, settings, task);
  const bool chamfer = settings.method == DistanceMapSettings::Method::kChamfer;
  const double limit_m = limit_of(settings);
  std::vector<double> distances(compared.size());
  parallel_for(task, distances.size(), kChamferMapGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const Vec3 p = compared.point(i);
      const double d =
          chamfer ? double{map.distance_m[cell_of(map.grid, p)]} : interpolated(map, p);
      distances[i] = d <= limit_m ? d : kNaN;
    }
  });
  return with_field<double>(compared, name, "m", "distance by a grid of cells", distances);
}

Cloud distance_map_cloud(const Cloud& reference, const DistanceMapSettings& settings, Task& task) {
  const std::string name = require_field_name(settings.name);
  require_points(reference);
  const DistanceMap map = distance_map(reference, bounds(reference, task), settings, task);
  const double limit_m = limit_of(settings);
  std::vector<uint64_t> cells;
  serial_for(task, map.distance_m.size(), kChamferMapGrain, [&](size_t begin, size_t end) {
    for (size_t c = begin; c < end; ++c)
      if (double{map.distance_m[c]} <= limit_m) cells.push_back(c);
  });
  Buffer<double> xyz(3 * cells.size());
  std::vector<float> distances(cells.size());
  parallel_for(task, cells.size(), kChamferMapGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const Vec3 p = map.grid.lowest + centre_offset(map.grid, cells[i]);
      for (int c = 0; c < 3; ++c) xyz[3 * i + static_cast<size_t>(c)] = p[c];
      distances[i] = map.distance_m[cells[i]];
    }
  });
  Cloud out = make_cloud(std::move(xyz));
  out.crs = reference.crs;
  return with_field<float>(out, name, "m", "distance of the cell's centre from the cloud",
                           distances);
}

}  // namespace jalon
