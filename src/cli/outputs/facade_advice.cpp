// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/outputs/facade_advice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "cli/table.h"

namespace jalon::cli {

namespace {

constexpr double kUpright = 0.26;      // most |z| of the normal of a wall: it leans by 15 degrees
constexpr double kLevel = 0.97;        // least |z| of the normal of a floor
constexpr double kLeastWalls = 0.05;   // share of a facade scan's points on upright surfaces
constexpr double kManyWithout = 0.3;   // share of points that no plane explains
constexpr size_t kManyDirections = 5;  // of upright planes
constexpr double kSameDirection = 0.985;                   // cosine: 10 degrees
constexpr double kLeastBent_m = 1, kLeastBentShare = 0.1;  // radius; of the area of all surfaces
constexpr double kLeastOfPlan =
    0.35;  // of the area of the box in plan, which a turned room fills to a half
constexpr double kNearEnd = 0.2;     // of the height: where floor and ceiling lie
constexpr double kOneSide = 0.97;    // share of the cloud in front of a wall of its room
constexpr double kOnWall_m = 0.05;   // points this near to a wall are on it
constexpr uint64_t kSample = 20000;  // points are asked at most

struct Surface {
  uint64_t type = 0, points = 0;
  std::array<double, 3> normal{}, centroid{};
  double area = 0, offset = 0, radius = 0;

  bool is_plane() const { return type == JALON_PRIMITIVE_PLANE; }
  bool is_wall() const { return is_plane() && std::fabs(normal[2]) <= kUpright; }
  bool is_bent_wall() const {
    return type == JALON_PRIMITIVE_CYLINDER && std::fabs(normal[2]) >= kLevel &&
           radius >= kLeastBent_m;
  }
};

std::vector<Surface> surfaces_of(const Segmentation& segmentation) {
  Fields fields;
  must(jalon_segmentation_segments(segmentation.get(), Out(fields)));
  const Table table(std::move(fields));
  std::vector<Surface> out(table.rows());
  for (uint64_t row = 0; row < table.rows(); ++row) {
    Surface& s = out[row];
    s.type = table.count("type", row), s.points = table.count("inliers", row);
    s.area = table.number("area", row), s.offset = table.number("offset", row);
    s.radius = table.number("radius", row);
    for (uint32_t k = 0; k < 3; ++k) {
      s.normal[k] = table.number("normal", row, k);
      s.centroid[k] = table.number("centroid", row, k);
    }
  }
  return out;
}

double area_of(const std::vector<Surface>& surfaces) {
  double sum = 0;
  for (const Surface& s : surfaces) sum += s.area;
  return sum;
}

uint64_t points_in(const Segmentation& segmentation) {
  Cloud cloud;
  must(jalon_segmentation_cloud(segmentation.get(), Out(cloud)));
  uint64_t count = 0;
  must(jalon_cloud_count(cloud.get(), &count));
  return count;
}

double dot_of(const std::array<double, 3>& a, const double* b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Directions, either way round, further apart than a few degrees.
size_t directions_of(const std::vector<Surface>& surfaces) {
  std::vector<const Surface*> apart;
  for (const Surface& s : surfaces) {
    if (!s.is_wall()) continue;
    const bool is_new = std::none_of(apart.begin(), apart.end(), [&](const Surface* other) {
      return std::fabs(dot_of(s.normal, other->normal.data())) > kSameDirection;
    });
    if (is_new) apart.push_back(&s);
  }
  return apart.size();
}

std::string percent(double share) { return fixed(100 * share, share < 0.1 ? 1 : 0) + " %"; }

// Is nearly all of the cloud in front of this wall, whichever way its normal looks?
bool is_outermost(const Surface& wall, const double* xyz, uint64_t count) {
  const uint64_t step = std::max<uint64_t>(1, count / kSample);
  double before = 0, behind = 0;
  for (uint64_t i = 0; i < count; i += step) {
    const double height = dot_of(wall.normal, xyz + 3 * i) - wall.offset;
    before += height > kOnWall_m;
    behind += height < -kOnWall_m;
  }
  return std::max(before, behind) >= kOneSide * (before + behind);
}

// Quarters of the horizon in which outermost walls stand, seen from the middle of the cloud.
size_t sides_of(const std::vector<Surface>& surfaces, const jalon_box& box, const double* xyz,
                uint64_t count) {
  std::array<bool, 4> has{};
  const double x = (box.min.x + box.max.x) / 2, y = (box.min.y + box.max.y) / 2;
  std::vector<std::array<double, 3>> outward;
  for (const Surface& s : surfaces) {
    if (!s.is_wall() || !is_outermost(s, xyz, count)) continue;
    const double toward = (s.centroid[0] - x) * s.normal[0] + (s.centroid[1] - y) * s.normal[1];
    outward.push_back({std::copysign(s.normal[0], s.normal[0] * toward),
                       std::copysign(s.normal[1], s.normal[1] * toward), 0});
  }
  if (outward.empty()) return 0;
  const double first = std::atan2(outward[0][1], outward[0][0]);
  for (const auto& n : outward) {
    const double turn = std::remainder(std::atan2(n[1], n[0]) - first, 2 * 3.141592653589793);
    has[static_cast<size_t>(std::lround(turn / (3.141592653589793 / 2)) + 4) % 4] = true;
  }
  return static_cast<size_t>(std::count(has.begin(), has.end(), true));
}

bool has_level(const std::vector<Surface>& surfaces, const jalon_box& box, bool above) {
  const double height = box.max.z - box.min.z,
               plan = (box.max.x - box.min.x) * (box.max.y - box.min.y);
  return std::any_of(surfaces.begin(), surfaces.end(), [&](const Surface& s) {
    const double z = (s.centroid[2] - box.min.z) / height;
    return s.is_plane() && std::fabs(s.normal[2]) >= kLevel && s.area >= kLeastOfPlan * plan &&
           (above ? z > 1 - kNearEnd : z < kNearEnd);
  });
}

bool is_room(const Cloud& cloud, const std::vector<Surface>& surfaces) {
  jalon_box box;
  jalon_array_view view;
  must(jalon_cloud_bounds(cloud.get(), &box));
  if (!has_level(surfaces, box, true) || !has_level(surfaces, box, false)) return false;
  must(jalon_cloud_points(cloud.get(), &view));
  return sides_of(surfaces, box, static_cast<const double*>(view.data), view.count) >= 3;
}

}  // namespace

bool may_be_bent(const Segmentation& segmentation) {
  const auto surfaces = surfaces_of(segmentation);
  uint64_t on_planes = 0;
  for (const Surface& s : surfaces) on_planes += s.points;
  const auto all = static_cast<double>(points_in(segmentation));
  return static_cast<double>(on_planes) < (1 - kManyWithout) * all ||
         directions_of(surfaces) >= kManyDirections;
}

std::string told_of_bent_walls(const Segmentation& segmentation) {
  const auto surfaces = surfaces_of(segmentation);
  const double all = area_of(surfaces);
  std::string radii;
  for (const Surface& s : surfaces)
    if (s.is_bent_wall() && s.area >= kLeastBentShare * all)
      radii += (radii.empty() ? "" : ", ") + fixed(s.radius, 3);
  if (radii.empty()) return "";
  return "bent walls (radius " + radii +
         ") are cylinders in segments.*; the model draws planes alone";
}

std::string why_no_facade(const Cloud& cloud, const Segmentation& segmentation) {
  const auto surfaces = surfaces_of(segmentation);
  double upright = 0;
  for (const Surface& s : surfaces)
    if (s.is_wall() || s.is_bent_wall()) upright += static_cast<double>(s.points);
  const double share = upright / static_cast<double>(points_in(segmentation));
  if (share < kLeastWalls)
    return percent(share) +
           " of the points are on upright surfaces, so this is no facade (measured from the air, "
           "or "
           "open land?); nothing is written: \"jalon segment\" finds what planes there are, "
           "\"jalon "
           "model --method outlines\" draws them";
  if (is_room(cloud, surfaces))
    return "floor, ceiling and walls all round: a room seen from inside is no facade; nothing is "
           "written: \"jalon model --method outlines\" draws its surfaces";
  return "";
}

}  // namespace jalon::cli
