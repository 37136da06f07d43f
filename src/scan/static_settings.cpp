// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/static_settings.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/parallel.h"

namespace jalon {

namespace {

constexpr size_t kAngleGrain = 65536;  // angles a chunk: about 2 ms

/// Number of steps in a range: one more, when closed, for its end. Rounding must not lose the last one.
uint64_t steps_in(double from, double to, double step, bool is_closed) {
  if (!(to >= from)) fail(Status::kInvalidArgument, "a field of view ends before it begins");
  const double n =
      is_closed ? std::floor((to - from) / step + 1e-9) + 1 : std::max(1.0, std::ceil((to - from) / step - 1e-9));
  if (!(n <= kMaxRays)) fail(Status::kLimit, "the angular steps give too many rays");
  return static_cast<uint64_t>(n);
}

/// Maker's values of the Trimble GX (Boulaassal 2010, table 3.1 and annex A.3): 7 mm, 12" and 14"; a spot of 3 mm at
/// 50 m that the autofocus keeps in proportion to the range.
void set_gx(StaticSettings& s) {
  s.range_noise = 0.007;
  s.range_noise_ppm = 0;
  s.horizontal_noise = 60e-6;
  s.vertical_noise = 70e-6;
  s.beam_diameter = 0;
  s.beam_divergence = 60e-6;
}

/// Noise, beam and misfit.
void read_errors(const ParamSet& params, StaticSettings& s) {
  s.range_noise = params.number("range_noise_m");
  s.range_noise_ppm = params.number("range_noise_ppm");
  s.horizontal_noise = params.number("angle_noise_rad");
  s.vertical_noise = params.number("vertical_noise_rad");
  if (s.vertical_noise < 0) s.vertical_noise = s.horizontal_noise;
  s.beam_diameter = params.number("beam_diameter_m");
  s.beam_divergence = params.number("beam_divergence_rad");
  if (params.text("instrument") == "gx") set_gx(s);
  s.beam_rings = static_cast<int>(params.integer("beam_rings"));
  s.range_resolution = params.number("range_resolution_m");
  s.echo = params.text("echo") == "first"  ? EchoChoice::kFirst
           : params.text("echo") == "last" ? EchoChoice::kLast
                                           : EchoChoice::kStrongest;
  s.misfit_shift = params.number("misfit_shift_m");
  s.misfit_rotation = params.number("misfit_rotation_rad");
  s.point_noise = params.number("point_noise_m");
}

}  // namespace

StaticSettings static_settings(const ParamSet& params) {
  StaticSettings s;
  s.horizontal_from = params.number("horizontal_from_rad");
  s.vertical_from = params.number("vertical_from_rad");
  s.horizontal_step = params.number("horizontal_step_rad");
  s.vertical_step = params.number("vertical_step_rad");
  s.columns = steps_in(s.horizontal_from, params.number("horizontal_to_rad"), s.horizontal_step, false);
  s.rows = steps_in(s.vertical_from, params.number("vertical_to_rad"), s.vertical_step, true);
  if (static_cast<double>(s.columns) * static_cast<double>(s.rows) > kMaxRays)
    fail(Status::kLimit, "the angular steps give more than 2^36 rays a station");
  s.by_columns = params.text("order") == "columns";
  s.min_range = params.number("min_range_m");
  s.max_range = params.number("max_range_m");
  if (!(s.min_range <= s.max_range)) fail(Status::kInvalidArgument, "min_range_m is above max_range_m");
  read_errors(params, s);
  s.dropout = params.number("dropout");
  s.outliers = params.number("outliers");
  s.outliers_in_box = params.text("outlier_place") == "box";
  s.step_m = params.number("coordinate_step_m");
  const auto& offset = params.numbers("offset_m");
  if (offset.size() != 3) fail(Status::kInvalidArgument, "offset_m takes three numbers");
  s.offset = {offset[0], offset[1], offset[2]};
  s.seed = static_cast<uint64_t>(params.integer("seed"));
  s.with_incidence = params.flag("incidence_angle");
  s.max_points = static_cast<uint64_t>(params.integer("max_points"));
  s.spacing_m = params.number("spacing_m");
  s.stations = static_cast<uint64_t>(params.integer("stations"));
  s.station_distance_m = params.number("station_distance_m");
  return s;
}

Directions::Directions(const StaticSettings& settings, Task& task)
    : settings_(settings), horizontal_(settings.columns), vertical_(settings.rows) {
  parallel_for(task, horizontal_.size(), kAngleGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) horizontal_[i] = sine_cosine(horizontal(i));
  });
  parallel_for(task, vertical_.size(), kAngleGrain, [&](size_t begin, size_t end) {
    for (size_t j = begin; j < end; ++j) vertical_[j] = sine_cosine(vertical(j));
  });
}

Vec3 Directions::of(uint64_t ray, double error_h_rad, double error_v_rad) const {
  return polar(sine_cosine(horizontal(column(ray)) + error_h_rad), sine_cosine(vertical(row(ray)) + error_v_rad));
}

double Directions::horizontal(uint64_t i) const {
  return settings_.horizontal_from + settings_.horizontal_step * static_cast<double>(i);
}
double Directions::vertical(uint64_t j) const {
  return settings_.vertical_from + settings_.vertical_step * static_cast<double>(j);
}

}  // namespace jalon
