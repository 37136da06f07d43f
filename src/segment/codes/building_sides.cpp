// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/codes/building_sides.h"

#include <algorithm>
#include <cmath>

#include "geometry/polygon2.h"

namespace jalon {

namespace {

constexpr double kSlopeStep_m = 0.02;
constexpr double kBeforeWall_m = 0.15;  // of the axis of a downpipe from an outline

}  // namespace

double depth_in_buildings(const CodedObjects& objects, const Vec2& place) {
  double most = -INFINITY;
  for (const CodedObject& object : objects.objects) {
    if (object.shape.kind != CodeShape::Kind::kPrism) continue;
    const double distance = border_distance(object.shape.polygon, place);
    most = std::max(most, contains(object.shape.polygon, place) ? distance : -distance);
  }
  return most;
}

Vec2 way_out_at_pipe(const CodedObjects& objects, const Vec2& place) {
  const auto depth = [&](const Vec2& p) { return depth_in_buildings(objects, p); };
  if (!(std::fabs(depth(place)) < kBeforeWall_m)) return {};
  const Vec2 u{kSlopeStep_m, 0}, v{0, kSlopeStep_m};
  const Vec2 inward{depth(place + u) - depth(place - u), depth(place + v) - depth(place - v)};
  const double length = norm(inward);
  return length > 0 ? inward * (-1 / length) : Vec2{};
}

}  // namespace jalon
