// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "segment/front/wall_sheet.h"
#include "unit/segment/scenes.h"

namespace jalon::test {

/// Labelled points on rectangles, with the segments that they make.
struct MadeWalls {
  std::vector<Vec3> points;
  std::vector<uint32_t> labels;
  std::vector<Segment> segments;
  CloudPtr cloud;

  using Keep = std::function<bool(double, double)>;
  static bool all(double, double) { return true; }

  /// A point each step of corner + a u + b v, a and b in metres, where keep says so: a segment, normal u x v.
  void add(const Vec3& corner, const Vec3& u, const Vec3& v, double width_m, double height_m,
           const Keep& keep = all, double step_m = 0.05) {
    Segment s;
    s.label = static_cast<uint32_t>(segments.size() + 1);
    s.fit.axis_u = u;
    s.fit.axis_v = v;
    s.fit.plane.normal = cross(u, v);
    s.fit.plane.offset = dot(s.fit.plane.normal, corner);
    s.fit.centroid = corner + 0.5 * width_m * u + 0.5 * height_m * v;
    s.length_u_m = width_m;
    s.length_v_m = height_m;
    const int columns = static_cast<int>(width_m / step_m + 0.5),
              rows = static_cast<int>(height_m / step_m + 0.5);
    for (int i = 0; i < columns; ++i)
      for (int k = 0; k < rows; ++k) {
        const double a = (i + 0.5) * step_m, b = (k + 0.5) * step_m;
        if (!keep(a, b)) continue;
        points.push_back(corner + a * u + b * v);
        labels.push_back(s.label);
        s.area_m2 += step_m * step_m;
      }
    segments.push_back(s);
  }
  /// An upright rectangle that looks along -Y when to the right is +X, along +Y when it is -X.
  void upright(const Vec3& corner, double right, double width_m, double height_m,
               const Keep& keep = all) {
    add(corner, {right, 0, 0}, {0, 0, 1}, width_m, height_m, keep);
  }
  void level(const Vec3& corner, double width_m, double depth_m) {
    add(corner, {1, 0, 0}, {0, 1, 0}, width_m, depth_m, all, 0.1);
  }
  const Cloud& made() {
    cloud = cloud_of(points);
    return *cloud;
  }
  WallSheet sheet(const WallGroup& group) {
    Task task;
    return {made(), {}, labels, segments, group, task};
  }
};

/// A window of 2 x 2 m in a wall, 3 m along it and 2 m up; its pane.
inline bool is_window(double a, double b) { return a > 3 && a < 5 && b > 2 && b < 4; }
inline bool is_wall(double a, double b) { return !is_window(a, b); }

}  // namespace jalon::test
