// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <numbers>

#include "scan/scanner.h"
#include "scan/static_settings.h"
#include "scan/surfaces.h"

namespace jalon {

namespace {

constexpr double kTau = 2 * std::numbers::pi;

}  // namespace

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
      number_row("range_noise_ppm", 0, 0, 1e6, "ppm", "", "what is added to it: millionths of the distance"),
      number_row("angle_noise_rad", 2e-5, 0, 1, "rad", "", "standard deviation of each measured angle"),
      number_row("vertical_noise_rad", -1, -1, 1, "rad", "",
                 "standard deviation of the vertical angle; negative: the same as that of the horizontal one"),
      number_row("point_noise_m", 0, 0, 100, "m", "",
                 "standard deviation added to each coordinate, whatever the range"),
      choice_row("instrument", "custom", "custom|gx", "",
                 "gx: noise and beam of a Trimble GX in place of those set: 7 mm, 60 and 70 urad, a spot of 60 urad"),
      number_row("misfit_shift_m", 0, 0, 10, "m", "",
                 "standard deviation of each coordinate of a recorded station: one error of its pose and points"),
      number_row("misfit_rotation_rad", 0, 0, 1, "rad", "",
                 "standard deviation of the rotation of a recorded station about each axis, through its centre"),
      number_row("beam_diameter_m", 0, 0, 1, "m", "", "diameter of the beam where it leaves the scanner"),
      number_row("beam_divergence_rad", 0, 0, 0.1, "rad", "", "full angle by which the diameter grows"),
      integer_row("beam_rings", 2, 0, kMostBeamRings, "1", "",
                  "sub-rays of a beam with a diameter: one and rings of 6, 12, 18 ...; 0: a line"),
      number_row("range_resolution_m", 0.3, 0, 100, "m", "",
                 "surfaces that a pulse meets within this range give one return at their weighted mean: a mixed pixel"),
      choice_row("echo", "first", "first|last|strongest", "", "which return of a pulse is recorded"),
      kGlassMinRow, kGlassMaxRow,
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
      integer_row("max_points", 0, 0, 9007199254740992.0, "points", "",
                  "thins the whole scan at random to this number of points; 0: all"),
      number_row("spacing_m", 0, 0, 100, "m", "",
                 "thins each station at random to one point a square of this side on the surfaces; 0: all"),
      integer_row("stations", 0, 0, 1000, "1", "",
                  "number of automatic stations, evenly along a facade, on the axis of a street, around a building; "
                  "0: by the model"),
      number_row("station_distance_m", 0, 0, 1e6, "m", "",
                 "distance of automatic stations from the foremost upright face; 0: 0.6 times the width"),
      kTruthRow,
      bool_row("incidence_angle", false, "", "adds the field incidence_angle"),
      integer_row("seed", 1, 0, 9007199254740992.0, "1", "", "of the noise; the same seed gives the same bits"),
  };
  return kRows;
}

}  // namespace jalon
