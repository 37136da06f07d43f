// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/changes/measured_steps.h"

#include <cmath>

namespace jalon {

MeasuredSteps::MeasuredSteps(const Comparison& comparison, const Cloud* reference)
    : comparison_(comparison),
      reference_(reference),
      distance_(comparison.points.require("distance").values<double>()) {
  constexpr const char* kNames[] = {"difference_x", "difference_y", "difference_z"};
  for (size_t axis = 0; axis < 3; ++axis)
    if (const Column* column = comparison.points.find(kNames[axis]))
      difference_[axis] = column->values<double>();
  if (const Column* column = comparison.points.find("nearest");
      column != nullptr && reference != nullptr)
    nearest_ = column->values<uint32_t>();
  if (const Column* column = comparison.points.find("normal")) normal_ = column->values<double>();
}

Vec3 MeasuredSteps::of(uint32_t point, const Vec3& otherwise_along) const {
  const double d = distance_[point];
  if (!std::isfinite(d)) return {d, d, d};
  if (!difference_[2].empty())
    return {difference_[0][point], difference_[1][point], difference_[2][point]};
  if (!nearest_.empty() && nearest_[point] < reference_->size())
    return comparison_.cloud->point(point) - reference_->point(nearest_[point]);
  if (const size_t at = 3 * size_t{point}; !normal_.empty())
    return Vec3{normal_[at], normal_[at + 1], normal_[at + 2]} * d;
  return otherwise_along * d;
}

}  // namespace jalon
