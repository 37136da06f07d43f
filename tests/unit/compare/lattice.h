// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "base/random.h"
#include "cloud/cloud.h"

namespace jalon::test {

/// What a scanner looks at: angles from the horizontal +Y axis, clockwise, and from the horizon.
struct Look {
  double left = -0.5, right = 0.5, low = -0.4, high = 0.4;
  double horizontal_step = 0.01, vertical_step = 0.01;
  double angle_noise = 0;
};

inline Vec3 direction_of(double h, double v) {
  return {std::cos(v) * std::sin(h), std::cos(v) * std::cos(h), std::sin(v)};
}

/// A cloud of one station whose rays meet something at range(direction in the scanner's frame); 0: nothing.
inline Cloud lattice(const Look& look, const Transform& pose,
                     const std::function<double(const Vec3&)>& range) {
  std::vector<double> xyz;
  RandomStream random(5, 1);
  const auto columns =
      static_cast<int>(std::floor((look.right - look.left) / look.horizontal_step + 1e-9));
  const auto rows =
      static_cast<int>(std::floor((look.high - look.low) / look.vertical_step + 1e-9));
  for (int i = 0; i <= columns; ++i)
    for (int j = 0; j <= rows; ++j) {
      const double aside = look.angle_noise * random.normal(),
                   up = look.angle_noise * random.normal();
      const Vec3 d = direction_of(look.left + i * look.horizontal_step + aside,
                                  look.low + j * look.vertical_step + up);
      const double r = range(d);
      if (!(r > 0)) continue;
      const Vec3 p = pose.point(d * r);
      xyz.insert(xyz.end(), {p.x, p.y, p.z});
    }
  Buffer<double> buffer(xyz.size());
  std::copy(xyz.begin(), xyz.end(), buffer.data());
  Cloud cloud = make_cloud(std::move(buffer));
  Station station;
  station.has_pose = true;
  station.pose = pose;
  station.count = cloud.size();
  cloud.stations.push_back(station);
  return cloud;
}

/// Range of the plane y = distance.
inline auto wall_at(double distance) {
  return [distance](const Vec3& d) { return d.y > 1e-9 ? distance / d.y : 0; };
}

}  // namespace jalon::test
