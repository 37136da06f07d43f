// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/raster/depth_image.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>

#include "base/parallel.h"
#include "segment/surface/spacing.h"

namespace jalon {

namespace {

constexpr size_t kImagePointsPerChunk = 1 << 15;
constexpr size_t kImagePixelsPerChunk = 1 << 14;
constexpr double kMostPixelsPerPoint =
    1.5;  // 21 B a pixel: an image is no larger than the points' columns
constexpr double kLeastPixels = 1 << 16;   // that any cloud may have
constexpr size_t kMostSpacings = 1 << 16;  // sampled evenly
constexpr uint64_t kNoReturn = 0;
// Two points a pixel on average leave 15 % of the pixels empty, which growth crosses; larger ones lose what is narrow.
constexpr double kSpacingsPerImagePixel = 1.4;

struct ImageBox {
  double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
  size_t points = 0;
  ImageBox& operator+=(const ImageBox& b) {
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], b.low[k]);
      high[k] = std::max(high[k], b.high[k]);
    }
    points += b.points;
    return *this;
  }
};

ImageBox box_of(const SegmentScene& scene, const ImageAxes& axes, Task& task) {
  return parallel_reduce(task, scene.size(), kImagePointsPerChunk, ImageBox{},
                         [&](size_t begin, size_t end) {
                           ImageBox box;
                           for (size_t i = begin; i < end; ++i) {
                             if (scene.owner[i] != 0) continue;
                             const Vec3 p = scene.local(i);
                             const double at[3] = {dot(p, axes.u), dot(p, axes.v), dot(p, axes.n)};
                             for (int k = 0; k < 3; ++k) {
                               box.low[k] = std::min(box.low[k], at[k]);
                               box.high[k] = std::max(box.high[k], at[k]);
                             }
                             ++box.points;
                           }
                           return box;
                         });
}

void size_image(DepthImage& image, const ImageBox& box, double pixel_m) {
  const double most = std::max(kLeastPixels, kMostPixelsPerPoint * static_cast<double>(box.points));
  const auto cells = [&](int k) { return std::floor((box.high[k] - box.low[k]) / pixel_m) + 1; };
  while (cells(0) * cells(1) > most) pixel_m *= 2;
  image.low = {box.low[0], box.low[1]};
  image.pixel_m = pixel_m;
  image.columns = static_cast<uint32_t>(cells(0));
  image.rows = static_cast<uint32_t>(cells(1));
}

// Depth and position as one number that orders returns: nearer to the viewer is more, then the first in order.
uint64_t key_of(double depth, size_t position) {
  const auto bits = std::bit_cast<uint32_t>(static_cast<float>(depth));
  const uint32_t ordered = (bits >> 31) != 0 ? ~bits : bits | 0x80000000u;
  return uint64_t{ordered} << 32 | (0xffffffffu - static_cast<uint32_t>(position));
}
uint32_t position_of(uint64_t key) { return 0xffffffffu - static_cast<uint32_t>(key); }

std::vector<uint64_t> nearest_returns(const SegmentScene& scene, const DepthImage& image,
                                      Task& task) {
  std::vector<uint64_t> keys(size_t{image.columns} * image.rows, kNoReturn);
  parallel_for(task, scene.size(), kImagePointsPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      if (scene.owner[i] != 0) continue;
      const Vec3 p = scene.local(i);
      const uint64_t key = key_of(dot(p, image.axes.n), i);
      std::atomic_ref<uint64_t> best(keys[image.pixel_of(p)]);
      uint64_t seen = best.load(std::memory_order_relaxed);
      while (seen < key && !best.compare_exchange_weak(seen, key, std::memory_order_relaxed)) {
      }
    }
  });
  return keys;
}

// The middle return of each pixel: returns counted, put pixel by pixel, and halved.
std::vector<uint64_t> middle_returns(const SegmentScene& scene, const DepthImage& image,
                                     size_t points, Task& task) {
  const size_t size = size_t{image.columns} * image.rows;
  std::vector<uint32_t> first(size + 1, 0);
  for (size_t i = 0; i < scene.size(); ++i)
    if (scene.owner[i] == 0) ++first[image.pixel_of(scene.local(i)) + 1];
  for (size_t p = 0; p < size; ++p) first[p + 1] += first[p];
  std::vector<uint64_t> returns(points), keys(size, kNoReturn);
  std::vector<uint32_t> next(first.begin(), first.end() - 1);
  for (size_t i = 0; i < scene.size(); ++i) {
    if (scene.owner[i] != 0) continue;
    const Vec3 p = scene.local(i);
    returns[next[image.pixel_of(p)]++] = key_of(dot(p, image.axes.n), i);
  }
  parallel_for(task, size, kImagePixelsPerChunk, [&](size_t begin, size_t end) {
    for (size_t p = begin; p < end; ++p) {
      if (first[p] == first[p + 1]) continue;
      const auto from = returns.begin() + first[p], to = returns.begin() + first[p + 1];
      const auto middle = from + (to - from) / 2;
      std::nth_element(from, middle, to);
      keys[p] = *middle;
    }
  });
  return keys;
}

// Grey values of the text's image file: whole numbers of the depth's range, at the middle of their pixels.
void quantise(DepthImage& image, const ImageBox& box, uint32_t bits, Task& task) {
  const double steps = std::ldexp(1.0, static_cast<int>(bits)) - 1;
  image.quantum_m = (box.high[2] - box.low[2]) / steps;
  parallel_for(task, image.size(), kImagePixelsPerChunk, [&](size_t begin, size_t end) {
    for (size_t p = begin; p < end; ++p) {
      if (image.occupied[p] == 0) continue;
      DepthImage::Pixel& pixel = image.pixels[p];
      const auto column = static_cast<double>(p % image.columns);
      const auto row = static_cast<double>(p / image.columns);
      pixel.u = static_cast<float>(image.low.u + (column + 0.5) * image.pixel_m);
      pixel.v = static_cast<float>(image.low.v + (row + 0.5) * image.pixel_m);
      if (image.quantum_m == 0) continue;
      const double grey = std::round((static_cast<double>(pixel.g) - box.low[2]) / image.quantum_m);
      pixel.g = static_cast<float>(box.low[2] + grey * image.quantum_m);
    }
  });
}

}  // namespace

DepthImage depth_image(const SegmentScene& scene, const RasterSettings& settings,
                       const ImageAxes& axes, double pixel_m, Task& task) {
  DepthImage image;
  image.axes = axes;
  const ImageBox box = box_of(scene, axes, task);
  if (box.points == 0) return image;
  size_image(image, box, pixel_m);
  const std::vector<uint64_t> keys = settings.returns == PixelReturn::kNearest
                                         ? nearest_returns(scene, image, task)
                                         : middle_returns(scene, image, box.points, task);
  image.pixels.resize(keys.size());
  image.occupied.assign(keys.size(), 0);
  parallel_for(task, keys.size(), kImagePixelsPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      if (keys[i] == kNoReturn) continue;
      const Vec3 p = scene.local(position_of(keys[i]));
      image.pixels[i] = {static_cast<float>(dot(p, axes.u)), static_cast<float>(dot(p, axes.v)),
                         static_cast<float>(dot(p, axes.n))};
      image.occupied[i] = 1;
    }
  });
  if (settings.grey_bits > 0) quantise(image, box, settings.grey_bits, task);
  return image;
}

double image_pixel_m(const SegmentScene& scene) {
  if (scene.settings.pixel_m > 0) return scene.settings.pixel_m;
  return std::max(scene.settings.distance_tolerance_m,
                  kSpacingsPerImagePixel * median_spacing_m(scene));
}

}  // namespace jalon
