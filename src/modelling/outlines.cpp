// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/outlines.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.h"
#include "base/parallel.h"
#include "geometry/polygon2.h"
#include "modelling/contour.h"
#include "modelling/nesting.h"
#include "modelling/plane_frame.h"
#include "modelling/straighten.h"

namespace jalon {

namespace {

constexpr ParamRow kRows[] = {
    number_row("max_edge_m", 0, 0, 1000, "m", "outlines",
               "Longest edge (a length) of a triangle that counts as surface; gaps wider than this are outside. "
               "0 = edge_factor x "
               "spacing of the segment's points"),
    number_row("edge_factor", 4, 1.5, 100, "1", "outlines", "Longest edge in spacings, when max_edge_m is 0"),
    number_row("min_area_m2", 0.1, 0, 1e9, "m2", "outlines", "Smallest area of a connected face"),
    number_row("min_opening_area_m2", 0.1, 0, 1e9, "m2", "outlines", "Smallest area of an opening"),
    number_row("min_opening_width_m", 0.2, 0, 1e6, "m", "outlines", "Smallest width (full, not half) of an opening"),
    bool_row("straighten", true, "outlines", "Straight edges and corners; false = the contour points as they are"),
    number_row("tolerance_m", 0, 0, 1000, "m", "outlines",
               "Half-width of the strip that counts as one straight edge; 0 = half the longest triangle edge"),
    number_row("snap_angle_rad", 0.05, 0, 0.26, "rad", "outlines",
               "Edges this near to horizontal or vertical are made exactly so; 0 = never"),
    bool_row("rectangles", true, "outlines", "Openings that fill an upright rectangle become one"),
};

// Points of a straight border end, on average, this share of the spacing inside it: 0.5 on a regular grid
// (facade-modelling A3, failure 2), 0.2 measured on points scattered at random, whose contour follows the outermost.
constexpr double kSetBack = 0.35;
// Strip of a straight edge in triangle edges: cut corners are at most half an edge deep.
constexpr double kToleranceOfEdge = 0.5;

struct Setting {
  ContourSetting contour;
  StraightenSetting straight;
  bool straighten = true;
};

Setting read_setting(const ParamSet& params) {
  Setting s;
  s.contour.max_edge_m = params.number("max_edge_m");
  s.contour.edge_factor = params.number("edge_factor");
  s.contour.min_area_m2 = params.number("min_area_m2");
  s.contour.min_opening_area_m2 = params.number("min_opening_area_m2");
  s.contour.min_opening_width_m = params.number("min_opening_width_m");
  s.straighten = params.flag("straighten");
  s.straight.tolerance_m = params.number("tolerance_m");
  s.straight.snap_angle_rad = params.number("snap_angle_rad");
  s.straight.rectangles = params.flag("rectangles");
  return s;
}

// Point indices by label (counting sort): segment s holds order[first[s] ... first[s + 1]).
struct ByLabel {
  std::vector<uint32_t> first, order;
};

ByLabel sort_by_label(const Segmentation& segmentation, Task& task) {
  constexpr size_t kBlock = size_t{1} << 20;
  const auto labels = segmentation.labels->values<uint32_t>();
  const size_t segments = segmentation.segments.size();
  ByLabel out;
  out.first.assign(segments + 2, 0);
  for (size_t i = 0; i < labels.size(); ++i) {
    if (i % kBlock == 0) task.checkpoint(0);
    if (labels[i] > segments)
      fail(Status::kInternal, "point %zu has the label %u of %zu segments", i, labels[i], segments);
    if (labels[i] != 0) ++out.first[labels[i] + 1];
  }
  for (size_t s = 1; s < out.first.size(); ++s) out.first[s] += out.first[s - 1];
  out.order.resize(out.first.back());
  std::vector<uint32_t> next(out.first.begin(), out.first.end() - 1);
  for (size_t i = 0; i < labels.size(); ++i) {
    if (i % kBlock == 0) task.checkpoint(0);
    if (labels[i] != 0) out.order[next[labels[i]]++] = static_cast<uint32_t>(i);
  }
  out.first.erase(out.first.begin());  // label s is segment s - 1
  return out;
}

// Corner of the segment's box, in whole metres: moves with the cloud without rounding.
Vec3 whole_metre_corner(const Cloud& cloud, std::span<const uint32_t> indices) {
  Box3 box;
  for (const uint32_t i : indices) box.add(cloud.point(i));
  return {std::floor(box.min.x), std::floor(box.min.y), std::floor(box.min.z)};
}

Polygons straight_polygons(const ContourPiece& piece, const Contour& contour, const Setting& setting) {
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

// One face a connected piece of the segment.
struct Outlined {
  PlaneFrame frame;
  std::vector<Polygons> faces;
};

Outlined outline_segment(const Cloud& cloud, const Segment& segment, std::span<const uint32_t> indices,
                         const Vec3& facade_x, const Setting& setting, Task& task) {
  Outlined out;
  if (indices.size() < 3) return out;
  out.frame = plane_frame(segment.fit.plane, whole_metre_corner(cloud, indices), facade_x);
  std::vector<Vec2> points(indices.size());
  for (size_t i = 0; i < indices.size(); ++i) points[i] = out.frame.project(cloud.point(indices[i]));
  const Contour contour = extract_contour(points, setting.contour, task);
  for (const ContourPiece& piece : contour.pieces) {
    task.checkpoint(0);
    out.faces.push_back(setting.straighten ? straight_polygons(piece, contour, setting) : raw_polygons(piece));
  }
  return out;
}

const char* part_class_of(Orientation orientation) {
  switch (orientation) {
    case Orientation::kParallel: return "wall";
    case Orientation::kVertical: return "vertical";
    case Orientation::kHorizontal: return "horizontal";
    case Orientation::kInclined: return "inclined";
    case Orientation::kNone: break;
  }
  return "plane";
}

void add_faces(Model& model, const Segment& segment, const Outlined& outlined) {
  const auto part = static_cast<uint32_t>(model.parts.size());
  model.parts.push_back({"plane " + std::to_string(segment.label), part_class_of(segment.orientation), 0});
  for (const Polygons& polygons : outlined.faces) {
    Face face;
    face.part = part;
    face.id = segment.label;
    face.face_class = static_cast<uint8_t>(segment.orientation);
    face.plane = segment.fit.plane;
    face.sigma_m = segment.fit.sigma;
    face.covariance = segment.fit.covariance;
    std::vector<std::vector<Vec3>> rings;
    for (const Polygon& polygon : polygons) {
      face.area_m2 += signed_area(polygon);  // openings run clockwise: they are taken off
      auto& ring = rings.emplace_back();
      for (const Vec2& p : polygon) ring.push_back(outlined.frame.lift(p));
    }
    model.add_face(face, rings);
  }
}

}  // namespace

std::span<const ParamRow> outlines_rows() { return kRows; }

Model model_outlines(const Segmentation& segmentation, const ParamSet& params, Task& task) {
  const Setting setting = read_setting(params);
  Model model;
  if (plane_count(segmentation.segments) == 0) return model;
  const Cloud& cloud = *segmentation.cloud;
  model.crs = cloud.crs;
  const auto& m = segmentation.T_facade_world.m;
  const Vec3 facade_x{m[0], m[1], m[2]};
  ByLabel by_label;
  {
    const Span span(task, 0, 0.05, "sorting points by plane");
    by_label = sort_by_label(segmentation, task);
  }
  std::vector<Outlined> outlined(segmentation.segments.size());
  {
    const Span span(task, 0.05, 1, "drawing outlines");
    parallel_for(task, outlined.size(), 1, [&](size_t begin, size_t end) {
      for (size_t s = begin; s < end; ++s) {
        if (!segmentation.segments[s].has_plane()) continue;
        const std::span<const uint32_t> indices(by_label.order.data() + by_label.first[s],
                                                by_label.first[s + 1] - by_label.first[s]);
        outlined[s] = outline_segment(cloud, segmentation.segments[s], indices, facade_x, setting, task);
      }
    });
  }
  model.parts.push_back({"facade", "facade", kNoParent});
  for (size_t s = 0; s < outlined.size(); ++s)
    if (segmentation.segments[s].has_plane()) add_faces(model, segmentation.segments[s], outlined[s]);
  return model;
}

}  // namespace jalon
