// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/surface/spacing.h"

#include <algorithm>

namespace jalon {

namespace {

constexpr size_t kMostSpacings = 1 << 16;

}  // namespace

double median_spacing_m(const SegmentScene& scene) {
  const size_t step = (scene.size() + kMostSpacings - 1) / kMostSpacings;
  std::vector<float> spacings;
  uint64_t place = ~uint64_t{0};
  for (size_t i = 0; i < scene.size(); i += step) {
    if (scene.owner[i] != 0 || scene.tree->code(i) == place) continue;
    place = scene.tree->code(i);
    spacings.push_back(scene.spacing[i]);
  }
  if (spacings.empty()) return 0;
  const auto middle = spacings.begin() + static_cast<ptrdiff_t>(spacings.size() / 2);
  std::nth_element(spacings.begin(), middle, spacings.end());
  return static_cast<double>(*middle);
}

}  // namespace jalon
