// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "compare/changes/change_objects.h"
#include "compare/distance/distance.h"
#include "unit/cloud/clouds.h"

namespace jalon::test {

/// Edge of the cells that hold one point each: two samplings of one surface are at most sqrt(2) of it apart, and points
/// of neighbouring cells at most sqrt(5).
constexpr double kStep_m = 0.04;
/// What is changed lies farther than that, and what lies nearer than that hangs together.
constexpr double kApart_m = 2.5 * kStep_m;

inline CloudPtr shared_cloud(const std::vector<Vec3>& points) {
  return std::make_shared<const Cloud>(cloud_of(points));
}

template <class T>
void set_column(FieldTable& table, const char* name, const std::vector<T>& values,
                uint32_t components = 1) {
  table.set(make_column<T>({name, element_type_of<T>(), components, "", ""}, values));
}

/// A comparison that says these distances of these points, NaN for "nothing near".
inline Comparison told(const std::vector<Vec3>& points, const std::vector<double>& distances) {
  Comparison made;
  made.cloud = shared_cloud(points);
  set_column(made.points, "distance", distances);
  std::vector<uint8_t> statuses;
  for (const double d : distances) statuses.push_back(std::isnan(d) ? uint8_t{4} : uint8_t{0});
  set_column(made.points, "status", statuses);
  return made;
}

/// Points of a surface point(s, t), 0 <= s, t <= 1: a grid of cells with one at a random place in each.
template <class F>
void add_surface(std::vector<Vec3>& points, double length_m, double width_m, RandomStream& random,
                 F&& point) {
  const auto rows = std::lround(length_m / kStep_m), columns = std::lround(width_m / kStep_m);
  for (long i = 0; i < rows; ++i)
    for (long j = 0; j < columns; ++j) {
      const double s = (static_cast<double>(i) + random.uniform()) / static_cast<double>(rows);
      const double t = (static_cast<double>(j) + random.uniform()) / static_cast<double>(columns);
      points.push_back(point(s, t));
    }
}

inline void add_sheet(std::vector<Vec3>& points, const Vec3& corner, const Vec3& u, const Vec3& v,
                      RandomStream& random) {
  add_surface(points, norm(u), norm(v), random,
              [&](double s, double t) { return corner + u * s + v * t; });
}

/// All sides of an upright box but its foot.
inline void add_box(std::vector<Vec3>& points, const Vec3& foot_corner, const Vec3& size,
                    RandomStream& random) {
  const Vec3 u{size.x, 0, 0}, v{0, size.y, 0}, w{0, 0, size.z};
  add_sheet(points, foot_corner + w, u, v, random);
  add_sheet(points, foot_corner, u, w, random);
  add_sheet(points, foot_corner + v, u, w, random);
  add_sheet(points, foot_corner, v, w, random);
  add_sheet(points, foot_corner + u, v, w, random);
}

/// Two epochs of a place, compared both ways, with their changed regions.
struct TwoEpochs {
  Comparison forward, reverse;
  Epoch before, after;

  TwoEpochs(const std::vector<Vec3>& was, const std::vector<Vec3>& is, const Vec3& origin = {}) {
    Task task;
    const CloudPtr first = shared_cloud(was), second = shared_cloud(is);
    forward = compare_distance(first, second, {}, task);
    reverse = compare_distance(second, first, {}, task);
    RegionSettings settings;
    settings.threshold_m = settings.cell_m = kApart_m;
    after = {&forward, change_regions(forward, settings, task, first.get()), origin};
    before = {&reverse, change_regions(reverse, settings, task, second.get()), origin};
  }
  TwoEpochs(const TwoEpochs&) = delete;
  TwoEpochs& operator=(const TwoEpochs&) = delete;
};

}  // namespace jalon::test
