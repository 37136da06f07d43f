// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/vectorise.h"

#include <cmath>

#include "base/error.h"
#include "base/parallel.h"
#include "modelling/contour.h"
#include "modelling/nesting.h"
#include "segment/label_groups.h"

namespace jalon {

namespace {

// Points of straight border end, on average, this share of the spacing inside it: 0.5 on a regular grid
// (facade-modelling A3, failure 2), 0.2 measured on points scattered at random, whose contour follows the outermost.
constexpr double kSetBack = 0.35;
// Strip of a straight edge in triangle edges: cut corners are at most half an edge deep.
constexpr double kToleranceOfEdge = 0.6;

// Corner of the segment's box, in whole metres: moves with the cloud without rounding.
Vec3 whole_metre_corner(const Cloud& cloud, std::span<const uint32_t> indices) {
  Box3 box;
  for (const uint32_t i : indices) box.add(cloud.point(i));
  return {std::floor(box.min.x), std::floor(box.min.y), std::floor(box.min.z)};
}

Polygons straight_polygons(const ContourPiece& piece, const Contour& contour, const VectoriseSetting& setting) {
  StraightenSetting s = setting.straight;
  s.max_edge_m = contour.max_edge_m;
  if (s.tolerance_m == 0) s.tolerance_m = kToleranceOfEdge * contour.max_edge_m;
  s.set_back_m = kSetBack * contour.spacing_m;
  std::vector<RingForms> rings;
  for (size_t k = 0; k <= piece.openings.size(); ++k) {
    const Chain& chain = k == 0 ? piece.outline : piece.openings[k - 1];
    RingForms forms;
    if (k > 0 && s.rectangles) forms.add(fitted_rectangle(chain, s));
    forms.add(straightened(chain, s));
    forms.add(thinned(chain, s.tolerance_m));
    forms.add(chain);
    rings.push_back(std::move(forms));
  }
  return nested(rings);
}

Polygons raw_polygons(const ContourPiece& piece) {
  Polygons out{piece.outline};
  out.insert(out.end(), piece.openings.begin(), piece.openings.end());
  return out;
}

VectorRing ring_of(Polygon polygon, const Chain& contour) {
  VectorRing ring{std::move(polygon), {}, contour};
  const size_t n = ring.corners.size();
  ring.edges.resize(n);
  for (size_t i = 0; i < n; ++i) {
    const Vec2 edge = ring.corners[(i + 1) % n] - ring.corners[i];
    if (edge.u == 0)
      ring.edges[i].direction = EdgeDirection::kVertical;
    else if (edge.v == 0)
      ring.edges[i].direction = EdgeDirection::kHorizontal;
  }
  return ring;
}

VectorPlane vectorise_segment(const Cloud& cloud, const Segment& segment, std::span<const uint32_t> indices,
                              const Vec3& facade_x, const VectoriseSetting& setting, Task& task) {
  VectorPlane out;
  out.label = segment.label;
  if (!segment.has_plane() || indices.size() < 3) return out;
  // 1. Frame and plane coordinates (A1).
  out.frame = plane_frame(segment.fit.plane, whole_metre_corner(cloud, indices), facade_x);
  std::vector<Vec2> points(indices.size());
  for (size_t i = 0; i < indices.size(); ++i) points[i] = out.frame.project(cloud.point(indices[i]));
  // 2. Contours (A2-A3).
  const Contour contour = extract_contour(points, setting.contour, task);
  out.spacing_m = contour.spacing_m;
  out.max_edge_m = contour.max_edge_m;
  // 3. Polygons (A5-A12).
  for (const ContourPiece& piece : contour.pieces) {
    task.checkpoint(0);
    Polygons polygons = setting.straighten ? straight_polygons(piece, contour, setting) : raw_polygons(piece);
    VectorFace face{ring_of(std::move(polygons[0]), piece.outline), {}};
    for (size_t k = 1; k < polygons.size(); ++k)
      face.openings.push_back(ring_of(std::move(polygons[k]), piece.openings[k - 1]));
    out.faces.push_back(std::move(face));
  }
  return out;
}

void check_labels(const Segmentation& segmentation) {
  const auto labels = segmentation.labels->values<uint32_t>();
  const size_t segments = segmentation.segments.size();
  for (size_t i = 0; i < labels.size(); ++i)
    if (labels[i] > segments)
      fail(Status::kInternal, "point %zu has the label %u of %zu segments", i, labels[i], segments);
}

}  // namespace

std::vector<VectorPlane> vectorise(const Segmentation& segmentation, const VectoriseSetting& setting, Task& task) {
  const size_t count = segmentation.segments.size();
  std::vector<VectorPlane> out(count);
  if (plane_count(segmentation.segments) == 0) return out;
  check_labels(segmentation);
  const auto& m = segmentation.T_facade_world.m;
  const Vec3 facade_x{m[0], m[1], m[2]};
  const LabelGroups groups = [&] {
    const Span span(task, 0, 0.05, "sorting points by plane");
    return LabelGroups(segmentation.labels->values<uint32_t>(), count, task);
  }();
  const Span span(task, 0.05, 1, "drawing outlines");
  parallel_for(task, count, 1, [&](size_t begin, size_t end) {
    for (size_t s = begin; s < end; ++s)
      out[s] = vectorise_segment(*segmentation.cloud, segmentation.segments[s],
                                 groups.of(static_cast<uint32_t>(s + 1)), facade_x, setting, task);
  });
  return out;
}

}  // namespace jalon
