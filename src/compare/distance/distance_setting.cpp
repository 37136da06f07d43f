// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/distance/distance_setting.h"

#include "compare/comparison.h"
#include "compare/distance/model_distance.h"
#include "compare/visibility/params.h"

namespace jalon {

namespace {

// Girardeau-Montaut 2006 sets k "from the density of the reference" and names no value. Measured on random points of a
// plane: the share of compared points whose foot is not on the surface is 0.2 % with 8 points for a plane (1.2 % with
// 6), 3 % with 16 for triangles (56 % with 6) and 0.04 % with 16 for a quadric (0.5 % with 12).
constexpr uint32_t kPlanePoints = 8, kDelaunayPoints = 16, kQuadricPoints = 16;

uint32_t default_points(LocalModelKind kind) {
  if (kind == LocalModelKind::kPlane) return kPlanePoints;
  return kind == LocalModelKind::kDelaunay ? kDelaunayPoints : kQuadricPoints;
}

constexpr ParamRow kRows[] = {
    number_row("max_distance_m", 0, 0, 1e9, "m", "",
               "Radius beyond which a point counts as without reference (status nothing near); 0 = no limit."),
    kSignedRow,
    kToleranceRow,
    kChordErrorRow,
    choice_row("local_model", "none", "none|plane|delaunay|quadric", "",
               "Surface through the reference points around the nearest one, to which the distance is taken: it takes "
               "away the sampling error of a thin or uneven reference. Never more than the distance to the nearest "
               "point."),
    integer_row("k", 0, 0, 256, "", "",
                "Reference points of a local model, the nearest one included; 0 = 8 for a plane, 16 for the "
                "others. Not used with radius_m."),
    number_row("radius_m", 0, 0, 1e6, "m", "",
               "Radius of the neighbourhood of a local model, instead of k; 0 = by k. Three to five times the mean "
               "spacing of the reference."),
    choice_row("neighbourhood", "nearest", "nearest|point", "",
               "Where a local model lies: around the nearest reference point, or around the compared point itself."),
    bool_row("differences", false, "",
             "Also gives the columns difference_x, _y, _z: from the foot on the reference to the compared point."),
    bool_row("sampling_error", false, "",
             "Also predicts, from the density of the reference, the distance that sampling alone makes."),
    bool_row("hausdorff", false, "",
             "Also measures from the reference to the compared cloud, for the symmetric Hausdorff distance."),
    kVisibilityRow,
    kReferenceSpacingRow,
    kDepthHorizontalStepRow,
    kDepthVerticalStepRow,
    kDepthCellFactorRow,
    kDepthRuleRow,
    kDepthFillPassesRow,
    kDepthEmptyRow,
    kDepthMarginRow,
    kDepthMarginFactorRow,
    kMaxRangeRow,
    kSecondCentreRow,
    kHiddenRow,
    kHiddenDirectionRow,
    kHiddenRadiusRow,
    kHiddenZoneRow,
    kHiddenShapeRatioRow,
};

LocalModelKind model_of(const std::string& name) {
  if (name == "plane") return LocalModelKind::kPlane;
  if (name == "delaunay") return LocalModelKind::kDelaunay;
  return name == "quadric" ? LocalModelKind::kQuadric : LocalModelKind::kNone;
}

}  // namespace

std::span<const ParamRow> distance_rows() { return kRows; }

DistanceSetting distance_setting(const ParamSet& params) {
  DistanceSetting s;
  if (params.number("max_distance_m") > 0) s.max_distance_m = params.number("max_distance_m");
  s.model = model_of(params.text("local_model"));
  s.k = static_cast<uint32_t>(params.integer("k"));
  if (s.k == 0) s.k = default_points(s.model);
  s.radius_m = params.number("radius_m");
  s.around_point = params.text("neighbourhood") == "point";
  s.differences = params.flag("differences");
  s.sampling_error = params.flag("sampling_error");
  s.hausdorff = params.flag("hausdorff");
  return s;
}

}  // namespace jalon
