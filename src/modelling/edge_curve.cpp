// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/edge_curve.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/setting_rows.h"
#include "base/table_columns.h"
#include "geometry/delaunay2.h"
#include "modelling/contour/long_edges.h"
#include "modelling/plane/plane_frame.h"
#include "modelling/plane/spacing.h"

namespace jalon {

namespace {

constexpr auto kEdgeCurveRows = setting_rows(number_row<&EdgeCurveSettings::threshold_m>(
    "threshold_m", 0, 1000, "m", "",
    "Edges longer than this end at contour points; 0 = at the knee of the sorted lengths, 2 to 5 "
    "spacings."));

std::vector<uint64_t> points_of(const Segmentation& segmentation, uint32_t label) {
  const auto labels = segmentation.labels->values<uint32_t>();
  std::vector<uint64_t> out;
  for (size_t i = 0; i < labels.size(); ++i)
    if (labels[i] == label) out.push_back(i);
  return out;
}

// Step 1. Whole metres near the points: a shift of the cloud by such changes no bit.
std::vector<Vec2> in_plane(const Segmentation& segmentation, const Segment& segment,
                           const std::vector<uint64_t>& indices) {
  const Vec3 first = segmentation.cloud->point(indices[0]);
  const auto& m = segmentation.T_facade_world.m;
  const PlaneFrame frame = plane_frame(
      segment.fit.plane, {std::floor(first.x), std::floor(first.y), std::floor(first.z)},
      {m[0], m[1], m[2]});
  std::vector<Vec2> out;
  out.reserve(indices.size());
  for (const uint64_t i : indices) out.push_back(frame.project(segmentation.cloud->point(i)));
  return out;
}

}  // namespace

std::span<const ParamRow> edge_curve_rows() { return kEdgeCurveRows; }

EdgeCurve find_edge_curve(const Segmentation& segmentation, uint32_t label,
                          const EdgeCurveSettings& settings, Task& task) {
  if (label == 0 || label > segmentation.segments.size())
    fail(Status::kNotFound, "no segment with label %u; there are %zu segments", label,
         segmentation.segments.size());
  const Segment& segment = segmentation.segments[label - 1];
  if (!segment.has_plane())
    fail(Status::kUnsupported, "segment %u is no plane: it has no contour by long edges", label);
  const std::vector<uint64_t> indices = points_of(segmentation, label);
  if (indices.size() < 3)
    fail(Status::kInsufficientData, "segment %u has %zu points; a triangulation needs 3", label,
         indices.size());
  // 1. Plane coordinates.  2. Triangles.
  const std::vector<Vec2> points = in_plane(segmentation, segment, indices);
  task.checkpoint(0.1);
  const auto triangles = delaunay(points, kDelaunayGrid_m, &task);
  if (triangles.empty())
    fail(Status::kDegenerate, "the points of segment %u lie on one line: no triangles", label);
  task.checkpoint(0.7);
  // 3. The curve.  4. Its threshold.
  EdgeCurve out;
  out.lengths_m = edge_lengths(points, triangles);
  out.spacing_m = typical_spacing(points, task);
  out.knee_m =
      out.spacing_m > 0 ? long_edge_threshold(out.lengths_m, out.spacing_m) : out.lengths_m.back();
  out.threshold_m = settings.threshold_m > 0 ? settings.threshold_m : out.knee_m;
  const auto beyond = std::upper_bound(out.lengths_m.begin(), out.lengths_m.end(), out.threshold_m);
  out.longer = static_cast<uint64_t>(out.lengths_m.end() - beyond);
  // 5. Contour points.
  for (const uint32_t i : long_edge_points(points, triangles, out.threshold_m))
    out.points.push_back(indices[i]);
  return out;
}

FieldTable edge_length_table(const EdgeCurve& curve) {
  FieldTable t;
  add_column<double>(t, curve.lengths_m, "length", "m",
                     "of an edge of the triangulation, ascending", [](double v) { return v; });
  return t;
}

FieldTable contour_point_table(const EdgeCurve& curve) {
  FieldTable t;
  add_column<uint64_t>(t, curve.points, "point", "", "end of a longer edge",
                       [](uint64_t v) { return v; });
  return t;
}

FieldTable edge_summary_table(const EdgeCurve& curve) {
  FieldTable t;
  add_value<double>(t, "spacing", "m", "of neighbouring points", curve.spacing_m);
  add_value<double>(t, "knee", "m", "where the curve turns", curve.knee_m);
  add_value<double>(t, "threshold", "m", "that was used", curve.threshold_m);
  add_value<uint64_t>(t, "edges", "", "of the triangulation", curve.lengths_m.size());
  add_value<uint64_t>(t, "longer", "", "beyond the threshold", curve.longer);
  add_value<uint64_t>(t, "points", "points", "of the contours", curve.points.size());
  return t;
}

}  // namespace jalon
