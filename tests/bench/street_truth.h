// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <map>
#include <vector>

#include "street_points.h"

namespace bench {

constexpr double kWidestReveal_m = 0.25;

/// The true planes that a segmentation must find, as rows of seven numbers: unit normal, a point of the plane in the
/// middle of its samples, how many those are. Ground, walls, glass and boxes, 28 in all; not the 288 reveals, which
/// are a hand wide.
inline std::vector<double> true_planes(const Street& street, const std::vector<Sample>& samples) {
  struct Sum {
    Vec normal, points;
    double count = 0, widest_m = 0;
  };
  std::map<uint32_t, Sum> sums;
  for (const Sample& sample : samples) {
    if (sample.surface == kOutlier || street.surfaces[sample.surface].plane == 0) continue;
    const Surface& surface = street.surfaces[sample.surface];
    const Vec normal = cross(surface.u, surface.v);
    Sum& sum = sums[surface.plane];
    sum.normal = normal;
    sum.points = sum.points + sample.point - normal * dot(sample.point - surface.origin, normal);
    sum.count += 1;
    sum.widest_m = std::max(sum.widest_m, std::min(surface.length_u, surface.length_v));
  }
  std::vector<double> rows;
  for (const auto& [plane, sum] : sums) {
    if (sum.widest_m <= kWidestReveal_m) continue;
    for (const Vec& v : {turned(sum.normal), turned(sum.points * (1 / sum.count))})
      rows.insert(rows.end(), {v.x, v.y, v.z});
    rows.push_back(sum.count);
  }
  return rows;
}

}  // namespace bench
