// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/distance/part_statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/numbers.h"
#include "base/table_columns.h"

namespace jalon {

namespace {

constexpr size_t kStep = 1 << 16;  // points between two looks at the task, about 1 ms

struct PartSums {
  uint64_t points = 0, within = 0;
  double sum = 0, mean = kNaN, squares = 0;
  double least = std::numeric_limits<double>::infinity(),
         most = -std::numeric_limits<double>::infinity();

  double or_nan(double value) const { return points > 0 ? value : kNaN; }
};

/// In the order of the points, by one thread: there may be as many parts as points.
template <class F>
void for_each_of_a_part(std::span<const double> distances, std::span<const uint32_t> parts,
                        std::vector<PartSums>& sums, Task& task, F&& f) {
  for (size_t begin = 0; begin < distances.size(); begin += kStep) {
    task.checkpoint(static_cast<double>(begin) / static_cast<double>(distances.size()));
    for (size_t i = begin; i < std::min(distances.size(), begin + kStep); ++i)
      if (parts[i] < sums.size() && !std::isnan(distances[i])) f(sums[parts[i]], distances[i]);
  }
}

}  // namespace

FieldTable part_statistics(std::span<const double> distances, std::span<const uint32_t> parts,
                           size_t part_count, double tolerance_m, Task& task) {
  std::vector<PartSums> sums(part_count);
  for_each_of_a_part(distances, parts, sums, task, [&](PartSums& s, double d) {
    ++s.points;
    s.sum += d;
    s.within += std::abs(d) <= tolerance_m ? 1 : 0;
    s.least = std::min(s.least, d);
    s.most = std::max(s.most, d);
  });
  for (PartSums& s : sums) s.mean = s.sum / static_cast<double>(s.points);
  // Second pass about the mean: the squares of large distances would take the digits of a small spread.
  for_each_of_a_part(distances, parts, sums, task,
                     [](PartSums& s, double d) { s.squares += (d - s.mean) * (d - s.mean); });
  FieldTable table;
  uint32_t row = 0;
  add_column<uint32_t>(table, sums, "part", "", "row of the model's parts",
                       [&](const PartSums&) { return row++; });
  add_column<uint64_t>(table, sums, "points", "", "points whose nearest surface is of the part",
                       [](const PartSums& s) { return s.points; });
  add_column<double>(table, sums, "mean", "m", "mean distance",
                     [](const PartSums& s) { return s.mean; });
  add_column<double>(
      table, sums, "sigma", "m", "standard deviation about the mean", [](const PartSums& s) {
        return s.points > 1 ? std::sqrt(s.squares / static_cast<double>(s.points - 1)) : kNaN;
      });
  add_column<double>(table, sums, "minimum", "m", "least distance",
                     [](const PartSums& s) { return s.or_nan(s.least); });
  add_column<double>(table, sums, "maximum", "m", "largest distance",
                     [](const PartSums& s) { return s.or_nan(s.most); });
  add_column<double>(
      table, sums, "maximum_absolute", "m", "largest distance on either side",
      [](const PartSums& s) { return s.or_nan(std::max(std::abs(s.least), std::abs(s.most))); });
  if (!(tolerance_m > 0)) return table;
  add_column<uint64_t>(table, sums, "within_tolerance", "",
                       "points at most tolerance_m from the model",
                       [](const PartSums& s) { return s.within; });
  add_column<double>(
      table, sums, "tolerance_share", "1", "share of the points within tolerance_m",
      [](const PartSums& s) {
        return s.or_nan(static_cast<double>(s.within) / static_cast<double>(s.points));
      });
  return table;
}

}  // namespace jalon
