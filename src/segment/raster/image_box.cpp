// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/raster/image_box.h"

#include <algorithm>

#include "base/parallel.h"
#include "segment/surface/near_most.h"

namespace jalon {

namespace {

constexpr size_t kBoxPointsPerChunk = 1 << 15;
constexpr double kMostPixelsPerPoint =
    1.5;  // 25 B a pixel with what grows on it: an image is no larger than the points' columns
constexpr double kLeastPixels = 1 << 16;  // that any cloud may have
constexpr size_t kMostSampled = 1 << 14;  // points that tell where most are: a share to 0.4 %

Vec3 place(const SegmentScene& scene, const ImageAxes& axes, uint32_t position) {
  const Vec3 p = scene.local(position);
  return {dot(p, axes.u), dot(p, axes.v), dot(p, axes.n)};
}

}  // namespace

void ImageBox::add(const std::array<double, 3>& at) {
  for (size_t k = 0; k < 3; ++k) {
    low[k] = std::min(low[k], at[k]);
    high[k] = std::max(high[k], at[k]);
  }
  ++points;
}

ImageBox& ImageBox::operator+=(const ImageBox& b) {
  for (size_t k = 0; k < 3; ++k) {
    low[k] = std::min(low[k], b.low[k]);
    high[k] = std::max(high[k], b.high[k]);
  }
  points += b.points;
  return *this;
}

ImageBox free_points_box(const SegmentScene& scene, std::span<const uint32_t> candidates,
                         const ImageAxes& axes, Task& task) {
  return parallel_reduce(task, candidates.size(), kBoxPointsPerChunk, ImageBox{},
                         [&](size_t begin, size_t end) {
                           ImageBox box;
                           for (const uint32_t i : candidates.subspan(begin, end - begin)) {
                             if (scene.owner[i] != 0) continue;
                             const Vec3 at = place(scene, axes, i);
                             box.add({at.x, at.y, at.z});
                           }
                           return box;
                         });
}

double most_image_pixels(size_t points) {
  return std::max(kLeastPixels, kMostPixelsPerPoint * static_cast<double>(points));
}

std::vector<uint32_t> far_candidates(const SegmentScene& scene,
                                     std::span<const uint32_t> candidates, const ImageAxes& axes,
                                     double pixel_m, Task& task) {
  const ImageBox box = free_points_box(scene, candidates, axes, task);
  if (box.points == 0 ||
      box.cells(0, pixel_m) * box.cells(1, pixel_m) <= most_image_pixels(scene.size()))
    return {};
  std::vector<Vec3> sample;
  const size_t step = (box.points + kMostSampled - 1) / kMostSampled;
  size_t turn = 0;
  for (const uint32_t i : candidates)
    if (scene.owner[i] == 0 && turn++ % step == 0) sample.push_back(place(scene, axes, i));
  const Box3 near = box_near_most(sample);
  std::vector<uint32_t> far;
  for (const uint32_t i : candidates)
    if (scene.owner[i] == 0 && !near.contains(place(scene, axes, i))) far.push_back(i);
  return far;
}

}  // namespace jalon
