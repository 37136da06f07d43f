// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/e57/record_points.h"

#include <cmath>

namespace jalon::e57 {

namespace {

// Range, azimuth from x to y, elevation (ASTM E2807, 8.5.3).
Vec3 of_angles(double range, double azimuth, double elevation) {
  return {range * std::cos(elevation) * std::cos(azimuth),
          range * std::cos(elevation) * std::sin(azimuth), range * std::sin(elevation)};
}

}  // namespace

RecordPoints::RecordPoints(const Records& records, const ScanLayout& layout, size_t begin,
                           size_t end)
    : records_(records), layout_(layout), begin_(begin), end_(end) {
  if (!layout.invalid) return;
  const std::vector<double> invalid = column(*layout.invalid);
  for (size_t i = 0; i < invalid.size(); ++i)
    if (invalid[i] == 0) valid_.push_back(i);
}

std::vector<double> RecordPoints::places(const std::optional<Transform>& pose) const {
  const std::vector<double> a = column(layout_.position[0]), b = column(layout_.position[1]),
                            c = column(layout_.position[2]);
  std::vector<double> xyz(3 * count());
  for (size_t p = 0; p < count(); ++p) {
    const size_t i = record(p);
    Vec3 place = layout_.spherical ? of_angles(a[i], b[i], c[i]) : Vec3{a[i], b[i], c[i]};
    if (pose) place = pose->point(place);
    for (size_t k = 0; k < 3; ++k) xyz[3 * p + k] = place[static_cast<int>(k)];
  }
  return xyz;
}

std::vector<double> RecordPoints::values(const FieldColumn& field) const {
  const std::vector<double> stored = column(field.column);
  const std::vector<double> invalid =
      field.invalid ? column(*field.invalid) : std::vector<double>();
  std::vector<double> values(count());
  for (size_t p = 0; p < values.size(); ++p) {
    const size_t i = record(p);
    const bool has_none = field.invalid && invalid[i] != 0;
    values[p] = has_none ? std::nan("") : stored[i] * field.factor + field.shift;
  }
  return values;
}

std::vector<double> RecordPoints::column(size_t number) const {
  std::vector<double> values(end_ - begin_);
  records_.values(number, begin_, values.size(), values.data());
  return values;
}

}  // namespace jalon::e57
