// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/setting_rows.h"
#include "segment/growing_settings.h"
#include "segment/plane_rows.h"
#include "segment/segmentation.h"

namespace jalon {

namespace {

// Origins: those that "ransac" has too as there; k as for normals; 20 degrees between the normals
// of point and plane as in CGAL's region growing (Lafarge & Mallet 2012 use 25).
constexpr auto kGrowingLeast = setting_rows(
    number_row<&SurfaceSettings::distance_tolerance_m>(
        "distance_tolerance_m", 1e-5, 10, "m", "region_growing",
        "Largest distance of a point from the running plane: a half-thickness, about 3 sigma "
        "of the scan."),
    number_row<&SurfaceSettings::min_area_m2>(
        "min_area_m2", 0, 1e9, "m2", "region_growing",
        "Smallest area of a segment, counted in occupied raster pixels."),
    integer_row<&SurfaceSettings::min_points>("min_points", 3, 4e9, "points", "region_growing",
                                              "Fewest points of a segment."));

constexpr auto kGrowingNormal = setting_rows(number_row<&SurfaceSettings::normal_tolerance_rad>(
    "normal_tolerance_rad", 0.01, 1.570796, "rad", "region_growing",
    "Largest angle between the normal of a point and that of the running plane; 0.349 = "
    "20 degrees."));

constexpr auto kGrowingEnding = setting_rows(
    number_row<&SurfaceSettings::pixel_m>(
        "pixel_m", 0, 100, "m", "region_growing",
        "Edge of a raster pixel for area and re-assignment; 0 = twice the point spacing of "
        "the segment."),
    number_row<&SurfaceSettings::merge_gap_m>(
        "merge_gap_m", 0, 1e4, "m", "region_growing",
        "Widest gap between coplanar regions joined at the end; more joins repeated panels "
        "and panes; 0 = none."),
    bool_row<&SurfaceSettings::global_planarity>("global_planarity", "region_growing",
                                                 kGlobalPlanarityHelp),
    number_row<&SurfaceSettings::orientation_tolerance_rad>(
        "orientation_tolerance_rad", 1e-4, 0.785398, "rad", "region_growing",
        "Largest angle to the facade's axes for the orientation classes; 0.0175 = 1 degree."),
    bool_row<&SurfaceSettings::facade_frame>(
        "facade_frame", "region_growing",
        "Turns the main facade parallel to OXZ in the facade frame; off: the frame is the "
        "identity."));

constexpr auto kGrowingRows = setting_rows(
    nested_rows<&GrowingSettings::surface, kGrowingLeast>(),
    choice_row<&GrowingSettings::normals>(
        "normals", "neighbours|field", "region_growing",
        "Normals of the points: from the planes through their k neighbours, or the field "
        "\"normal\"."),
    integer_row<&GrowingSettings::k>(
        "k", 4, 256, "points", "region_growing",
        "Number of nearest neighbours that give a normal, the point itself included."),
    nested_rows<&GrowingSettings::surface, kGrowingNormal>(),
    number_row<&GrowingSettings::gap_m>(
        "gap_m", 0, 100, "m", "region_growing",
        "How far from a region its next points are looked for; 0 = twice the local point "
        "spacing."),
    nested_rows<&GrowingSettings::surface, kGrowingEnding>());

}  // namespace

std::span<const ParamRow> region_growing_rows() { return kGrowingRows; }

}  // namespace jalon
