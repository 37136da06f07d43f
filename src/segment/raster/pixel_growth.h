// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/plane.h"
#include "segment/raster/depth_image.h"

namespace jalon {

/// How regions grow on an image.
struct PixelRule {
  double tolerance_m = 0;     ///< of a pixel from its region's plane, across the plane
  uint32_t seed_pixels = 3;   ///< edge of a seed's window
  uint32_t reach_pixels = 1;  ///< to the next pixel of a region: 1 = no empty ones between
  uint64_t least_pixels = 9;  ///< of a region
};

/// Regions of an image, numbered from 1 as they were found.
struct PixelRegions {
  std::vector<uint32_t> pixels;  ///< of all regions, one region after the other
  std::vector<uint32_t> labels;  ///< of these pixels
  std::vector<Plane> planes;     ///< in the scene's coordinates
};

/// Pixels whose window makes a seed: least residual first, by classes of it, within a class in the order of the image.
std::vector<uint32_t> pixel_seeds(const DepthImage& image, const PixelRule& rule, Task& task);
/// Of those alone whose window has one of these pixels.
std::vector<uint32_t> pixel_seeds(const DepthImage& image, const PixelRule& rule,
                                  std::span<const uint32_t> changed, Task& task);

/// Region growing on grey values (the first of three methods for planes compared in France in 2006): seeds by least
/// residual of their window's plane; a pixel joins when its grey value is the plane's within the tolerance, which is
/// refitted from running sums as the region grows; a pixel refused is not asked again by the same region: there its
/// border stays. Planes that the image foreshortens by more than a quarter are left to another image. O(pixels of the
/// regions), as often as it is asked for an image of the same size.
class PixelGrowth {
 public:
  PixelRegions grow(const DepthImage& image, const PixelRule& rule, std::span<const uint32_t> seeds,
                    Task& task);

 private:
  std::vector<uint32_t> labels_;  ///< by pixel; all 0 between two calls
  std::vector<uint32_t> seen_;    ///< the last region that asked
  uint32_t round_ = 0;
};
PixelRegions grow_pixels(const DepthImage& image, const PixelRule& rule, Task& task);

}  // namespace jalon
