// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "base/random.h"
#include "cloud/cloud.h"
#include "compare/landslide/landslide.h"
#include "compare/volumes/volume_grid.h"

namespace jalon::test {

constexpr double kSlopeNoise_m = 0.01, kScar_m = 0.5;

/// A slope of 40 x 30 m; after, a box of 8 x 6 m has gone down by kScar_m and one of 8 x 4 m below it has risen by half
/// as much.
inline double slope_ground(double x, double y, bool after) {
  const bool scar = x > 16 && x < 24 && y > 18 && y<24, toe = x> 16 && x < 24 && y > 8 && y < 12;
  return 100 + 0.3 * y + 0.05 * x + (after ? (toe ? kScar_m / 2 : 0) - (scar ? kScar_m : 0) : 0);
}
constexpr double kScar_m3 = 8 * 6 * kScar_m, kToe_m3 = 8 * 4 * kScar_m / 2;

inline CloudPtr cloud_of_points(const std::vector<Vec3>& points) {
  Buffer<double> xyz(3 * points.size());
  for (size_t i = 0; i < points.size(); ++i)
    for (int a = 0; a < 3; ++a) xyz[3 * i + static_cast<size_t>(a)] = points[i][a];
  return std::make_shared<const Cloud>(make_cloud(std::move(xyz)));
}

/// Without points where gap says so.
template <class Gap>
CloudPtr slope_survey(bool after, uint64_t seed, size_t points, Gap&& gap) {
  RandomStream random(seed, 77);
  std::vector<Vec3> out;
  while (out.size() < points) {
    const double x = 40 * random.uniform(), y = 30 * random.uniform();
    const double z = slope_ground(x, y, after) + kSlopeNoise_m * random.normal();
    if (!gap(x, y)) out.push_back({x, y, z});
  }
  return cloud_of_points(out);
}
inline CloudPtr slope_survey(bool after, uint64_t seed, size_t points = 60000) {
  return slope_survey(after, seed, points, [](double, double) { return false; });
}

inline Comparison compared_slopes(const CloudPtr& before, const CloudPtr& after,
                                  LandslideSettings settings = {}) {
  Task task;
  if (settings.cell_m == 0) settings.cell_m = 1;
  return compare_landslide(before, after, settings, task);
}
inline double summed(const Comparison& comparison, const char* name) {
  return comparison.summary.require(name).number(0);
}

/// A grid of square cells of 1 m from the origin.
inline VolumeGrid plain_grid(uint32_t columns, uint32_t rows) {
  VolumeGrid grid;
  grid.columns = columns;
  grid.rows = rows;
  return grid;
}

}  // namespace jalon::test
