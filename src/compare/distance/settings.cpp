// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/distance/settings.h"

#include "base/setting_rows.h"
#include "compare/visibility/rows.h"

namespace jalon {

namespace {

// Girardeau-Montaut 2006 sets k "from the density of the reference" and names no value. Measured on
// random points of a plane: the share of compared points whose foot is not on the surface is 0.2 %
// with 8 points for a plane (1.2 % with 6), 3 % with 16 for triangles (56 % with 6) and 0.04 % with
// 16 for a quadric (0.5 % with 12).
constexpr uint32_t kPlanePoints = 8, kDelaunayPoints = 16, kQuadricPoints = 16;

constexpr auto kSettingsRows = setting_rows(
    number_row<&DistanceSettings::max_distance_m>(
        "max_distance_m", 0, 1e9, "m", "",
        "Radius beyond which a point counts as without reference (status nothing near); 0 = no "
        "limit."),
    bool_row<&DistanceSettings::is_signed>(
        "signed", "",
        "Of a model: distances are negative behind its surfaces, where their corners run "
        "clockwise."),
    number_row<&DistanceSettings::tolerance_m>(
        "tolerance_m", 0, 1e9, "m", "",
        "Of a model: distance up to which a point is judged to be within tolerance; 0 = no "
        "judgement."),
    number_row<&DistanceSettings::chord_error_m>(
        "chord_error_m", 1e-7, 1, "m", "",
        "Of a model: largest distance of chords from the arcs they stand for."),
    choice_row<&DistanceSettings::local_model>(
        "local_model", "none|plane|delaunay|quadric", "",
        "Surface through the reference points around the nearest one, to which the distance is "
        "taken: it takes away the sampling error of a thin or uneven reference. Never more than "
        "the distance to the nearest point."),
    integer_row<&DistanceSettings::k>(
        "k", 0, 256, "", "",
        "Reference points of a local model, the nearest one included; 0 = 8 for a plane, 16 for "
        "the others. Not used with radius_m."),
    number_row<&DistanceSettings::radius_m>(
        "radius_m", 0, 1e6, "m", "",
        "Radius of the neighbourhood of a local model, instead of k; 0 = by k. Three to five "
        "times the mean spacing of the reference."),
    choice_row<&DistanceSettings::neighbourhood>(
        "neighbourhood", "nearest|point", "",
        "Where a local model lies: around the nearest reference point, or around the compared "
        "point itself."),
    bool_row<&DistanceSettings::differences>(
        "differences", "",
        "Also gives the columns difference_x, _y, _z: from the foot on the reference to the "
        "compared point."),
    bool_row<&DistanceSettings::sampling_error>(
        "sampling_error", "",
        "Also predicts, from the density of the reference, the distance that sampling alone "
        "makes."),
    bool_row<&DistanceSettings::hausdorff>(
        "hausdorff", "",
        "Also measures from the reference to the compared cloud, for the symmetric Hausdorff "
        "distance."),
    choice_row<&DistanceSettings::visibility>(
        "visibility", "none|stations|found", "",
        "stations: points that the stations of the reference cloud could not have seen get no "
        "distance, and say why; none: every point is compared; found: as stations, and where the "
        "points have none those that their order tells, if it tells any"),
    bool_row<&DistanceSettings::reference_spacing>(
        "reference_spacing", "",
        "With visibility: also tells how far apart the reference's points lie where each point is "
        "seen, along grazing rays and across edges in depth: a distance up to half of that is no "
        "sign of a change"),
    bool_row<&DistanceSettings::detection>(
        "detection", "",
        "Tests every point: distances from the surfaces of the reference, their level of detection "
        "by noise, spacing and shape, and whether the reference's stations saw through the place "
        "(visibility). What they could not see is hidden; without stations what lies beyond the "
        "border of a surface is. local_model is not used then."),
    number_row<&DistanceSettings::false_discovery_rate>(
        "false_discovery_rate", 1e-9, 0.5, "1", "",
        "Of detection: share of the surfaces called moved that need not have (Benjamini & Hochberg "
        "1995)."),
    number_row<&DistanceSettings::alignment_sigma_m>(
        "alignment_sigma_m", 0, 1e3, "m", "",
        "Of detection: standard deviation of the clouds' alignment."),
    nested_rows<&DistanceSettings::depth, kDepthRows>(),
    nested_rows<&DistanceSettings::hidden, kHiddenRows>());

}  // namespace

std::span<const ParamRow> distance_rows() { return kSettingsRows; }

uint32_t DistanceSettings::model_points() const {
  if (k != 0) return k;
  if (local_model == LocalModelKind::kPlane) return kPlanePoints;
  return local_model == LocalModelKind::kDelaunay ? kDelaunayPoints : kQuadricPoints;
}

}  // namespace jalon
