// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/elevation/elevation.h"

#include "geometry/polygon2.h"

namespace jalon {

namespace {

using Kind = DrawnFace::Kind;
using Role = DrawnFace::Role;

// Line widths (ISO 128-20 groups of 0.18, 0.25, 0.35, 0.5 mm): the nearer to the building's body the thicker.
constexpr double kOutline = 0.35, kEdge = 0.25, kDetail = 0.18, kGround = 0.5, kCross = 0.13;
constexpr const char* kSolid = "none";
constexpr const char* kDashed = "1.4 0.8";

std::string url_of(const ElevationDrawing& drawing, const char* name) {
  return std::string("url(#").append(name).append(drawing.content.id).append(")");
}

double width_of(Role role) {
  return role == Role::kWall ? kOutline : role == Role::kInside ? kDetail : kEdge;
}

std::string fill_of(const ElevationDrawing& drawing, const DrawnFace& face) {
  if (face.role == Role::kNoData) return url_of(drawing, "unknown");
  if (face.kind == Kind::kSlanted) return kSlantedFill;
  return group_colour(drawing.faces, face.group, drawing.content.colours);
}

void draw_face(SvgWriter& svg, const ElevationDrawing& drawing, const DrawnFace& face) {
  const OnPaper& on_paper = drawing.on_paper;
  const char* dashes = face.is_copy ? kDashed : kSolid;
  if (face.kind == Kind::kEdgeOn) {
    const bool is_ground = face.role == Role::kGround;
    svg_line(svg, on_paper(face.edge[0]), on_paper(face.edge[1]), is_ground ? kInk : kEdgeOn,
             is_ground ? kGround : kDetail);
    return;
  }
  const bool is_slanted = face.kind == Kind::kSlanted;
  const std::string fill = fill_of(drawing, face);
  svg.leaf("path", {{"class", "face"},
                    {"d", svg_path(face.rings, on_paper)},
                    {"fill", fill},
                    {"stroke", is_slanted || face.role == Role::kNoData ? kGrey : kInk},
                    {"stroke-width", is_slanted ? kDetail : width_of(face.role)},
                    {"stroke-dasharray", dashes}});
}

// End of a line from a corner of the box towards its middle that lies on the contour: arched heads have no corners.
Vec2 on_contour(const DrawnOpening& opening, const Vec2& corner) {
  constexpr int kSteps = 64;
  const Vec2 middle = (opening.low + opening.high) * 0.5;
  for (int i = 0; i < kSteps; ++i) {
    const Vec2 p = corner + (middle - corner) * (static_cast<double>(i) / kSteps);
    for (const DrawnRing& ring : opening.contour)
      if (contains(ring.polygon, p)) return p;
  }
  return middle;
}

// The crossed diagonals of building drawings: an open hole.
void draw_cross(SvgWriter& svg, const OnPaper& on_paper, const DrawnOpening& opening) {
  const Vec2 &a = opening.low, &b = opening.high;
  const Vec2 corners[2][2] = {{a, b}, {{a.u, b.v}, {b.u, a.v}}};
  for (const auto& [from, to] : corners)
    svg_line(svg, on_paper(on_contour(opening, from)), on_paper(on_contour(opening, to)), kGrey,
             kCross);
}

// Under all faces: what shows where nothing lies behind a hole.
void draw_holes(SvgWriter& svg, const ElevationDrawing& drawing) {
  for (const DrawnRing& ring : drawing.faces.unknown)
    svg.leaf("path",
             {{"d", svg_path(ring, drawing.on_paper)}, {"fill", url_of(drawing, "unknown")}});
  for (const DrawnOpening& opening : drawing.faces.openings)
    if (opening.is_empty) draw_cross(svg, drawing.on_paper, opening);
}

void draw_contour(SvgWriter& svg, const ElevationDrawing& drawing, const DrawnOpening& opening) {
  const OpeningRow& row = drawing.faces.list.rows[opening.row];
  const std::string d = svg_path(opening.contour, drawing.on_paper);
  if (row.is_copy())  // between the dashes shows paper, not the wall's own line
    svg.leaf("path",
             {{"d", d}, {"fill", "none"}, {"stroke", "#ffffff"}, {"stroke-width", kOutline + 0.1}});
  svg.leaf("path", {{"class", "opening"},
                    {"data-class", row.part_class},
                    {"d", d},
                    {"fill", "none"},
                    {"stroke", opening_colour(row.part_class)},
                    {"stroke-width", kOutline},
                    {"stroke-dasharray", row.is_copy() ? kDashed : kSolid}});
}

}  // namespace

void draw_body(SvgWriter& svg, const ElevationDrawing& drawing) {
  svg.open("g", {{"clip-path", url_of(drawing, "window")},
                 {"stroke-linejoin", "round"},
                 {"fill-rule", "evenodd"}});
  draw_holes(svg, drawing);
  auto opening = drawing.faces.openings.begin();
  const auto end = drawing.faces.openings.end();
  for (const DrawnFace& face : drawing.faces.faces) {
    for (; opening != end && opening->depth_m > face.depth_m; ++opening)
      draw_contour(svg, drawing, *opening);
    draw_face(svg, drawing, face);
  }
  for (; opening != end; ++opening) draw_contour(svg, drawing, *opening);
  svg.close();
}

}  // namespace jalon
