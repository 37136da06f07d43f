// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/surface/spacing.h"

#include <algorithm>

namespace jalon {

namespace {

constexpr size_t kMostSpacings = 1 << 16;

}  // namespace

SpacingSample::SpacingSample(const SegmentScene& scene) {
  const size_t step = (scene.size() + kMostSpacings - 1) / kMostSpacings;
  for (size_t i = 0; i < scene.size(); i += step)
    points_.push_back({scene.tree->code(i), static_cast<uint32_t>(i), scene.spacing[i]});
}

double SpacingSample::median_m(const SegmentScene& scene) const {
  std::vector<float> spacings;
  uint64_t place = ~uint64_t{0};
  for (const Point& point : points_) {
    if (scene.owner[point.position] != 0 || point.place == place) continue;
    place = point.place;
    spacings.push_back(point.spacing_m);
  }
  if (spacings.empty()) return 0;
  const auto middle = spacings.begin() + static_cast<ptrdiff_t>(spacings.size() / 2);
  std::nth_element(spacings.begin(), middle, spacings.end());
  return static_cast<double>(*middle);
}

double median_spacing_m(const SegmentScene& scene) { return SpacingSample(scene).median_m(scene); }

}  // namespace jalon
