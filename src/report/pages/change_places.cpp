// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pages/change_places.h"

#include <algorithm>
#include <cmath>

#include "compare/changes/changed_points.h"
#include "report/charts/column_vector.h"

namespace jalon {

namespace {

bool has_vectors(const Column* column) {
  return column != nullptr && column->info().components == 3;
}

double volume_of(const Box3& box) {
  const Vec3 size = box.max - box.min;
  return size.x * size.y * size.z;
}

// The places, the smallest first, whose boxes the points of one epoch fill.
void fill(const Comparison& comparison, double threshold_m,
          std::vector<uint64_t> ChangePlace::*points, std::vector<ChangePlace>& places,
          Task& task) {
  RegionSettings settings;
  settings.threshold_m = threshold_m;
  if (threshold_m > 0) settings.criterion = RegionSettings::Criterion::kThreshold;
  else if (comparison.points.find("significant") == nullptr) return;
  const std::vector<uint8_t> is_changed = changed_points(comparison, settings, task);
  for (size_t i = 0; i < is_changed.size(); ++i) {
    if (is_changed[i] == 0) continue;
    const Vec3 p = comparison.cloud->point(i);
    const auto place = std::find_if(places.begin(), places.end(),
                                    [&](const ChangePlace& one) { return one.box.contains(p); });
    if (place != places.end()) ((*place).*points).push_back(i);
  }
}

}  // namespace

std::vector<Vec3> ChangePlace::points(const Comparison& forward, const Comparison* reverse) const {
  std::vector<Vec3> out;
  for (const uint64_t i : after) out.push_back(forward.cloud->point(i));
  if (reverse != nullptr)
    for (const uint64_t i : before) out.push_back(reverse->cloud->point(i));
  return out;
}

std::vector<ChangePlace> change_places(const Comparison& forward, const Comparison* reverse,
                                       const FieldTable& changes, double threshold_m, size_t most,
                                       Task& task) {
  const Column *low = changes.find("box_min"), *high = changes.find("box_max");
  std::vector<ChangePlace> out;
  if (!has_vectors(low) || !has_vectors(high)) return out;
  for (size_t row = 0; row < std::min({low->count(), high->count(), most}); ++row) {
    const Box3 box{vector_at(*low, row), vector_at(*high, row)};
    if (std::isfinite(volume_of(box)) && !box.empty()) out.push_back({row, box, {}, {}});
  }
  std::stable_sort(out.begin(), out.end(), [](const ChangePlace& a, const ChangePlace& b) {
    return volume_of(a.box) < volume_of(b.box);
  });
  fill(forward, threshold_m, &ChangePlace::after, out, task);
  if (reverse != nullptr) fill(*reverse, threshold_m, &ChangePlace::before, out, task);
  std::sort(out.begin(), out.end(),
            [](const ChangePlace& a, const ChangePlace& b) { return a.row < b.row; });
  return out;
}

}  // namespace jalon
