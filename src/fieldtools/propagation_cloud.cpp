// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/error.h"
#include "base/numbers.h"
#include "base/parallel.h"
#include "base/serial.h"
#include "base/setting_rows.h"
#include "base/table_columns.h"
#include "fieldtools/field_values.h"
#include "fieldtools/propagation.h"
#include "fieldtools/two_means.h"
#include "spatial/union_find.h"

namespace jalon {

namespace {

constexpr double kPropagationCloudCellSpacings =
    3;  // some nine points a cell: means of gradients, and cells that touch
constexpr size_t kPropagationCloudGrain = 1 << 12;
constexpr size_t kPropagationPointsPerLook = 1 << 16, kArrivalsPerLook = 1 << 12;

/// The points that have both values.
struct Nodes {
  std::vector<uint32_t> points;    ///< index in the cloud
  std::vector<double> deviations;  ///< one a point of these
  Buffer<double> xyz;              ///< relative to a corner that moves with the cloud
  SurfaceCells cells;
  std::vector<double> gradient;   ///< one a cell: mean of its points
  std::vector<uint32_t> cell_of;  ///< one a point of these
};

Nodes nodes_of(const Cloud& cloud, std::span<const double> deviations,
               std::span<const double> gradients, double cell_m, Task& task) {
  Nodes out;
  std::vector<double> both(deviations.begin(), deviations.end());
  serial_for(task, both.size(), kPropagationPointsPerLook, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      if (!std::isfinite(gradients[i])) both[i] = kNaN;
      if (!std::isfinite(both[i])) continue;
      out.points.push_back(static_cast<uint32_t>(i));
      out.deviations.push_back(both[i]);
    }
  });
  if (out.points.empty())
    fail(Status::kInsufficientData, "no point has both a deviation and a gradient");
  if (cell_m == 0)
    cell_m = radius_or_spacings(0, kPropagationCloudCellSpacings, cloud,
                                valued_points(cloud, both, task));
  const Buffer<double> all = relative_coordinates(cloud, task);
  out.xyz = Buffer<double>(3 * out.points.size());
  parallel_for(task, out.points.size(), kPropagationPointsPerLook, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i)
      std::copy_n(all.data() + 3 * size_t{out.points[i]}, 3, out.xyz.data() + 3 * i);
  });
  out.cells = surface_cells({out.xyz.data(), out.xyz.size()}, cell_m, task);
  out.gradient.resize(out.cells.size());
  out.cell_of.resize(out.points.size());
  parallel_for(task, out.cells.size(), kPropagationCloudGrain, [&](size_t begin, size_t end) {
    for (size_t c = begin; c < end; ++c) {
      const auto members = out.cells.points(static_cast<uint32_t>(c));
      double sum = 0;
      for (const uint32_t i : members) {
        sum += gradients[out.points[i]];
        out.cell_of[i] = static_cast<uint32_t>(c);
      }
      out.gradient[c] = sum / static_cast<double>(members.size());
    }
  });
  return out;
}

/// Steps (1) to (5): fronts from the largest deviations that are left.
struct Found {
  FrontRegion front;
  uint32_t seed;  ///< among the nodes' points
  uint64_t points = 0;
};
std::vector<Found> all_fronts(const Nodes& nodes, const PropagationSettings& settings,
                              double minimum_seed, Task& task) {
  std::vector<uint32_t> order;
  serial_for(task, nodes.points.size(), kPropagationPointsPerLook, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i)
      if (nodes.deviations[i] >= minimum_seed) order.push_back(static_cast<uint32_t>(i));
  });
  const auto higher = [&](uint32_t a, uint32_t b) {
    return nodes.deviations[a] != nodes.deviations[b] ? nodes.deviations[a] > nodes.deviations[b]
                                                      : a < b;
  };
  {
    ProgressSpan span(task, 0, 0.2);
    order = sorted_in_chunks(std::move(order), higher, task);
  }
  ProgressSpan span(task, 0.2, 1);
  Propagation propagation(nodes.cells, nodes.gradient, settings);
  std::vector<Found> out;
  size_t taken = 0;  // cells
  for (size_t k = 0; k < order.size(); ++k) {
    const uint32_t seed = order[k];
    if (k % kPropagationPointsPerLook == 0) task.checkpoint(0);
    if (propagation.is_taken(nodes.cell_of[seed])) continue;
    ProgressSpan front(task, static_cast<double>(taken) / static_cast<double>(nodes.cells.size()),
                       1);
    task.checkpoint(0);
    Found found{propagation.spread(nodes.cell_of[seed], task), seed};
    for (const Arrival& a : found.front.arrivals) found.points += nodes.cells.points(a.cell).size();
    taken += found.front.arrivals.size();
    out.push_back(std::move(found));
  }
  return out;
}

FieldTable region_table(const std::vector<const Found*>& rows, const Nodes& nodes) {
  FieldTable t;
  using Row = const Found*;
  uint32_t label = 0;
  add_column<uint32_t>(t, rows, "label", "", "number of the region", [&](Row) { return ++label; });
  add_column<uint64_t>(t, rows, "points", "points", "of the region",
                       [](Row r) { return r->points; });
  add_column<uint64_t>(t, rows, "cells", "", "of the region",
                       [](Row r) { return r->front.arrivals.size(); });
  add_column<uint64_t>(t, rows, "seed", "", "index of the point that it grew from",
                       [&](Row r) { return nodes.points[r->seed]; });
  add_column<double>(t, rows, "seed_deviation", "", "deviation there",
                     [&](Row r) { return nodes.deviations[r->seed]; });
  add_column<double>(t, rows, "last_arrival", "m", "arrival time of its last cell",
                     [](Row r) { return r->front.arrivals.back().time_m; });
  add_column<double>(t, rows, "next_arrival", "m",
                     "of the cell that the front ended at; infinite = none was left",
                     [](Row r) { return r->front.next_time_m; });
  return t;
}

}  // namespace

std::span<const ParamRow> propagation_rows() {
  using S = PropagationSettings;
  static constexpr auto kRows = setting_rows(
      number_row<&S::cell_m>(
          "cell_m", 0, 1e6, "m", "",
          "Edge of the grid cells that fronts pass through; 0 = 3 mean spacings"),
      number_row<&S::alpha>("alpha", 0, 1e4, "1", "",
                            "Speed from cell i to cell j is exp(alpha (g_j - g_i)), g = gradient: "
                            "up the gradient fast, down slow"),
      choice_row<&S::scope>("scope", "front|step", "",
                            "front: a front ends where its next arrival takes too long; step: only "
                            "the step from cell to cell that would take too long is barred"),
      number_row<&S::jump>("jump", 0, 1e300, "1", "",
                           "What takes too long, in steps of one cell at speed 1; small values are "
                           "strict: pieces, no leaks"),
      number_row<&S::minimum_seed>(
          "minimum_seed", 0, 1e300, "", "",
          "Deviations below it start no front; 0 = the cut of two means of the deviations"),
      integer_row<&S::min_points>("min_points", 1, 1e15, "points", "",
                                  "Regions of fewer points get the number 0"),
      string_row<&S::name>("name", "", "Name of the field of region numbers"),
      string_row<&S::arrival_name>("arrival_name", "",
                                   "Name of a field of arrival times; empty = none"));
  return kRows;
}

PropagationResult segment_by_propagation(const Cloud& cloud, std::span<const double> deviations,
                                         std::span<const double> gradients,
                                         const PropagationSettings& settings, Task& task) {
  PropagationResult out;
  Nodes nodes;
  {
    ProgressSpan span(task, 0, 0.4, "cells");
    nodes = nodes_of(cloud, deviations, gradients, settings.cell_m, task);
    out.minimum_seed = settings.minimum_seed;
    if (out.minimum_seed == 0)
      out.minimum_seed = two_means(sorted_values(nodes.deviations, task)).cut;
  }
  ProgressSpan span(task, 0.4, 1, "propagation");
  const std::vector<Found> found = all_fronts(nodes, settings, out.minimum_seed, task);
  std::vector<uint64_t> sizes;
  for (const Found& f : found) sizes.push_back(f.points);
  const std::vector<uint32_t> ranks = ranks_by_size(sizes);
  out.labels.assign(cloud.size(), 0);
  out.arrival_m.assign(cloud.size(), kNaN);
  std::vector<const Found*> rows;
  for (size_t f = 0; f < found.size(); ++f) {
    if (found[f].points < settings.min_points) continue;
    if (rows.size() < ranks[f]) rows.resize(ranks[f]);
    rows[ranks[f] - 1] = &found[f];
    const auto& arrivals = found[f].front.arrivals;
    serial_for(task, arrivals.size(), kArrivalsPerLook, [&](size_t begin, size_t end) {
      for (const Arrival& a : std::span(arrivals).subspan(begin, end - begin))
        for (const uint32_t i : nodes.cells.points(a.cell)) {
          out.labels[nodes.points[i]] = ranks[f];
          out.arrival_m[nodes.points[i]] = a.time_m;
        }
    });
  }
  out.regions = region_table(rows, nodes);
  return out;
}

}  // namespace jalon
