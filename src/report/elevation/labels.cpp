// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "geometry/polygon2.h"
#include "report/elevation/elevation.h"

namespace jalon {

namespace {

constexpr double kLabelsText = 2.5, kSmallText = 1.8;

bool overlap(const Box_mm& a, const Box_mm& b) {
  return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

/// Boxes of the labels that stand already.
class Taken {
 public:
  bool take(const Box_mm& box) {
    if (std::any_of(boxes_.begin(), boxes_.end(), [&](const Box_mm& b) { return overlap(box, b); }))
      return false;
    boxes_.push_back(box);
    return true;
  }

 private:
  std::vector<Box_mm> boxes_;
};

bool is_inside(const DrawnFace& face, const Vec2& p) {
  if (!contains(face.rings.front().polygon, p)) return false;
  return std::none_of(face.rings.begin() + 1, face.rings.end(),
                      [&](const DrawnRing& ring) { return contains(ring.polygon, p); });
}

// Is a point at this depth hidden by a nearer front face?
bool is_covered(const Vec2& p, const ElevationFaces& faces, double depth_m) {
  return std::any_of(faces.faces.rbegin(), faces.faces.rend(),
                     [&](const DrawnFace& face) {  // the nearest come last
                       return face.depth_m < depth_m && face.kind == DrawnFace::Kind::kFront &&
                              is_inside(face, p);
                     });
}

// The point of a face farthest from its borders, on a coarse raster: where a label has most room. Returns the room.
double roomiest_point(const DrawnFace& face, Vec2& best) {
  constexpr int kSteps = 16;
  constexpr size_t kMaxCorners = 4000;  // raw contours of large faces get no label
  size_t corners = 0;
  for (const auto& ring : face.rings) corners += ring.polygon.size();
  if (corners > kMaxCorners) return 0;
  Vec2 low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
  for (const Vec2& p : face.rings.front().polygon) {
    low = {std::min(low.u, p.u), std::min(low.v, p.v)};
    high = {std::max(high.u, p.u), std::max(high.v, p.v)};
  }
  double room = 0;
  for (int i = 1; i < kSteps; ++i)
    for (int j = 1; j < kSteps; ++j) {
      const Vec2 p{low.u + (high.u - low.u) * i / kSteps, low.v + (high.v - low.v) * j / kSteps};
      if (!is_inside(face, p)) continue;
      double here = INFINITY;
      for (size_t r = 0; r < face.rings.size() && here > room; ++r)
        here = std::min(here, border_distance(face.rings[r].polygon, p));
      if (here > room) {
        room = here;
        best = p;
      }
    }
  return room;
}

// Types stand in a white field at the middle of their openings.
void draw_type(SvgWriter& svg, const ElevationDrawing& drawing, const DrawnOpening& opening,
               Taken& taken) {
  const ElevationFaces& faces = drawing.faces;
  const OpeningRow& row = faces.list.rows[opening.row];
  const Vec2 middle = (opening.low + opening.high) * 0.5;
  const std::string& tag = faces.list.types[row.type].tag;
  const double room = drawing.sheet.mm_of(opening.high.u - opening.low.u);
  const double size = text_width(tag, kLabelsText) + 1.2 <= room ? kLabelsText : kSmallText;
  const double width = text_width(tag, size) + 0.8;
  if (width > room || is_covered(middle, faces, opening.depth_m)) return;
  const Vec2 p = drawing.on_paper(middle);
  const Box_mm box{p.u - width / 2, p.v - 0.62 * size, width, 1.24 * size};
  if (!taken.take(box)) return;
  svg.leaf("rect", {{"x", box.x},
                    {"y", box.y},
                    {"width", box.width},
                    {"height", box.height},
                    {"rx", 0.5},
                    {"fill", "#ffffff"},
                    {"fill-opacity", 0.85}});
  svg_text(svg, {p.u, p.v + 0.36 * size}, size, Anchor::kMiddle, tag, true, false,
           opening_colour(row.part_class));
}

// The plane's number, as in the report's table, where there is room for it.
void draw_number(SvgWriter& svg, const ElevationDrawing& drawing, const DrawnFace& face,
                 Taken& taken) {
  Vec2 at;
  const std::string text = std::to_string(face.label);
  const double room = drawing.sheet.mm_of(roomiest_point(face, at)),
               width = text_width(text, kLabelsText);
  if (room < std::max(kLabelsText, width) * 0.6 || is_covered(at, drawing.faces, face.depth_m))
    return;
  const Vec2 p = drawing.on_paper(at);
  if (!taken.take({p.u - width / 2, p.v - kLabelsText, width, 2 * kLabelsText})) return;
  const std::string fill = group_colour(drawing.faces, face.group, drawing.content.colours);
  svg_text(svg, {p.u, p.v + 0.9}, kLabelsText, Anchor::kMiddle, text, true, false,
           is_dark(fill) ? "#ffffff" : kInk);
}

}  // namespace

void draw_labels(SvgWriter& svg, const ElevationDrawing& drawing) {
  Taken taken;
  const ElevationFaces& faces = drawing.faces;
  if (faces.has_named_openings)
    for (const DrawnOpening& opening : faces.openings) draw_type(svg, drawing, opening, taken);
  else
    for (size_t i = faces.faces.size(); i-- > 0;)
      if (faces.faces[i].kind == DrawnFace::Kind::kFront)
        draw_number(svg, drawing, faces.faces[i], taken);
}

}  // namespace jalon
