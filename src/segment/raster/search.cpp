// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/raster/search.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/parallel.h"
#include "segment/raster/image_box.h"
#include "segment/raster/layers.h"
#include "segment/raster/pixel_growth.h"

namespace jalon {

namespace {

constexpr uint32_t kBridgedPixels = 2;  // of gap_m = 0
constexpr uint32_t kMostReach = 64;     // pixels: a ray is followed no farther
constexpr double kLeastRegion = 0.25;   // of the least segment: such pieces may be joined
// Between pixels that fit the points left and those that fitted the points before: then the raster is made anew, so
// that those wait no longer that stood too far apart. Anything from 1.1 to 1.4 does as well on S1, S3, S11, the street.
constexpr double kOtherDensity = 1.25;
constexpr double kFewTaken = 0.02;  // of the points: without them the median spacing is what it was
constexpr size_t kRasterPixelsPerChunk = 1 << 12;
constexpr size_t kCandidatesPerChunk = 1 << 16;

PixelRule rule_of(const RasterSettings& settings, const DepthImage& image, const RasterScale& scale,
                  size_t free_points) {
  PixelRule rule;
  rule.tolerance_m = std::max(settings.surface.distance_tolerance_m, image.quantum_m);
  rule.seed_pixels = settings.seed_pixels | 1u;
  const double bridged = settings.gap_m > 0 ? std::floor(settings.gap_m / image.pixel_m)
                                            : static_cast<double>(kBridgedPixels);
  rule.reach_pixels =
      1 + static_cast<uint32_t>(scale.bridges ? std::min<double>(kMostReach, bridged) : 0.0);
  const double filled =
      static_cast<double>(std::count(image.occupied.begin(), image.occupied.end(), uint8_t{1}));
  const double by_area = settings.surface.min_area_m2 / (image.pixel_m * image.pixel_m);
  const double by_points = settings.surface.min_points * filled / static_cast<double>(free_points);
  rule.least_pixels =
      std::max(scale.least_pixels,
               static_cast<uint64_t>(
                   std::max(rule.seed_pixels * 2.0, kLeastRegion * std::max(by_area, by_points))));
  return rule;
}

// The free points of the regions' pixels that lie in their planes; the pixels where there were such.
struct TakenPoints {
  size_t points = 0;
  std::vector<uint32_t> pixels;
  TakenPoints& operator+=(const TakenPoints& b) {
    points += b.points;
    pixels.insert(pixels.end(), b.pixels.begin(), b.pixels.end());
    return *this;
  }
};

TakenPoints take_points(SegmentScene& scene, const RasterLayers& layers,
                        const PixelRegions& regions, double tolerance_m, uint32_t first_id,
                        Task& task) {
  const double cosine = scene.min_cosine();
  return parallel_reduce(task, regions.pixels.size(), kRasterPixelsPerChunk, TakenPoints{},
                         [&](size_t begin, size_t end) {
                           TakenPoints taken;
                           for (size_t k = begin; k < end; ++k) {
                             const size_t before = taken.points;
                             const uint32_t label = regions.labels[k];
                             const Plane& plane = regions.planes[label - 1];
                             for (const uint32_t i : layers.points_of(regions.pixels[k])) {
                               if (scene.owner[i] != 0 ||
                                   std::fabs(plane.distance(scene.local(i))) > tolerance_m ||
                                   scene.inconsistent(i, plane.normal, cosine))
                                 continue;
                               scene.owner[i] = first_id + label - 1;
                               ++taken.points;
                             }
                             if (taken.points > before) taken.pixels.push_back(regions.pixels[k]);
                           }
                           return taken;
                         });
}

class RasterSearch {
 public:
  RasterSearch(SegmentScene& scene, const RasterSettings& settings, const RasterScale& scale,
               uint32_t first_id, Task& task)
      : scene_(scene),
        settings_(settings),
        scale_(scale),
        spacings_(scene),
        next_id_(first_id),
        task_(task) {
    const size_t all = (scene.size() + scale.step - 1) / scale.step;
    candidates_ = free_among(all, [&](size_t k) { return static_cast<uint32_t>(k * scale.step); });
    free_points_ = candidates_.size();
  }

  // Those of most points, then those of what lies far from them: a stray point makes no image of all too wide.
  void grow_along(const ImageAxes& axes) {
    candidates_ = free_among(candidates_.size(), [&](size_t k) { return candidates_[k]; });
    if (free_points_ < least_points()) return;
    std::vector<uint32_t> far = far_candidates(scene_, candidates_, axes, own_pixel_m(), task_);
    if (far.empty()) return grow_layers(axes, candidates_);
    std::vector<uint32_t> group = candidates_;
    for (double begin = 0; group.size() >= least_points(); begin = (1 + begin) / 2) {
      ProgressSpan span(task_, begin, (1 + begin) / 2);
      std::vector<uint32_t> near;
      std::ranges::set_difference(group, far, std::back_inserter(near));
      grow_layers(axes, near);
      group = std::move(far);
      far = far_candidates(scene_, group, axes, own_pixel_m(), task_);
    }
  }

  uint32_t next_id() const { return next_id_; }

 private:
  size_t least_points() const { return std::max<size_t>(3, settings_.surface.min_points); }

  // Rasters along one direction until one takes nothing worth while: behind the first, regions start where the one
  // before took what stood in front, as long as the points left are about as dense.
  void grow_layers(const ImageAxes& axes, std::span<const uint32_t> candidates) {
    RasterLayers layers(scene_, settings_, candidates);
    PixelGrowth growth;
    TakenPoints taken;
    double pixel_m = 0;
    const DepthImage& image = layers.image();
    for (uint32_t layer = 0; layer < settings_.layers; ++layer) {
      if (free_points_ < least_points()) break;
      ProgressSpan span(task_, static_cast<double>(layer) / settings_.layers,
                        (layer + 1.0) / settings_.layers);
      const double own_m = own_pixel_m();
      const bool anew = own_m > kOtherDensity * pixel_m || own_m * kOtherDensity < pixel_m;
      if (anew) layers.look_along(axes, pixel_m = own_m, task_);
      else layers.look_behind(taken.pixels, task_);
      const PixelRule rule = rule_of(settings_, image, scale_, free_points_);
      const std::vector<uint32_t> seeds =
          anew ? pixel_seeds(image, rule, task_) : pixel_seeds(image, rule, taken.pixels, task_);
      const PixelRegions regions = growth.grow(image, rule, seeds, task_);
      taken = take_points(scene_, layers, regions, rule.tolerance_m, next_id_, task_);
      next_id_ += static_cast<uint32_t>(regions.planes.size());
      free_points_ -= taken.points;
      if (taken.points < settings_.surface.min_points || taken.points == 0) break;
    }
  }

  // Those of the positions at(0) ... at(n - 1) that are free.
  template <class At>
  std::vector<uint32_t> free_among(size_t n, const At& at) {
    std::vector<std::vector<uint32_t>> parts((n + kCandidatesPerChunk - 1) / kCandidatesPerChunk);
    parallel_for(task_, n, kCandidatesPerChunk, [&](size_t begin, size_t end) {
      for (size_t k = begin; k < end; ++k)
        if (scene_.owner[at(k)] == 0) parts[begin / kCandidatesPerChunk].push_back(at(k));
    });
    std::vector<uint32_t> out;
    for (const auto& part : parts) out.insert(out.end(), part.begin(), part.end());
    return out;
  }

  // The pixel that fits the points left, looked for anew when some of them went.
  double own_pixel_m() {
    const double few = kFewTaken * static_cast<double>(looked_at_);
    if (looked_at_ == 0 || static_cast<double>(looked_at_ - free_points_) > few) {
      pixel_m_ = scale_.pixels * image_pixel_m(scene_, spacings_);
      looked_at_ = free_points_;
    }
    return pixel_m_;
  }

  SegmentScene& scene_;
  const RasterSettings& settings_;
  const RasterScale& scale_;
  SpacingSample spacings_;
  uint32_t next_id_;
  Task& task_;
  std::vector<uint32_t> candidates_;  ///< that were free before this direction
  size_t free_points_ = 0;
  double pixel_m_ = 0;
  size_t looked_at_ = 0;  ///< free points when pixel_m_ was found
};

}  // namespace

uint32_t search_rasters(SegmentScene& scene, const RasterSettings& settings,
                        std::span<const ImageAxes> axes, const RasterScale& scale,
                        uint32_t first_id, Task& task) {
  RasterSearch search(scene, settings, scale, first_id, task);
  const auto parts = static_cast<double>(axes.size());
  for (size_t d = 0; d < axes.size(); ++d) {
    const auto part = static_cast<double>(d);
    ProgressSpan span(task, part / parts, (part + 1) / parts, "growing on rasters");
    search.grow_along(axes[d]);
  }
  return search.next_id() - first_id;
}

}  // namespace jalon
