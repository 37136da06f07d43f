// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/directions.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/parallel.h"

namespace jalon {

namespace {

constexpr size_t kAngleGrain = 65536;  // angles a chunk: about 2 ms

/// Number of steps in a range: one more, when closed, for its end. Rounding must not lose the last
/// one.
uint64_t steps_in(double from, double to, double step, bool is_closed) {
  if (!(to >= from)) fail(Status::kInvalidArgument, "a field of view ends before it begins");
  const double n = is_closed ? std::floor((to - from) / step + 1e-9) + 1
                             : std::max(1.0, std::ceil((to - from) / step - 1e-9));
  if (!(n <= kMaxRays)) fail(Status::kLimit, "the angular steps give too many rays");
  return static_cast<uint64_t>(n);
}

}  // namespace

RayGrid ray_grid(const StaticSettings& s) {
  RayGrid grid;
  grid.columns = steps_in(s.horizontal_from_rad, s.horizontal_to_rad, s.horizontal_step_rad, false);
  grid.rows = steps_in(s.vertical_from_rad, s.vertical_to_rad, s.vertical_step_rad, true);
  if (static_cast<double>(grid.columns) * static_cast<double>(grid.rows) > kMaxRays)
    fail(Status::kLimit, "the angular steps give more than 2^36 rays a station");
  return grid;
}

Directions::Directions(const StaticSettings& settings, const RayGrid& grid, Task& task)
    : settings_(settings), grid_(grid), horizontal_(grid.columns), vertical_(grid.rows) {
  parallel_for(task, horizontal_.size(), kAngleGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) horizontal_[i] = sine_cosine(horizontal(i));
  });
  parallel_for(task, vertical_.size(), kAngleGrain, [&](size_t begin, size_t end) {
    for (size_t j = begin; j < end; ++j) vertical_[j] = sine_cosine(vertical(j));
  });
}

Vec3 Directions::of(uint64_t ray, double error_h_rad, double error_v_rad) const {
  return polar(sine_cosine(horizontal(column(ray)) + error_h_rad),
               sine_cosine(vertical(row(ray)) + error_v_rad));
}

double Directions::horizontal(uint64_t i) const {
  return settings_.horizontal_from_rad + settings_.horizontal_step_rad * static_cast<double>(i);
}
double Directions::vertical(uint64_t j) const {
  return settings_.vertical_from_rad + settings_.vertical_step_rad * static_cast<double>(j);
}

}  // namespace jalon
