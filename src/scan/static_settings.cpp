// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/static_settings.h"

#include "base/error.h"
#include "base/setting_rows.h"
#include "scan/surfaces.h"

namespace jalon {

namespace {

/// Maker's values of the Trimble GX (Boulaassal 2010, table 3.1 and annex A.3): 7 mm, 12" and 14"; a spot of 3 mm at
/// 50 m that the autofocus keeps in proportion to the range.
void set_gx(StaticSettings& s) {
  s.range_noise_m = 0.007;
  s.range_noise_ppm = 0;
  s.angle_noise_rad = 60e-6;
  s.vertical_noise_rad = 70e-6;
  s.beam_diameter_m = 0;
  s.beam_divergence_rad = 60e-6;
}

}  // namespace

std::span<const ParamRow> static_scanner_rows() {
  using S = StaticSettings;
  constexpr double kPi = std::numbers::pi;
  static constexpr auto kRows = setting_rows(
      number_row<&S::horizontal_step_rad>("horizontal_step_rad", 1e-6, 1, "rad", "",
                                          "angle between neighbouring columns"),
      number_row<&S::vertical_step_rad>("vertical_step_rad", 1e-6, 1, "rad", "",
                                        "angle between neighbouring points of a column"),
      number_row<&S::horizontal_from_rad>(
          "horizontal_from_rad", -2 * kPi, 2 * kPi, "rad", "",
          "start of the field of view, from the scanner's +Y axis, clockwise toward +X"),
      number_row<&S::horizontal_to_rad>("horizontal_to_rad", -2 * kPi, 2 * kPi, "rad", "",
                                        "end of the field of view, itself left out"),
      number_row<&S::vertical_from_rad>("vertical_from_rad", -kPi / 2, kPi / 2, "rad", "",
                                        "lowest angle, from the horizon"),
      number_row<&S::vertical_to_rad>("vertical_to_rad", -kPi / 2, kPi / 2, "rad", "",
                                      "highest angle, from the horizon"),
      number_row<&S::min_range_m>("min_range_m", 0, 1e6, "m", "", "smallest range recorded"),
      number_row<&S::max_range_m>("max_range_m", 0, 1e6, "m", "", "largest range recorded"),
      number_row<&S::range_noise_m>("range_noise_m", 0, 100, "m", "",
                                    "standard deviation of the measured distance"),
      number_row<&S::range_noise_ppm>("range_noise_ppm", 0, 1e6, "ppm", "",
                                      "what is added to it: millionths of the distance"),
      number_row<&S::angle_noise_rad>("angle_noise_rad", 0, 1, "rad", "",
                                      "standard deviation of each measured angle"),
      number_row<&S::vertical_noise_rad>("vertical_noise_rad", -1, 1, "rad", "",
                                         "standard deviation of the vertical angle; negative: the "
                                         "same as that of the horizontal one"),
      number_row<&S::point_noise_m>(
          "point_noise_m", 0, 100, "m", "",
          "standard deviation added to each coordinate, whatever the range"),
      choice_row<&S::instrument>("instrument", "custom|gx", "",
                                 "gx: noise and beam of a Trimble GX in place of those set: 7 mm, "
                                 "60 and 70 urad, a spot of 60 urad"),
      number_row<&S::misfit_shift_m>("misfit_shift_m", 0, 10, "m", "",
                                     "standard deviation of each coordinate of a recorded station: "
                                     "one error of its pose and points"),
      number_row<&S::misfit_rotation_rad>("misfit_rotation_rad", 0, 1, "rad", "",
                                          "standard deviation of the rotation of a recorded "
                                          "station about each axis, through its centre"),
      number_row<&S::beam_diameter_m>("beam_diameter_m", 0, 1, "m", "",
                                      "diameter of the beam where it leaves the scanner"),
      number_row<&S::beam_divergence_rad>("beam_divergence_rad", 0, 0.1, "rad", "",
                                          "full angle by which the diameter grows"),
      integer_row<&S::beam_rings>(
          "beam_rings", 0, kMostBeamRings, "1", "",
          "sub-rays of a beam with a diameter: one and rings of 6, 12, 18 ...; 0: a line"),
      number_row<&S::range_resolution_m>("range_resolution_m", 0, 100, "m", "",
                                         "surfaces that a pulse meets within this range give one "
                                         "return at their weighted mean: a mixed pixel"),
      choice_row<&S::echo>("echo", "first|last|strongest", "",
                           "which return of a pulse is recorded"),
      nested_rows<&S::surfaces, kGlassRows>(),
      number_row<&S::dropout>("dropout", 0, 1, "1", "", "share of the returns that is lost"),
      number_row<&S::outliers>("outliers", 0, 1, "1", "",
                               "share of the returns that is no point of a face"),
      choice_row<&S::outlier_place>(
          "outlier_place", "ray|box", "",
          "ray: in front of the surface, on the ray; box: anywhere in the model's box"),
      number_row<&S::coordinate_step_m>("coordinate_step_m", 0, 1, "m", "",
                                        "coordinates are recorded as whole metres and multiples of "
                                        "this, before the offset; 0: as they are"),
      doubles_row<&S::offset_m>(
          "offset_m", -1e9, 1e9, "m", "",
          "three numbers added to all coordinates and poses at the end, e.g. a national grid"),
      choice_row<&S::order>(
          "order", "columns|rows", "",
          "columns: points of a station run upward column by column; rows: line by line"),
      integer_row<&S::max_points>(
          "max_points", 0, 9007199254740992.0, "points", "",
          "thins the whole scan at random to this number of points; 0: all"),
      number_row<&S::spacing_m>("spacing_m", 0, 100, "m", "",
                                "thins each station at random to one point a square of this side "
                                "on the surfaces; 0: all"),
      integer_row<&S::stations>("stations", 0, 1000, "1", "",
                                "number of automatic stations, evenly along a facade, on the axis "
                                "of a street, around a building; 0: by the model"),
      number_row<&S::station_distance_m>(
          "station_distance_m", 0, 1e6, "m", "",
          "distance of automatic stations from the foremost upright face; 0: 0.6 times the width"),
      nested_rows<&S::surfaces, kTruthRows>(),
      bool_row<&S::incidence_angle>("incidence_angle", "", "adds the field incidence_angle"),
      integer_row<&S::seed>("seed", 0, 9007199254740992.0, "1", "",
                            "of the noise; the same seed gives the same bits"));
  return kRows;
}

StaticSettings resolved(StaticSettings s) {
  if (!(s.min_range_m <= s.max_range_m))
    fail(Status::kInvalidArgument, "min_range_m is above max_range_m");
  if (s.vertical_noise_rad < 0) s.vertical_noise_rad = s.angle_noise_rad;
  if (s.instrument == StaticSettings::Instrument::kGx) set_gx(s);
  return s;
}

}  // namespace jalon
