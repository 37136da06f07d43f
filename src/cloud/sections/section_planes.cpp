// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cloud/sections/section_planes.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/parallel.h"
#include "base/text_number.h"

namespace jalon {

namespace {

constexpr size_t kMostSections = 100000;  // of one call: a cut a metre through 100 km
constexpr double kOwnStep_m = 1;          // where no place is told
constexpr double kLevel = 0.95;           // |z| of a direction whose sections are seen from above
constexpr double kStationSlack_m = 1e-9;  // rounding of the alignment's length
constexpr size_t kSectionPointsPerChunk = 1 << 14;

Vec3 unit_direction(const SectionSettings& settings) {
  const std::vector<double>& d = settings.direction;
  const Vec3 n = d.size() == 3 ? normalized({d[0], d[1], d[2]}) : Vec3{};
  if (!(squared_norm(n) > 0.5))
    fail(Status::kInvalidArgument, "direction must be three numbers x, y, z, not all 0");
  return n;
}

// Those of at_m and the multiples of the step in [low, high], each once.
std::vector<double> places_of(const SectionSettings& settings, double low, double high) {
  std::vector<double> places = settings.at_m;
  const double step_m = settings.step_m > 0 ? settings.step_m : places.empty() ? kOwnStep_m : 0;
  if (step_m > 0) {
    const double first = std::ceil(low / step_m), last = std::floor(high / step_m);
    if (!(last - first < static_cast<double>(kMostSections)))
      fail(Status::kLimit, "a step of %s m makes more than %zu sections", text_of(step_m).c_str(),
           kMostSections);
    for (double k = first; k <= last; ++k) places.push_back(k * step_m);
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

// Axes of a section that is looked at against the normal: u level, v upward; seen from above x and y.
SectionPlane facing(const Vec3& normal) {
  SectionPlane plane;
  const Vec3 up = std::fabs(normal.z) < kLevel ? Vec3{0, 0, 1} : Vec3{0, 1, 0};
  plane.normal = normal;
  plane.u = normalized(cross(up, normal));
  plane.v = cross(normal, plane.u);
  return plane;
}

// Parallel planes of one row: the points of each by a search among their places.
struct PlaneRow {
  Vec3 origin, along;
  size_t first = 0;
  std::vector<double> places;  ///< of each from the origin, ascending
};

std::vector<PlaneRow> rows_of(std::span<const SectionPlane> planes) {
  std::vector<PlaneRow> rows;
  for (size_t k = 0; k < planes.size(); ++k) {
    const SectionPlane& plane = planes[k];
    const bool level = std::fabs(plane.normal.z) >= kLevel;
    const Vec3 along = level && plane.normal.z > 0 ? plane.normal : -1.0 * plane.normal;
    if (rows.empty() || !(rows.back().along == along)) rows.push_back({plane.origin, along, k, {}});
    rows.back().places.push_back(dot(plane.origin - rows.back().origin, along));
  }
  return rows;
}

// Does a box reach a row's planes?
bool may_meet(const PlaneRow& row, const Box3& box, double half_m) {
  const Vec3 half = 0.5 * (box.max - box.min);
  const double middle = dot(box.min + half - row.origin, row.along);
  const double wide = std::fabs(row.along.x) * half.x + std::fabs(row.along.y) * half.y +
                      std::fabs(row.along.z) * half.z + 2 * half_m;
  const auto at = std::lower_bound(row.places.begin(), row.places.end(), middle - wide);
  return at != row.places.end() && *at <= middle + wide;
}

}  // namespace

std::vector<SectionPlane> planes_along_direction(const Cloud& cloud,
                                                 const SectionSettings& settings, Task& task) {
  const Vec3 direction = unit_direction(settings);
  const Box3 box = bounds(cloud, task);
  double low = INFINITY, high = -INFINITY;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p{(corner & 1) != 0 ? box.max.x : box.min.x,
                 (corner & 2) != 0 ? box.max.y : box.min.y,
                 (corner & 4) != 0 ? box.max.z : box.min.z};
    low = std::min(low, dot(p, direction));
    high = std::max(high, dot(p, direction));
  }
  const bool level = std::fabs(direction.z) >= kLevel;
  const Vec3 normal = level && direction.z > 0 ? direction : -1.0 * direction;
  const Vec3 corner{std::floor(box.min.x), std::floor(box.min.y), 0};
  std::vector<SectionPlane> planes;
  for (const double at : places_of(settings, low, high)) {
    SectionPlane plane = facing(normal);
    plane.at_m = at;
    plane.origin = corner + (at - dot(corner, direction)) * direction;
    planes.push_back(plane);
  }
  return planes;
}

std::vector<SectionPlane> planes_along_alignment(std::span<const Vec3> alignment,
                                                 const SectionSettings& settings) {
  std::vector<Vec3> corners;  // in plan
  std::vector<double> stations;
  for (const Vec3& p : alignment) {
    if (!is_finite(p))
      fail(Status::kInvalidArgument, "the alignment holds a number that is not finite");
    const Vec3 corner{p.x, p.y, 0};
    if (!corners.empty() && corner == corners.back()) continue;
    stations.push_back(corners.empty() ? 0 : stations.back() + norm(corner - corners.back()));
    corners.push_back(corner);
  }
  if (corners.size() < 2)
    fail(Status::kInvalidArgument, "an alignment needs two points that differ in plan");
  const double length = stations.back();
  std::vector<SectionPlane> planes;
  for (const double at : places_of(settings, 0, length + kStationSlack_m)) {
    if (at < 0 || at > length + kStationSlack_m)
      fail(Status::kInvalidArgument, "station %s m; the alignment has 0 to %s m",
           text_of(at).c_str(), text_of(length).c_str());
    const auto after = std::upper_bound(stations.begin() + 1, stations.end() - 1, at);
    const auto k = static_cast<size_t>(after - stations.begin()) - 1;
    const Vec3 along = normalized(corners[k + 1] - corners[k]);
    SectionPlane plane = facing(-1.0 * along);
    plane.at_m = at;
    plane.origin = corners[k] + (at - stations[k]) * along;
    planes.push_back(plane);
  }
  return planes;
}

std::vector<std::vector<uint32_t>> points_of_planes(const Cloud& cloud,
                                                    std::span<const SectionPlane> planes,
                                                    double thickness_m, double reach_m,
                                                    Task& task) {
  const std::vector<PlaneRow> rows = rows_of(planes);
  const double half = thickness_m / 2;
  const size_t n = cloud.size();
  struct Member {
    uint32_t plane, point;
  };
  std::vector<std::vector<Member>> found((n + kSectionPointsPerChunk - 1) / kSectionPointsPerChunk);
  parallel_for(task, n, kSectionPointsPerChunk, [&](size_t begin, size_t end) {
    auto& part = found[begin / kSectionPointsPerChunk];
    Box3 box;
    for (size_t i = begin; i < end; ++i) box.add(cloud.point(i));
    for (const PlaneRow& row : rows) {
      if (!may_meet(row, box, half)) continue;
      for (size_t i = begin; i < end; ++i) {
        const Vec3 p = cloud.point(i);
        const double at = dot(p - row.origin, row.along);
        auto place = std::lower_bound(row.places.begin(), row.places.end(), at - half);
        for (; place != row.places.end() && *place <= at + half; ++place) {
          const size_t k = row.first + static_cast<size_t>(place - row.places.begin());
          if (reach_m > 0 && std::fabs(dot(p - planes[k].origin, planes[k].u)) > reach_m) continue;
          part.push_back({static_cast<uint32_t>(k), static_cast<uint32_t>(i)});
        }
      }
    }
  });
  std::vector<std::vector<uint32_t>> points(planes.size());
  for (const auto& part : found)
    for (const Member& member : part) points[member.plane].push_back(member.point);
  return points;
}

}  // namespace jalon
