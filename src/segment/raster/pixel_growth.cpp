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
constexpr uint16_t kNoSeed = 0xffff;
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

// The pixels with a changed one in their window, ascending.
std::vector<uint32_t> pixels_about(const DepthImage& image, const PixelRule& rule,
                                   std::span<const uint32_t> changed) {
  const size_t half = rule.seed_pixels / 2;
  std::vector<uint8_t> about(image.size(), 0);
  for (const uint32_t p : changed) {
    const size_t column = p % image.columns, row = p / image.columns;
    const size_t left = column - std::min(column, half);
    const size_t count = std::min<size_t>(image.columns - 1, column + half) - left + 1;
    for (size_t r = row - std::min(row, half); r <= std::min<size_t>(image.rows - 1, row + half);
         ++r)
      std::fill_n(about.begin() + static_cast<ptrdiff_t>(r * image.columns + left), count,
                  uint8_t{1});
  }
  std::vector<uint32_t> pixels;
  for (size_t p = 0; p < about.size(); ++p)
    if (about[p] != 0) pixels.push_back(static_cast<uint32_t>(p));
  return pixels;
}

// Class of the residual of a seed in the pixel, or kNoSeed.
uint16_t residual_step(const DepthImage& image, const PixelRule& rule, size_t pixel) {
  const double per_step = kSeedResidual * rule.tolerance_m / (kResidualSteps - 1);
  GreyPlane plane;
  if (!seed_plane(image, rule, {}, pixel, plane)) return kNoSeed;
  return static_cast<uint16_t>(plane.rms * plane.cosine() / per_step);
}

// Those of the pixels at(0) ... at(n - 1), which ascend, that make a seed.
template <class At>
std::vector<uint32_t> seeds_among(const DepthImage& image, const PixelRule& rule, size_t n,
                                  const At& at, Task& task) {
  std::vector<uint16_t> steps(n);
  parallel_for(task, n, kSeedPixelsPerChunk, [&](size_t begin, size_t end) {
    for (size_t k = begin; k < end; ++k) steps[k] = residual_step(image, rule, at(k));
  });
  std::vector<uint32_t> next(kResidualSteps + 1, 0);
  for (const uint16_t step : steps)
    if (step != kNoSeed) ++next[step + 1u];
  for (size_t s = 0; s < kResidualSteps; ++s) next[s + 1] += next[s];
  std::vector<uint32_t> seeds(next[kResidualSteps]);
  for (size_t k = 0; k < n; ++k)
    if (steps[k] != kNoSeed) seeds[next[steps[k]]++] = static_cast<uint32_t>(at(k));
  return seeds;
}

class PixelGrower {
 public:
  PixelGrower(const DepthImage& image, const PixelRule& rule, std::vector<uint32_t>& labels,
              std::vector<uint32_t>& seen, uint32_t& round, Task& task)
      : image_(image), rule_(rule), task_(task), labels_(labels), seen_(seen), round_(round) {}

  PixelRegions run(std::span<const uint32_t> seeds) {
    for (size_t i = 0; i < seeds.size(); ++i) {
      progress_ = static_cast<double>(i) / static_cast<double>(seeds.size());
      if (i % kPixelsPerCheckpoint == 0) task_.checkpoint(progress_);
      if (seen_[seeds[i]] != kSpent) try_seed(seeds[i]);
    }
    for (const uint32_t p : spent_) seen_[p] = 0;
    for (const uint32_t p : regions_.pixels) seen_[p] = labels_[p] = 0;
    return std::move(regions_);
  }

 private:
  static constexpr uint32_t kSpent = 0xffffffffu;  // in a region, or in what was none

  void try_seed(uint32_t seed) {
    GreyPlane plane;
    if (!seed_plane(image_, rule_, labels_, seed, plane)) return;
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
      if (!good) labels_[member] = 0;
    }
    std::vector<uint32_t>& kept = good ? regions_.pixels : spent_;
    kept.insert(kept.end(), members_.begin(), members_.end());
    if (!good) return;
    regions_.labels.resize(regions_.pixels.size(), label);
    regions_.planes.push_back(in_scene(plane));
  }

  void take(size_t p, uint32_t label, GreySums& region) {
    const DepthImage::Pixel& pixel = image_.pixels[p];
    seen_[p] = round_;
    labels_[p] = label;
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
    if (image_.occupied[p] == 0 || seen_[p] == round_ || labels_[p] != 0) return;
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
  std::vector<uint32_t>& labels_;
  std::vector<uint32_t>& seen_;  ///< the last region that asked, or kSpent
  std::vector<uint32_t> members_;
  std::vector<uint32_t> spent_;  ///< of regions that were none
  uint32_t& round_;
  double progress_ = 0;
};

}  // namespace

std::vector<uint32_t> pixel_seeds(const DepthImage& image, const PixelRule& rule, Task& task) {
  return seeds_among(
      image, rule, image.size(), [](size_t k) { return k; }, task);
}

std::vector<uint32_t> pixel_seeds(const DepthImage& image, const PixelRule& rule,
                                  std::span<const uint32_t> changed, Task& task) {
  const std::vector<uint32_t> pixels = pixels_about(image, rule, changed);
  return seeds_among(
      image, rule, pixels.size(), [&](size_t k) { return size_t{pixels[k]}; }, task);
}

PixelRegions PixelGrowth::grow(const DepthImage& image, const PixelRule& rule,
                               std::span<const uint32_t> seeds, Task& task) {
  if (labels_.size() != image.size()) {
    labels_.assign(image.size(), 0);
    seen_.assign(image.size(), 0);
    round_ = 0;
  }
  return PixelGrower(image, rule, labels_, seen_, round_, task).run(seeds);
}

PixelRegions grow_pixels(const DepthImage& image, const PixelRule& rule, Task& task) {
  return PixelGrowth().grow(image, rule, pixel_seeds(image, rule, task), task);
}

}  // namespace jalon
