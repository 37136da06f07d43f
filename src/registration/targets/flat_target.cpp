// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/targets/flat_target.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/random.h"
#include "geometry/adjustment.h"
#include "geometry/plane.h"
#include "registration/targets/intensity_pattern.h"
#include "spatial/raster.h"

namespace jalon {

namespace {

constexpr double kSearchSizes = 1.5;
constexpr int kFlatTargetDraws = 400;
constexpr size_t kScoredAtOnce = 256;    // points, before a draw may be given up
constexpr double kLeastExplained = 0.5;  // of the brightness: less is no pattern
constexpr double kPixelSpacings = 2;     // of a plate's raster
constexpr double kMostSizeOff = 0.5;     // of a plate's size, relative

/// offset(p) = p . normal - offset, as unknowns of adjust(): along the normal and the slopes about the middle.
struct PlaneModel {
  using Point = Vec3;
  static constexpr size_t kUnknowns = 3;
  Vec3 origin, normal, u, v;  ///< orthonormal

  double residual(const Vec3& p, Coefficients<3>& j) const {
    const Vec3 d = p - origin;
    j = {-1, -dot(d, u), -dot(d, v)};
    return dot(d, normal);
  }
  void move(const Coefficients<3>& x) {
    origin += x[0] * normal;
    normal = normalized(normal - x[1] * u - x[2] * v);
    // Both slopes at once lengthen the normal; the axes follow it.
    u = normalized(u - dot(u, normal) * normal);
    v = cross(normal, u);
  }
};

PlaneModel model_of(const Plane& plane) {
  PlaneModel out;
  out.normal = plane.normal;
  out.origin = plane.offset * plane.normal;
  const Vec3 away = std::fabs(plane.normal.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
  out.u = normalized(cross(away, out.normal));
  out.v = cross(out.normal, out.u);
  return out;
}

struct FittedPlane {
  PlaneModel plane;
  Adjusted<3> fit;
};

// Sum of 1 - (d / tolerance)^2 over the points within it; when that cannot exceed best any more, something below it. A
// point gives 1 at most; one is left for the rounding of the sum.
double score_of(const std::vector<Vec3>& points, const Plane& plane, double tolerance_m,
                double best) {
  double score = 0;
  for (size_t first = 0; first < points.size(); first += kScoredAtOnce) {
    if (score + static_cast<double>(points.size() - first) + 1 < best) break;
    const size_t count = std::min(kScoredAtOnce, points.size() - first);
    for (const Vec3& p : std::span(points).subspan(first, count)) {
      const double d = plane.distance(p) / tolerance_m;
      score += d * d < 1 ? 1 - d * d : 0;
    }
  }
  return score;
}

// Step 1. Random draws of three points, judged as MLESAC's simpler kin (Torr & Zisserman 2000),
// then the biweight.
std::optional<FittedPlane> plane_of(const std::vector<Vec3>& points,
                                    const MeasuringSettings& setting, Task& task) {
  FittedPlane out;
  double best = 0;
  // No plane is better than one that all points lie on.
  for (int i = 0; i < kFlatTargetDraws && best < static_cast<double>(points.size()); ++i) {
    RandomStream random(setting.seed, static_cast<uint64_t>(i));
    Plane plane;
    const auto draw = [&] { return points[random.below(points.size())]; };
    const Vec3 a = draw(), b = draw(), c = draw();
    if (!plane_through(a, b, c, plane)) continue;
    const double score = score_of(points, plane, setting.tolerance_m, best);
    if (score > best) best = score, out.plane = model_of(plane);
  }
  if (!(best > 0)) return std::nullopt;
  const std::span<const Vec3> all(points);
  if (!adjust(all, {setting.tolerance_m, true}, task, out.plane, out.fit)) return std::nullopt;
  return out;
}

// What carries the target: points of the plane, in its own coordinates.
struct Patch {
  std::vector<BrightPoint> points;
  std::vector<Vec2> places;
};

Patch patch_of(const Surroundings& near, const PlaneModel& plane, const Column* intensity,
               double tolerance_m) {
  Patch out;
  for (size_t i = 0; i < near.points.size(); ++i) {
    const Vec3 d = near.points[i] - plane.origin;
    if (std::fabs(dot(d, plane.normal)) > tolerance_m) continue;
    const Vec2 at{dot(d, plane.u), dot(d, plane.v)};
    const double value = intensity != nullptr ? intensity->number(near.indices[i]) : 0;
    if (!std::isfinite(value)) continue;
    out.places.push_back(at);
    out.points.push_back({at.u, at.v, value});
  }
  return out;
}

double cross_of(const Vec2& o, const Vec2& a, const Vec2& b) { return cross(a - o, b - o); }

// Andrew (1979): the convex hull, counter-clockwise.
std::vector<Vec2> hull_of(std::vector<Vec2> points) {
  std::sort(points.begin(), points.end(),
            [](const Vec2& a, const Vec2& b) { return a.u != b.u ? a.u < b.u : a.v < b.v; });
  std::vector<Vec2> hull;
  for (int pass = 0; pass < 2; ++pass) {
    const size_t first = hull.size();
    for (const Vec2& p : points) {
      while (hull.size() >= first + 2 && cross_of(hull[hull.size() - 2], hull.back(), p) <= 0)
        hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

struct RingCentre {
  Vec2 centroid;
  double area = 0;
};

RingCentre centre_of(const std::vector<Vec2>& ring) {
  Vec2 sum;
  double area = 0;
  for (size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i] - ring[0], b = ring[(i + 1) % ring.size()] - ring[0];
    area += cross(a, b) / 2;
    sum = sum + (a + b) * (cross(a, b) / 6);
  }
  return {ring[0] + sum * (1 / area), area};
}

// The plate that holds the place: connected, all of it in sight, about as large as it should be. Its edges are known to
// half the spacing either way; those of a plate that stands along the scan lines are wrong as a whole.
std::optional<PatternCentre> find_plate(const std::vector<Vec2>& places, const Vec2& seed,
                                        double search_m, double size_m) {
  if (places.size() < 3) return std::nullopt;
  const double all_m2 = centre_of(hull_of(places)).area;
  if (!(all_m2 > 0)) return std::nullopt;
  const double pixel = kPixelSpacings * std::sqrt(all_m2 / static_cast<double>(places.size()));
  const Raster raster = rasterise(places, pixel, 1);
  const Regions regions = label_regions(raster);
  size_t nearest = 0;
  for (size_t i = 1; i < places.size(); ++i)
    if (norm(places[i] - seed) < norm(places[nearest] - seed)) nearest = i;
  const uint32_t label = regions.labels[raster.pixel_of(places[nearest])];
  std::vector<Vec2> members;
  for (const Vec2& p : places) {
    if (regions.labels[raster.pixel_of(p)] != label) continue;
    if (norm(p - seed) > search_m - pixel)
      return std::nullopt;  // goes on beyond what was looked at
    members.push_back(p);
  }
  const auto [centroid, area] = centre_of(hull_of(members));
  const double across = std::sqrt(area), n = static_cast<double>(members.size());
  if (!(std::fabs(across - size_m) <= kMostSizeOff * size_m)) return std::nullopt;
  const double variance = area / n / 24;
  PatternCentre out;
  out.centre = centroid;
  out.covariance = {variance, 0, 0, variance};
  out.points = members.size();
  return out;
}

struct KindOfPattern {
  PatternCentre pattern;
  TargetKind kind = TargetKind::kPatch;
};

// Step 2. What explains more of the brightness, a checker or a disc, where either explains enough;
// else the plate.
std::optional<KindOfPattern> find_pattern(const Patch& patch, const Vec2& seed,
                                          const MeasuringSettings& setting, bool has_intensity,
                                          double search_m, Task& task) {
  std::vector<BrightPoint> about = patch.points;  // about the place that was given
  for (BrightPoint& p : about) p.u -= seed.u, p.v -= seed.v;
  const bool any = setting.pattern == TargetPattern::kAutomatic;
  const double reach = std::max(search_m - setting.size_m / 2, setting.size_m / 8);
  const bool seeks_checker = has_intensity && (any || setting.pattern == TargetPattern::kChecker);
  const bool seeks_disc = has_intensity && (any || setting.pattern == TargetPattern::kDisc);
  std::optional<PatternCentre> checker, disc;
  if (seeks_checker) checker = find_checker(about, setting.size_m, reach, task);
  if (seeks_disc) disc = find_disc(about, setting.size_m, reach, task);
  const double by_checker = checker ? checker->explained : 0, by_disc = disc ? disc->explained : 0;
  if (std::max(by_checker, by_disc) >= kLeastExplained) {
    const bool is_checker = by_checker >= by_disc;
    PatternCentre best = is_checker ? *checker : *disc;
    best.centre = best.centre + seed;
    return KindOfPattern{best, is_checker ? TargetKind::kChecker : TargetKind::kDisc};
  }
  if (!any && setting.pattern != TargetPattern::kPatch) return std::nullopt;
  const auto plate = find_plate(patch.places, seed, search_m, setting.size_m);
  if (!plate) return std::nullopt;
  return KindOfPattern{*plate, TargetKind::kPatch};
}

// Step 3. Across: of the pattern; along the normal: of the plane there.
Square<3> covariance_at(const PlaneModel& plane, const PatternCentre& pattern,
                        const Square<3>& of_plane) {
  const Coefficients<3> j{1, pattern.centre.u, pattern.centre.v};
  double along = 0;
  for (size_t r = 0; r < 3; ++r)
    for (size_t c = 0; c < 3; ++c) along += j[r] * of_plane[3 * r + c] * j[c];
  const Square<3> local{pattern.covariance[0],
                        pattern.covariance[1],
                        0,
                        pattern.covariance[2],
                        pattern.covariance[3],
                        0,
                        0,
                        0,
                        along};
  const Vec3 &u = plane.u, &v = plane.v, &n = plane.normal;
  return propagated<3, 3>({u.x, v.x, n.x, u.y, v.y, n.y, u.z, v.z, n.z}, local);
}

}  // namespace

MeasuredTarget measure_flat(const Cloud& cloud, const Octree& tree, const Vec3& place,
                            const MeasuringSettings& setting, Task& task) {
  const double search_m = setting.search_m > 0 ? setting.search_m : kSearchSizes * setting.size_m;
  const Surroundings near = surroundings_of(cloud, tree, place, {}, search_m);
  MeasuredTarget out;
  out.points = near.points.size();
  out.status = Status::kInsufficientData;
  if (near.points.size() < setting.min_points) return out;
  out.status = Status::kDegenerate;
  out.points = 0;
  const std::optional<FittedPlane> fitted = plane_of(near.points, setting, task);
  if (!fitted) return out;
  const auto& [plane, fit] = *fitted;
  const Column* intensity = cloud.fields.find(setting.intensity_field);
  const Patch patch = patch_of(near, plane, intensity, setting.tolerance_m);
  const Vec2 seed{-dot(plane.origin, plane.u), -dot(plane.origin, plane.v)};
  const auto found = find_pattern(patch, seed, setting, intensity != nullptr, search_m, task);
  out.kind = found ? found->kind : TargetKind::kPatch;
  if (!found) return out;
  const PatternCentre& pattern = found->pattern;
  if (pattern.points < setting.min_points) {
    out.status = Status::kInsufficientData;
    out.points = pattern.points;
    return out;
  }
  out.status = Status::kOk;
  out.centre = plane.origin + pattern.centre.u * plane.u + pattern.centre.v * plane.v;
  out.covariance = covariance_at(plane, pattern, fit.covariance);
  if (out.kind == TargetKind::kDisc)
    out.radius_m = pattern.radius_m, out.radius_sigma_m = pattern.radius_sigma_m;
  out.normal = plane.normal;
  out.sigma_m = fit.sigma;
  out.points = pattern.points;
  return out;
}

}  // namespace jalon
