// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "segment/raster/depth_image.h"

namespace jalon {

/// The rasters of the points that are free, one after the other as regions take theirs. All rasters along one direction
/// have the pixels of the first, and each pixel knows its points, so that after the first one only those pixels are
/// looked at whose points were taken: the last of many rasters, which take little each, cost little.
class RasterLayers {
 public:
  /// candidates: the points that are looked at, ascending; they must outlive it.
  RasterLayers(const SegmentScene& scene, const RasterSettings& settings,
               std::span<const uint32_t> candidates)
      : scene_(scene), settings_(settings), candidates_(candidates) {}
  /// The first raster along a direction: depth_image() of the candidates that are free.
  void look_along(const ImageAxes& axes, double pixel_m, Task& task);
  /// The next one: of these pixels points were taken, in scene.owner.
  void look_behind(std::span<const uint32_t> pixels, Task& task);
  const DepthImage& image() const { return image_; }
  /// The points of a pixel that were free in the first raster.
  std::span<const uint32_t> points_of(size_t pixel) const {
    return {points_.data() + firsts_[pixel], points_.data() + firsts_[pixel + 1]};
  }

 private:
  struct DepthRange {
    double low = 0, high = 0;
  };
  void put_points_in_pixels(size_t free_points, std::span<uint64_t> nearest, Task& task);
  void paint(size_t pixel, uint64_t key);
  uint64_t nearest_return(size_t pixel) const;
  uint64_t middle_return(size_t pixel) const;
  void quantise(size_t pixel);

  const SegmentScene& scene_;
  const RasterSettings& settings_;
  std::span<const uint32_t> candidates_;
  DepthImage image_;
  DepthRange depths_;
  std::vector<uint32_t> firsts_;  ///< by pixel, into points_; with the end behind
  std::vector<uint32_t> points_;  ///< pixel by pixel
};

}  // namespace jalon
