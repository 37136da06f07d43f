// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/setting_rows.h"
#include "fieldtools/chi_square.h"

namespace jalon {

namespace {

constexpr ParamRow kChiSquareSettingsMethodRow = choice_row<&ChiSquareSettings::method>(
    "method", "chi_square|kolmogorov", "",
    "chi_square: counts in classes against the law; kolmogorov: largest difference of the "
    "cumulatives");

}  // namespace

std::span<const ParamRow> chi_square_rows() {
  using S = ChiSquareSettings;
  static constexpr auto kRows = setting_rows(
      kChiSquareSettingsMethodRow,
      integer_row<&S::neighbours>("neighbours", kFewestTested, 256, "points", "",
                                  "Nearest points with a value that are tested together, the point "
                                  "itself included; not read when radius_m is above 0"),
      number_row<&S::radius_m>(
          "radius_m", 0, 1e6, "m", "",
          "Radius of the ball to test instead, free of the density; 0 = neighbours"),
      number_row<&S::error_margin>(
          "error_margin", 1e-9, 0.5, "1", "",
          "Share of neighbourhoods of pure noise that may count as changed"),
      choice_row<&S::classes>(
          "classes", "equiprobable|relaxed", "chi_square",
          "equiprobable: all of one probability, distances saturate; relaxed: of one width up to "
          "the largest value, distances diverge and leave room for the cut"),
      choice_row<&S::threshold>("threshold", "tabulated|empirical|given", "",
                                "The cut: of the error margin; the law's distance to its own "
                                "sample (chi_square); or cut"),
      number_row<&S::cut>("cut", 0, 1e300, "1", "", "The cut where threshold is given"),
      integer_row<&S::passes>("passes", 1, 2, "", "",
                              "2 tests the points near the limit again, with more neighbours"),
      integer_row<&S::second_neighbours>(
          "second_neighbours", kFewestTested, 256, "points", "",
          "Neighbours of the second pass; a radius grows by the root of their ratio"),
      number_row<&S::band_low>("band_low", 0, 1, "1", "",
                               "The second pass takes points from this many tabulated cuts ..."),
      number_row<&S::band_high>("band_high", 1, 1e6, "1", "", "... to this many"),
      bool_row<&S::one_sided>("one_sided", "",
                              "Only where deviations are above those of the law on average: the "
                              "test alone also finds places that are quieter"),
      string_row<&S::name>("name", "",
                           "Name of the field of distances; empty = that of the method"),
      string_row<&S::changed>("changed", "", "Name of the field of 0 and 1"));
  return kRows;
}

std::string ChiSquareSettings::distance_field() const {
  return name.empty() ? choice_at(kChiSquareSettingsMethodRow, static_cast<size_t>(method)) : name;
}

}  // namespace jalon
