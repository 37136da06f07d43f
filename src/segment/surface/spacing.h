// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "segment/surface/scene.h"

namespace jalon {

/// An even sample of a scene's points with their local spacing, at hand for one question after the other: in the scene
/// itself each costs a walk over all columns.
class SpacingSample {
 public:
  explicit SpacingSample(const SegmentScene& scene);
  /// Median spacing of those that are free, m; points on one place of the index count once. 0 where none is free.
  double median_m(const SegmentScene& scene) const;

 private:
  struct Point {
    uint64_t place;
    uint32_t position;
    float spacing_m;
  };
  std::vector<Point> points_;
};

/// The same for one question.
double median_spacing_m(const SegmentScene& scene);

}  // namespace jalon
