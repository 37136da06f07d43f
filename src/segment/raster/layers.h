// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "segment/raster/depth_image.h"

namespace jalon {

/// Extent of points in an image's axes, and which points reach its six sides: while these are free, it stands.
struct ImageBox {
  std::array<double, 3> low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};
  std::array<uint32_t, 6> reached_by{};
  void add(const std::array<double, 3>& at, uint32_t position);
  ImageBox& operator+=(const ImageBox& b);
};

/// The rasters of the points that are free, one after the other. Points that are not free any more are passed over
/// once; where an image has the pixels of the one before it, only those whose points were taken are made anew, so that
/// the last of many rasters, which take little each, cost little.
class RasterLayers {
 public:
  RasterLayers(const SegmentScene& scene, const RasterSettings& settings);
  /// Axes of the images that come.
  void look_along(const ImageAxes& axes);
  /// Makes the image of the points that are free now: depth_image() of them, to the bit.
  void show(double pixel_m, Task& task);
  const DepthImage& image() const { return image_; }
  /// By pixel, whether it may differ from the image before; empty: the whole image may.
  const std::vector<uint8_t>& changed() const { return changed_; }

  /// The free points, in the order of the scene.
  size_t points() const { return all_ ? scene_.size() : positions_.size(); }
  uint32_t position(size_t k) const { return all_ ? static_cast<uint32_t>(k) : positions_[k]; }
  /// Pixel of a free point in the last image.
  uint32_t pixel(size_t k) const { return pixels_[k]; }
  /// To be called when points of the last image were taken, in scene.owner, before the next is made.
  void drop_taken();

 private:
  bool box_stands() const;
  bool same_pixels(const DepthImage& next) const;
  void find_pixels(Task& task);
  std::vector<uint64_t> nearest_returns(Task& task) const;
  std::vector<uint64_t> middle_returns(Task& task) const;
  void paint(const std::vector<uint64_t>& keys, Task& task);
  void quantise(Task& task);

  const SegmentScene& scene_;
  const RasterSettings& settings_;
  DepthImage image_;
  ImageBox box_, painted_box_;
  bool all_ = false, has_box_ = false;
  std::vector<uint32_t> positions_;  ///< of the free points, unless they are all
  std::vector<uint32_t> pixels_;     ///< of the free points
  std::vector<uint8_t> changed_, taken_from_;
};

}  // namespace jalon
