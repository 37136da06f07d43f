// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/plane/spacing.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "modelling/plane/cell_rows.h"

namespace jalon {

namespace {

constexpr size_t kSamples = 1000;
constexpr size_t kNeighbours = 8;
constexpr double kStepsPerOctave = 8;
constexpr double kSpacingQuantile = 0.75;
// k points in a disc of radius d take pi d^2 / k each: spacing = sqrt(pi / 8) d.
constexpr double kSpacingOfRadius = 0.62665706865775006;
static_assert(kNeighbours == 8);

// Squared distance to the 8th neighbour of p, looking at most reach cells away; infinity when there are fewer.
double eighth_neighbour(std::span<const Vec2> points, const CellRows& rows, const Vec2& p,
                        uint64_t reach) {
  std::array<double, kNeighbours + 1> best;  // p itself is among them
  best.fill(INFINITY);
  const uint64_t key = rows.key_of(p), row = key >> 32, column = key & 0xffffffffu;
  for (uint64_t r = row > reach ? row - reach : 0; r <= row + reach; ++r) {
    const uint64_t from = r << 32 | (column > reach ? column - reach : 0),
                   to = r << 32 | (column + reach);
    auto cell = static_cast<size_t>(std::lower_bound(rows.keys.begin(), rows.keys.end(), from) -
                                    rows.keys.begin());
    for (; cell < rows.keys.size() && rows.keys[cell] <= to; ++cell)
      for (uint32_t k = rows.first[cell]; k < rows.first[cell + 1]; ++k) {
        const Vec2 d = points[rows.order[k]] - p;
        const double squared = dot(d, d);
        if (squared >= best.back()) continue;
        *std::prev(best.end()) = squared;
        for (size_t i = best.size() - 1; i > 0 && best[i] < best[i - 1]; --i)
          std::swap(best[i], best[i - 1]);
      }
  }
  return best.back();
}

}  // namespace

double typical_spacing(std::span<const Vec2> points, Task& task) {
  if (points.size() <= kNeighbours) return 0;
  Vec2 low = points.front(), high = points.front();
  for (const Vec2& p : points) {
    low = {std::min(low.u, p.u), std::min(low.v, p.v)};
    high = {std::max(high.u, p.u), std::max(high.v, p.v)};
  }
  const double n = static_cast<double>(points.size());
  const double du = high.u - low.u, dv = high.v - low.v;
  // Cells of about four points if the points filled their box; a narrow or sparse segment has fuller cells.
  const double cell = std::max(2 * std::sqrt(du * dv / n), 2 * std::max(du, dv) / n);
  if (!(cell > 0)) return 0;
  const CellRows rows = sort_into_cells(points, cell, task);
  const size_t step = (points.size() + kSamples - 1) / kSamples;
  std::vector<double> spacings;
  for (size_t i = 0; i < points.size(); i += step) {
    if (spacings.size() % 64 == 0) task.checkpoint(0);
    double squared = INFINITY;
    for (uint64_t reach = 1; reach <= 16 && !std::isfinite(squared); reach *= 4) {
      squared = eighth_neighbour(points, rows, points[i], reach);
      const double safe = static_cast<double>(reach) *
                          rows.cell_m;  // nothing nearer lies beyond the cells looked at
      if (squared > safe * safe) squared = INFINITY;
    }
    if (std::isfinite(squared)) spacings.push_back(kSpacingOfRadius * std::sqrt(squared));
  }
  if (spacings.empty()) return 0;
  const auto at =
      spacings.begin() +
      static_cast<ptrdiff_t>(kSpacingQuantile * static_cast<double>(spacings.size() - 1));
  std::nth_element(spacings.begin(), at, spacings.end());
  return *at;
}

double stepped_length(double length_m) {
  if (!(length_m > 0)) return 0;
  return std::exp2(std::round(kStepsPerOctave * std::log2(length_m)) / kStepsPerOctave);
}

}  // namespace jalon
