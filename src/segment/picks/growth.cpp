// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/picks/growth.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.h"
#include "base/parallel.h"
#include "base/serial.h"
#include "base/text_number.h"
#include "geometry/polygon2.h"
#include "segment/surface/connectivity.h"
#include "segment/surface/surface_map.h"

namespace jalon {

namespace {

constexpr size_t kPointsPerChunk = 1 << 15;
constexpr int kRounds = 12;
constexpr double kReachGrowth = 2;
constexpr uint32_t kMaxGapPixels = 256;
constexpr double kSpacingsPerPixel = 2;
constexpr uint32_t kSpacingNeighbours = 8;
constexpr int kMillimetreDigits = 4;  // of lengths in messages

// Free points that `takes` takes, ascending.
template <class F>
std::vector<uint32_t> free_points(const PickScene& scene, Task& task, F&& takes) {
  const size_t n = scene.cloud.size();
  std::vector<std::vector<uint32_t>> parts((n + kPointsPerChunk - 1) / kPointsPerChunk);
  parallel_for(task, n, kPointsPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i)
      if (scene.labels[i] == 0 && takes(scene.local(i)))
        parts[begin / kPointsPerChunk].push_back(static_cast<uint32_t>(i));
  });
  std::vector<uint32_t> out;
  for (const auto& part : parts) out.insert(out.end(), part.begin(), part.end());
  return out;
}

std::vector<Vec3> points_of(const PickScene& scene, std::span<const uint32_t> members, Task& task) {
  std::vector<Vec3> out(members.size());
  parallel_for(task, out.size(), kPointsPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) out[i] = scene.local(members[i]);
  });
  return out;
}

// Pixel of the connectivity raster: the user's, or twice the point spacing around the picks.
double pixel_of(const PickScene& scene, Task& task) {
  if (scene.setting.pixel_m > 0) return scene.setting.pixel_m;
  const auto tree = scene.cloud.octree(task);
  double widest = 0;
  std::vector<Neighbour> near(kSpacingNeighbours);
  for (const Vec3& pick : scene.picks) {
    if (tree->knn(pick + scene.origin, 1, near) == 0) continue;  // a pick may lie beside the points
    const size_t n = tree->knn(scene.cloud.point(near[0].index), kSpacingNeighbours, near);
    // k points in a disc of radius r: a spacing of r sqrt(pi / k).
    if (n > 0)
      widest = std::max(widest, std::sqrt(near[n - 1].squared_distance * std::numbers::pi /
                                          static_cast<double>(n)));
  }
  return std::max(scene.setting.primitive.tolerance_m, kSpacingsPerPixel * widest);
}

std::vector<Vec2> flattened(const Segment& segment, std::span<const Vec3> points,
                            std::span<const Vec3> also, std::vector<Vec2>& also_flat, Task& task) {
  const SurfaceMap map = SurfaceMap::of(segment, points, task);
  std::vector<Vec2> uv(points.size());
  parallel_for(task, uv.size(), kPointsPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) uv[i] = map(points[i]);
  });
  for (const Vec3& p : also) also_flat.push_back(map(p));
  return uv;
}

// The members whose places `stays` keeps, in their order.
template <class F>
void keep_members(std::vector<uint32_t>& members, Task& task, F&& stays) {
  size_t kept = 0;
  serial_for(task, members.size(), kPointsPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i)
      if (stays(i)) members[kept++] = members[i];
  });
  members.resize(kept);
}

// Keeps the members connected, over gaps of at most gap_m, with the place of a pick.
void keep_connected(const PickScene& scene, const Segment& segment, double pixel_m,
                    std::vector<uint32_t>& members, Task& task) {
  if (members.empty()) return;
  std::vector<Vec2> seeds;
  const std::vector<Vec2> uv =
      flattened(segment, points_of(scene, members, task), scene.picks, seeds, task);
  const double gap = scene.setting.gap_m;
  const auto margin =
      static_cast<uint32_t>(std::min<double>(kMaxGapPixels, std::floor(gap / (2 * pixel_m))));
  const Raster raster = bounded_raster(uv, pixel_m, margin + 1, task);
  const Regions regions = label_regions(margin > 0 ? dilated(raster, margin) : raster);
  std::vector<uint8_t> wanted(regions.count() + 1, 0);
  for (const Vec2& seed :
       seeds) {  // the region nearest to the pick: noise may put it into an empty pixel
    double nearest = INFINITY;
    uint32_t label = 0;
    serial_for(task, uv.size(), kPointsPerChunk, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i)
        if (const double d = norm(uv[i] - seed); d < nearest) {
          nearest = d;
          label = regions.labels[raster.pixel_of(uv[i])];
        }
    });
    if (nearest <= gap + 2 * pixel_m) wanted[label] = 1;
  }
  wanted[0] = 0;
  keep_members(members, task,
               [&](size_t i) { return wanted[regions.labels[raster.pixel_of(uv[i])]] != 0; });
}

// Minimal-surface filter: pieces below the smallest area that means something are left to the remaining points.
void drop_small_pieces(const PickScene& scene, const Segment& segment, double pixel_m,
                       std::vector<uint32_t>& members, Task& task) {
  if (members.empty()) return;
  std::vector<Vec2> unused;
  const std::vector<Vec2> uv =
      flattened(segment, points_of(scene, members, task), {}, unused, task);
  const Raster raster = bounded_raster(uv, pixel_m, 0, task);
  const Regions regions = label_regions(raster);
  const double least = scene.setting.min_area_m2 / (raster.pixel_m * raster.pixel_m);
  keep_members(members, task, [&](size_t i) {
    return static_cast<double>(regions.pixel_counts[regions.labels[raster.pixel_of(uv[i])]]) >=
           least;
  });
}

bool refit(const PickScene& scene, std::span<const uint32_t> members, const Vec3* direction,
           Task& task, Segment& segment) {
  const std::vector<Vec3> points = points_of(scene, members, task);
  const PrimitiveSetting& setting = scene.setting.primitive;
  if (segment.type == PrimitiveType::kPlane) return fit_plane(points, segment.fit);
  if (segment.type == PrimitiveType::kSphere)
    return adjust_sphere(points, segment.sphere.sphere, setting, task, segment.sphere);
  if (direction != nullptr)
    return fit_cylinder_along(*direction, points, setting, task, segment.cylinder);
  return adjust_cylinder(points, segment.cylinder.cylinder, setting, task, segment.cylinder);
}

/// The ball around a seed within which its plane is followed. The plane of a few neighbours is a degree or two off:
/// all at once, it would gather a slanted band right across a facade. It grows while the members come near its border.
struct SeedReach {
  Vec3 seed;
  double radius_m = INFINITY;

  bool holds(const Vec3& p) const { return squared_norm(p - seed) <= radius_m * radius_m; }
  bool grow_if_touched(const PickScene& scene, std::span<const uint32_t> members, double margin_m) {
    if (std::isinf(radius_m)) return false;
    double farthest = 0;
    for (const uint32_t i : members) farthest = std::max(farthest, norm(scene.local(i) - seed));
    if (farthest <= radius_m - margin_m) return false;
    radius_m *= kReachGrowth;
    return true;
  }
};

// Rounds of members - connection - fit, from the surface of the picks until the points stay the same; then the small
// pieces are left out and the last fit is made.
template <class F>
Picked grow(const PickScene& scene, Segment start, const Vec3* direction, bool connected,
            SeedReach reach, F&& bounds, Task& task) {
  const double tolerance = scene.setting.primitive.tolerance_m, pixel = pixel_of(scene, task);
  Picked out;
  out.segment = start;
  for (int round = 0; round < kRounds;) {
    auto members = free_points(scene, task, [&](const Vec3& p) {
      return std::fabs(out.segment.distance(p)) <= tolerance && reach.holds(p) && bounds(p);
    });
    if (connected) keep_connected(scene, out.segment, pixel, members, task);
    Segment next = out.segment;
    if (!refit(scene, members, direction, task, next)) break;
    const bool settled = members == out.members;
    out.members = std::move(members);
    out.segment = next;
    if (reach.grow_if_touched(scene, out.members, scene.setting.gap_m + 2 * pixel)) continue;
    if (settled) break;
    ++round;
  }
  if (!out.members.empty()) drop_small_pieces(scene, out.segment, pixel, out.members, task);
  if (out.members.size() < scene.setting.min_points ||
      !refit(scene, out.members, direction, task, out.segment))
    fail(Status::kInsufficientData,
         "the picks gather %zu free points within %s m of their surface in pieces of %s m2 or more",
         out.members.size(), text_of(tolerance).c_str(),
         text_of(scene.setting.min_area_m2).c_str());
  if (!out.segment.is_plane())
    describe_curved(points_of(scene, out.members, task), pixel, out.segment, task);
  return out;
}

// A plane's extents and area from its points.
void describe_plane(const PickScene& scene, double pixel_m, Picked& picked, Task& task) {
  const PlaneFit& fit = picked.segment.fit;
  std::vector<Vec2> uv(picked.members.size());
  Vec2 low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
  serial_for(task, uv.size(), kPointsPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const Vec3 d = scene.local(picked.members[i]) - fit.centroid;
      const Vec2 q{dot(d, fit.axis_u), dot(d, fit.axis_v)};
      low = {std::min(low.u, q.u), std::min(low.v, q.v)};
      high = {std::max(high.u, q.u), std::max(high.v, q.v)};
      uv[i] = q;
    }
  });
  picked.segment.length_u_m = high.u - low.u;
  picked.segment.length_v_m = high.v - low.v;
  const Raster raster = bounded_raster(uv, pixel_m, 0, task);
  const auto pixels = std::count(raster.pixels.begin(), raster.pixels.end(), uint8_t{1});
  picked.segment.area_m2 = static_cast<double>(pixels) * raster.pixel_m * raster.pixel_m;
}

// The plane of the points around a seed, and how far they reach.
PlaneFit seed_plane(const PickScene& scene, Task& task, SeedReach& reach) {
  const auto tree = scene.cloud.octree(task);
  std::vector<Neighbour> near(scene.setting.k);
  near.resize(tree->knn(scene.picks[0] + scene.origin, scene.setting.k, near));
  std::vector<Vec3> points;
  reach = {scene.picks[0], 0};
  for (const Neighbour& n : near) {
    reach.radius_m = std::max(reach.radius_m, kReachGrowth * std::sqrt(n.squared_distance));
    if (scene.labels[n.index] == 0) points.push_back(scene.local(n.index));
  }
  const double away_m = near.empty() ? INFINITY : std::sqrt(near[0].squared_distance);
  if (!(away_m <= scene.setting.gap_m + scene.setting.primitive.tolerance_m))
    fail(Status::kInsufficientData, "the nearest point lies %s m from the seed",
         text_of(away_m, kMillimetreDigits).c_str());
  PlaneFit fit;
  if (points.size() < 3 || 2 * points.size() < near.size())  // what others left is no surface
    fail(Status::kInsufficientData,
         "%zu of the %zu points around the seed are free; a plane needs 3 and half of them",
         points.size(), near.size());
  if (!fit_plane(points, fit))
    fail(Status::kDegenerate, "the %zu free points around the seed are equal or on one line",
         points.size());
  if (fit.sigma > scene.setting.primitive.tolerance_m)
    fail(Status::kDegenerate,
         "the points around the seed lie %s m from a plane; the tolerance is %s m",
         text_of(fit.sigma, kMillimetreDigits).c_str(),
         text_of(scene.setting.primitive.tolerance_m).c_str());
  return fit;
}

// The picks as a polygon on their plane: in their order when that is a simple polygon, else their convex hull.
std::vector<Vec2> pick_polygon(const PickScene& scene, const PlaneFit& fit) {
  std::vector<Vec2> uv;
  for (const Vec3& p : scene.picks)
    uv.push_back({dot(p - fit.centroid, fit.axis_u), dot(p - fit.centroid, fit.axis_v)});
  if (is_simple(uv)) return uv;
  std::vector<Vec2> hull;
  for (const uint32_t i : convex_hull(uv)) hull.push_back(uv[i]);
  return hull;
}

Vec3 pick_normal(const PickScene& scene, size_t i, Task& task) {
  if (scene.cloud.size() < 3)
    fail(Status::kInsufficientData, "the cloud has %zu points; a normal needs 3",
         scene.cloud.size());
  const Vec3 n = normal_near(scene.cloud, *scene.cloud.octree(task), scene.picks[i] + scene.origin,
                             scene.setting.k);
  if (!is_finite(n))
    fail(Status::kDegenerate, "the points around pick %zu are equal or on one line: no normal", i);
  return n;
}

void require_radius(const PickScene& scene, bool found, double radius_m) {
  if (!found)
    fail(Status::kDegenerate,
         "the %zu picks fix no such surface: they are flat, on one line or too close together",
         scene.picks.size());
  const PrimitiveSetting& s = scene.setting.primitive;
  if (!s.allows(radius_m))
    fail(Status::kDegenerate, "the picks give a radius of %s m; the limits are %s and %s m",
         text_of(radius_m, kMillimetreDigits).c_str(), text_of(s.min_radius_m).c_str(),
         text_of(s.max_radius_m).c_str());
}

constexpr auto kEverywhere = [](const Vec3&) { return true; };

}  // namespace

// 1. plane of the picks or of the seed's surroundings; 2. points near it, inside the picks' polygon (in the plane: the
// axis-parallel box of the source is too wide for oblique facades) or connected with the seed; 3. least squares.
Picked pick_plane(const PickScene& scene, Task& task) {
  Segment start;
  Picked out;
  if (scene.picks.size() == 1) {
    SeedReach reach;
    start.fit = seed_plane(scene, task, reach);
    out = grow(scene, start, nullptr, true, reach, kEverywhere, task);
  } else {
    const size_t n = scene.picks.size();
    if (n < 3) fail(Status::kInsufficientData, "%zu picks; a plane needs 3, or one seed", n);
    if (!fit_plane(scene.picks, start.fit))
      fail(Status::kDegenerate, "the %zu picks are on one line", n);
    const PlaneFit frame = start.fit;
    const std::vector<Vec2> polygon = pick_polygon(scene, frame);
    const auto inside = [&](const Vec3& p) {
      const Vec3 d = p - frame.centroid;
      return contains(polygon, {dot(d, frame.axis_u), dot(d, frame.axis_v)});
    };
    out = grow(scene, start, nullptr, false, {}, inside, task);
  }
  describe_plane(scene, pixel_of(scene, task), out, task);
  return out;
}

Picked pick_sphere(const PickScene& scene, Task& task) {
  Segment start;
  start.type = PrimitiveType::kSphere;
  Sphere& sphere = start.sphere.sphere;
  const auto& picks = scene.picks;
  bool found = false;
  if (picks.size() == 2)
    found = sphere_from_normals(picks[0], pick_normal(scene, 0, task), picks[1],
                                pick_normal(scene, 1, task), sphere);
  else if (picks.size() == 4)
    found = sphere_through({picks[0], picks[1], picks[2], picks[3]}, sphere);
  else if (picks.size() > 4) found = sphere_linear(picks, sphere);
  else
    fail(Status::kInsufficientData,
         "%zu picks; a sphere needs 4, or 2 where the points around give normals", picks.size());
  require_radius(scene, found, sphere.radius);
  return grow(scene, start, nullptr, true, {}, kEverywhere, task);
}

Picked pick_cylinder(const PickScene& scene, Task& task) {
  constexpr Vec3 kUp{0, 0, 1};
  Segment start;
  start.type = PrimitiveType::kCylinder;
  Cylinder& cylinder = start.cylinder.cylinder;
  const auto& picks = scene.picks;
  if (picks.size() < 2)
    fail(Status::kInsufficientData,
         "%zu picks; a vertical cylinder needs 3, any other 2 where the points around give normals",
         picks.size());
  const bool vertical = picks.size() >= 3;
  const bool found = vertical
                         ? cylinder_along(kUp, picks, cylinder)
                         : cylinder_from_normals(picks[0], pick_normal(scene, 0, task), picks[1],
                                                 pick_normal(scene, 1, task), cylinder);
  require_radius(scene, found, cylinder.radius);
  return grow(scene, start, vertical ? &kUp : nullptr, true, {}, kEverywhere, task);
}

}  // namespace jalon
