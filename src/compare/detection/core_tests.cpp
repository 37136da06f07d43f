// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/detection/core_tests.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "base/parallel.h"
#include "compare/detection/common_misfit.h"
#include "compare/detection/false_discovery.h"

namespace jalon {

namespace {

constexpr size_t kTestGrain = 512;
constexpr uint32_t kCandidates =
    6;  // of the reference's cores: those around, and one behind an edge
constexpr uint32_t kBorderCandidates = 16;  // where the surface of a core may have ended
constexpr double kSameFacing = 0.866;       // cosine of 30 degrees
// A disc of points ends at 4 standard deviations squared, beyond 6 nothing supports a foot.
constexpr double kMostAside2 = 6;
// Scatter beyond so many times the noise is shape, which more points do not average out.
constexpr double kNoiseSpread = 1.25;
constexpr double kRough = 0.25;              // scatter over radius: no plane
constexpr double kMadSigma = 1.4826;         // median of |z| to a standard deviation
constexpr size_t kMisalignmentCores = 8192;  // the median of their deviates is right to 1 %
constexpr double kPartsAlong = 8;            // of the scene's longest side
constexpr size_t kLeastOfPart = 10;          // cores, for their median
// Of |z|: the share below, and how many sigmas. The greater counts, for few stations err in few ways, and a quarter of
// the scene may really have changed.
constexpr std::array<std::pair<double, double>, 2> kNormalQuantiles{
    {{0.5, 0.6745}, {0.75, 1.1503}}};
constexpr int kMisalignmentHalvings = 24;  // of metres: to a micrometre
constexpr double kExplained2 = 4;          // variances that a bend may leave: 95 %
constexpr double kMarginSigmas = 4;        // of noise, about a surface that was seen

/// A plane that is as wide as its points are rough is none, nor is one row of points under grazing rays, which noise
/// alone spreads along them. A disc of points ends at 2 standard deviations.
bool is_surface(const SurfaceCore& core, double noise_m) {
  return core.has_plane() && core.sigma_m <= kRough * core.radius_m &&
         noise_m <= kRough * 2 * std::sqrt(core.spread_v2);
}

double shape2(const SurfaceCore& core, double noise_m) {
  const double noise = kNoiseSpread * noise_m;
  return std::max(0.0, core.sigma_m * core.sigma_m - noise * noise);
}

/// z of the same p-value as t (Wallace's approximation as simplified by Gleason): the scatter is of few points.
double deviate(double t, double degrees) {
  return std::sqrt(degrees * std::log1p(t * t / degrees)) * (1 - 3 / (4 * degrees));
}

struct Offset {
  double distance_m = 0, variance_m2 = 0;
};

/// Of a core from the plane of the other epoch beside it.
Offset offset_from_plane(const SurfaceCore& core, const SurfaceCore& surface) {
  return {dot(surface.normal, core.centroid - surface.centroid),
          core.height_variance() + surface.variance_at(core.centroid)};
}

/// The same for one curved surface that did not move. Along the surface's normal a curved one that did not move
/// has one, by the bend between both; along the mean of both normals it has none to second order (Rusinkiewicz 2019,
/// the symmetric objective of ICP), but the core's own normal brings its scatter. So the correction counts by what of
/// it the scatter of the normals does not explain (the positive part of James & Stein 1961): none of it on a plane.
Offset offset_of(const SurfaceCore& core, const SurfaceCore& surface) {
  const Vec3 apart = core.centroid - surface.centroid;
  const Vec3 facing = dot(surface.normal, core.normal) < 0 ? -core.normal : core.normal;
  const double lever = surface.lever_variance_at(core.centroid),
               own_lever = core.lever_variance_at(surface.centroid);
  const double bend = dot(facing - surface.normal, apart) / 2;
  const double scatter = (lever + own_lever) / 4;
  const double share = bend * bend > scatter ? 1 - scatter / (bend * bend) : 0;
  const double weight = 1 - share / 2, own_weight = share / 2;  // of the normals
  return {dot(surface.normal, apart) + share * bend,
          core.height_variance() + surface.height_variance() + weight * weight * lever +
              own_weight * own_weight * own_lever};
}

/// The same for discs of two sizes, as scans of two densities have them: on a curved surface the middle of the wider
/// one lies deeper inside the bend. How much the surface curves is told by both, and counts by what of it their scatter
/// does not explain.
Offset without_sags(const Offset& bent, const SurfaceCore& core, const SurfaceCore& surface) {
  const auto weight = [](const SurfaceCore& of) {
    constexpr double kLeastSigma_per_m = 1e-9;  // of points without noise
    const double sigma = std::max<double>(of.curving_sigma_per_m, kLeastSigma_per_m);
    return 1 / (sigma * sigma);
  };
  const double side = dot(surface.normal, core.normal) < 0 ? -1 : 1;
  const double own = weight(core), others = weight(surface);
  const double curving_per_m =
      (own * side * core.curving_per_m + others * surface.curving_per_m) / (own + others);
  const double wider_m2 = core.spread2() - surface.spread2();
  const double sag_m = curving_per_m * wider_m2, scatter = wider_m2 * wider_m2 / (own + others);
  const double share = sag_m * sag_m > scatter ? 1 - scatter / (sag_m * sag_m) : 0;
  return {bent.distance_m - share * sag_m, bent.variance_m2 + share * share * scatter};
}

class Tester {
 public:
  Tester(const SurfaceCores& reference, double noise_m, std::span<const double> nearest_m,
         const Sights* sights, const Vec3& origin, const DetectionRates& rates)
      : reference_(reference),
        nearest_m_(nearest_m),
        sights_(sights),
        origin_(origin),
        rates_(rates),
        noise_m_(noise_m) {}

  // Step 1.
  CoreTest measured(const SurfaceCore& core) const {
    CoreTest out;
    out.distance_m = nearest_m_[core.point];
    std::array<Neighbour, kCandidates> found;
    const size_t n = reference_.nearest(core.centroid, kCandidates, found);
    if (n > 0) out.surface = found[0].index;
    if (!is_surface(core, noise_m_)) return out;
    for (size_t k = 0; k < n; ++k) {
      const SurfaceCore& surface = reference_[found[k].index];
      if (!is_surface(surface, noise_m_) ||
          std::abs(dot(surface.normal, core.normal)) < kSameFacing)
        continue;
      if (surface.aside2(core.centroid) > kMostAside2) continue;
      const double rest = shape2(core, noise_m_) + shape2(surface, noise_m_) +
                          rates_.alignment_m * rates_.alignment_m;
      const auto is_explained = [&](const Offset& off) {
        return off.distance_m * off.distance_m <= kExplained2 * (off.variance_m2 + rest);
      };
      Offset off = offset_of(core, surface);
      if (!is_explained(off)) off = without_sags(off, core, surface);
      if (!is_explained(off)) off = offset_from_plane(core, surface);
      if (out.has_surface && std::abs(off.distance_m) >= std::abs(out.distance_m)) continue;
      out.has_surface = true;
      out.surface = found[k].index;
      out.distance_m = off.distance_m;
      out.sigma_m = std::sqrt(off.variance_m2 + rest);
    }
    return out;
  }

  double z_of(const CoreTest& test, double scale) const {
    const double degrees = reference_[test.surface].count - 3.0;
    return deviate(test.distance_m / (scale * std::max(test.sigma_m, 1e-9)), degrees);
  }

  // Step 4.
  void settle(const SurfaceCore& core, double limit, double scale, CoreTest& test) const {
    const double reach = std::max(core.radius_m, reference_[test.surface].radius_m);
    const double margin = kMarginSigmas * noise_m_;
    if (test.has_surface) {
      if (z_of(test, scale) < limit) return;
      test.state = CoreState::kMoved;
      if (std::abs(test.distance_m) <= reach) return;
      // A surface far before or behind another is not that surface moved, unless the place was seen: but a flank of a
      // column whose other flank is that surface is as near to what was seen of the column as its points are apart.
      test.state = seen_or_not(core, margin);
      if (test.state == CoreState::kNew && nearest_m_[core.point] <= reach)
        test.state = CoreState::kUntold;
      return;
    }
    if (nearest_m_[core.point] <= reach + margin) return;
    test.state = seen_or_not(core, margin);
  }

  double noise_m() const { return noise_m_; }

 private:
  // Is the core on a surface of the reference that ends before it, as at the edge of a shadow or of the scan?
  bool goes_on(const SurfaceCore& core) const {
    std::array<Neighbour, kBorderCandidates> found;
    const size_t n = reference_.nearest(core.centroid, kBorderCandidates, found);
    for (size_t k = 0; k < n; ++k) {
      const SurfaceCore& surface = reference_[found[k].index];
      if (!is_surface(surface, noise_m_) ||
          std::abs(dot(surface.normal, core.normal)) < kSameFacing)
        continue;
      const double off = std::abs(dot(surface.normal, core.centroid - surface.centroid));
      const double reach = std::max(core.radius_m, surface.radius_m);
      const double sigma = std::sqrt(surface.variance_at(core.centroid));
      if (off <= std::min(kMarginSigmas * (noise_m_ + sigma), reach + kMarginSigmas * noise_m_))
        return true;
    }
    return false;
  }

  CoreState seen_or_not(const SurfaceCore& core, double margin_m) const {
    if (sights_ == nullptr) return goes_on(core) ? CoreState::kUntold : CoreState::kNew;
    const PlaceSight seen = sights_->look(core.centroid + origin_, core.normal, margin_m);
    return seen == PlaceSight::kThrough ? CoreState::kNew : CoreState::kUntold;
  }

  const SurfaceCores& reference_;
  std::span<const double> nearest_m_;
  const Sights* sights_;
  Vec3 origin_;
  DetectionRates rates_;
  double noise_m_;
};

/// Standard deviation of the deviates of all cores, by their median: what is common to most is no change (the
/// empirical null of Efron 2004).
double null_scale(const Tester& tester, const std::vector<CoreTest>& cores) {
  std::vector<double> sizes;
  for (const CoreTest& test : cores)
    if (test.has_surface) sizes.push_back(tester.z_of(test, 1));
  if (sizes.empty()) return 1;
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  return kMadSigma * *middle;
}

// The standard deviation that added to theirs makes the deviates of these cores what they should be.
double common_error_m(const Tester& tester, const std::vector<CoreTest>& cores, Task& task) {
  double most = 0;
  for (const CoreTest& test : cores) most = std::max(most, std::abs(test.distance_m));
  const auto scale_with = [&](double common_m) {
    std::vector<CoreTest> with = cores;
    for (CoreTest& test : with) test.sigma_m = std::hypot(test.sigma_m, common_m);
    return null_scale(tester, with);
  };
  if (cores.empty() || scale_with(0) <= 1) return 0;
  double low = 0, high = most;
  for (int halving = 0; halving < kMisalignmentHalvings; ++halving) {
    task.checkpoint(0);
    const double middle = (low + high) / 2;
    (scale_with(middle) > 1 ? low : high) = middle;
  }
  return high;
}

/// How far parts of surfaces lie apart, ascending: the medians of cores of a cell that face the same way. A scan's
/// errors are those of few stations, so neighbours err alike, and cores alone would let the largest surface speak for
/// all.
std::vector<double> part_offsets(const SurfaceCores& reference, const SurfaceCores& compared,
                                 const std::vector<CoreTest>& tests) {
  Box3 box;
  for (size_t k = 0; k < tests.size(); ++k)
    if (tests[k].has_surface) box.add(compared[k].centroid);
  if (box.empty()) return {};
  const Vec3 size = box.max - box.min;
  const double cell = std::max({size.x, size.y, size.z, 1e-9}) / kPartsAlong;
  std::map<std::array<int, 4>, std::vector<double>> parts;
  for (size_t k = 0; k < tests.size(); ++k) {
    if (!tests[k].has_surface) continue;
    const Vec3 at = (compared[k].centroid - box.min) / cell;
    const Vec3& normal = reference[tests[k].surface].normal;
    int axis = 0;
    for (int c = 1; c < 3; ++c)
      if (std::abs(normal[c]) > std::abs(normal[axis])) axis = c;
    const double side = normal[axis] < 0 ? -1 : 1;
    parts[{static_cast<int>(at.x), static_cast<int>(at.y), static_cast<int>(at.z), axis}].push_back(
        side * tests[k].distance_m);
  }
  std::vector<double> out;
  for (auto& [key, offsets] : parts) {
    if (offsets.size() < kLeastOfPart) continue;
    const auto middle = offsets.begin() + static_cast<std::ptrdiff_t>(offsets.size() / 2);
    std::nth_element(offsets.begin(), middle, offsets.end());
    out.push_back(std::abs(*middle));
  }
  std::ranges::sort(out);
  return out;
}

/// Whether most surfaces have the other epoch's within the reach of their own points: only then are both epochs of one
/// scene, and what they differ by a matter of registration.
bool is_of_one_scene(const SurfaceCores& reference, const SurfaceCores& compared,
                     const std::vector<CoreTest>& tests) {
  size_t all = 0, near = 0;
  for (size_t k = 0; k < tests.size(); ++k) {
    if (!tests[k].has_surface) continue;
    ++all;
    const double reach = std::max(compared[k].radius_m, reference[tests[k].surface].radius_m);
    near += std::abs(tests[k].distance_m) <= reach ? 1 : 0;
  }
  return 2 * near > all;
}

// Cores of all parts, enough of them.
size_t sample_step(size_t cores) {
  return std::max<size_t>(1, (cores + kMisalignmentCores - 1) / kMisalignmentCores);
}

// Step 2: one motion of all of the scene.
CommonMisfit motion_of_all(const SurfaceCores& reference, const SurfaceCores& compared,
                           const std::vector<CoreTest>& tests, Task& task) {
  std::vector<SurfaceOffset> sample;
  for (size_t k = 0; k < tests.size(); k += sample_step(tests.size()))
    if (tests[k].has_surface)
      sample.push_back({compared[k].centroid, reference[tests[k].surface].normal,
                        tests[k].distance_m, tests[k].sigma_m});
  return common_misfit(sample, task);
}

// Step 2: each part of it by its own.
double own_misalignment_m(const Tester& tester, const SurfaceCores& reference,
                          const SurfaceCores& compared, const std::vector<CoreTest>& tests,
                          Task& task) {
  std::vector<CoreTest> sample;
  for (size_t k = 0; k < tests.size(); k += sample_step(tests.size()))
    if (tests[k].has_surface) sample.push_back(tests[k]);
  double out = common_error_m(tester, sample, task);
  if (out == 0) return 0;  // to their noise
  const std::vector<double> parts = part_offsets(reference, compared, tests);
  for (const auto& [share, sigmas] : kNormalQuantiles)
    if (!parts.empty())
      out = std::max(
          out, parts[static_cast<size_t>(share * static_cast<double>(parts.size()))] / sigmas);
  return out;
}

double root_mean_square(const std::vector<double>& moved_m, const std::vector<CoreTest>& tests) {
  double sum = 0, n = 0;
  for (size_t k = 0; k < tests.size(); ++k)
    if (tests[k].has_surface) sum += moved_m[k] * moved_m[k], ++n;
  return n > 0 ? std::sqrt(sum / n) : 0;
}

}  // namespace

CoreTests test_cores(const SurfaceCores& reference, const SurfaceCores& compared,
                     std::span<const double> nearest_m, const Sights* sights, const Vec3& origin,
                     const DetectionRates& rates, Task& task) {
  const double noise_m = std::max(reference.noise_m(), compared.noise_m());
  const Tester tester(reference, noise_m, nearest_m, sights, origin, rates);
  CoreTests out;
  out.noise_m = tester.noise_m();
  out.cores.resize(compared.size());
  parallel_for(task, out.cores.size(), kTestGrain, [&](size_t begin, size_t end) {
    for (size_t k = begin; k < end; ++k) out.cores[k] = tester.measured(compared[k]);
  });
  // 2.
  const bool is_one_scene = is_of_one_scene(reference, compared, out.cores);
  const CommonMisfit misfit =
      is_one_scene ? motion_of_all(reference, compared, out.cores, task) : CommonMisfit{};
  std::vector<double> moved_m(out.cores.size(), 0);  // by that motion
  std::vector<CoreTest> rest = out.cores;
  for (size_t k = 0; k < rest.size(); ++k) {
    if (!rest[k].has_surface) continue;
    moved_m[k] = misfit.offset_m(compared[k].centroid, reference[rest[k].surface].normal);
    rest[k].distance_m -= moved_m[k];
  }
  const double own_m =
      is_one_scene ? own_misalignment_m(tester, reference, compared, rest, task) : 0;
  for (CoreTest& test : rest) test.sigma_m = std::hypot(test.sigma_m, own_m);
  out.null_scale = std::max(1.0, null_scale(tester, rest));
  for (size_t k = 0; k < rest.size(); ++k)
    out.cores[k].sigma_m = std::hypot(rest[k].sigma_m, moved_m[k]);
  out.misalignment_m = std::hypot(own_m, root_mean_square(moved_m, out.cores));
  // 3.
  std::vector<double> p_values;
  for (const CoreTest& test : out.cores)
    if (test.has_surface) p_values.push_back(normal_p_value(tester.z_of(test, out.null_scale)));
  out.tested = p_values.size();
  const double p = discovery_limit(std::move(p_values), rates.false_discovery);
  out.limit_sigmas = deviate_of(p);
  // 4.
  parallel_for(task, out.cores.size(), kTestGrain, [&](size_t begin, size_t end) {
    for (size_t k = begin; k < end; ++k)
      tester.settle(compared[k], out.limit_sigmas, out.null_scale, out.cores[k]);
  });
  return out;
}

}  // namespace jalon
