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

// Sums over a seed's window; false where too few of its pixels are filled or one is taken (no labels: none is).
bool window_sums(const DepthImage& image, const PixelRule& rule,
                 const std::vector<uint32_t>& labels, size_t centre, GreySums& sums) {
  const int64_t half = rule.seed_pixels / 2;
  const auto column = static_cast<int64_t>(centre % image.columns);
  const auto row = static_cast<int64_t>(centre / image.columns);
  if (image.occupied[centre] == 0 || column < half || row < half ||
      column + half >= image.columns || row + half >= image.rows)
    return false;
  const DepthImage::Pixel& own = image.pixels[centre];
  sums = GreySums(own.u, own.v, own.g);
  const double one_depth = kSteepest * rule.seed_pixels * image.pixel_m + 2 * rule.tolerance_m;
  for (int64_t r = row - half; r <= row + half; ++r)
    for (int64_t c = column - half; c <= column + half; ++c) {
      const auto p = static_cast<size_t>(r * image.columns + c);
      if (image.occupied[p] == 0) continue;
      if (!labels.empty() && labels[p] != 0) return false;
      const DepthImage::Pixel& pixel = image.pixels[p];
      if (std::fabs(static_cast<double>(pixel.g) - static_cast<double>(own.g)) <= one_depth)
        sums.add(pixel.u, pixel.v, pixel.g);
    }
  const double edge = rule.seed_pixels;
  return sums.count() >= kLeastFilled * edge * edge;
}

bool seed_plane(const DepthImage& image, const PixelRule& rule, const std::vector<uint32_t>& labels,
                size_t centre, GreyPlane& plane) {
  GreySums sums;
  return window_sums(image, rule, labels, centre, sums) && sums.fit(plane) &&
         plane.cosine() >= kLeastCosine &&
         plane.rms * plane.cosine() <= kSeedResidual * rule.tolerance_m;
}

// Whether a pixel of the window about this one changed.
bool window_changed(const DepthImage& image, const PixelRule& rule,
                    const std::vector<uint8_t>& changed, size_t centre) {
  const size_t half = rule.seed_pixels / 2;
  const size_t column = centre % image.columns, row = centre / image.columns;
  if (column < half || row < half || column + half >= image.columns || row + half >= image.rows)
    return false;
  for (size_t r = row - half; r <= row + half; ++r) {
    const auto from = changed.begin() + static_cast<ptrdiff_t>(r * image.columns + column - half);
    if (std::find(from, from + static_cast<ptrdiff_t>(2 * half + 1), 1) !=
        from + static_cast<ptrdiff_t>(2 * half + 1))
      return true;
  }
  return false;
}

class PixelGrower {
 public:
  PixelGrower(const DepthImage& image, const PixelRule& rule, Task& task)
      : image_(image), rule_(rule), task_(task), seen_(image.size(), 0) {
    regions_.labels.assign(image.size(), 0);
  }

  PixelRegions run(const std::vector<uint32_t>& seeds) {
    for (size_t i = 0; i < seeds.size(); ++i) {
      progress_ = static_cast<double>(i) / static_cast<double>(seeds.size());
      if (i % kPixelsPerCheckpoint == 0) task_.checkpoint(progress_);
      if (seen_[seeds[i]] != kSpent) try_seed(seeds[i]);
    }
    return std::move(regions_);
  }

 private:
  static constexpr uint32_t kSpent = 0xffffffffu;  // in a region, or in what was none

  void try_seed(uint32_t seed) {
    GreyPlane plane;
    if (!seed_plane(image_, rule_, regions_.labels, seed, plane)) return;
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

void PixelSeeds::look_at(const DepthImage& image, const PixelRule& rule,
                         const std::vector<uint8_t>& changed, Task& task) {
  if (changed.empty()) steps_.assign(image.size(), kNone);
  const double per_step = kSeedResidual * rule.tolerance_m / (kResidualSteps - 1);
  parallel_for(task, image.size(), kSeedPixelsPerChunk, [&](size_t begin, size_t end) {
    GreyPlane plane;
    for (size_t p = begin; p < end; ++p) {
      if (!changed.empty() && !window_changed(image, rule, changed, p)) continue;
      steps_[p] = seed_plane(image, rule, {}, p, plane)
                      ? static_cast<uint16_t>(plane.rms * plane.cosine() / per_step)
                      : kNone;
    }
  });
}

std::vector<uint32_t> PixelSeeds::in_order() const {
  std::vector<uint32_t> next(kResidualSteps + 1, 0);
  for (const uint16_t step : steps_)
    if (step != kNone) ++next[step + 1u];
  for (size_t s = 0; s < kResidualSteps; ++s) next[s + 1] += next[s];
  std::vector<uint32_t> seeds(next[kResidualSteps]);
  for (size_t p = 0; p < steps_.size(); ++p)
    if (steps_[p] != kNone) seeds[next[steps_[p]]++] = static_cast<uint32_t>(p);
  return seeds;
}

PixelRegions grow_pixels(const DepthImage& image, const PixelRule& rule, const PixelSeeds& seeds,
                         Task& task) {
  return PixelGrower(image, rule, task).run(seeds.in_order());
}

PixelRegions grow_pixels(const DepthImage& image, const PixelRule& rule, Task& task) {
  PixelSeeds seeds;
  seeds.look_at(image, rule, {}, task);
  return grow_pixels(image, rule, seeds, task);
}

}  // namespace jalon
