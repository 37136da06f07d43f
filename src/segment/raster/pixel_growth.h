// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
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
  std::vector<uint32_t> labels;  ///< one a pixel, 0 = none
  std::vector<Plane> planes;     ///< in the scene's coordinates
};

/// For each pixel how good a seed its window makes. Windows without a pixel that changed are as they were.
class PixelSeeds {
 public:
  static constexpr uint16_t kNone = 0xffff;
  /// changed: by pixel, of the same image under the same rule for seeds; empty: all of them.
  void look_at(const DepthImage& image, const PixelRule& rule, const std::vector<uint8_t>& changed,
               Task& task);
  /// Least residual first, by classes of it; within a class in the order of the image.
  std::vector<uint32_t> in_order() const;

 private:
  std::vector<uint16_t> steps_;  ///< class of the residual, or kNone
};

/// Region growing on grey values (the first of three methods for planes compared in France in 2006): seeds by least
/// residual of their window's plane; a pixel joins when its grey value is the plane's within the tolerance, which is
/// refitted from running sums as the region grows; a pixel refused is not asked again by the same region: there its
/// border stays. Planes that the image foreshortens by more than a quarter are left to another image. O(pixels).
PixelRegions grow_pixels(const DepthImage& image, const PixelRule& rule, const PixelSeeds& seeds,
                         Task& task);
PixelRegions grow_pixels(const DepthImage& image, const PixelRule& rule, Task& task);

}  // namespace jalon
