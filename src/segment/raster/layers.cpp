// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/raster/layers.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>

#include "base/buffer.h"
#include "base/parallel.h"
#include "segment/raster/image_box.h"

namespace jalon {

namespace {

constexpr size_t kImagePointsPerChunk = 1 << 15;
constexpr size_t kImagePixelsPerChunk = 1 << 12;
constexpr uint64_t kNoReturn = 0;
constexpr uint32_t kInNoPixel = 0xffffffffu;

void size_image(DepthImage& image, const ImageBox& box, size_t points, double pixel_m) {
  const double most = most_image_pixels(points);
  while (box.cells(0, pixel_m) * box.cells(1, pixel_m) > most) pixel_m *= 2;
  image.low = {box.low[0], box.low[1]};
  image.pixel_m = pixel_m;
  image.columns = static_cast<uint32_t>(box.cells(0, pixel_m));
  image.rows = static_cast<uint32_t>(box.cells(1, pixel_m));
  const size_t size = size_t{image.columns} * image.rows;
  image.pixels.resize(size);
  image.occupied.assign(size, 0);
}

// Depth and position as one number that orders returns: nearer to the viewer is more, then the first in order.
uint64_t key_of(double depth, size_t position) {
  const auto bits = std::bit_cast<uint32_t>(static_cast<float>(depth));
  const uint32_t ordered = (bits >> 31) != 0 ? ~bits : bits | 0x80000000u;
  return uint64_t{ordered} << 32 | (0xffffffffu - static_cast<uint32_t>(position));
}
uint32_t position_of(uint64_t key) { return 0xffffffffu - static_cast<uint32_t>(key); }

// From any thread: whatever the order, the nearest return stays.
void keep_nearest(uint64_t& kept, uint64_t key) {
  std::atomic_ref<uint64_t> nearest(kept);
  uint64_t before = nearest.load(std::memory_order_relaxed);
  while (key > before && !nearest.compare_exchange_weak(before, key, std::memory_order_relaxed)) {
  }
}

}  // namespace

void RasterLayers::look_along(const ImageAxes& axes, double pixel_m, Task& task) {
  image_ = {};
  image_.axes = axes;
  firsts_ = {};
  points_ = {};
  const ImageBox box = free_points_box(scene_, candidates_, axes, task);
  if (box.points == 0) return;
  size_image(image_, box, scene_.size(), pixel_m);
  depths_ = {box.low[2], box.high[2]};
  if (settings_.grey_bits > 0)
    image_.quantum_m =
        (depths_.high - depths_.low) / (std::ldexp(1.0, static_cast<int>(settings_.grey_bits)) - 1);
  const bool by_nearest = settings_.returns == PixelReturn::kNearest;
  std::vector<uint64_t> nearest(by_nearest ? image_.size() : 0, kNoReturn);
  put_points_in_pixels(box.points, nearest, task);
  parallel_for(task, image_.size(), kImagePixelsPerChunk, [&](size_t begin, size_t end) {
    for (size_t p = begin; p < end; ++p) paint(p, by_nearest ? nearest[p] : middle_return(p));
  });
}

void RasterLayers::look_behind(std::span<const uint32_t> pixels, Task& task) {
  parallel_for(task, pixels.size(), kImagePixelsPerChunk, [&](size_t begin, size_t end) {
    for (size_t k = begin; k < end; ++k)
      paint(pixels[k], settings_.returns == PixelReturn::kNearest ? nearest_return(pixels[k])
                                                                  : middle_return(pixels[k]));
  });
}

// Counted, then put in place, in any order within a pixel: none is asked for. The nearest return of each pixel, where
// asked for, is found by the way, as long as the points are at hand one after the other.
void RasterLayers::put_points_in_pixels(size_t free_points, std::span<uint64_t> nearest,
                                        Task& task) {
  const size_t n = candidates_.size();
  Buffer<uint32_t> pixels(n);
  firsts_.assign(image_.size() + 1, 0);
  parallel_for(task, n, kImagePointsPerChunk, [&](size_t begin, size_t end) {
    for (size_t k = begin; k < end; ++k) {
      pixels[k] = kInNoPixel;
      if (scene_.owner[candidates_[k]] != 0) continue;
      const Vec3 at = scene_.local(candidates_[k]);
      pixels[k] = static_cast<uint32_t>(image_.pixel_of(at));
      std::atomic_ref(firsts_[pixels[k]]).fetch_add(1, std::memory_order_relaxed);
      if (!nearest.empty())
        keep_nearest(nearest[pixels[k]], key_of(dot(at, image_.axes.n), candidates_[k]));
    }
  });
  uint32_t sum = 0;
  for (uint32_t& first : firsts_) first = sum += first;  // the ends, which go down to the firsts
  points_.resize(free_points);
  parallel_for(task, n, kImagePointsPerChunk, [&](size_t begin, size_t end) {
    for (size_t k = begin; k < end; ++k)
      if (pixels[k] != kInNoPixel)
        points_[std::atomic_ref(firsts_[pixels[k]]).fetch_sub(1, std::memory_order_relaxed) - 1] =
            candidates_[k];
  });
}

uint64_t RasterLayers::nearest_return(size_t pixel) const {
  uint64_t best = kNoReturn;
  for (const uint32_t i : points_of(pixel))
    if (scene_.owner[i] == 0) best = std::max(best, key_of(dot(scene_.local(i), image_.axes.n), i));
  return best;
}

uint64_t RasterLayers::middle_return(size_t pixel) const {
  std::vector<uint64_t> keys;
  for (const uint32_t i : points_of(pixel))
    if (scene_.owner[i] == 0) keys.push_back(key_of(dot(scene_.local(i), image_.axes.n), i));
  if (keys.empty()) return kNoReturn;
  const auto middle = keys.begin() + static_cast<ptrdiff_t>(keys.size() / 2);
  std::nth_element(keys.begin(), middle, keys.end());
  return *middle;
}

void RasterLayers::paint(size_t pixel, uint64_t key) {
  const ImageAxes& axes = image_.axes;
  image_.occupied[pixel] = key != kNoReturn ? 1 : 0;
  image_.pixels[pixel] = {};
  if (key == kNoReturn) return;
  const Vec3 at = scene_.local(position_of(key));
  image_.pixels[pixel] = {static_cast<float>(dot(at, axes.u)), static_cast<float>(dot(at, axes.v)),
                          static_cast<float>(dot(at, axes.n))};
  if (settings_.grey_bits > 0) quantise(pixel);
}

// Grey values of the text's image file: whole numbers of the depth's range, at the middle of their pixels.
void RasterLayers::quantise(size_t pixel) {
  DepthImage::Pixel& own = image_.pixels[pixel];
  const auto column = static_cast<double>(pixel % image_.columns);
  const auto row = static_cast<double>(pixel / image_.columns);
  own.u = static_cast<float>(image_.low.u + (column + 0.5) * image_.pixel_m);
  own.v = static_cast<float>(image_.low.v + (row + 0.5) * image_.pixel_m);
  if (image_.quantum_m == 0) return;
  const double grey = std::round((static_cast<double>(own.g) - depths_.low) / image_.quantum_m);
  own.g = static_cast<float>(depths_.low + grey * image_.quantum_m);
}

}  // namespace jalon
