// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/growing/settings.h"
#include "segment/segmentation.h"

namespace jalon {

std::span<const ParamRow> region_growing_rows() {
  // Origins: those that "ransac" has too as there; k as for normals; 20 degrees between the normals of point and plane
  // as in CGAL's region growing (Lafarge & Mallet 2012 use 25).
  static constexpr ParamRow kRows[] = {
      number_row("distance_tolerance_m", 0.025, 1e-5, 10, "m", "region_growing",
                 "Largest distance of a point from the running plane: a half-thickness, about 3 sigma of the scan."),
      number_row("min_area_m2", 0.05, 0, 1e9, "m2", "region_growing",
                 "Smallest area of a segment, counted in occupied raster pixels."),
      integer_row("min_points", 50, 3, 4e9, "points", "region_growing", "Fewest points of a segment."),
      choice_row("normals", "neighbours", "neighbours|field", "region_growing",
                 "Normals of the points: from the planes through their k neighbours, or the field \"normal\"."),
      integer_row("k", 16, 4, 256, "points", "region_growing",
                  "Number of nearest neighbours that give a normal, the point itself included."),
      number_row("normal_tolerance_rad", 0.349066, 0.01, 1.570796, "rad", "region_growing",
                 "Largest angle between the normal of a point and that of the running plane; 0.349 = 20 degrees."),
      number_row("gap_m", 0, 0, 100, "m", "region_growing",
                 "How far from a region its next points are looked for; 0 = twice the local point spacing."),
      number_row("pixel_m", 0, 0, 100, "m", "region_growing",
                 "Edge of a raster pixel for area and re-assignment; 0 = twice the point spacing of the segment."),
      number_row("merge_gap_m", 0.5, 0, 1e4, "m", "region_growing",
                 "Widest gap between coplanar regions joined at the end; more joins repeated panels and panes; 0 = none."),
      number_row("orientation_tolerance_rad", 0.0174533, 1e-4, 0.785398, "rad", "region_growing",
                 "Largest angle to the facade's axes for the orientation classes; 0.0175 = 1 degree."),
      bool_row("facade_frame", true, "region_growing",
               "Turns the main facade parallel to OXZ in the facade frame; off: the frame is the identity."),
  };
  return kRows;
}

GrowingSettings growing_settings(const ParamSet& params) {
  GrowingSettings s;
  s.planes.distance_tolerance_m = params.number("distance_tolerance_m");
  s.planes.min_area_m2 = params.number("min_area_m2");
  s.planes.min_points = static_cast<uint32_t>(params.integer("min_points"));
  s.planes.normal_tolerance_rad = params.number("normal_tolerance_rad");
  s.planes.pixel_m = params.number("pixel_m");
  s.planes.merge_gap_m = params.number("merge_gap_m");
  s.planes.orientation_tolerance_rad = params.number("orientation_tolerance_rad");
  s.planes.facade_frame = params.flag("facade_frame");
  s.k = static_cast<uint32_t>(params.integer("k"));
  s.gap_m = params.number("gap_m");
  s.field_normals = params.text("normals") == "field";
  s.planes.normals = s.field_normals ? NormalSource::kField : NormalSource::kCells;
  return s;
}

}  // namespace jalon
