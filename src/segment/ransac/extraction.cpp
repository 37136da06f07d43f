// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/ransac/extraction.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace jalon {

namespace {

constexpr int kExtractionMaxRounds = 12;     // a plane from a 0.2 m cell reaches a 20 m wall in 3-5
constexpr double kExtractionStable = 0.001;  // change of the number of points that ends the rounds
constexpr double kSigmas = 3;
constexpr double kLeastReach =
    0.1;  // of the tolerance: keeps noise-free planes from reaching nothing
// A strip of n points with rms width s fixes the plane's turn about its long side to sigma / (s sqrt(n)) (fit_plane's
// covariance). Sigma is that of a scan for which the tolerance was chosen, 3 sigma, not the fit's own: least squares
// through a single column finds hardly any residual. Twice the usual tolerance of 1 degree for orientations.
constexpr double kLargestTurn_rad = 0.035;
// A strip whose width is that of the noise has no direction however many its points.
constexpr double kLeastWidthInSigmas = 1.5;
constexpr size_t kExtractionPointsPerChunk = 1 << 14;
// The surface is followed from the candidate's cell outward: looking at a whole infinite plane for each small surface
// would cost far more than the surface.
constexpr double kFirstWindow = 4;  // half side, in edges of the cell
constexpr double kWindowGrowth = 3;

struct ExtractionMembers {
  std::vector<uint32_t> slots;
  double area_m2 = 0, pixel_m = 0;
};

// Keeps of the slots those in the raster's region.
template <class At>
void keep_in(const RegionRaster& raster, const At& at, Task& task, std::vector<uint32_t>& slots) {
  std::vector<uint8_t> is_in(slots.size());
  parallel_for(task, slots.size(), kExtractionPointsPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) is_in[i] = raster.holds(at(i));
  });
  size_t count = 0;
  for (size_t i = 0; i < slots.size(); ++i)
    if (is_in[i] != 0) slots[count++] = slots[i];
  slots.resize(count);
}

// Millions of points: each loop over them looks at the cancel.
void keep_largest_region(const SegmentScene& scene, const PointPool& pool, const Plane& plane,
                         Task& task, ExtractionMembers& members) {
  const SurfaceSettings& settings = scene.settings;
  const size_t n = members.slots.size();
  const auto spacing_at = [&](size_t i) { return scene.spacing[pool.position(members.slots[i])]; };
  members.pixel_m = connectivity_pixel(settings, n, spacing_at, task);
  task.checkpoint(0);
  const FlatFrame frame = plane_frame(plane, pool.point(members.slots[0]));
  const auto at = [&](size_t i) { return frame(pool.point(members.slots[i])); };
  if (!settings.connectivity) {
    std::vector<Vec2> uv(n);
    for (size_t i = 0; i < n; ++i) uv[i] = at(i);
    members.area_m2 = occupied_area_m2(bounded_raster(uv, members.pixel_m, 0));
    return;
  }
  const FlatBox box =
      parallel_reduce(task, n, kExtractionPointsPerChunk, FlatBox{}, [&](size_t begin, size_t end) {
        FlatBox part;
        for (size_t i = begin; i < end; ++i) part.add(at(i));
        return part;
      });
  RegionRaster raster(
      box, {members.pixel_m, settings.gap_m, settings.min_area_m2, settings.strip_width_m});
  parallel_for(task, n, kExtractionPointsPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) raster.mark(at(i));
  });
  members.area_m2 = raster.settle();
  keep_in(raster, at, task, members.slots);
}

bool fit_members(const PointPool& pool, const ExtractionMembers& members, Task& task,
                 PlaneFit& fit) {
  Moments zero;
  zero.reference = pool.point(members.slots[0]);
  const Moments moments = parallel_reduce(task, members.slots.size(), kExtractionPointsPerChunk,
                                          zero, [&](size_t begin, size_t end) {
                                            Moments part = zero;
                                            for (size_t i = begin; i < end; ++i)
                                              part.add(pool.point(members.slots[i]));
                                            return part;
                                          });
  return fit_plane(moments, fit);
}

bool large_enough_of_extraction(const SurfaceSettings& settings, const ExtractionMembers& members) {
  return members.slots.size() >= std::max<size_t>(3, settings.min_points) &&
         members.area_m2 >= settings.min_area_m2;
}

// The cube around the candidate in which its surface is looked for.
struct Window {
  Vec3 centre;
  double half_m = 0, all_m = 0;  ///< all_m: the half side that holds every point

  Box3 box() const {
    const Vec3 h{half_m, half_m, half_m};
    Box3 out;
    out.min = centre - h;
    out.max = centre + h;
    return out;
  }
  bool whole() const { return half_m >= all_m; }
  // True when the region might go on outside; then the window has grown.
  bool grow_if_touched(const PointPool& pool, const ExtractionMembers& members, double margin_m) {
    if (whole()) return false;
    bool touched = false;
    for (const uint32_t slot : members.slots) {
      const Vec3 d = pool.point(slot) - centre;
      const double reach = std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)});
      touched |= reach > half_m - margin_m;
    }
    if (touched) half_m *= kWindowGrowth;
    return touched;
  }
};

Window first_window(const SegmentScene& scene, const Candidate& candidate) {
  const double edge = scene.tree->cube().edge;
  Window window{scene.local(candidate.seed),
                std::ldexp(kFirstWindow * edge, -scene.level[candidate.seed]), edge};
  if (!scene.settings.connectivity) window.half_m = edge;
  return window;
}

// Rounds of collect - region - least squares; members are those of the last round.
bool settle_plane(const RansacScene& scene, const PointPool& pool, Task& task, Surface& surface,
                  Window& window, ExtractionMembers& members) {
  const SurfaceSettings& settings = scene.settings;
  if (!scene.draw.refit) {
    window.half_m = window.all_m;
    surface.sigma_m = settings.distance_tolerance_m / kSigmas;
    return true;
  }
  double reach = settings.distance_tolerance_m;
  size_t previous = 0;
  for (int round = 0; round < kExtractionMaxRounds; ++round) {
    members.slots = {};  // those before would lie beside these
    members.slots =
        pool.collect(scene.test(surface.plane, reach, scene.min_cosine()), window.box(), task);
    if (members.slots.empty()) return false;
    keep_largest_region(scene, pool, surface.plane, task, members);
    PlaneFit fit;
    if (members.slots.size() < 3 || !fit_members(pool, members, task, fit)) return false;
    surface.plane = fit.plane;
    surface.sigma_m = fit.sigma;
    reach = core_reach(settings, fit.sigma);
    const bool grown = window.grow_if_touched(pool, members, settings.gap_m + 2 * members.pixel_m);
    if (!grown && (!large_enough_of_extraction(settings, members) || !wide_enough(settings, fit)))
      return false;
    if (too_rough(settings, fit.sigma)) return false;
    const double change =
        std::fabs(static_cast<double>(members.slots.size()) - static_cast<double>(previous));
    if (!grown && round > 1 && change <= kExtractionStable * static_cast<double>(previous)) break;
    previous = members.slots.size();
  }
  return true;
}

// The points of the settled plane: all within its core, and out to the tolerance those whose normals agree.
ExtractionMembers members_of(const SegmentScene& scene, const PointPool& pool,
                             const Surface& surface, const Window& window, Task& task) {
  ExtractionMembers members;
  const PlaneTest test = scene.test(surface.plane, scene.settings.distance_tolerance_m, 0);
  members.slots = pool.collect(test, window.box(), task);
  const double cosine = scene.min_cosine(), core = core_reach(scene.settings, surface.sigma_m);
  std::erase_if(members.slots, [&](uint32_t slot) {
    return std::fabs(surface.plane.distance(pool.point(slot))) > core &&
           scene.inconsistent(pool.position(slot), surface.plane.normal, cosine);
  });
  if (!members.slots.empty()) keep_largest_region(scene, pool, surface.plane, task, members);
  return members;
}

// Notes on the points of a surface that it was none, so that they do not lead to it for ever.
void reject_of_extraction(SegmentScene& scene, const PointPool& pool, const Candidate& candidate,
                          const ExtractionMembers& members) {
  const auto note = [&](uint32_t position) {
    if (position != kNoPoint) scene.note_rejection(scene.rejections, position, 255);
  };
  note(candidate.seed);
  for (const uint32_t slot : members.slots) note(pool.position(slot));
}

// Slots go through the pool's pieces one after the other, so their positions are a few ascending runs.
void sort_runs(std::vector<uint32_t>& positions) {
  auto sorted = std::is_sorted_until(positions.begin(), positions.end());
  while (sorted != positions.end()) {
    const auto next = std::is_sorted_until(sorted, positions.end());
    std::inplace_merge(positions.begin(), sorted, next);
    sorted = next;
  }
}

}  // namespace

std::vector<Vec2> flat_points(const SegmentScene& scene, const Surface& surface, Task& task) {
  std::vector<Vec2> uv(surface.positions.size());
  if (surface.is_plane()) {
    const FlatFrame frame = plane_frame(surface.plane, scene.local(surface.positions[0]));
    parallel_for(task, uv.size(), kExtractionPointsPerChunk, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) uv[i] = frame(scene.local(surface.positions[i]));
    });
    return uv;
  }
  std::vector<Vec3> points(uv.size());
  for (size_t i = 0; i < uv.size(); ++i) points[i] = scene.local(surface.positions[i]);
  const SurfaceMap map = surface.curved.map(points, task);
  for (size_t i = 0; i < uv.size(); ++i) uv[i] = map(points[i]);
  return uv;
}

bool wide_enough(const SurfaceSettings& settings, const PlaneFit& fit) {
  if (!settings.uses_normals()) return true;  // the plain method: any three points are a plane
  const double sigma = settings.distance_tolerance_m / kSigmas;
  const double width = std::sqrt(fit.eigenvalues[1]);
  return width >= kLeastWidthInSigmas * sigma &&
         width * std::sqrt(static_cast<double>(fit.n)) * kLargestTurn_rad >= sigma;
}

bool too_rough(const SurfaceSettings& settings, double sigma_m) {
  // Points evenly spread over the tolerance, as where a plane cuts through clutter, a pipe or a step, have an rms of
  // 0.46 tolerances after the core is cut and more before; noise with the tolerance at 2.5 sigma has 0.38.
  constexpr double kMaxPlaneRoughness = 0.42;
  return settings.uses_normals() && sigma_m > kMaxPlaneRoughness * settings.distance_tolerance_m;
}

double core_reach(const SurfaceSettings& settings, double sigma_m) {
  const double tolerance = settings.distance_tolerance_m;
  if (!settings.uses_normals())
    return tolerance;  // the plain method of Boulaassal 2010: the buffer zone alone decides
  return std::clamp(kSigmas * sigma_m, kLeastReach * tolerance, tolerance);
}

double settled_sigma(const RansacScene& scene, const PointPool& pool, const Candidate& candidate,
                     Task& task) {
  Surface surface;
  surface.plane = candidate.plane;
  Window window = first_window(scene, candidate);
  ExtractionMembers members;
  return settle_plane(scene, pool, task, surface, window, members) ? surface.sigma_m : INFINITY;
}

bool extract_surface(RansacScene& scene, PointPool& pool, const OrientationPass& pass,
                     const Candidate& candidate, uint32_t owner_id, Task& task, Surface& out) {
  Surface surface;
  surface.plane = candidate.plane;
  Window window = first_window(scene, candidate);
  ExtractionMembers members;
  const bool settled = settle_plane(scene, pool, task, surface, window, members) &&
                       pass.accepts(surface.plane.normal);
  if (settled) {
    members = {};  // they would lie beside the new ones
    members = members_of(scene, pool, surface, window, task);
  }
  if (!settled || !large_enough_of_extraction(scene.settings, members)) {
    reject_of_extraction(scene, pool, candidate, members);
    return false;
  }
  surface.area_m2 = members.area_m2;
  surface.pixel_m = members.pixel_m;
  surface.positions.resize(members.slots.size());
  parallel_for(task, members.slots.size(), kExtractionPointsPerChunk,
               [&](size_t begin, size_t end) {
                 for (size_t i = begin; i < end; ++i) {
                   surface.positions[i] = pool.position(members.slots[i]);
                   scene.owner[surface.positions[i]] = owner_id;
                 }
               });
  pool.remove(members.slots, task);
  members.slots = {};
  sort_runs(surface.positions);
  out = std::move(surface);
  return true;
}

}  // namespace jalon
