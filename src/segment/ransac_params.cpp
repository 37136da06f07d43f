// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/setting_rows.h"
#include "segment/plane_rows.h"
#include "segment/ransac_settings.h"
#include "segment/segmentation.h"

namespace jalon {

namespace {

// Origins: Boulaassal 2010, figs 3.10-3.11 (0.025 m), 3.4.3.2 (0.99), 3.4.5.2 (1 degree); Schnabel
// et al. 2007 (25 degrees between the normals of point and plane).
constexpr auto kRansacTolerance = setting_rows(number_row<&SurfaceSettings::distance_tolerance_m>(
    "distance_tolerance_m", 1e-5, 10, "m", "ransac",
    "Largest distance of a point from its plane: a half-thickness, about 3 sigma of the "
    "scan."));

constexpr auto kRansacToleranceFrom = setting_rows(
    choice_row<&ToleranceSettings::tolerance_from>(
        "tolerance_from", "auto|hand|sigma|estimate", "ransac",
        "The tolerance: distance_tolerance_m, and where that is left at its default no less than "
        "3 sigma of the cloud's noisiest surfaces; distance_tolerance_m as it is; from sigma_m by "
        "chi-square; or the same with the sigma of the cloud's own neighbourhoods."),
    number_row<&ToleranceSettings::sigma_m>(
        "sigma_m", 1e-6, 10, "m", "ransac",
        "Standard deviation of a point across its surface, for tolerance_from = sigma."),
    number_row<&ToleranceSettings::tolerance_probability>(
        "tolerance_probability", 0.5, 0.999999, "1", "ransac",
        "Share of a plane's points within the tolerance, for tolerance_from = sigma or "
        "estimate."),
    integer_row<&ToleranceSettings::tolerance_dof>(
        "tolerance_dof", 1, 2, "1", "ransac",
        "Degrees of freedom of that chi-square: 1 is right for distances to a plane (2.58 "
        "sigma at 0.99); 2 as in Boulaassal 2010 (3.03 sigma)."));

constexpr auto kRansacLeast =
    setting_rows(number_row<&SurfaceSettings::min_area_m2>(
                     "min_area_m2", 0, 1e9, "m2", "ransac",
                     "Smallest area of a segment, counted in occupied raster pixels."),
                 integer_row<&SurfaceSettings::min_points>("min_points", 3, 4e9, "points", "ransac",
                                                           "Fewest points of a segment."));

constexpr auto kRansacDraws = setting_rows(
    number_row<&DrawSettings::probability>(
        "probability", 0.5, 0.999999, "1", "ransac",
        "Probability that no plane of min_points or more is missed; more takes longer."),
    choice_row<&DrawSettings::sampling>(
        "sampling", "local|global", "ransac",
        "The three points of a draw: of one octree cell, or any of the cloud (slow, and for "
        "one facade only)."),
    bool_row<&DrawSettings::refit>(
        "refit", "ransac",
        "Settles each plane by least squares; off: it keeps the points of the best draw, as "
        "plain RANSAC does."),
    integer_row<&DrawSettings::draws>(
        "draws", 0, 1e9, "1", "ransac",
        "Draws for each plane; 0 = adaptive, as many as the probability needs."),
    choice_row<&DrawSettings::criterion>(
        "criterion", "cardinality|standard_deviation", "ransac",
        "The best plane: of most points, or of least standard deviation among those with "
        "nearly as many."),
    integer_row<&DrawSettings::max_planes>("max_planes", 0, 1e6, "1", "ransac",
                                           "Ends after this many planes were drawn; 0 = no limit."),
    integer_row<&DrawSettings::seed>(
        "seed", 0, 9e15, "1", "ransac",
        "Seed of the random draws: the same seed gives the same result."));

constexpr auto kRansacSurface = setting_rows(
    bool_row<&SurfaceSettings::connectivity>(
        "connectivity", "ransac",
        "A segment is one connected surface; off: all points near the plane, wherever they "
        "lie."),
    number_row<&SurfaceSettings::pixel_m>(
        "pixel_m", 0, 100, "m", "ransac",
        "Edge of a raster pixel for connectivity and area; 0 = twice the point spacing of the "
        "segment."),
    number_row<&SurfaceSettings::gap_m>(
        "gap_m", 0, 100, "m", "ransac",
        "Widest gap (a pipe, a pillar) inside one connected surface."),
    number_row<&SurfaceSettings::strip_width_m>(
        "strip_width_m", 0, 10, "m", "ransac",
        "Least full width of a part of a surface: narrower ones, such as the strip of a wall "
        "in the plane of a sill, are left to other planes; 0 = kept."),
    number_row<&SurfaceSettings::merge_gap_m>(
        "merge_gap_m", 0, 1e4, "m", "ransac",
        "Widest gap between coplanar segments joined at the end; more joins repeated panels "
        "and panes."),
    choice_row<&SurfaceSettings::normals>(
        "normals", "cells|field|none", "ransac",
        "Normals for the consistency test: local planes of octree cells, the field "
        "\"normal\", or no test."),
    number_row<&SurfaceSettings::normal_tolerance_rad>(
        "normal_tolerance_rad", 0.01, 1.570796, "rad", "ransac",
        "Largest angle between the normal of a point and that of its plane; 0.436 = 25 "
        "degrees."),
    number_row<&SurfaceSettings::least_radius_m>(
        "least_radius_m", 0, 1000, "m", "ransac",
        "Surfaces that bend more tightly than this radius (columns, pipes, balls) are no "
        "planes: their points stay noise; 0 = strips of them are taken as planes."),
    choice_row<&SurfaceSettings::primitives>(
        "primitives", "planes|planes+spheres|planes+cylinders|all", "ransac",
        "What is looked for: planes, or spheres and cylinders with them in one run, where the "
        "surface of most points wins; such a run takes up to twice the time."),
    number_row<&SurfaceSettings::min_radius_m>(
        "min_radius_m", 1e-4, 1000, "m", "ransac",
        "Smallest radius of a sphere or cylinder; below 2 tolerances a pipe cannot be told "
        "from a bar."),
    number_row<&SurfaceSettings::max_radius_m>(
        "max_radius_m", 0, 1e5, "m", "ransac",
        "Largest radius of a sphere or cylinder; 0 = the diagonal of the cloud's box."),
    bool_row<&SurfaceSettings::reassign>(
        "reassign", "ransac",
        "Shares the points out anew once all planes are known, and splits what falls apart "
        "then; off: each plane keeps what it took first."),
    bool_row<&SurfaceSettings::global_planarity>("global_planarity", "ransac",
                                                 kGlobalPlanarityHelp));

constexpr auto kRansacOrder = setting_rows(string_row<&DrawSettings::orientation_order>(
    "orientation_order", "ransac",
    "Orientation classes one after the other, as \"vertical horizontal inclined "
    "parallel\" (small planes first), and again while they yield planes; classes left out "
    "are not looked for. Empty = all together."));

constexpr auto kRansacFrame = setting_rows(
    number_row<&SurfaceSettings::orientation_tolerance_rad>(
        "orientation_tolerance_rad", 1e-4, 0.785398, "rad", "ransac",
        "Largest angle to the facade's axes for the orientation classes; 0.0175 = 1 degree."),
    bool_row<&SurfaceSettings::facade_frame>(
        "facade_frame", "ransac",
        "Turns the main facade parallel to OXZ in the facade frame; off: the frame is the "
        "identity."));

constexpr auto kRansacRows =
    setting_rows(nested_rows<&RansacSettings::surface, kRansacTolerance>(),
                 nested_rows<&RansacSettings::tolerance, kRansacToleranceFrom>(),
                 nested_rows<&RansacSettings::surface, kRansacLeast>(),
                 nested_rows<&RansacSettings::draw, kRansacDraws>(),
                 nested_rows<&RansacSettings::surface, kRansacSurface>(),
                 nested_rows<&RansacSettings::draw, kRansacOrder>(),
                 nested_rows<&RansacSettings::surface, kRansacFrame>());

}  // namespace

std::span<const ParamRow> ransac_rows() { return kRansacRows; }

}  // namespace jalon
