// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "unit/segment/scenes.h"

namespace jalon::test {

/// A cloud with the fields row and column.
inline CloudPtr with_places(const std::vector<Vec3>& points, const std::vector<uint32_t>& rows,
                            const std::vector<uint32_t>& columns, const Vec3& shift = {}) {
  auto cloud = std::make_shared<Cloud>(*cloud_of(points, shift));
  for (const auto& [name, values] : {std::pair{"row", &rows}, {"column", &columns}}) {
    auto column =
        std::make_shared<Column>(FieldInfo{name, ElementType::kUint32, 1, "", ""}, values->size());
    std::copy(values->begin(), values->end(), column->values<uint32_t>().begin());
    cloud->fields.set(column);
  }
  return cloud;
}

/// The same of points as one row after the other of `length` points.
inline CloudPtr in_rows(const std::vector<Vec3>& points, size_t length, const Vec3& shift = {}) {
  std::vector<uint32_t> rows, columns;
  for (size_t i = 0; i < points.size(); ++i) {
    rows.push_back(static_cast<uint32_t>(i / length));
    columns.push_back(static_cast<uint32_t>(i % length));
  }
  return with_places(points, rows, columns, shift);
}

struct ScannedFace {
  Vec3 corner, u, v;  ///< at right angles
};

/// Faces as a tripod at the origin sees them, by constant steps of both angles.
struct Scanned {
  Scene scene;
  std::vector<uint32_t> rows, columns;

  Scanned(const std::vector<ScannedFace>& faces, double step_rad, double sigma_m, uint64_t seed) {
    RandomStream random(seed, 31);
    const auto count = static_cast<uint32_t>(1.2 / step_rad);
    for (uint32_t r = 0; r < 2 * count; ++r)
      for (uint32_t c = 0; c < count; ++c) {
        const double h = step_rad * (r - static_cast<double>(count)),
                     v = step_rad * (c - count / 2.0);
        shoot({std::cos(v) * std::sin(h), std::cos(v) * std::cos(h), std::sin(v)}, faces, sigma_m,
              random, r, c);
      }
  }

  /// With the fields row and column, or with the station alone.
  CloudPtr cloud(bool fields, const Vec3& shift = {}) const {
    if (fields) return with_places(scene.points, rows, columns, shift);
    auto cloud = std::make_shared<Cloud>(*cloud_of(scene.points, shift));
    Station station;
    station.has_pose = true;
    station.pose.m[3] = shift.x;
    station.pose.m[7] = shift.y;
    station.pose.m[11] = shift.z;
    station.count = scene.points.size();
    cloud->stations.push_back(station);
    return cloud;
  }

 private:
  void shoot(const Vec3& ray, const std::vector<ScannedFace>& faces, double sigma_m,
             RandomStream& random, uint32_t row, uint32_t column) {
    double nearest = INFINITY;
    int seen = 0;
    for (size_t f = 0; f < faces.size(); ++f) {
      const Vec3 n = cross(faces[f].u, faces[f].v);
      const double range = dot(faces[f].corner, n) / dot(ray, n);
      const Vec3 d = range * ray - faces[f].corner;
      const double a = dot(d, faces[f].u) / squared_norm(faces[f].u),
                   b = dot(d, faces[f].v) / squared_norm(faces[f].v);
      if (!(range > 0) || range >= nearest || a < 0 || a > 1 || b < 0 || b > 1) continue;
      nearest = range;
      seen = static_cast<int>(f + 1);
    }
    if (seen == 0) return;
    scene.points.push_back((nearest + sigma_m * random.normal()) * ray);
    scene.faces.push_back(seen);
    rows.push_back(row);
    columns.push_back(column);
  }
};

/// A wall 6 m away with a window set back by 0.2 m, a bay with a side that is seen, ground.
inline std::vector<ScannedFace> scanned_house() {
  return {{{-5, 6, -1.5}, {4, 0, 0}, {0, 0, 4}},    {{-1, 6.2, -0.5}, {1.2, 0, 0}, {0, 0, 1.5}},
          {{0.2, 6, -1.5}, {1.8, 0, 0}, {0, 0, 4}}, {{2, 5, -1.5}, {0, 1, 0}, {0, 0, 4}},
          {{2, 5, -1.5}, {2, 0, 0}, {0, 0, 4}},     {{-6, 2, -1.5}, {12, 0, 0}, {0, 4, 0}}};
}

}  // namespace jalon::test
