// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/volumes/volume.h"

#include <cmath>

#include "base/error.h"
#include "base/numbers.h"
#include "base/parallel.h"
#include "base/setting_rows.h"
#include "base/table_columns.h"

namespace jalon {

namespace {

constexpr size_t kVolumeGrain = 1 << 15;
constexpr double kSpacings = 3;  // of the thinner cloud: nine points a cell on the average

using S = VolumeSettings;

constexpr auto kRows = setting_rows(
    doubles_row<&S::direction>(
        "direction", -1e9, 1e9, "", "",
        "Three numbers: the direction along which heights are counted, upward."),
    number_row<&S::cell_m>(
        "cell_m", 0, 1e6, "m", "",
        "Side of the cells; 0 = three mean spacings of the thinner cloud, of models a 500th of "
        "their extent."),
    choice_row<&S::cell_value>(
        "cell_value", "mean|median|interpolated", "",
        "Of a cloud: height of a cell from its points, or at its centre from the plane through "
        "its points and those of the eight cells around, which also fills single gaps."),
    number_row<&S::dead_band_m>(
        "dead_band_m", 0, 1e6, "m", "",
        "Cells whose height changed by no more count neither as cut nor as fill: noise else adds "
        "to both."),
    choice_row<&S::surfaces>(
        "surfaces", "automatic|closed|prisms", "",
        "Of models: the volume that each encloses, or prisms between both; automatic = closed if "
        "both are."));

Box3 projected_box(const Cloud& cloud, const VolumeGrid& grid, Task& task) {
  return parallel_reduce(task, cloud.size(), kVolumeGrain, Box3{}, [&](size_t begin, size_t end) {
    Box3 box;
    for (size_t i = begin; i < end; ++i) box.add(grid.project(cloud.point(i)));
    return box;
  });
}

/// Mean spacing if the points covered their box.
double spacing_of(const Box3& box, size_t points) {
  const double area = (box.max.x - box.min.x) * (box.max.y - box.min.y);
  return std::sqrt(area / static_cast<double>(points));
}

double chosen_cell(double cell_m, double automatic_m) {
  if (cell_m > 0) return cell_m;
  return automatic_m > 0 ? automatic_m : 1;  // points on a line, or one point
}

enum CellStatus : uint8_t { kBoth = 0, kNoReference = 1, kNoCompared = 2, kNeither = 3 };

uint8_t status_of(double reference, double compared) {
  return static_cast<uint8_t>((std::isnan(reference) ? 1 : 0) + (std::isnan(compared) ? 2 : 0));
}

struct Totals {
  double cut = 0, fill = 0, cut_cells = 0, fill_cells = 0, variance = 0, sum = 0;
  uint64_t of_status[4] = {0, 0, 0, 0};

  void add(double difference, double height_variance, double dead_band) {
    sum += difference;
    variance += height_variance;
    if (!(std::abs(difference) > dead_band)) return;
    (difference < 0 ? cut : fill) += std::abs(difference);
    (difference < 0 ? cut_cells : fill_cells) += 1;
  }
  Totals& operator+=(const Totals& t) {
    cut += t.cut;
    fill += t.fill;
    cut_cells += t.cut_cells;
    fill_cells += t.fill_cells;
    variance += t.variance;
    sum += t.sum;
    for (int i = 0; i < 4; ++i) of_status[i] += t.of_status[i];
    return *this;
  }
};

FieldTable summary_of(const Totals& t, const VolumeGrid& grid) {
  const double area = grid.cell_m * grid.cell_m, both = static_cast<double>(t.of_status[kBoth]);
  FieldTable table;
  add_value<double>(table, "cut", "m3", "what the reference has above the compared state",
                    t.cut * area);
  add_value<double>(table, "fill", "m3", "what the compared state has above the reference",
                    t.fill * area);
  add_value<double>(table, "net", "m3", "fill less cut", (t.fill - t.cut) * area);
  add_value<double>(table, "sigma", "m3",
                    "standard deviation of the net volume from the scatter within the cells",
                    std::sqrt(t.variance) * area);
  add_value<double>(table, "area", "m2", "of the cells that both have data in", both * area);
  add_value<double>(table, "cut_area", "m2", "of the cells that were cut", t.cut_cells * area);
  add_value<double>(table, "fill_area", "m2", "of the cells that were filled", t.fill_cells * area);
  add_value<double>(table, "mean_difference", "m", "mean change of height",
                    both > 0 ? t.sum / both : kNaN);
  add_value<double>(table, "cell", "m", "side of the cells", grid.cell_m);
  add_value<uint64_t>(table, "cells", "", "cells that both have data in", t.of_status[kBoth]);
  add_value<uint64_t>(table, "without_reference", "", "cells that the reference has no data in",
                      t.of_status[kNoReference]);
  add_value<uint64_t>(table, "without_compared", "", "cells that the compared state has no data in",
                      t.of_status[kNoCompared]);
  add_value<uint64_t>(table, "without_data", "", "cells of the rectangle that neither has data in",
                      t.of_status[kNeither]);
  return table;
}

FieldTable table_of_cells(const VolumeGrid& grid, const CellHeights& reference,
                          const CellHeights& compared) {
  std::vector<size_t> cells;
  for (size_t c = 0; c < grid.cells(); ++c)
    if (status_of(reference.height[c], compared.height[c]) != kNeither) cells.push_back(c);
  FieldTable table;
  const double area = grid.cell_m * grid.cell_m;
  const auto difference = [&](size_t c) { return compared.height[c] - reference.height[c]; };
  add_column<uint32_t>(table, cells, "column", "", "of the grid",
                       [&](size_t c) { return grid.column_of(c); });
  add_column<uint32_t>(table, cells, "row", "", "of the grid",
                       [&](size_t c) { return grid.row_of(c); });
  add_columns<double, 3>(
      table, cells, "xyz", "m", "centre of the cell at the height of the state that has data there",
      [&](size_t c, double* out) {
        const bool seen = !std::isnan(compared.height[c]);
        const Vec3 at = grid.place(c, seen ? compared.height[c] : reference.height[c]);
        for (int a = 0; a < 3; ++a) out[a] = at[a];
      });
  add_column<uint8_t>(table, cells, "status", "",
                      "0 both have data, 1 the reference has none, 2 the compared state has none",
                      [&](size_t c) { return status_of(reference.height[c], compared.height[c]); });
  add_column<double>(table, cells, "difference", "m",
                     "height of the compared state above the reference", difference);
  add_column<double>(table, cells, "volume", "m3", "difference times the area of the cell",
                     [&](size_t c) { return difference(c) * area; });
  add_column<uint32_t>(table, cells, "reference_points", "", "points of the reference",
                       [&](size_t c) { return reference.points[c]; });
  add_column<uint32_t>(table, cells, "compared_points", "", "points of the compared state",
                       [&](size_t c) { return compared.points[c]; });
  return table;
}

}  // namespace

std::span<const ParamRow> volume_rows() { return kRows; }

Volume sum_up_volume(const VolumeGrid& grid, const CellHeights& reference,
                     const CellHeights& compared, double dead_band_m, Task& task) {
  Totals totals =
      parallel_reduce(task, grid.cells(), kVolumeGrain, Totals{}, [&](size_t begin, size_t end) {
        Totals part;
        for (size_t c = begin; c < end; ++c) {
          const uint8_t status = status_of(reference.height[c], compared.height[c]);
          ++part.of_status[status];
          if (status == kBoth)
            part.add(compared.height[c] - reference.height[c],
                     reference.variance[c] + compared.variance[c], dead_band_m);
        }
        return part;
      });
  totals.of_status[kNeither] += grid.all_cells() - grid.cells();
  return {summary_of(totals, grid), table_of_cells(grid, reference, compared)};
}

Volume volume_between(const Cloud& reference, const Cloud& compared, const VolumeSettings& settings,
                      Task& task) {
  if (reference.size() == 0) fail(Status::kInsufficientData, "the reference cloud is empty");
  if (compared.size() == 0) fail(Status::kInsufficientData, "the compared cloud is empty");
  const VolumeGrid axes =
      volume_axes(bounds(reference, task), bounds(compared, task), settings.direction);
  const Box3 first = projected_box(reference, axes, task),
             second = projected_box(compared, axes, task);
  const double spacing =
      std::max(spacing_of(first, reference.size()), spacing_of(second, compared.size()));
  Box3 both = first;
  both += second;
  const double cell_m = chosen_cell(settings.cell_m, kSpacings * spacing);
  const VolumeGrid grid =
      without_empty_blocks(grid_over(axes, both, cell_m), reference, compared, task);
  const CellHeights before = cloud_heights(reference, grid, settings.cell_value, task);
  const CellHeights after = cloud_heights(compared, grid, settings.cell_value, task);
  return sum_up_volume(grid, before, after, settings.dead_band_m, task);
}

}  // namespace jalon
