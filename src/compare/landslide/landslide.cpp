// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/landslide/landslide.h"

#include <cmath>

#include "base/distributions.h"
#include "base/error.h"
#include "base/numbers.h"
#include "base/table_columns.h"
#include "compare/landslide/cell_map.h"
#include "compare/landslide/cell_table.h"
#include "compare/landslide/ground_grid.h"
#include "compare/landslide/moved_zones.h"
#include "compare/landslide/surveyed_cells.h"
#include "compare/landslide/zone_measures.h"
#include "compare/summary.h"

namespace jalon {

namespace {

/// All that is known of the cells; rows: those inside.
struct Slope {
  VolumeGrid grid;
  GroundChange change;
  SurveyedCells cells;
  MovedZones zones;
  std::vector<size_t> rows;
};

// Beside ground without points a cell is seen in part, and the rest lies to one side.
double variance_of(const VolumeGrid& grid, const GroundHeights& ground, size_t cell) {
  bool is_border = false;
  for_each_around(grid, cell,
                  [&](size_t other) { is_border = is_border || std::isnan(ground.height[other]); });
  const double gap = is_border ? ground.gap_sigma[cell] : 0;
  return ground.variance[cell] + gap * gap;
}

GroundChange change_of(const VolumeGrid& grid, const SurveyedCells& cells,
                       const GroundHeights& before, const GroundHeights& after) {
  const size_t n = cells.is_inside.size();
  GroundChange out{std::vector<double>(n, kNaN), std::vector<double>(n, kNaN)};
  for (size_t cell = 0; cell < n; ++cell) {
    const double difference = after.height[cell] - before.height[cell];
    if (cells.is_inside[cell] == 0 || std::isnan(difference)) continue;
    out.difference[cell] = difference;
    out.sigma[cell] = std::sqrt(variance_of(grid, before, cell) + variance_of(grid, after, cell));
  }
  return out;
}

// Why a row has no distance: what the reference lacks comes first.
CompareStatus status_of(const Slope& slope, size_t cell) {
  const CompareStatus before = slope.cells.reference[cell];
  return before != CompareStatus::kCompared ? before : slope.cells.compared[cell];
}

CloudPtr places_of(const Slope& slope, const Cloud& reference, const Cloud& compared) {
  Buffer<double> xyz(3 * slope.rows.size());
  for (size_t i = 0; i < slope.rows.size(); ++i) {
    const Vec3 p = slope.grid.place(slope.rows[i], slope.cells.place_m[slope.rows[i]]);
    for (int a = 0; a < 3; ++a) xyz[3 * i + static_cast<size_t>(a)] = p[a];
  }
  Cloud cloud = make_cloud(std::move(xyz));
  cloud.crs = compared.crs.empty() ? reference.crs : compared.crs;
  return std::make_shared<const Cloud>(std::move(cloud));
}

FieldTable table_of(const Slope& slope, const LandslideSettings& settings,
                    const GroundHeights& before, const GroundHeights& after) {
  const auto& rows = slope.rows;
  const double quantile = normal_quantile(0.5 + settings.confidence / 2);
  const GroundErrors& errors = slope.zones.errors;
  const double shared = std::hypot(errors.systematic_m, settings.alignment_sigma_m);
  const auto sigma = [&](size_t c) { return errors.scale * slope.change.sigma[c]; };
  FieldTable table;
  add_column<double>(table, rows, "distance", "m",
                     "compared ground above the reference's, along the direction",
                     [&](size_t c) { return slope.change.difference[c]; });
  add_column<uint8_t>(table, rows, "status", "",
                      "0 measured in both epochs; else why not, of the reference first",
                      [&](size_t c) { return static_cast<uint8_t>(status_of(slope, c)); });
  add_column<double>(table, rows, "lod", "m", "level of detection",
                     [&](size_t c) { return quantile * std::hypot(sigma(c), shared); });
  add_column<uint8_t>(table, rows, "significant", "", "1 = of a zone that moved",
                      [&](size_t c) { return slope.zones.labels[c] != 0 ? 1 : 0; });
  add_column<uint32_t>(table, rows, kZoneColumn, "", "that moved, 1 = most cells; 0 = none",
                       [&](size_t c) { return slope.zones.labels[c]; });
  add_column<double>(table, rows, "sigma", "m", "of the distance, without what all cells share",
                     sigma);
  add_column<uint8_t>(table, rows, "reference_status", "",
                      "0 measured; else why the reference has no ground there",
                      [&](size_t c) { return static_cast<uint8_t>(slope.cells.reference[c]); });
  add_column<uint8_t>(table, rows, "compared_status", "",
                      "0 measured; else why the compared epoch has none",
                      [&](size_t c) { return static_cast<uint8_t>(slope.cells.compared[c]); });
  add_column<uint32_t>(table, rows, "column", "", "of the grid",
                       [&](size_t c) { return slope.grid.column_of(c); });
  add_column<uint32_t>(table, rows, "row", "", "of the grid",
                       [&](size_t c) { return slope.grid.row_of(c); });
  add_column<uint32_t>(table, rows, "reference_points", "", "points of the reference",
                       [&](size_t c) { return before.points[c]; });
  add_column<uint32_t>(table, rows, "compared_points", "", "points of the compared epoch",
                       [&](size_t c) { return after.points[c]; });
  return table;
}

void add_vector(FieldTable& table, const char* name, const char* unit, const char* meaning,
                const Vec3& v) {
  const Vec3 one[] = {v};
  add_columns<double, 3>(table, one, name, unit, meaning, [](const Vec3& p, double* out) {
    for (int k = 0; k < 3; ++k) out[k] = p[k];
  });
}

// What the zones' measures, the outlines and the report need to know of the grid and of the errors.
void add_frame(FieldTable& summary, const Slope& slope, const LandslideSettings& settings) {
  const VolumeGrid& grid = slope.grid;
  uint64_t significant = 0, compared = 0;
  double lod = 0;
  const double quantile = normal_quantile(0.5 + settings.confidence / 2);
  const GroundErrors& errors = slope.zones.errors;
  const double shared = std::hypot(errors.systematic_m, settings.alignment_sigma_m);
  for (const size_t cell : slope.rows) {
    significant += slope.zones.labels[cell] != 0 ? 1 : 0;
    if (!slope.change.is_measured(cell)) continue;
    ++compared;
    lod += quantile * std::hypot(errors.scale * slope.change.sigma[cell], shared);
  }
  add_value<uint64_t>(summary, "significant", "", "cells of zones that moved", significant);
  add_value<double>(summary, "mean_lod", "m", "mean level of detection of the measured cells",
                    compared > 0 ? lod / static_cast<double>(compared) : kNaN);
  add_value<double>(summary, "cell", "m", "side of the cells", grid.cell_m);
  add_value<double>(summary, "sigma_scale", "1",
                    "by which ground at rest differs more than its points scatter", errors.scale);
  add_value<double>(summary, "systematic", "m",
                    "standard deviation of what whole blocks of cells are off, as ground at rest "
                    "shows, with that of the alignment",
                    shared);
  add_vector(summary, "direction", "", "along which movements are counted", grid.up);
  add_vector(summary, "along_columns", "", "from column to column", grid.u);
  add_vector(summary, "first_cell", "m", "centre of column 0 and row 0", grid.place(0, 0));
}

}  // namespace

Comparison compare_landslide(const CloudPtr& reference, const CloudPtr& compared,
                             const LandslideSettings& settings, Task& task) {
  if (reference->size() == 0) fail(Status::kInsufficientData, "the reference cloud is empty");
  if (compared->size() == 0) fail(Status::kInsufficientData, "the compared cloud is empty");
  settings.check();
  Slope slope;
  {
    const ProgressSpan span(task, 0, 0.2, "cells across the slope");
    slope.grid = ground_grid(*reference, *compared, settings, task);
  }
  const auto heights = [&](const Cloud& cloud, double from, double to) {
    const ProgressSpan span(task, from, to, "ground of the cells");
    return ground_heights(cloud, slope.grid, settings.min_points, task);
  };
  const GroundHeights before = heights(*reference, 0.2, 0.45),
                      after = heights(*compared, 0.45, 0.7);
  {
    const ProgressSpan span(task, 0.7, 0.9);
    slope.cells = surveyed_cells(slope.grid, before, after, reference, compared, settings, task);
  }
  const ProgressSpan span(task, 0.9, 1, "zones that moved");
  slope.change = change_of(slope.grid, slope.cells, before, after);
  slope.zones = moved_zones(slope.grid, slope.change, settings, task);
  for (size_t cell = 0; cell < slope.grid.cells(); ++cell)
    if (slope.cells.is_inside[cell] != 0 && !std::isnan(slope.cells.place_m[cell]))
      slope.rows.push_back(cell);
  if (slope.rows.empty())
    fail(Status::kInsufficientData,
         "no cell of either epoch has ground: take a larger cell_m, or fewer min_points");
  Comparison made;
  made.cloud = places_of(slope, *reference, *compared);
  made.points = table_of(slope, settings, before, after);
  made.summary = summarise(made.points.require("distance").values<double>(),
                           made.points.require("status").values<uint8_t>(), task);
  add_frame(made.summary, slope, settings);
  add_totals(made);
  return made;
}

}  // namespace jalon
