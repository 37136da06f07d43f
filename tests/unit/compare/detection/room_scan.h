// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "cloud/cloud.h"
#include "base/random.h"

namespace jalon::test {

/// A room of 10 x 8 x 3 m about the origin, floor at 0, scanned in upright sweeps with 2 mm of noise along the rays.
struct RoomScan {
  double step_rad = 0.012;
  double panel_m =
      0;  ///< how far the panel -1 <= y <= 1, 0.5 <= z <= 1.7 stands before the wall x = 5
  bool has_box = false;  ///< 0.8 x 0.8 x 1 m, on the floor at (2.6, 0.6)

  CloudPtr scan(const std::vector<Vec3>& stations, uint64_t seed) const {
    std::vector<double> xyz;
    auto out = std::make_shared<Cloud>();
    std::vector<Station> placed;
    RandomStream random(seed, 3);
    for (const Vec3& from : stations) {
      Station& s = placed.emplace_back();
      s.name = "told";
      s.has_pose = true;
      s.pose.m[3] = from.x, s.pose.m[7] = from.y, s.pose.m[11] = from.z;
      s.first = xyz.size() / 3;
      for (double around = -3.14; around < 3.14; around += step_rad)
        for (double up = -1.2; up < 1.2; up += step_rad) {
          const Vec3 way{std::cos(up) * std::sin(around), std::cos(up) * std::cos(around),
                         std::sin(up)};
          const Vec3 p = from + way * (range(from, way) + 0.002 * random.normal());
          xyz.insert(xyz.end(), {p.x, p.y, p.z});
        }
      s.count = xyz.size() / 3 - s.first;
    }
    Buffer<double> buffer(xyz.size());
    std::copy(xyz.begin(), xyz.end(), buffer.data());
    *out = make_cloud(std::move(buffer));
    out->stations = std::move(placed);
    return out;
  }

 private:
  double range(const Vec3& from, const Vec3& way) const {
    const auto to = [](double at, double by, double low, double high) {
      return by > 0 ? (high - at) / by : by < 0 ? (low - at) / by : 1e9;
    };
    double t =
        std::min({to(from.x, way.x, -5, 5), to(from.y, way.y, -4, 4), to(from.z, way.z, 0, 3)});
    if (way.x > 0) {
      const double s = (5 - panel_m - from.x) / way.x;
      const Vec3 p = from + way * s;
      if (std::abs(p.y) <= 1 && p.z >= 0.5 && p.z <= 1.7) t = std::min(t, s);
      if (panel_m < 0 && std::abs(p.y) <= 1 && p.z >= 0.5 && p.z <= 1.7) t = s;
    }
    return has_box ? std::min(t, to_box(from, way)) : t;
  }
  static double to_box(const Vec3& from, const Vec3& way) {
    const Vec3 low{2.6, 0.6, 0}, high{3.4, 1.4, 1};
    double near = 0, far = 1e9;
    for (int k = 0; k < 3; ++k) {
      const double a = (low[k] - from[k]) / way[k], b = (high[k] - from[k]) / way[k];
      near = std::max(near, std::min(a, b));
      far = std::min(far, std::max(a, b));
    }
    return near <= far ? near : 1e9;
  }
};

inline CloudPtr without_stations(const CloudPtr& cloud) {
  auto out = std::make_shared<Cloud>(*cloud);
  out->stations.clear();
  return out;
}

}  // namespace jalon::test
