// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/static_settings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.h"
#include "base/parallel.h"
#include "scan/scanner.h"

namespace jalon {

namespace {

constexpr double kTau = 2 * std::numbers::pi;
constexpr size_t kAngleGrain = 65536;  // angles a chunk: about 2 ms

/// Number of steps in a range: one more, when closed, for its end. Rounding must not lose the last one.
uint64_t steps_in(double from, double to, double step, bool is_closed) {
  if (!(to >= from)) fail(Status::kInvalidArgument, "a field of view ends before it begins");
  const double n =
      is_closed ? std::floor((to - from) / step + 1e-9) + 1 : std::max(1.0, std::ceil((to - from) / step - 1e-9));
  if (!(n <= kMaxRays)) fail(Status::kLimit, "the angular steps give too many rays");
  return static_cast<uint64_t>(n);
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
  s.range_noise = params.number("range_noise_m");
  s.angle_noise = params.number("angle_noise_rad");
  s.point_noise = params.number("point_noise_m");
  s.dropout = params.number("dropout");
  s.outliers = params.number("outliers");
  s.outliers_in_box = params.text("outlier_place") == "box";
  s.step_m = params.number("coordinate_step_m");
  const auto& offset = params.numbers("offset_m");
  if (offset.size() != 3) fail(Status::kInvalidArgument, "offset_m takes three numbers");
  s.offset = {offset[0], offset[1], offset[2]};
  s.seed = static_cast<uint64_t>(params.integer("seed"));
  s.with_incidence = params.flag("incidence_angle");
  return s;
}

std::span<const ParamRow> static_scanner_rows() {
  static constexpr ParamRow kRows[] = {
      number_row("horizontal_step_rad", 0.0016, 1e-6, 1, "rad", "", "angle between neighbouring columns"),
      number_row("vertical_step_rad", 0.0016, 1e-6, 1, "rad", "", "angle between neighbouring points of a column"),
      number_row("horizontal_from_rad", -std::numbers::pi, -kTau, kTau, "rad", "",
                 "start of the field of view, from the scanner's +Y axis, clockwise toward +X"),
      number_row("horizontal_to_rad", std::numbers::pi, -kTau, kTau, "rad", "",
                 "end of the field of view, itself left out"),
      number_row("vertical_from_rad", -std::numbers::pi / 3, -std::numbers::pi / 2, std::numbers::pi / 2, "rad", "",
                 "lowest angle, from the horizon"),
      number_row("vertical_to_rad", std::numbers::pi / 2, -std::numbers::pi / 2, std::numbers::pi / 2, "rad", "",
                 "highest angle, from the horizon"),
      number_row("min_range_m", 0.5, 0, 1e6, "m", "", "smallest range recorded"),
      number_row("max_range_m", 200, 0, 1e6, "m", "", "largest range recorded"),
      number_row("range_noise_m", 0.003, 0, 100, "m", "", "standard deviation of the measured distance"),
      number_row("angle_noise_rad", 2e-5, 0, 1, "rad", "", "standard deviation of each measured angle"),
      number_row("point_noise_m", 0, 0, 100, "m", "",
                 "standard deviation added to each coordinate, whatever the range"),
      number_row("dropout", 0, 0, 1, "1", "", "share of the returns that is lost"),
      number_row("outliers", 0, 0, 1, "1", "", "share of the returns that is no point of a face"),
      choice_row("outlier_place", "ray", "ray|box", "",
                 "ray: in front of the surface, on the ray; box: anywhere in the model's box"),
      number_row("coordinate_step_m", 0, 0, 1, "m", "",
                 "coordinates are recorded as whole metres and multiples of this, before the offset; 0: as they are"),
      doubles_row("offset_m", "0 0 0", -1e9, 1e9, "m", "",
                  "three numbers added to all coordinates and poses at the end, e.g. a national grid"),
      choice_row("order", "columns", "columns|rows", "",
                 "columns: points of a station run upward column by column; rows: line by line"),
      bool_row("incidence_angle", false, "", "adds the field incidence_angle"),
      integer_row("seed", 1, 0, 9007199254740992.0, "1", "", "of the noise; the same seed gives the same bits"),
  };
  return kRows;
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
