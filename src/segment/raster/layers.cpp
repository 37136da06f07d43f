// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/raster/layers.h"

#include <algorithm>
#include <atomic>
#include <bit>

#include "base/parallel.h"

namespace jalon {

namespace {

constexpr size_t kImagePointsPerChunk = 1 << 15;
constexpr size_t kImagePixelsPerChunk = 1 << 14;
constexpr double kMostPixelsPerPoint =
    1.5;  // 21 B a pixel: an image is no larger than the points' columns
constexpr double kLeastPixels = 1 << 16;  // that any cloud may have
constexpr uint64_t kNoReturn = 0;

void size_image(DepthImage& image, const ImageBox& box, size_t points, double pixel_m) {
  const double most = std::max(kLeastPixels, kMostPixelsPerPoint * static_cast<double>(points));
  const auto cells = [&](size_t k) { return std::floor((box.high[k] - box.low[k]) / pixel_m) + 1; };
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

}  // namespace

void ImageBox::add(const std::array<double, 3>& at, uint32_t position) {
  for (size_t k = 0; k < 3; ++k) {
    if (at[k] < low[k]) {
      low[k] = at[k];
      reached_by[k] = position;
    }
    if (at[k] > high[k]) {
      high[k] = at[k];
      reached_by[3 + k] = position;
    }
  }
}

ImageBox& ImageBox::operator+=(const ImageBox& b) {
  for (size_t k = 0; k < 3; ++k) {
    if (b.low[k] < low[k]) {
      low[k] = b.low[k];
      reached_by[k] = b.reached_by[k];
    }
    if (b.high[k] > high[k]) {
      high[k] = b.high[k];
      reached_by[3 + k] = b.reached_by[3 + k];
    }
  }
  return *this;
}

RasterLayers::RasterLayers(const SegmentScene& scene, const RasterSettings& settings)
    : scene_(scene), settings_(settings) {
  all_ = std::all_of(scene.owner.begin(), scene.owner.end(), [](uint32_t o) { return o == 0; });
  if (all_) return;
  for (size_t i = 0; i < scene.size(); ++i)
    if (scene.owner[i] == 0) positions_.push_back(static_cast<uint32_t>(i));
}

void RasterLayers::look_along(const ImageAxes& axes) {
  image_ = {};
  image_.axes = axes;
  changed_ = {};
  taken_from_ = {};
  pixels_ = {};
  has_box_ = false;
}

bool RasterLayers::box_stands() const {
  return has_box_ && std::all_of(box_.reached_by.begin(), box_.reached_by.end(),
                                 [&](uint32_t position) { return scene_.owner[position] == 0; });
}

bool RasterLayers::same_pixels(const DepthImage& next) const {
  return settings_.returns == PixelReturn::kNearest && image_.size() != 0 &&
         next.low == image_.low && next.pixel_m == image_.pixel_m &&
         next.columns == image_.columns && next.rows == image_.rows &&
         (settings_.grey_bits == 0 ||
          (box_.low[2] == painted_box_.low[2] && box_.high[2] == painted_box_.high[2]));
}

void RasterLayers::show(double pixel_m, Task& task) {
  const ImageAxes& axes = image_.axes;
  if (points() == 0) {
    const ImageAxes own = axes;
    image_ = {};
    image_.axes = own;
    return;
  }
  if (!box_stands())
    box_ = parallel_reduce(
        task, points(), kImagePointsPerChunk, ImageBox{}, [&](size_t begin, size_t end) {
          ImageBox box;
          for (size_t k = begin; k < end; ++k) {
            const Vec3 p = scene_.local(position(k));
            box.add({dot(p, axes.u), dot(p, axes.v), dot(p, axes.n)}, position(k));
          }
          return box;
        });
  has_box_ = true;
  DepthImage next;
  next.axes = axes;
  size_image(next, box_, points(), pixel_m);
  if (same_pixels(next) && !taken_from_.empty()) {
    changed_ = std::move(taken_from_);
  } else {
    changed_ = {};
    const size_t size = size_t{next.columns} * next.rows;
    image_ = std::move(next);
    image_.pixels.resize(size);
    image_.occupied.assign(size, 0);
    find_pixels(task);
  }
  taken_from_ = {};
  painted_box_ = box_;
  paint(settings_.returns == PixelReturn::kNearest ? nearest_returns(task) : middle_returns(task),
        task);
  if (settings_.grey_bits > 0) quantise(task);
}

void RasterLayers::find_pixels(Task& task) {
  pixels_ = {};
  pixels_.resize(points());
  parallel_for(task, points(), kImagePointsPerChunk, [&](size_t begin, size_t end) {
    for (size_t k = begin; k < end; ++k)
      pixels_[k] = static_cast<uint32_t>(image_.pixel_of(scene_.local(position(k))));
  });
}

std::vector<uint64_t> RasterLayers::nearest_returns(Task& task) const {
  std::vector<uint64_t> keys(image_.size(), kNoReturn);
  parallel_for(task, points(), kImagePointsPerChunk, [&](size_t begin, size_t end) {
    for (size_t k = begin; k < end; ++k) {
      const uint32_t own = pixels_[k];
      if (!changed_.empty() && changed_[own] == 0) continue;
      const uint32_t i = position(k);
      const uint64_t key = key_of(dot(scene_.local(i), image_.axes.n), i);
      std::atomic_ref<uint64_t> best(keys[own]);
      uint64_t seen = best.load(std::memory_order_relaxed);
      while (seen < key && !best.compare_exchange_weak(seen, key, std::memory_order_relaxed)) {
      }
    }
  });
  return keys;
}

// The middle return of each pixel: returns counted, put pixel by pixel, and halved.
std::vector<uint64_t> RasterLayers::middle_returns(Task& task) const {
  const size_t size = image_.size();
  std::vector<uint32_t> first(size + 1, 0);
  for (const uint32_t own : pixels_) ++first[own + size_t{1}];
  for (size_t p = 0; p < size; ++p) first[p + 1] += first[p];
  std::vector<uint64_t> returns(points()), keys(size, kNoReturn);
  std::vector<uint32_t> next(first.begin(), first.end() - 1);
  for (size_t k = 0; k < points(); ++k) {
    const uint32_t i = position(k);
    returns[next[pixels_[k]]++] = key_of(dot(scene_.local(i), image_.axes.n), i);
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

void RasterLayers::paint(const std::vector<uint64_t>& keys, Task& task) {
  const ImageAxes& axes = image_.axes;
  parallel_for(task, keys.size(), kImagePixelsPerChunk, [&](size_t begin, size_t end) {
    for (size_t p = begin; p < end; ++p) {
      if (!changed_.empty() && changed_[p] == 0) continue;
      image_.occupied[p] = keys[p] != kNoReturn ? 1 : 0;
      image_.pixels[p] = {};
      if (keys[p] == kNoReturn) continue;
      const Vec3 at = scene_.local(position_of(keys[p]));
      image_.pixels[p] = {static_cast<float>(dot(at, axes.u)), static_cast<float>(dot(at, axes.v)),
                          static_cast<float>(dot(at, axes.n))};
    }
  });
}

// Grey values of the text's image file: whole numbers of the depth's range, at the middle of their pixels.
void RasterLayers::quantise(Task& task) {
  const double steps = std::ldexp(1.0, static_cast<int>(settings_.grey_bits)) - 1;
  image_.quantum_m = (box_.high[2] - box_.low[2]) / steps;
  parallel_for(task, image_.size(), kImagePixelsPerChunk, [&](size_t begin, size_t end) {
    for (size_t p = begin; p < end; ++p) {
      if (image_.occupied[p] == 0 || (!changed_.empty() && changed_[p] == 0)) continue;
      DepthImage::Pixel& pixel = image_.pixels[p];
      const auto column = static_cast<double>(p % image_.columns);
      const auto row = static_cast<double>(p / image_.columns);
      pixel.u = static_cast<float>(image_.low.u + (column + 0.5) * image_.pixel_m);
      pixel.v = static_cast<float>(image_.low.v + (row + 0.5) * image_.pixel_m);
      if (image_.quantum_m == 0) continue;
      const double grey =
          std::round((static_cast<double>(pixel.g) - box_.low[2]) / image_.quantum_m);
      pixel.g = static_cast<float>(box_.low[2] + grey * image_.quantum_m);
    }
  });
}

void RasterLayers::drop_taken() {
  taken_from_.assign(image_.size(), 0);
  size_t left = 0;
  if (all_) {
    left = static_cast<size_t>(std::count(scene_.owner.begin(), scene_.owner.end(), 0u));
    positions_.reserve(left);
    size_t kept = 0;
    for (size_t i = 0; i < scene_.size(); ++i) {
      if (scene_.owner[i] != 0) {
        taken_from_[pixels_[i]] = 1;
        continue;
      }
      positions_.push_back(static_cast<uint32_t>(i));
      pixels_[kept++] = pixels_[i];
    }
    all_ = false;
  } else {
    for (size_t k = 0; k < positions_.size(); ++k) {
      if (scene_.owner[positions_[k]] != 0) {
        taken_from_[pixels_[k]] = 1;
        continue;
      }
      positions_[left] = positions_[k];
      pixels_[left++] = pixels_[k];
    }
    positions_.resize(left);
  }
  pixels_.resize(left);
}

}  // namespace jalon
