// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/raster/pixel_growth.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "segment/raster/grey_plane.h"

namespace jalon {

namespace {

constexpr double kLeastFilled =
    0.55;  // of a seed's window: five of nine, as where a strip has two columns
constexpr double kSeedResidual = 0.5;    // rms of a seed, in tolerances (as of other seeds)
constexpr double kRegionResidual = 0.5;  // the same of a finished region
constexpr double kLeastCosine = 0.75;    // 41 degrees between a plane and its image
constexpr double kSteepest =
    0.88;  // slope at that cosine: farther off is another depth, seen through a gap
constexpr double kPixelRefit = 1.1;      // growth after which the plane is solved anew
constexpr size_t kResidualSteps = 1024;  // classes of residuals that order the seeds
constexpr size_t kSeedPixelsPerChunk = 1 << 12;
constexpr size_t kPixelsPerCheckpoint = 1 << 13;
constexpr uint16_t kNoSeed = 0xffff;

class PixelGrower {
 public:
  PixelGrower(const DepthImage& image, const PixelRule& rule, Task& task)
      : image_(image), rule_(rule), task_(task), seen_(image.size(), 0) {
    regions_.labels.assign(image.size(), 0);
  }

  PixelRegions run() {
    const std::vector<uint32_t> seeds = seeds_by_residual();
    for (size_t i = 0; i < seeds.size(); ++i) {
      progress_ = static_cast<double>(i) / static_cast<double>(seeds.size());
      if (i % kPixelsPerCheckpoint == 0) task_.checkpoint(progress_);
      if (seen_[seeds[i]] != kSpent) try_seed(seeds[i]);
    }
    return std::move(regions_);
  }

 private:
  static constexpr uint32_t kSpent = 0xffffffffu;  // in a region, or in what was none

  // Sums over a seed's window; false where too few of its pixels are filled or one is taken.
  bool window_sums(size_t centre, GreySums& sums) const {
    const int64_t half = rule_.seed_pixels / 2;
    const auto column = static_cast<int64_t>(centre % image_.columns);
    const auto row = static_cast<int64_t>(centre / image_.columns);
    if (image_.occupied[centre] == 0 || column < half || row < half ||
        column + half >= image_.columns || row + half >= image_.rows)
      return false;
    const DepthImage::Pixel& own = image_.pixels[centre];
    sums = GreySums(own.u, own.v, own.g);
    const double one_depth = kSteepest * rule_.seed_pixels * image_.pixel_m + 2 * rule_.tolerance_m;
    for (int64_t r = row - half; r <= row + half; ++r)
      for (int64_t c = column - half; c <= column + half; ++c) {
        const auto p = static_cast<size_t>(r * image_.columns + c);
        if (image_.occupied[p] == 0) continue;
        if (regions_.labels[p] != 0) return false;
        const DepthImage::Pixel& pixel = image_.pixels[p];
        if (std::fabs(static_cast<double>(pixel.g) - static_cast<double>(own.g)) <= one_depth)
          sums.add(pixel.u, pixel.v, pixel.g);
      }
    const double edge = rule_.seed_pixels;
    return sums.count() >= kLeastFilled * edge * edge;
  }

  bool seed_plane(size_t centre, GreySums& sums, GreyPlane& plane) const {
    return window_sums(centre, sums) && sums.fit(plane) && plane.cosine() >= kLeastCosine &&
           plane.rms * plane.cosine() <= kSeedResidual * rule_.tolerance_m;
  }

  // Least residual first, by classes of it; within a class in the order of the image.
  std::vector<uint32_t> seeds_by_residual() const {
    std::vector<uint16_t> steps(image_.size(), kNoSeed);
    const double per_step = kSeedResidual * rule_.tolerance_m / (kResidualSteps - 1);
    parallel_for(task_, image_.size(), kSeedPixelsPerChunk, [&](size_t begin, size_t end) {
      GreySums sums;
      GreyPlane plane;
      for (size_t p = begin; p < end; ++p)
        if (seed_plane(p, sums, plane))
          steps[p] = static_cast<uint16_t>(plane.rms * plane.cosine() / per_step);
    });
    std::vector<uint32_t> next(kResidualSteps + 1, 0);
    for (const uint16_t step : steps)
      if (step != kNoSeed) ++next[step + 1u];
    for (size_t s = 0; s < kResidualSteps; ++s) next[s + 1] += next[s];
    std::vector<uint32_t> seeds(next[kResidualSteps]);
    for (size_t p = 0; p < steps.size(); ++p)
      if (steps[p] != kNoSeed) seeds[next[steps[p]]++] = static_cast<uint32_t>(p);
    return seeds;
  }

  void try_seed(uint32_t seed) {
    GreySums sums;
    GreyPlane plane;
    if (!seed_plane(seed, sums, plane)) return;
    ++round_;
    const auto label = static_cast<uint32_t>(regions_.planes.size() + 1);
    const DepthImage::Pixel& own = image_.pixels[seed];
    GreySums region(own.u, own.v, own.g);
    members_.clear();
    take(seed, label, region);
    grow(label, plane, region);
    const bool good = members_.size() >= rule_.least_pixels && region.fit(plane) &&
                      plane.cosine() >= kLeastCosine &&
                      plane.rms * plane.cosine() <= kRegionResidual * rule_.tolerance_m;
    for (const uint32_t member : members_) {
      seen_[member] = kSpent;
      if (!good) regions_.labels[member] = 0;
    }
    if (good) regions_.planes.push_back(in_scene(plane));
  }

  void take(size_t p, uint32_t label, GreySums& region) {
    const DepthImage::Pixel& pixel = image_.pixels[p];
    seen_[p] = round_;
    regions_.labels[p] = label;
    region.add(pixel.u, pixel.v, pixel.g);
    members_.push_back(static_cast<uint32_t>(p));
  }

  // Breadth first, so that the plane is fitted to a compact patch as early as possible. Asked are the pixels to the
  // left, to the right, below and above, within reach: beyond an empty one, or beyond one of another depth.
  void grow(uint32_t label, GreyPlane& plane, GreySums& region) {
    PixelFit fit{plane, plane.cosine(), 1};
    for (size_t at = 0; at < members_.size(); ++at) {
      if ((at + 1) % kPixelsPerCheckpoint == 0) task_.checkpoint(progress_);
      const size_t from = members_[at];
      const size_t column = from % image_.columns, row = from / image_.columns;
      const size_t reach = rule_.reach_pixels, step = image_.columns;
      for (size_t s = 1; s <= std::min(reach, column); ++s) ask(from - s, label, fit, region);
      for (size_t s = 1; s <= std::min(reach, step - 1 - column); ++s)
        ask(from + s, label, fit, region);
      for (size_t s = 1; s <= std::min(reach, row); ++s) ask(from - s * step, label, fit, region);
      for (size_t s = 1; s <= std::min(reach, image_.rows - 1 - row); ++s)
        ask(from + s * step, label, fit, region);
    }
  }

  struct PixelFit {
    GreyPlane plane;
    double cosine, fitted;
  };
  void ask(size_t p, uint32_t label, PixelFit& fit, GreySums& region) {
    if (image_.occupied[p] == 0 || seen_[p] == round_ || regions_.labels[p] != 0) return;
    if (seen_[p] != kSpent) seen_[p] = round_;
    const DepthImage::Pixel& pixel = image_.pixels[p];
    const double off = (static_cast<double>(pixel.g) - fit.plane.at(pixel.u, pixel.v)) * fit.cosine;
    if (std::fabs(off) > rule_.tolerance_m) return;
    take(p, label, region);
    const double window = rule_.seed_pixels * rule_.seed_pixels;
    if (region.count() < window || region.count() < kPixelRefit * fit.fitted) return;
    fit.fitted = region.count();
    if (region.fit(fit.plane)) fit.cosine = fit.plane.cosine();
  }

  Plane in_scene(const GreyPlane& plane) const {
    const ImageAxes& axes = image_.axes;
    const double cosine = plane.cosine();
    return {cosine * (axes.n - plane.a * axes.u - plane.b * axes.v), cosine * plane.c};
  }

  const DepthImage& image_;
  const PixelRule& rule_;
  Task& task_;
  PixelRegions regions_;
  std::vector<uint32_t> seen_;  ///< the last region that asked, or kSpent
  std::vector<uint32_t> members_;
  uint32_t round_ = 0;
  double progress_ = 0;
};

}  // namespace

PixelRegions grow_pixels(const DepthImage& image, const PixelRule& rule, Task& task) {
  return PixelGrower(image, rule, task).run();
}

}  // namespace jalon
