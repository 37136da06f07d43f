// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/parallel.h"
#include "base/text_number.h"
#include "cloud/operations.h"
#include "geometry/polygon2.h"

namespace jalon {

namespace {

constexpr size_t kCropGrain = 1 << 15;

template <class F>
std::vector<uint8_t> mask_where(const Cloud& cloud, Task& task, size_t grain, F&& is_inside) {
  std::vector<uint8_t> mask(cloud.size());
  parallel_for(task, cloud.size(), grain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) mask[i] = is_inside(cloud.point(i));
  });
  return mask;
}

}  // namespace

std::vector<uint8_t> inside_box(const Cloud& cloud, const Box3& box, const Transform& T_box_world,
                                Task& task) {
  return mask_where(cloud, task, kCropGrain,
                    [&](const Vec3& p) { return box.contains(T_box_world.point(p)); });
}

std::vector<uint8_t> inside_prism(const Cloud& cloud, std::span<const Vec2> polygon, double w_min,
                                  double w_max, const Transform& T_prism_world, Task& task) {
  if (polygon.size() < 3)
    fail(Status::kInvalidArgument, "a polygon of %zu corners; it needs 3", polygon.size());
  Vec2 low = polygon[0], high = polygon[0];
  for (const Vec2& corner : polygon) {
    low = {std::min(low.u, corner.u), std::min(low.v, corner.v)};
    high = {std::max(high.u, corner.u), std::max(high.v, corner.v)};
  }
  // Polygons of many corners get smaller chunks, so that cancel stays quick.
  const size_t grain = std::max<size_t>(64, kCropGrain * 8 / (8 + polygon.size()));
  return mask_where(cloud, task, grain, [&](const Vec3& p) {
    const Vec3 q = T_prism_world.point(p);
    return q.z >= w_min && q.z <= w_max && q.x >= low.u && q.x <= high.u && q.y >= low.v &&
           q.y <= high.v && contains(polygon, {q.x, q.y});
  });
}

std::vector<uint8_t> inside_cylinder(const Cloud& cloud, const Vec3& foot, const Vec3& top,
                                     double radius_m, Task& task) {
  const Vec3 axis = top - foot;
  const double length2 = squared_norm(axis);
  if (!(length2 > 0) || !std::isfinite(length2))
    fail(Status::kInvalidArgument, "foot and top of the cylinder are one point, or not finite");
  if (!(radius_m > 0) || !std::isfinite(radius_m))
    fail(Status::kInvalidArgument, "a radius of %s m: it must be above 0",
         text_of(radius_m).c_str());
  return mask_where(cloud, task, kCropGrain, [&](const Vec3& p) {
    const Vec3 d = p - foot;
    const double along = dot(d, axis);
    if (!(along >= 0 && along <= length2)) return false;
    return squared_norm(d - axis * (along / length2)) <= radius_m * radius_m;
  });
}

}  // namespace jalon
