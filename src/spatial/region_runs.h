// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "spatial/raster.h"

namespace jalon {

/// The connected regions of an image as stretches of its rows: what label_regions() tells pixel by pixel, at a small
/// part of the memory. Large surfaces have millions of pixels and thousands of stretches.
struct RegionRuns {
  struct Run {
    uint32_t begin, end;  ///< pixels, the end behind the last
    uint32_t label;       ///< numbered as by label_regions()
  };
  std::vector<Run> runs;               ///< in the order of the pixels
  std::vector<uint64_t> pixel_counts;  ///< [label] = pixels of that region, [0] = empty ones
  size_t count() const { return pixel_counts.empty() ? 0 : pixel_counts.size() - 1; }
};

/// Two passes over the stretches with union-find (Rosenfeld & Pfaltz 1966; He, Chao & Suzuki 2008 for stretches
/// instead of pixels).
RegionRuns region_runs(const Raster& raster, Connectivity2 connectivity = Connectivity2::k8);

}  // namespace jalon
