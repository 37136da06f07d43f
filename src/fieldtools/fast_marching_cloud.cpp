// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/numbers.h"
#include "base/parallel.h"
#include "base/setting_rows.h"
#include "fieldtools/fast_marching.h"
#include "fieldtools/field_values.h"

namespace jalon {

namespace {

constexpr double kFastMarchingCloudCellSpacings =
    3;  // cells of a surface then hold some nine points and touch their neighbours

std::vector<uint32_t> checked_seeds(std::span<const uint64_t> seeds, size_t points) {
  if (seeds.empty()) fail(Status::kInsufficientData, "no seeds: the front has nowhere to start");
  std::vector<uint32_t> out;
  for (const uint64_t seed : seeds) {
    if (seed >= points)
      fail(Status::kInvalidArgument, "seed %llu is no point of the cloud, which has %zu",
           static_cast<unsigned long long>(seed), points);
    out.push_back(static_cast<uint32_t>(seed));
  }
  return out;
}

}  // namespace

std::span<const ParamRow> geodesic_rows() {
  using S = GeodesicSettings;
  static constexpr auto kRows =
      setting_rows(number_row<&S::cell_m>("cell_m", 0, 1e6, "m", "",
                                          "Edge of the grid cells that the front passes through: "
                                          "gaps of two stop it; 0 = 3 mean spacings"),
                   number_row<&S::max_distance_m>(
                       "max_distance_m", 0, 1e9, "m", "",
                       "The front stops here, points beyond have no value; 0 = never"),
                   string_row<&S::name>("name", "", "Name of the field of distances"));
  return kRows;
}

Cloud with_geodesic_distance(const Cloud& cloud, std::span<const uint64_t> seeds,
                             const GeodesicSettings& settings, Task& task) {
  const std::string name = require_field_name(settings.name);
  const std::vector<uint32_t> starts = checked_seeds(seeds, cloud.size());
  double cell_m = settings.cell_m, most_m = settings.max_distance_m;
  if (most_m == 0) most_m = std::numeric_limits<double>::max();
  // 1. The grid, relative to a corner that moves with the cloud.
  SurfaceCells cells;
  Buffer<double> xyz;
  {
    ProgressSpan span(task, 0, 0.5, "cells");
    if (cell_m == 0) {
      const std::vector<double> all(cloud.size(), 0);
      cell_m = radius_or_spacings(0, kFastMarchingCloudCellSpacings, cloud,
                                  valued_points(cloud, all, task));
    }
    xyz = relative_coordinates(cloud, task);
    cells = surface_cells({xyz.data(), xyz.size()}, cell_m, task);
  }
  // 2. The front.
  ProgressSpan span(task, 0.5, 1, "front");
  std::vector<double> distances =
      surface_distances({xyz.data(), xyz.size()}, cells, starts, most_m, task);
  for (double& d : distances)
    if (!std::isfinite(d)) d = kNaN;
  return with_field<double>(cloud, name, "m", "distance along the surface from the nearest seed",
                            distances);
}

}  // namespace jalon
