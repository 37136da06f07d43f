// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/result/point_columns.h"

#include "base/numbers.h"
#include "base/parallel.h"

namespace jalon {

namespace {

constexpr size_t kPointColumnsPointsPerChunk = 1 << 15;

std::shared_ptr<Column> point_column(const char* name, ElementType type, const char* unit,
                                     const char* meaning, size_t n) {
  return std::make_shared<Column>(FieldInfo{name, type, 1, unit, meaning}, n);
}

}  // namespace

std::shared_ptr<Column> make_label_column(size_t n) {
  return point_column("label", ElementType::kUint32, "", "0 noise, else row of the segment + 1", n);
}

void add_point_columns(Segmentation& s, const Vec3& origin, Task& task) {
  const size_t n = s.cloud->size();
  auto residuals =
      point_column("residual", ElementType::kFloat32, "m", "signed distance to the own surface", n);
  auto orientations =
      point_column("orientation", ElementType::kUint8, "",
                   "0 noise, 1 parallel to the facade, 2 vertical, 3 horizontal, 4 inclined", n);
  const auto labels = s.labels->values<uint32_t>();
  const auto residual = residuals->values<float>();
  const auto orientation = orientations->values<uint8_t>();
  parallel_for(task, n, kPointColumnsPointsPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      residual[i] = kFloatNaN;
      orientation[i] = 0;
      if (labels[i] == 0) continue;
      const Segment& segment = s.segments[labels[i] - 1];
      residual[i] = static_cast<float>(segment.distance(s.cloud->point(i) - origin));
      orientation[i] = static_cast<uint8_t>(segment.orientation);
    }
  });
  s.residuals = residuals;
  s.orientations = orientations;
}

}  // namespace jalon
