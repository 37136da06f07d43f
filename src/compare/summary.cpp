// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/summary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/numbers.h"
#include "base/parallel.h"
#include "base/table_columns.h"
#include "compare/comparison.h"

namespace jalon {

namespace {

constexpr size_t kGrain = 1 << 15;

struct Sums {
  std::array<uint64_t, kCompareStatuses> of_status{};
  double sum = 0, squares = 0;
  double least = std::numeric_limits<double>::infinity(),
         most = -std::numeric_limits<double>::infinity();

  void add(double distance, uint8_t status) {
    ++of_status[status];
    if (status != static_cast<uint8_t>(CompareStatus::kCompared)) return;
    sum += distance;
    squares += distance * distance;
    least = std::min(least, distance);
    most = std::max(most, distance);
  }
  Sums& operator+=(const Sums& other) {
    for (size_t i = 0; i < kCompareStatuses; ++i) of_status[i] += other.of_status[i];
    sum += other.sum;
    squares += other.squares;
    least = std::min(least, other.least);
    most = std::max(most, other.most);
    return *this;
  }
};

void add_counts(FieldTable& table, const Sums& sums, size_t points) {
  constexpr const char* kNames[kCompareStatuses] = {
      "compared", "hidden", "out_of_range", "out_of_field", "nothing_near", "too_few_points"};
  add_value<uint64_t>(table, "points", "", "points that were to be compared", points);
  for (size_t i = 0; i < kCompareStatuses; ++i)
    add_value<uint64_t>(table, kNames[i], "", "points with this status", sums.of_status[i]);
}

}  // namespace

FieldTable summarise(std::span<const double> distances, std::span<const uint8_t> statuses,
                     Task& task) {
  const Sums sums =
      parallel_reduce(task, distances.size(), kGrain, Sums{}, [&](size_t begin, size_t end) {
        Sums part;
        for (size_t i = begin; i < end; ++i) part.add(distances[i], statuses[i]);
        return part;
      });
  const auto n = static_cast<double>(sums.of_status[0]);
  const double nan = kNaN;
  const double mean = n > 0 ? sums.sum / n : nan;
  // Second pass about the mean: the squares of large distances would take the digits of a small spread.
  const double squares =
      parallel_reduce(task, distances.size(), kGrain, 0.0, [&](size_t begin, size_t end) {
        double part = 0;
        for (size_t i = begin; i < end; ++i)
          if (statuses[i] == 0) part += (distances[i] - mean) * (distances[i] - mean);
        return part;
      });
  FieldTable table;
  add_counts(table, sums, distances.size());
  add_value<double>(table, "mean", "m", "mean distance of the compared points", mean);
  add_value<double>(table, "rms", "m", "root mean square distance",
                    n > 0 ? std::sqrt(sums.squares / n) : nan);
  add_value<double>(table, "sigma", "m", "standard deviation about the mean",
                    n > 1 ? std::sqrt(squares / (n - 1)) : nan);
  add_value<double>(table, "minimum", "m", "least distance", n > 0 ? sums.least : nan);
  add_value<double>(table, "maximum", "m",
                    "largest distance: the directed Hausdorff distance of unsigned distances",
                    n > 0 ? sums.most : nan);
  return table;
}

}  // namespace jalon
