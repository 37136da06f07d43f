// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/ransac/curved_extraction.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "segment/ransac/curved_checks.h"
#include "segment/ransac/curved_hypotheses.h"
#include "segment/surface/primitive_fits.h"

namespace jalon {

namespace {

constexpr int kCurvedExtractionMaxRounds = 12;  // as for planes (extraction.cpp)
constexpr double kCurvedExtractionStable = 0.001;
constexpr int kTurningRounds = 3;
constexpr size_t kSettleSample = 2048;  // points that settle the shape; the last fit takes all
// Of the tolerance. Points evenly spread over it have 0.41 when a sphere or cylinder has settled on them, which bends
// to them where a plane cannot (0.46); noise with the tolerance at 2.58 sigma has 0.375.
constexpr double kMaxRoughness = 0.39;
constexpr double kMostOpenRadius = 0.1;  // standard deviation of the radius, relative

struct CurvedExtractionMembers {
  std::vector<uint32_t> slots;
  double area_m2 = 0, pixel_m = 0;
};

bool too_rough_to_bend(const SurfaceSettings& settings, double sigma_m) {
  return settings.uses_normals() && sigma_m > kMaxRoughness * settings.distance_tolerance_m;
}

std::vector<Vec3> points_of(const PointPool& pool, const CurvedExtractionMembers& members) {
  std::vector<Vec3> out(members.slots.size());
  for (size_t i = 0; i < out.size(); ++i) out[i] = pool.point(members.slots[i]);
  return out;
}

void keep_largest_region(const SegmentScene& scene, const PointPool& pool, const Curved& curved,
                         Task& task, CurvedExtractionMembers& members) {
  const auto spacing_at = [&](size_t i) { return scene.spacing[pool.position(members.slots[i])]; };
  members.pixel_m = connectivity_pixel(scene.settings, members.slots.size(), spacing_at, task);
  const std::vector<Vec3> points = points_of(pool, members);
  const SurfaceMap map = curved.map(points, task);
  std::vector<Vec2> uv(points.size());
  for (size_t i = 0; i < uv.size(); ++i) uv[i] = map(points[i]);
  if (!scene.settings.connectivity) {
    members.area_m2 = occupied_area_m2(bounded_raster(uv, members.pixel_m, 0, task));
    return;
  }
  // At least two pixels: on a pipe of few points some rows are empty by chance.
  const double gap = std::max(scene.settings.gap_m, 2 * members.pixel_m);
  const Region region = largest_region(uv, {members.pixel_m, gap, scene.settings.min_area_m2, 0});
  members.area_m2 = region.area_m2;
  for (size_t i = 0; i < region.members.size(); ++i)
    members.slots[i] = members.slots[region.members[i]];
  members.slots.resize(region.members.size());
}

bool large_enough_of_curved_extraction(const SurfaceSettings& settings,
                                       const CurvedExtractionMembers& members) {
  return members.slots.size() >= std::max<size_t>(3, settings.min_points) &&
         members.area_m2 >= settings.min_area_m2;
}

PrimitiveSetting fit_setting(const SurfaceSettings& settings, bool robust) {
  PrimitiveSetting out;
  out.tolerance_m = settings.distance_tolerance_m;
  out.min_radius_m = settings.min_radius_m;
  out.max_radius_m = settings.max_radius_m;
  out.robust = robust;
  return out;
}

// An even one.
std::vector<Vec3> sample_of(const PointPool& pool, const CurvedExtractionMembers& members) {
  std::vector<Vec3> out;
  const size_t step = members.slots.size() / kSettleSample + 1;
  for (size_t i = 0; i < members.slots.size(); i += step)
    out.push_back(pool.point(members.slots[i]));
  return out;
}

bool fit_members(const SegmentScene& scene, const PointPool& pool,
                 const CurvedExtractionMembers& members, Task& task, Surface& surface) {
  Segment fitted;
  const PrimitiveSetting setting = fit_setting(scene.settings, false);
  if (!adjust_curved(sample_of(pool, members), surface.curved, setting, task, fitted)) return false;
  surface.curved = curved_of(fitted);
  surface.sigma_m = fitted.sigma_m();
  return true;
}

// Rounds of collect - region - least squares; members are those of the last round.
bool settle(const SegmentScene& scene, const PointPool& pool, double edge_m, Task& task,
            Surface& surface, CurvedExtractionMembers& members) {
  const SurfaceSettings& settings = scene.settings;
  double reach = settings.distance_tolerance_m;
  size_t previous = 0;
  for (int round = 0; round < kCurvedExtractionMaxRounds; ++round) {
    members.slots = pool.collect(curved_test(scene, surface.curved, edge_m, reach), task);
    if (members.slots.empty()) return false;
    keep_largest_region(scene, pool, surface.curved, task, members);
    if (!large_enough_of_curved_extraction(settings, members) ||
        !fit_members(scene, pool, members, task, surface))
      return false;
    // The axis of a short piece soon leaves a long pipe: the first rounds only turn it.
    if (round >= kTurningRounds && too_rough_to_bend(settings, surface.sigma_m)) return false;
    reach = core_reach(settings, surface.sigma_m);
    const double change =
        std::fabs(static_cast<double>(members.slots.size()) - static_cast<double>(previous));
    if (round >= kTurningRounds &&
        change <= kCurvedExtractionStable * static_cast<double>(previous))
      break;
    previous = members.slots.size();
  }
  return true;
}

// The points of the settled surface: all within its core, and out to the tolerance those whose normals agree.
CurvedExtractionMembers members_of(const SegmentScene& scene, const PointPool& pool,
                                   const Surface& surface, Task& task) {
  CurvedExtractionMembers members;
  CurvedTest test = curved_test(scene, surface.curved, 0, scene.settings.distance_tolerance_m);
  test.cosine2 = 0;
  members.slots = pool.collect(test, task);
  const double core = core_reach(scene.settings, surface.sigma_m);
  std::erase_if(members.slots, [&](uint32_t slot) {
    return std::fabs(surface.curved.distance(pool.point(slot))) > core &&
           curved_inconsistent(scene, surface.curved, pool.position(slot));
  });
  if (!members.slots.empty()) keep_largest_region(scene, pool, surface.curved, task, members);
  return members;
}

// A sphere that is a band of a cylinder settles anew as one; false when it is and cylinders are not looked for.
bool settle_as_what_it_is(const SegmentScene& scene, const PointPool& pool, double edge_m,
                          Task& task, Surface& surface, CurvedExtractionMembers& members) {
  if (!settle(scene, pool, edge_m, task, surface, members)) return false;
  if (!surface.curved.is_sphere()) return true;
  const PrimitiveSetting setting = fit_setting(scene.settings, false);
  if (!better_as_cylinder(surface, sample_of(pool, members), setting, task, surface.curved))
    return true;
  return scene.settings.cylinders() && settle(scene, pool, edge_m, task, surface, members);
}

// Is it a curved surface, and one by itself?
bool is_curved(const SegmentScene& scene, const PointPool& pool, const Surface& surface,
               std::span<const Vec3> points, Task& task) {
  return bends(scene.settings, surface, points, task) && !is_faceted(surface, points, task) &&
         stands_out(scene, pool, surface, points, task);
}

void reject_of_curved_extraction(SegmentScene& scene, const PointPool& pool,
                                 const Candidate& candidate,
                                 const CurvedExtractionMembers& members) {
  const auto note = [&](uint32_t position) {
    if (position != kNoPoint)
      scene.note_rejection(scene.curved_rejections, position, kMostRejections);
  };
  note(candidate.seed);
  for (const uint32_t slot : members.slots) note(pool.position(slot));
}

}  // namespace

bool extract_curved(SegmentScene& scene, PointPool& pool, const Candidate& candidate,
                    uint32_t owner_id, Task& task, Surface& out) {
  Surface surface;
  surface.curved = candidate.curved;
  CurvedExtractionMembers members;
  const double edge = scene.cell_edge_m(candidate.seed);
  const bool settled = settle_as_what_it_is(scene, pool, edge, task, surface, members);
  if (settled) members = members_of(scene, pool, surface, task);
  surface.area_m2 = members.area_m2;
  surface.pixel_m = members.pixel_m;
  if (!settled || !large_enough_of_curved_extraction(scene.settings, members) ||
      !is_curved(scene, pool, surface, points_of(pool, members), task)) {
    reject_of_curved_extraction(scene, pool, candidate, members);
    return false;
  }
  for (const uint32_t slot : members.slots) {
    surface.positions.push_back(pool.position(slot));
    scene.owner[pool.position(slot)] = owner_id;
  }
  pool.remove(members.slots, task);
  std::sort(surface.positions.begin(), surface.positions.end());
  out = std::move(surface);
  return true;
}

bool fit_curved_core(const SegmentScene& scene, const Surface& surface, bool robust, Task& task,
                     Segment& out) {
  const double core = core_reach(scene.settings, surface.sigma_m);
  std::vector<Vec3> all(surface.positions.size()), near;
  for (size_t i = 0; i < all.size(); ++i) {
    all[i] = scene.exact(surface.positions[i]);
    if (robust || std::fabs(surface.curved.distance(all[i])) <= core) near.push_back(all[i]);
  }
  if (!adjust_curved(near, surface.curved, fit_setting(scene.settings, robust), task, out))
    return false;
  describe_curved(all, surface.pixel_m, out, task);
  return true;
}

bool refit_curved(const SegmentScene& scene, Surface& surface, Task& task) {
  const SurfaceSettings& settings = scene.settings;
  if (surface.positions.size() < std::max<size_t>(3, settings.min_points)) return false;
  Segment fitted;
  if (!fit_curved_core(scene, surface, true, task, fitted)) return false;
  surface.curved = curved_of(fitted);
  surface.sigma_m = fitted.sigma_m();
  surface.area_m2 = fitted.area_m2;
  const double variance =
      surface.curved.is_sphere() ? fitted.sphere.covariance[15] : fitted.cylinder.covariance[48];
  const double open = kMostOpenRadius * surface.curved.radius;
  if (surface.area_m2 < settings.min_area_m2 || too_rough_to_bend(settings, surface.sigma_m) ||
      variance > open * open)
    return false;
  std::vector<Vec3> points(surface.positions.size());
  for (size_t i = 0; i < points.size(); ++i) points[i] = scene.local(surface.positions[i]);
  return bends(settings, surface, points, task) && !is_faceted(surface, points, task);
}

}  // namespace jalon
