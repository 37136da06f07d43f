// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/landslide/settings.h"

#include "base/error.h"
#include "base/setting_rows.h"

namespace jalon {

namespace {

using S = LandslideSettings;

constexpr auto kLandslideRows = setting_rows(
    doubles_row<&S::direction>(
        "direction", -1e9, 1e9, "", "",
        "Three numbers: the direction along which movements are counted, out of the ground; none = "
        "upward, or across the ground where it is steeper than 45 degrees as a whole."),
    number_row<&S::cell_m>(
        "cell_m", 0, 1e6, "m", "",
        "Side of the square cells across the direction; 0 = the smallest of 1, 2, 5 x 10^k m that "
        "leave 85 of 100 of those with points at least min_points in either epoch."),
    integer_row<&S::min_points>(
        "min_points", 3, 1e6, "points", "",
        "Fewest points of an epoch in a cell; with fewer the cell is not measured."),
    number_row<&S::confidence>(
        "confidence", 0.5, 0.9999, "1", "",
        "Share of unchanged cells whose movement stays within the level of detection."),
    number_row<&S::alignment_sigma_m>(
        "alignment_sigma_m", 0, 1e6, "m", "",
        "Standard deviation of the alignment of both epochs, the same everywhere; joins what the "
        "ground at rest shows of it."),
    number_row<&S::min_area_m2>("min_area_m2", 0, 1e12, "m2", "",
                                "Smaller zones are dropped, the cells beside them that were not "
                                "measured counted; 0 = three "
                                "cells."),
    choice_row<&S::stations>(
        "stations", "automatic|none", "",
        "Where the scanners stood, which tells why a cell was not measured: as the clouds say, "
        "else as the order of the points tells (automatic), or not asked (none)."),
    number_row<&S::max_range_m>("max_range_m", 0, 1e9, "m", "",
                                "From this distance on the scanners see nothing; 0 = unknown."),
    doubles_row<&S::outline>(
        "outline", -1e9, 1e9, "m", "",
        "x, y, z of the corners of the area that was to be surveyed, at least three: what lies in "
        "it and has no points is not measured, what lies outside is no part of the result. None = "
        "where either epoch has points, and what they enclose."));

}  // namespace

std::span<const ParamRow> landslide_rows() { return kLandslideRows; }

void LandslideSettings::check() const {
  if (!direction.empty() && direction.size() != 3)
    fail(Status::kInvalidArgument, "direction has %zu numbers; it needs x, y, z, or none",
         direction.size());
  if (!outline.empty() && (outline.size() % 3 != 0 || outline.size() < 9))
    fail(Status::kInvalidArgument,
         "outline has %zu numbers; it needs x, y, z of three corners or more", outline.size());
}

std::vector<Vec3> LandslideSettings::corners() const {
  std::vector<Vec3> out;
  for (size_t i = 0; i + 2 < outline.size(); i += 3)
    out.push_back({outline[i], outline[i + 1], outline[i + 2]});
  return out;
}

}  // namespace jalon
