// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/edges/join/vectorise.h"

#include <cmath>

#include "base/error.h"
#include "base/parallel.h"
#include "base/text_number.h"
#include "modelling/contour/contour.h"
#include "modelling/edges/find/crossing_lines.h"
#include "modelling/edges/find/edge_shape.h"
#include "modelling/edges/join/measured_rings.h"
#include "modelling/edges/join/nesting.h"
#include "modelling/plane/crossing_points.h"
#include "modelling/plane/segment_frame.h"
#include "segment/labels/label_groups.h"

namespace jalon {

namespace {

// Strip of a straight edge in triangle edges: cut corners are at most half an edge deep.
constexpr double kToleranceOfEdge = 0.6;
constexpr double kVectoriseChordError = 0.05;  // spacings: chords for arcs in the tests of nesting
constexpr size_t kPointsProjected = 1 << 15;   // at once
constexpr double kCrossingReach = 3;           // spacings: about 28 points of each of two planes
constexpr double kParallel = 0.9;              // cosine: 26 degrees

VectorRing ring_of(Polygon polygon, const Chain& contour) {
  VectorRing ring{std::move(polygon), {}, contour};
  const size_t n = ring.corners.size();
  ring.edges.resize(n);
  for (size_t i = 0; i < n; ++i) {
    const Vec2 edge = ring.corners[(i + 1) % n] - ring.corners[i];
    if (edge.u == 0) ring.edges[i].direction = EdgeDirection::kVertical;
    else if (edge.v == 0) ring.edges[i].direction = EdgeDirection::kHorizontal;
  }
  return ring;
}

// The forms a ring may take, so that it fits beside the others: as measured, or a polygon, at worst its contour.
RingForms forms_of(VectorRing measured, const Chain& chain, bool is_opening, const Contour& contour,
                   const VectoriseSetting& setting) {
  StraightenSetting s;
  s.max_edge_m = contour.max_edge_m;
  s.tolerance_m =
      setting.tolerance_m != 0 ? setting.tolerance_m : kToleranceOfEdge * contour.max_edge_m;
  s.snap_angle_rad = setting.snap_angle_rad;
  s.set_back_m = kSetBack * contour.spacing_m;
  const double chord_error = kVectoriseChordError * contour.spacing_m;
  RingForms forms;
  const auto add = [&](Polygon polygon) {
    if (polygon.size() >= 3) forms.add(ring_of(std::move(polygon), chain), chord_error);
  };
  forms.add(std::move(measured), chord_error);
  if (is_opening && setting.rectangles) add(fitted_rectangle(chain, s));
  add(straightened(chain, s));
  add(thinned(chain, s.tolerance_m));
  add(chain);
  return forms;
}

VectorFace face_of(const ContourPiece& piece, std::span<VectorRing> measured,
                   const Contour& contour, const VectoriseSetting& setting) {
  std::vector<RingForms> rings;
  rings.push_back(forms_of(std::move(measured[0]), piece.outline, false, contour, setting));
  for (size_t k = 0; k < piece.openings.size(); ++k)
    rings.push_back(
        forms_of(std::move(measured[k + 1]), piece.openings[k], true, contour, setting));
  const auto chosen = nested(rings);
  VectorFace face{std::move(rings[0].rings[chosen[0]]), {}};
  for (size_t k = 1; k < rings.size(); ++k)
    face.openings.push_back(std::move(rings[k].rings[chosen[k]]));
  return face;
}

VectorFace raw_face(const ContourPiece& piece) {
  VectorFace face{ring_of(piece.outline, piece.outline), {}};
  for (const Chain& opening : piece.openings) face.openings.push_back(ring_of(opening, opening));
  return face;
}

// 1 for segments whose plane is parallel to that of segment s.
std::vector<uint8_t> parallel_planes(const Segmentation& segmentation, size_t s) {
  const Vec3& normal = segmentation.segments[s].fit.plane.normal;
  std::vector<uint8_t> out;
  for (const Segment& other : segmentation.segments)
    out.push_back(other.has_plane() && std::fabs(dot(other.fit.plane.normal, normal)) > kParallel);
  out[s] = 0;
  return out;
}

// A cloud and the tools that its segments share.
struct Vectoriser {
  const Segmentation& segmentation;
  const VectoriseSetting& setting;
  const ContourMaker& make_contour;
  std::shared_ptr<const Octree> tree;
  const LabelGroups& groups;
  std::vector<Box3> boxes;  ///< of the points of each segment

  VectorPlane operator()(size_t s, Task& task) const;
};

VectorPlane Vectoriser::operator()(size_t s, Task& task) const {
  const auto indices = groups.of(static_cast<uint32_t>(s + 1));
  const Cloud& cloud = *segmentation.cloud;
  const Segment& segment = segmentation.segments[s];
  VectorPlane out;
  out.label = segment.label;
  if (!segment.has_plane() || indices.size() < 3) return out;
  // 1. Frame and plane coordinates (Boulaassal 2010, 4.2.1).
  out.frame = segment_frame(segmentation, segment, indices);
  std::vector<Vec2> points(indices.size());
  parallel_for(task, indices.size(), kPointsProjected, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) points[i] = out.frame.project(cloud.point(indices[i]));
  });
  // 2. Contours (4.2.2, 4.2.3).
  ForeignTest foreign;
  if (setting.straighten)
    foreign = [&, crossing = CrossingPoints(segmentation, *tree, s, boxes)](uint32_t i,
                                                                            double spacing_m) {
      return crossing.holds(indices[i], kCrossingReach * spacing_m);
    };
  const Contour contour = make_contour ? make_contour(s, points, setting.contour, foreign, task)
                                       : extract_contour(points, setting.contour, task, foreign);
  out.spacing_m = contour.spacing_m;
  out.max_edge_m = contour.max_edge_m;
  if (contour.pieces.empty()) return out;
  if (!setting.straighten) {
    for (const ContourPiece& piece : contour.pieces) out.faces.push_back(raw_face(piece));
    return out;
  }
  // 3. Edges and nodes where they are measured (4.3.1 to 4.3.3).
  const auto near = [&](std::span<const std::vector<Vec2>> rings, const NearSetting& about) {
    return points_near(segmentation, *tree, out.frame, rings, parallel_planes(segmentation, s),
                       about, task);
  };
  const auto joints = [&] {
    return crossing_lines(segmentation, groups, s, out.frame, kCrossingReach * contour.spacing_m);
  };
  auto rings = measured_rings({contour, segment.fit.sigma, near, joints}, setting, task);
  // 4. Polygons with holes (4.3.3).
  size_t first = 0;
  for (const ContourPiece& piece : contour.pieces) {
    task.checkpoint(0);
    const size_t count = piece.openings.size() + 1;
    out.faces.push_back(face_of(piece, std::span(rings).subspan(first, count), contour, setting));
    first += count;
  }
  return out;
}

std::vector<Box3> boxes_of(const Cloud& cloud, const LabelGroups& groups, Task& task) {
  constexpr size_t kPointsPerChunk = 1 << 15;
  std::vector<Box3> boxes(groups.count());
  groups.for_each(task, [&](uint32_t label) {
    const auto indices = groups.of(label);
    boxes[label - 1] = parallel_reduce(task, indices.size(), kPointsPerChunk, Box3{},
                                       [&](size_t begin, size_t end) {
                                         Box3 part;
                                         for (size_t i = begin; i < end; ++i)
                                           part.add(cloud.point(indices[i]));
                                         return part;
                                       });
  });
  return boxes;
}

void check_labels(const Segmentation& segmentation) {
  const auto labels = segmentation.labels->values<uint32_t>();
  const size_t segments = segmentation.segments.size();
  for (size_t i = 0; i < labels.size(); ++i)
    if (labels[i] > segments)
      fail(Status::kInternal, "point %zu has the label %u of %zu segments", i, labels[i], segments);
}

}  // namespace

std::vector<VectorPlane> vectorise(const Segmentation& segmentation,
                                   const VectoriseSetting& setting, Task& task,
                                   const ContourMaker& make_contour) {
  const size_t count = segmentation.segments.size();
  std::vector<VectorPlane> out(count);
  if (plane_count(segmentation.segments) == 0) return out;
  check_labels(segmentation);
  const LabelGroups groups = [&] {
    const ProgressSpan span(task, 0, 0.05, "sorting points by plane");
    return LabelGroups(segmentation.labels->values<uint32_t>(), count, task);
  }();
  Vectoriser vectoriser{segmentation, setting, make_contour, nullptr, groups, {}};
  if (setting.straighten) {
    const ProgressSpan span(task, 0.05, 0.1, "indexing points");
    vectoriser.tree = segmentation.cloud->octree(task);
    vectoriser.boxes = boxes_of(*segmentation.cloud, groups, task);
  }
  const ProgressSpan span(task, 0.1, 1, "drawing outlines");
  parallel_for(task, count, 1, [&](size_t begin, size_t end) {
    for (size_t s = begin; s < end; ++s) out[s] = vectoriser(s, task);
  });
  for (const VectorPlane& plane : out)
    if (!plane.faces.empty())
      task.log(Task::kDebug, "plane %u: points %s m apart, gaps up to %s m are surface",
               plane.label, text_of(plane.spacing_m).c_str(), text_of(plane.max_edge_m).c_str());
  return out;
}

}  // namespace jalon
