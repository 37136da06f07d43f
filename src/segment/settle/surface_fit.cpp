// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/settle/surface_fit.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "geometry/contaminated_plane.h"
#include "geometry/curved_plane.h"
#include "segment/ransac/curved_extraction.h"
#include "segment/settle/each_surface.h"
#include "segment/surface/border.h"

namespace jalon {

namespace {

constexpr size_t kSurfaceFitPointsPerChunk = 1 << 14;
// Share of the points, and of the variance of their narrow side, that those away from the border must have to stand for
// the surface: strips keep all.
constexpr double kLeastInner = 0.3;
// And their number: the shift is a tenth of sigma at most, which fewer do not know to a third.
constexpr size_t kLeastInnerPoints = 1000;
constexpr double kBendSigmas =
    4;  // beyond doubt: 1 in 30 000 flat surfaces is taken for a curved one
constexpr double kCoreSigmas = 4;  // rejection of outliers in the last fit: biases sigma by 0.05 %
// Share of a surface's points: fewer, none of them farther off than the tolerance, shift its plane by less than a
// thousandth of the tolerance. The last fit is to all points.
constexpr double kLeastMoved = 1e-3;
constexpr double kBorderReach = 3;  // spacings within which a point has neighbours on all sides
constexpr size_t kMostForBorder = 50000;  // larger surfaces tell their border by pixels
// Points: their plane is right to a two-hundredth of its noise, which is itself a fraction of the tolerance.
constexpr size_t kEnoughForSharing = 1 << 16;

// For each point of the surface, 1 when it lies away from the surface's border. Where another surface meets this one at
// an angle, that one's points are within reach on one side only and shift the plane: 0.3 mm at a pane of 1.2 m whose
// reveals have too few points to be found as planes. Nothing else tells those points from the surface's own.
std::vector<uint8_t> inner_points(const SegmentScene& scene, const Surface& surface, Task& task) {
  const FlatFrame frame = plane_frame(surface.plane, scene.local(surface.positions[0]));
  const auto at = [&](size_t i) { return frame(scene.local(surface.positions[i])); };
  const size_t n = surface.positions.size();
  const Raster inner = eroded(closed(bounded_raster_of(n, at, surface.pixel_m, 1, task), 1), 1);
  std::vector<uint8_t> out(n);
  parallel_for(task, n, kSurfaceFitPointsPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) out[i] = inner.pixels[inner.pixel_of(at(i))];
  });
  return out;
}

struct CoreMoments {
  Moments all, inner;
  CoreMoments& operator+=(const CoreMoments& b) {
    all += b.all;
    inner += b.inner;
    return *this;
  }
};

CoreMoments core_moments(const SegmentScene& scene, const Surface& surface,
                         std::span<const uint8_t> inner, Task& task) {
  const SurfaceSettings& settings = scene.settings;
  const double reach =
      settings.uses_normals() && surface.sigma_m > 0
          ? std::min(settings.distance_tolerance_m,
                     std::max(kCoreSigmas * surface.sigma_m, core_reach(settings, surface.sigma_m)))
          : INFINITY;
  const double min_cosine = scene.min_cosine();
  CoreMoments zero;
  zero.all.reference = zero.inner.reference = scene.local(surface.positions[0]);
  const auto part_of = [&](size_t begin, size_t end) {
    CoreMoments part = zero;
    for (size_t i = begin; i < end; ++i) {
      if (i + kFetchedAhead < end) scene.fetch_exact(surface.positions[i + kFetchedAhead]);
      const Vec3 p = scene.exact(surface.positions[i]);
      if (std::fabs(surface.plane.distance(p)) > reach) continue;
      if (scene.inconsistent(surface.positions[i], surface.plane.normal, min_cosine)) continue;
      part.all.add(p);
      if (!inner.empty() && inner[i] != 0) part.inner.add(p);
    }
    return part;
  };
  return parallel_reduce(task, surface.positions.size(), kSurfaceFitPointsPerChunk, zero, part_of);
}

// Do the fits to all points and to the inner ones differ by more than chance? The difference of an efficient and a
// consistent estimate has the difference of their variances (Hausman 1978, 2.4): of the height at the inner points'
// centroid and of the two slopes there.
bool border_shifts(const PlaneFit& all, const PlaneFit& inner) {
  constexpr double kHeightAndSlopes99 = 11.345;  // chi-square, 3 degrees of freedom, 0.99
  const double n_all = static_cast<double>(all.n), n_inner = static_cast<double>(inner.n);
  const double squared = inner.sigma * inner.sigma;
  const auto term = [&](double difference, double inner_weight, double all_weight) {
    const double variance =
        squared * std::max(1 / inner_weight - 1 / all_weight, 0.1 / inner_weight);
    return difference * difference / variance;
  };
  const double sign = dot(all.plane.normal, inner.plane.normal) < 0 ? -1 : 1;
  const Vec3 turn = sign * all.plane.normal - inner.plane.normal;
  const double height = term(all.plane.distance(inner.centroid), n_inner, n_all);
  const double slope_u =
      term(dot(turn, inner.axis_u), n_inner * inner.eigenvalues[2], n_all * all.eigenvalues[2]);
  const double slope_v =
      term(dot(turn, inner.axis_v), n_inner * inner.eigenvalues[1], n_all * all.eigenvalues[1]);
  return height + slope_u + slope_v > kHeightAndSlopes99;
}

}  // namespace

bool is_large(const Surface& surface) { return surface.positions.size() >= 2 * kEnoughForSharing; }

std::vector<uint8_t> points_off_border(const SegmentScene& scene, const Surface& surface,
                                       Task& task) {
  const bool asked = scene.settings.connectivity && scene.settings.reassign &&
                     surface.positions.size() >= kLeastInnerPoints;
  return asked ? inner_points(scene, surface, task) : std::vector<uint8_t>{};
}

bool fit_core(const SegmentScene& scene, const Surface& surface, Task& task, PlaneFit& fit) {
  return fit_core(scene, surface, points_off_border(scene, surface, task), task, fit);
}

bool fit_core(const SegmentScene& scene, const Surface& surface, std::span<const uint8_t> inner,
              Task& task, PlaneFit& fit) {
  if (surface.positions.size() < 3) return false;
  const CoreMoments core = core_moments(scene, surface, inner, task);
  if (!fit_plane(core.all, fit)) return false;
  PlaneFit inside;
  const auto share = static_cast<double>(core.inner.n) / static_cast<double>(core.all.n);
  if (core.inner.n < kLeastInnerPoints || share < kLeastInner) return true;
  if (!fit_plane(core.inner, inside) || inside.eigenvalues[1] < kLeastInner * fit.eigenvalues[1])
    return true;
  if (!border_shifts(fit, inside)) return true;
  fit = inside;
  fit.sigma = rms_about(core.all, fit.plane);
  return true;
}

namespace {

// The points of a surface as seen from its plane, each with its zone: its normal must agree, as in the core.
std::vector<PlaneSample> samples_of(const SegmentScene& scene, const Surface& surface,
                                    std::span<const uint8_t> inner, const PlaneFit& fit,
                                    Task& task) {
  const double tolerance = scene.settings.distance_tolerance_m, min_cosine = scene.min_cosine();
  const size_t n = surface.positions.size();
  const bool by_pixels = n > kMostForBorder;
  std::vector<uint8_t> own_zones;
  if (by_pixels && inner.empty()) inner = own_zones = inner_points(scene, surface, task);
  std::vector<PlaneSample> samples(n);
  // Each chunk leaves those that count at its beginning.
  std::vector<size_t> kept((n + kSurfaceFitPointsPerChunk - 1) / kSurfaceFitPointsPerChunk, 0);
  parallel_for(task, n, kSurfaceFitPointsPerChunk, [&](size_t begin, size_t end) {
    size_t to = begin;
    for (size_t i = begin; i < end; ++i) {
      if (i + kFetchedAhead < end) scene.fetch_exact(surface.positions[i + kFetchedAhead]);
      const Vec3 d = scene.exact(surface.positions[i]) - fit.centroid;
      const double across = dot(d, fit.plane.normal);
      if (std::fabs(across) > tolerance ||
          scene.inconsistent(surface.positions[i], fit.plane.normal, min_cosine))
        continue;
      samples[to++] = {static_cast<float>(dot(d, fit.axis_u)),
                       static_cast<float>(dot(d, fit.axis_v)), static_cast<float>(across),
                       by_pixels ? inner[i] : 1u};
    }
    kept[begin / kSurfaceFitPointsPerChunk] = to - begin;
  });
  auto to = samples.begin();
  for (size_t chunk = 0; chunk < kept.size(); ++chunk) {
    const auto from = samples.begin() + static_cast<ptrdiff_t>(chunk * kSurfaceFitPointsPerChunk);
    to = std::move(from, from + static_cast<ptrdiff_t>(kept[chunk]), to);
  }
  samples.erase(to, samples.end());
  if (by_pixels) return samples;
  // Surfaces at right angles to this one have all their points within the noise of its border; at 45 degrees, within
  // the tolerance of it.
  const double spacing = std::sqrt(surface.area_m2 / static_cast<double>(surface.positions.size()));
  std::vector<Vec2> uv;
  for (const PlaneSample& s : samples)
    uv.push_back({static_cast<double>(s.u), static_cast<double>(s.v)});
  const auto border =
      border_points(uv, tolerance, std::max(kBorderReach * spacing, 2 * tolerance), task);
  for (size_t i = 0; i < samples.size(); ++i) samples[i].zone = 1u - border[i];
  return samples;
}

}  // namespace

bool settle_surface(const SegmentScene& scene, const Surface& surface,
                    std::span<const uint8_t> inner, Task& task, PlaneFit& fit) {
  std::vector<PlaneSample> samples = samples_of(scene, surface, inner, fit, task);
  return settle_contaminated_plane(samples, scene.settings.distance_tolerance_m, task, fit);
}

namespace {

// True when the surface bends, beyond doubt, more tightly than the least radius.
bool bends(const SegmentScene& scene, const Surface& surface, const PlaneFit& fit, Task& task) {
  const double radius = scene.settings.least_radius_m;
  // Noise aside, a surface of that radius is within the tolerance on both sides of a plane over sqrt(16 r t) only.
  const double width = std::sqrt(16 * radius * scene.settings.distance_tolerance_m);
  const double narrow = std::sqrt(12 * fit.eigenvalues[1]);  // of evenly spread points
  if (radius == 0 || narrow > width) return false;
  const double long_m = std::sqrt(fit.eigenvalues[2]), across_m = std::sqrt(fit.eigenvalues[1]);
  if (!(across_m > 0)) return false;
  const auto sums_of = [&](size_t begin, size_t end) {
    BendSums part;
    for (size_t i = begin; i < end; ++i) {
      const Vec3 d = scene.exact(surface.positions[i]) - fit.centroid;
      part.add(dot(d, fit.axis_u) / long_m, dot(d, fit.axis_v) / across_m,
               dot(d, fit.plane.normal));
    }
    return part;
  };
  const BendSums sums = parallel_reduce(task, surface.positions.size(), kSurfaceFitPointsPerChunk,
                                        BendSums{}, sums_of);
  Bend bend;
  if (!largest_bend(sums, long_m, across_m, bend)) return false;
  return std::fabs(bend.curvature) > 1 / radius &&
         std::fabs(bend.curvature) - 1 / radius > kBendSigmas * bend.sigma;
}

// While points are shared out, every so many-th of a large surface's tells its plane well enough.
Surface thinned(const Surface& surface) {
  Surface out = surface.without_points();
  const size_t step = surface.positions.size() / kEnoughForSharing;
  for (size_t i = 0; i < surface.positions.size(); i += step)
    out.positions.push_back(surface.positions[i]);
  out.pixel_m *= std::sqrt(static_cast<double>(step));  // as many points a pixel
  return out;
}

bool refit_to(const SegmentScene& scene, const Surface& surface, Task& task, PlaneFit& fit) {
  if (is_large(surface)) return refit_to(scene, thinned(surface), task, fit);
  return fit_core(scene, surface, task, fit) && wide_enough(scene.settings, fit) &&
         !too_rough(scene.settings, fit.sigma) && !bends(scene, surface, fit, task);
}

// The plane, its sigma and its area anew from the surface's points; false when it is none any more.
bool refit_plane(const SegmentScene& scene, Surface& surface, Task& task) {
  const SurfaceSettings& settings = scene.settings;
  PlaneFit fit;
  if (surface.positions.size() < std::max<size_t>(3, settings.min_points) ||
      !refit_to(scene, surface, task, fit))
    return false;
  surface.plane = fit.plane;
  surface.sigma_m = fit.sigma;
  const FlatFrame frame = plane_frame(surface.plane, scene.local(surface.positions[0]));
  const auto at = [&](size_t i) { return frame(scene.local(surface.positions[i])); };
  surface.image = bounded_raster_of(surface.positions.size(), at, surface.pixel_m, 1, task);
  surface.area_m2 = occupied_area_m2(surface.image);
  return surface.area_m2 >= settings.min_area_m2;
}

// Few points that came or went do not shift a plane.
bool fit_stands(const Surface& surface) {
  return static_cast<double>(surface.sharing.moved) <=
         kLeastMoved * static_cast<double>(surface.positions.size());
}

}  // namespace

bool refit_surfaces(SegmentScene& scene, std::vector<Surface>& surfaces, Task& task) {
  std::vector<uint8_t> lost(surfaces.size(), 0);
  for_each_surface(surfaces, task, [&](size_t s) {
    Surface& surface = surfaces[s];
    if (fit_stands(surface)) return;
    surface.sharing.fresh = true;
    surface.sharing.moved = 0;
    lost[s] = surface.is_plane() ? !refit_plane(scene, surface, task)
                                 : !refit_curved(scene, surface, task);
  });
  bool dropped = false;
  for (size_t s = 0; s < surfaces.size(); ++s) {
    if (lost[s] == 0) continue;
    for (const uint32_t position : surfaces[s].positions) scene.owner[position] = 0;
    surfaces[s].positions.clear();
    dropped = true;
  }
  std::erase_if(surfaces, [](const Surface& s) { return s.positions.empty(); });
  return dropped;
}

}  // namespace jalon
