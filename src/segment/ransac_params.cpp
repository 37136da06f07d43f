// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/ransac_settings.h"
#include "segment/segmentation.h"

namespace jalon {

std::span<const ParamRow> ransac_rows() {
  // Origins: Boulaassal 2010, figs 3.10-3.11 (0.025 m), 3.4.3.2 (0.99), 3.4.5.2 (1 degree); Schnabel et al. 2007 (25
  // degrees between the normals of point and plane).
  static constexpr ParamRow kRows[] = {
      number_row("distance_tolerance_m", 0.025, 1e-5, 10, "m", "ransac",
                 "Largest distance of a point from its plane: a half-thickness, about 3 sigma of the scan."),
      choice_row("tolerance_from", "hand", "hand|sigma|estimate", "ransac",
                 "The tolerance: distance_tolerance_m; from sigma_m by chi-square; or the same with the sigma of the "
                 "cloud's own neighbourhoods."),
      number_row("sigma_m", 0.005, 1e-6, 10, "m", "ransac",
                 "Standard deviation of a point across its surface, for tolerance_from = sigma."),
      number_row("tolerance_probability", 0.99, 0.5, 0.999999, "1", "ransac",
                 "Share of a plane's points within the tolerance, for tolerance_from = sigma or estimate."),
      integer_row("tolerance_dof", 1, 1, 2, "1", "ransac",
                  "Degrees of freedom of that chi-square: 1 is right for distances to a plane (2.58 sigma at 0.99); 2 as "
                  "in Boulaassal 2010 (3.03 sigma)."),
      number_row("min_area_m2", 0.05, 0, 1e9, "m2", "ransac",
                 "Smallest area of a segment, counted in occupied raster pixels."),
      integer_row("min_points", 50, 3, 4e9, "points", "ransac", "Fewest points of a segment."),
      number_row("probability", 0.99, 0.5, 0.999999, "1", "ransac",
                 "Probability that no plane of min_points or more is missed; more takes longer."),
      choice_row("sampling", "local", "local|global", "ransac",
                 "The three points of a draw: of one octree cell, or any of the cloud (slow, and for one facade only)."),
      bool_row("refit", true, "ransac",
               "Settles each plane by least squares; off: it keeps the points of the best draw, as plain RANSAC does."),
      integer_row("draws", 0, 0, 1e9, "1", "ransac",
                  "Draws for each plane; 0 = adaptive, as many as the probability needs."),
      choice_row("criterion", "cardinality", "cardinality|standard_deviation", "ransac",
                 "The best plane: of most points, or of least standard deviation among those with nearly as many."),
      integer_row("max_planes", 0, 0, 1e6, "1", "ransac", "Ends after this many planes were drawn; 0 = no limit."),
      integer_row("seed", 1, 0, 9e15, "1", "ransac", "Seed of the random draws: the same seed gives the same result."),
      bool_row("connectivity", true, "ransac",
               "A segment is one connected surface; off: all points near the plane, wherever they lie."),
      number_row("pixel_m", 0, 0, 100, "m", "ransac",
                 "Edge of a raster pixel for connectivity and area; 0 = twice the point spacing of the segment."),
      number_row("gap_m", 0.5, 0, 100, "m", "ransac",
                 "Widest gap (a pipe, a pillar) inside one connected surface."),
      number_row("strip_width_m", 0, 0, 10, "m", "ransac",
                 "Least full width of a part of a surface: narrower ones, such as the strip of a wall in the plane of a sill, are "
                 "left to other planes; 0 = kept."),
      number_row("merge_gap_m", 0.5, 0, 1e4, "m", "ransac",
                 "Widest gap between coplanar segments joined at the end; more joins repeated panels and panes."),
      choice_row("normals", "cells", "cells|field|none", "ransac",
                 "Normals for the consistency test: local planes of octree cells, the field \"normal\", or no test."),
      number_row("normal_tolerance_rad", 0.436332, 0.01, 1.570796, "rad", "ransac",
                 "Largest angle between the normal of a point and that of its plane; 0.436 = 25 degrees."),
      number_row("least_radius_m", 1, 0, 1000, "m", "ransac",
                 "Surfaces that bend more tightly than this radius (columns, pipes, balls) are no planes: their points stay "
                 "noise; 0 = strips of them are taken as planes."),
      choice_row("primitives", "planes", "planes|planes+spheres|planes+cylinders|all", "ransac",
                 "What is looked for: planes, or spheres and cylinders with them in one run, where the surface of most "
                 "points wins; such a run takes up to twice the time."),
      number_row("min_radius_m", 0.03, 1e-4, 1000, "m", "ransac",
                 "Smallest radius of a sphere or cylinder; below 2 tolerances a pipe cannot be told from a bar."),
      number_row("max_radius_m", 5, 1e-4, 1000, "m", "ransac", "Largest radius of a sphere or cylinder."),
      bool_row("reassign", true, "ransac",
               "Shares the points out anew once all planes are known, and splits what falls apart then; off: each plane "
               "keeps what it took first."),
      string_row("orientation_order", "", "ransac",
                 "Orientation classes one after the other, as \"vertical horizontal inclined parallel\" (small planes "
                 "first), and again while they yield planes; classes left out are not looked for. Empty = all together."),
      number_row("orientation_tolerance_rad", 0.0174533, 1e-4, 0.785398, "rad", "ransac",
                 "Largest angle to the facade's axes for the orientation classes; 0.0175 = 1 degree."),
      bool_row("facade_frame", true, "ransac",
               "Turns the main facade parallel to OXZ in the facade frame; off: the frame is the identity."),
  };
  return kRows;
}

RansacSettings ransac_settings(const ParamSet& params) {
  RansacSettings s;
  const std::string& from = params.text("tolerance_from");
  s.tolerance_from = from == "sigma"      ? ToleranceSource::kSigma
                     : from == "estimate" ? ToleranceSource::kEstimate
                                          : ToleranceSource::kHand;
  s.sigma_m = params.number("sigma_m");
  s.tolerance_probability = params.number("tolerance_probability");
  s.tolerance_dof = static_cast<int>(params.integer("tolerance_dof"));
  s.local_sampling = params.text("sampling") == "local";
  s.refit = params.flag("refit");
  s.draws = static_cast<uint64_t>(params.integer("draws"));
  if (params.text("criterion") == "standard_deviation") s.criterion = Criterion::kStandardDeviation;
  s.strip_width_m = params.number("strip_width_m");
  s.least_radius_m = params.number("least_radius_m");
  const std::string& primitives = params.text("primitives");
  s.spheres = primitives == "planes+spheres" || primitives == "all";
  s.cylinders = primitives == "planes+cylinders" || primitives == "all";
  s.min_radius_m = params.number("min_radius_m");
  s.max_radius_m = params.number("max_radius_m");
  s.reassign = params.flag("reassign");
  s.order = orientation_order(params.text("orientation_order"));
  s.distance_tolerance_m = params.number("distance_tolerance_m");
  s.min_area_m2 = params.number("min_area_m2");
  s.min_points = static_cast<uint32_t>(params.integer("min_points"));
  s.probability = params.number("probability");
  s.max_planes = static_cast<uint32_t>(params.integer("max_planes"));
  s.seed = static_cast<uint64_t>(params.integer("seed"));
  s.connectivity = params.flag("connectivity");
  s.pixel_m = params.number("pixel_m");
  s.gap_m = params.number("gap_m");
  s.merge_gap_m = params.number("merge_gap_m");
  const std::string& normals = params.text("normals");
  s.normals = normals == "field" ? NormalSource::kField
              : normals == "none" ? NormalSource::kNone
                                  : NormalSource::kCells;
  s.normal_tolerance_rad = params.number("normal_tolerance_rad");
  s.orientation_tolerance_rad = params.number("orientation_tolerance_rad");
  s.facade_frame = params.flag("facade_frame");
  return s;
}

}  // namespace jalon
