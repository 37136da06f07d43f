// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "scan/scanner.h"

namespace jalon {

namespace {

constexpr double kTripod_m = 1.7;
constexpr double kFrontDistance = 0.6;  // of the width: the whole facade lies within +-40 degrees
constexpr double kBeside = 0.25;        // of the length, either side of the middle
constexpr double kLeastDistance_m = 2.0;
constexpr double kUpright = 0.17;  // |normal z| below sin(10 degrees)
constexpr double kOneSided = 0.4;  // share of the area that has to look one way to make a front

/// Sums over the upright triangles, relative to a vertex of the model.
struct Upright {
  double area = 0;
  Vec3 facing;                    ///< sum of area x normal
  Vec3 centre;                    ///< sum of area x centre, then their mean
  double xx = 0, xy = 0, yy = 0;  ///< second moments in plan about the mean
  double inward =
      0;  ///< sum of area x (normal . way to the middle): > 0 inside a room, < 0 around a building
};

template <class F>
void for_upright(const Model& model, const Vec3& reference, F&& f) {
  for (const auto& t : model.triangles) {
    const std::array<Vec3, 3> p{model.vertices[t[0]] - reference, model.vertices[t[1]] - reference,
                                model.vertices[t[2]] - reference};
    const Vec3 twice = cross(p[1] - p[0], p[2] - p[0]);
    const double length = norm(twice);
    if (length > 0 && std::abs(twice.z) <= kUpright * length) f(p, twice / length, length / 2);
  }
}

Upright measure(const Model& model, const Vec3& reference) {
  Upright sum;
  for_upright(model, reference, [&](const std::array<Vec3, 3>& p, const Vec3& normal, double area) {
    sum.area += area;
    sum.facing += normal * area;
    sum.centre += (p[0] + p[1] + p[2]) * (area / 3);
  });
  if (!(sum.area > 0)) return sum;
  sum.centre = sum.centre / sum.area;
  for_upright(model, reference, [&](const std::array<Vec3, 3>& p, const Vec3& normal, double area) {
    const Vec3 d = (p[0] + p[1] + p[2]) / 3 - sum.centre;
    sum.xx += area * d.x * d.x;
    sum.xy += area * d.x * d.y;
    sum.yy += area * d.y * d.y;
    sum.inward -= area * dot(normal, d);
  });
  return sum;
}

struct Extent {
  double min = std::numeric_limits<double>::infinity(),
         max = -std::numeric_limits<double>::infinity();
  double middle() const { return (min + max) / 2; }
  double length() const { return max - min; }
};

Extent extent_along(const Model& model, const Vec3& reference, const Vec3& axis) {
  Extent extent;
  for_upright(model, reference, [&](const std::array<Vec3, 3>& p, const Vec3&, double) {
    for (const Vec3& q : p) {
      extent.min = std::min(extent.min, dot(q, axis));
      extent.max = std::max(extent.max, dot(q, axis));
    }
  });
  return extent;
}

/// Two places either side of the middle, or so many in the middles of equal parts.
std::vector<double> spread(const Extent& length, uint64_t count) {
  if (count == 0)
    return {length.middle() - kBeside * length.length(),
            length.middle() + kBeside * length.length()};
  std::vector<double> out;
  for (uint64_t i = 0; i < count; ++i)
    out.push_back(length.min +
                  length.length() * (static_cast<double>(i) + 0.5) / static_cast<double>(count));
  return out;
}

}  // namespace

std::vector<ScanStation> automatic_stations(const Model& model, uint64_t count, double distance_m) {
  if (model.triangles.empty()) return {};
  // Whole metres, so that a model shifted by them gets its stations shifted exactly.
  Box3 box;
  for (const auto& t : model.triangles)
    for (const uint32_t v : t) box.add(model.vertices[v]);
  const Vec3 reference{std::floor(box.min.x), std::floor(box.min.y), std::floor(box.min.z)};
  const Upright upright = measure(model, reference);
  if (!(upright.area > 0)) return {};

  // 1. The long axis in plan, and across it.
  Vec3 across{upright.facing.x, upright.facing.y, 0};
  const bool has_front = norm(across) > kOneSided * upright.area;
  if (!has_front) {
    const double angle = 0.5 * std::atan2(2 * upright.xy, upright.xx - upright.yy);
    across = {-std::sin(angle), std::cos(angle), 0};
  }
  across = normalized(across);
  const Vec3 along{-across.y, across.x, 0};
  const Extent length = extent_along(model, reference, along),
               depth = extent_along(model, reference, across);

  // 2. Places (along, across) by the way the walls look.
  std::vector<Vec2> places;
  const auto away = [&](double width) {
    return distance_m > 0 ? distance_m : std::max(kLeastDistance_m, kFrontDistance * width);
  };
  if (has_front) {
    for (const double u : spread(length, count))
      places.push_back({u, depth.max + away(length.length())});
  } else if (upright.inward > 0) {
    for (const double u : spread(length, count)) places.push_back({u, depth.middle()});
  } else if (count > 0) {
    const double radius = std::hypot(length.length(), depth.length()) / 2 +
                          away(std::max(length.length(), depth.length()));
    for (uint64_t i = 0; i < count; ++i) {
      const double angle =
          2 * std::numbers::pi * (static_cast<double>(i) + 0.5) / static_cast<double>(count);
      places.push_back(
          {length.middle() + radius * std::cos(angle), depth.middle() + radius * std::sin(angle)});
    }
  } else {
    const double beside = away(std::max(length.length(), depth.length()));
    for (const double u : {length.min - beside, length.max + beside})
      for (const double v : {depth.min - beside, depth.max + beside}) places.push_back({u, v});
  }

  // 3. Upright tripods, the scanner's axes parallel to those of the model.
  std::vector<ScanStation> out;
  for (const Vec2& place : places) {
    const Vec3 p = along * place.u + across * place.v;
    ScanStation station;
    station.name = "station " + std::to_string(out.size() + 1);
    station.pose.m[3] = reference.x + p.x;
    station.pose.m[7] = reference.y + p.y;
    station.pose.m[11] = box.min.z + kTripod_m;
    out.push_back(station);
  }
  return out;
}

}  // namespace jalon
