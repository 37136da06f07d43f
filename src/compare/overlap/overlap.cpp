// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/overlap/overlap.h"

#include <algorithm>
#include <cmath>

#include "base/table_columns.h"
#include "compare/overlap/apart_cause.h"

namespace jalon {

namespace {

constexpr double kFinestEdge = 0.01, kCoarsestEdge = 0.125;  // of the smaller diagonal
constexpr double kPointsACell = 4;  // in the mean, so that few cells of a surface are left out
// Below, both are seen as apart: strips that are to be compared share a tenth and more.
constexpr double kLeastShare = 0.05;

double edge_for(const std::vector<Vec3>& a, const std::vector<Vec3>& b, double diagonal) {
  if (!(diagonal > 0)) return 1;  // single points
  double edge = kFinestEdge * diagonal;
  const auto is_filled = [&](const std::vector<Vec3>& points) {
    return static_cast<double>(points.size()) >=
           kPointsACell * static_cast<double>(OccupiedCells(points, edge).size());
  };
  while (edge < kCoarsestEdge * diagonal && !(is_filled(a) && is_filled(b))) edge *= 2;
  return edge;
}

double gap_between(const Box3& a, const Box3& b) {
  Vec3 gap;
  gap.x = std::max({0.0, a.min.x - b.max.x, b.min.x - a.max.x});
  gap.y = std::max({0.0, a.min.y - b.max.y, b.min.y - a.max.y});
  gap.z = std::max({0.0, a.min.z - b.max.z, b.min.z - a.max.z});
  return norm(gap);
}

}  // namespace

CloudsOverlap clouds_overlap(const Cloud& reference, const Cloud& compared, Task& task) {
  CloudsOverlap out;
  if (reference.size() == 0 || compared.size() == 0) return out;
  const ApartSides sides{bounds(reference, task), bounds(compared, task), sampled_points(reference),
                         sampled_points(compared)};
  const double diagonal = std::min(norm(sides.reference.max - sides.reference.min),
                                   norm(sides.compared.max - sides.compared.min));
  const double edge = edge_for(sides.reference_points, sides.compared_points, diagonal);
  const OccupiedCells a(sides.reference_points, edge), b(sides.compared_points, edge);
  out.reference_share = a.share_in(b);
  out.compared_share = b.share_in(a);
  out.gap_m = gap_between(sides.reference, sides.compared);
  out.is_apart = std::max(out.reference_share, out.compared_share) < kLeastShare;
  find_cause(sides, task, out);
  return out;
}

FieldTable overlap_table(const CloudsOverlap& overlap) {
  FieldTable table;
  add_value<double>(table, "reference_share", "1", "of its space, shared", overlap.reference_share);
  add_value<double>(table, "compared_share", "1", "of its space, shared", overlap.compared_share);
  add_value<double>(table, "gap", "m", "between the boxes", overlap.gap_m);
  add_value<uint8_t>(table, "apart", "", "1: they hardly share a place", overlap.is_apart ? 1 : 0);
  add_value<uint8_t>(table, "cause", "", "likely cause of that",
                     static_cast<uint8_t>(overlap.cause));
  const CloudsOverlap* row[] = {&overlap};
  add_columns<int8_t, 3>(
      table, row, "axes", "", "of the compared cloud that are x, y, z",
      [](const CloudsOverlap* o, int8_t* out) { std::copy(o->axes.begin(), o->axes.end(), out); });
  add_value<double>(table, "factor", "1", "of the compared cloud's coordinates", overlap.factor);
  add_columns<double, 3>(table, row, "shift", "m", "of the compared cloud onto the reference",
                         [](const CloudsOverlap* o, double* out) {
                           for (int k = 0; k < 3; ++k) out[k] = o->shift[k];
                         });
  return table;
}

}  // namespace jalon
