// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/edges/adjust/bar_edge.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace jalon {

namespace {

constexpr size_t kLeastColumns = 6;
constexpr double kStrays = 0.04;  // share of columns that noise lets end beyond the edge: of 25 one
constexpr double kMostGap = 2.5;  // spacings from row to row
constexpr double kEven = 12;      // variance of what is spread evenly: its range squared over this

/// The highest point of a column and the widest gap between two of its points, 0 with one alone.
struct BarColumn {
  double top = 0, gap_m = 0;
};

std::vector<BarColumn> columns_of(std::span<const Vec2> points, double width_m) {
  std::vector<std::pair<int64_t, double>> order;
  for (const Vec2& p : points)
    order.emplace_back(static_cast<int64_t>(std::floor(p.u / width_m)), p.v);
  std::sort(order.begin(), order.end());
  std::vector<BarColumn> out;
  for (size_t i = 0; i < order.size(); ++i) {
    const bool is_new = i == 0 || order[i].first != order[i - 1].first;
    if (is_new) out.emplace_back();
    BarColumn& column = out.back();
    if (!is_new) column.gap_m = std::max(column.gap_m, order[i].second - order[i - 1].second);
    column.top = order[i].second;
  }
  return out;
}

/// The distance of rows: the middle one of the columns' gaps.
double row_distance(std::span<const BarColumn> columns, double most_m) {
  std::vector<double> gaps;
  for (const BarColumn& c : columns)
    if (c.gap_m > 0 && c.gap_m <= most_m) gaps.push_back(c.gap_m);
  if (gaps.empty()) return most_m / 2;
  const auto middle = gaps.begin() + static_cast<ptrdiff_t>(gaps.size() / 2);
  std::nth_element(gaps.begin(), middle, gaps.end());
  return *middle;
}

}  // namespace

std::optional<BarEdge> upper_edge(std::span<const Vec2> points, double spacing_m, double sigma_m) {
  // 1. Columns a spacing wide and where they end.
  const std::vector<BarColumn> columns = columns_of(points, spacing_m);
  if (columns.size() < kLeastColumns) return {};
  const double row_m = row_distance(columns, kMostGap * spacing_m);
  std::vector<double> tops;
  for (const BarColumn& c : columns) tops.push_back(c.top);
  std::sort(tops.begin(), tops.end());
  // 2. The edge lies above all of them, and below the first that a row more would take beyond the highest. Columns that
  // end lower still are cut short by something else.
  const auto whole = static_cast<double>(
      tops.end() - std::upper_bound(tops.begin(), tops.end(), tops.back() - row_m));
  const double low = tops[tops.size() - 1 - static_cast<size_t>(kStrays * whole)];
  const double next = *std::upper_bound(tops.begin(), tops.end(), low - row_m);
  const double high = std::max(low, std::min(next, low) + row_m);
  const double open_m = high - low;
  return BarEdge{(low + high) / 2, std::sqrt(open_m * open_m / kEven + sigma_m * sigma_m)};
}

}  // namespace jalon
