// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/field.h"
#include "base/params.h"
#include "base/task.h"
#include "segment/segmentation.h"

namespace jalon {

/// The parameters of operation "long_edges".
struct EdgeCurveSettings {
  double threshold_m = 0;  ///< 0 = at the knee of the curve
};
std::span<const ParamRow> edge_curve_rows();

/// Contour points of a segment by the rule of Boulaassal 2010, 4.2.3, to the letter.
struct EdgeCurve {
  std::vector<double> lengths_m;  ///< of all edges of the triangulation, ascending
  std::vector<uint64_t> points;   ///< of the cloud: end points of longer edges, ascending
  double spacing_m = 0, knee_m = 0, threshold_m = 0;
  uint64_t longer = 0;  ///< edges beyond the threshold
};

/// 1. The points in their plane (4.2.1). 2. Their Delaunay triangulation, all of it (4.2.2). 3. Lengths of its edges,
/// sorted. 4. The threshold where that curve turns. 5. End points of longer edges: outer and inner contours together.
///
/// Throws kNotFound for an unknown label, kInsufficientData for fewer than 3 points, kDegenerate for points without
/// triangles, kUnsupported for a segment that is no plane. O(n log n).
EdgeCurve find_edge_curve(const Segmentation& segmentation, uint32_t label,
                          const EdgeCurveSettings& settings, Task& task);

/// The tables of jalon/modeller.h.
FieldTable edge_length_table(const EdgeCurve& curve);
FieldTable contour_point_table(const EdgeCurve& curve);
FieldTable edge_summary_table(const EdgeCurve& curve);

}  // namespace jalon
