// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/elevation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/text_number.h"
#include "geometry/polygon2.h"
#include "report/elevation_legend.h"
#include "report/svg_parts.h"
#include "report/ticks.h"

namespace jalon {

namespace {

constexpr double kText = 2.5;
constexpr const char* kEdgeOn = "#b3472f";

// From facade metres to millimetres on paper.
struct OnPaper {
  const Sheet& sheet;
  Window window;
  Vec2 operator()(const Vec2& p) const {
    return {sheet.view.x + sheet.mm_of(p.u - window.low.u), sheet.view.bottom() - sheet.mm_of(p.v - window.low.v)};
  }
  std::vector<std::vector<Vec2>> rings(const DrawnFace& face) const {
    std::vector<std::vector<Vec2>> out;
    for (const auto& ring : face.rings) {
      auto& to = out.emplace_back();
      for (const Vec2& p : ring) to.push_back((*this)(p));
    }
    return out;
  }
};

void define_patterns(SvgWriter& svg, const Sheet& sheet) {
  svg.open("defs");
  svg.open("clipPath", {{"id", "window"}});
  svg.leaf("rect", {{"x", sheet.view.x}, {"y", sheet.view.y}, {"width", sheet.view.width},
                    {"height", sheet.view.height}});
  svg.close();
  svg.open("pattern", {{"id", "slanted"},
                       {"width", 1.5},
                       {"height", 1.5},
                       {"patternUnits", "userSpaceOnUse"},
                       {"patternTransform", "rotate(45)"}});
  svg_line(svg, {0, 0}, {0, 1.5}, "#a8a8a8", 0.15);
  svg.close();
  svg.close();
}

// Tick marks, labels, faint grid, axis names. x counts from the left end of the drawing's faces, z is the height of the
// data.
void draw_axes(SvgWriter& svg, const Sheet& sheet, const OnPaper& on_paper, const ElevationFaces& faces) {
  const Window& w = on_paper.window;
  const double mm = sheet.mm_of(1);
  const Ticks x = make_ticks(w.low.u - faces.low.u, w.high.u - faces.low.u, 12 / mm);
  const Ticks z = make_ticks(w.low.v, w.high.v, 8 / mm);
  const Box_mm& v = sheet.view;
  for (const double value : x.values) {
    const double at = on_paper({value + faces.low.u, 0}).u;
    svg_line(svg, {at, v.y}, {at, v.bottom()}, kFaint, 0.1);
    svg_line(svg, {at, v.bottom()}, {at, v.bottom() + 1.5}, kInk, 0.18);
    svg_text(svg, {at, v.bottom() + 4.8}, kText, Anchor::kMiddle, x.label(value));
  }
  for (const double value : z.values) {
    const double at = on_paper({0, value}).v;
    svg_line(svg, {v.x, at}, {v.right(), at}, kFaint, 0.1);
    svg_line(svg, {v.x - 1.5, at}, {v.x, at}, kInk, 0.18);
    svg_text(svg, {v.x - 2.3, at + 0.9}, kText, Anchor::kEnd, z.label(value));
  }
  svg_text(svg, {v.x + v.width / 2, v.bottom() + 9.5}, 2.8, Anchor::kMiddle, "Distance along the facade (m)");
  svg_text(svg, {v.x - 12.5, v.y + v.height / 2}, 2.8, Anchor::kMiddle, "Height Z (m)", false, true);
}

void draw_faces(SvgWriter& svg, const OnPaper& on_paper, const ElevationFaces& faces) {
  svg.open("g", {{"clip-path", "url(#window)"}, {"stroke-linejoin", "round"}, {"fill-rule", "evenodd"}});
  for (const DrawnFace& face : faces.faces) {
    const auto rings = on_paper.rings(face);
    switch (face.kind) {
      case DrawnFace::Kind::kFront:
        svg.leaf("path", {{"d", svg_rings(rings)},
                          {"fill", depth_colour(face.group, faces.groups.size())},
                          {"stroke", kInk},
                          {"stroke-width", 0.25}});
        break;
      case DrawnFace::Kind::kEdgeOn:
        svg.leaf("path", {{"d", svg_polyline(rings.front())},
                          {"fill", "none"},
                          {"stroke", kEdgeOn},
                          {"stroke-width", 0.35}});
        break;
      case DrawnFace::Kind::kSlanted:
        svg.leaf("path", {{"d", svg_rings(rings)},
                          {"fill", "url(#slanted)"},
                          {"stroke", kGrey},
                          {"stroke-width", 0.18}});
        break;
    }
  }
  svg.close();
}

// The point of a face farthest from its borders, on a coarse raster: where a label has most room. Returns the room.
double roomiest_point(const DrawnFace& face, Vec2& best) {
  constexpr int kSteps = 16;
  constexpr size_t kMaxCorners = 4000;  // raw contours of large faces get no label
  size_t corners = 0;
  for (const auto& ring : face.rings) corners += ring.size();
  if (corners > kMaxCorners) return 0;
  Vec2 low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
  for (const Vec2& p : face.rings.front()) {
    low = {std::min(low.u, p.u), std::min(low.v, p.v)};
    high = {std::max(high.u, p.u), std::max(high.v, p.v)};
  }
  double room = 0;
  for (int i = 1; i < kSteps; ++i)
    for (int j = 1; j < kSteps; ++j) {
      const Vec2 p{low.u + (high.u - low.u) * i / kSteps, low.v + (high.v - low.v) * j / kSteps};
      if (!contains(face.rings.front(), p)) continue;
      double here = INFINITY;
      for (size_t r = 0; r < face.rings.size() && here > room; ++r) {
        if (r > 0 && contains(face.rings[r], p)) here = 0;
        here = std::min(here, border_distance(face.rings[r], p));
      }
      if (here > room) {
        room = here;
        best = p;
      }
    }
  return room;
}

bool is_covered(const Vec2& p, const ElevationFaces& faces, size_t own) {
  for (size_t i = own + 1; i < faces.faces.size(); ++i) {  // nearer ones come later
    const DrawnFace& face = faces.faces[i];
    if (face.kind != DrawnFace::Kind::kFront || !contains(face.rings.front(), p)) continue;
    const bool in_opening = std::any_of(face.rings.begin() + 1, face.rings.end(),
                                        [&](const std::vector<Vec2>& ring) { return contains(ring, p); });
    if (!in_opening) return true;
  }
  return false;
}

// Plane numbers, as in the report's table, where there is room for them: nearest first, none on another.
void draw_labels(SvgWriter& svg, const Sheet& sheet, const OnPaper& on_paper, const ElevationFaces& faces) {
  std::vector<Box_mm> taken;
  for (size_t i = faces.faces.size(); i-- > 0;) {
    const DrawnFace& face = faces.faces[i];
    if (face.kind != DrawnFace::Kind::kFront) continue;
    Vec2 at;
    const std::string text = std::to_string(face.label);
    const double room = sheet.mm_of(roomiest_point(face, at)), width = text_width(text, kText);
    if (room < std::max(kText, width) * 0.6 || is_covered(at, faces, i)) continue;
    const Vec2 p = on_paper(at);
    const Box_mm box{p.u - width / 2, p.v - kText, width, 2 * kText};
    const bool overlaps = std::any_of(taken.begin(), taken.end(), [&](const Box_mm& b) {
      return box.x < b.right() && b.x < box.right() && box.y < b.bottom() && b.y < box.bottom();
    });
    if (overlaps) continue;
    taken.push_back(box);
    const bool is_dark = face.group * 2 > faces.groups.size();
    svg_text(svg, {p.u, p.v + 0.9}, kText, Anchor::kMiddle, text, true, false, is_dark ? "#ffffff" : kInk);
  }
}

// Overall width above and height to the right, with the oblique ticks of building drawings.
void draw_dimensions(SvgWriter& svg, const OnPaper& on_paper, const ElevationFaces& faces) {
  const Box_mm& v = on_paper.sheet.view;
  const Vec2 low = on_paper(faces.low), high = on_paper(faces.high);
  const double y = v.y - 4, x = v.right() + 4;
  const auto tick = [&](const Vec2& p) { svg_line(svg, p + Vec2{-1, 1}, p + Vec2{1, -1}, kInk, 0.35); };
  svg_line(svg, {low.u - 1.5, y}, {high.u + 1.5, y}, kInk, 0.18);
  svg_line(svg, {x, low.v + 1.5}, {x, high.v - 1.5}, kInk, 0.18);
  for (const double end : {low.u, high.u}) {
    svg_line(svg, {end, v.y - 0.5}, {end, y - 1.5}, kInk, 0.18);
    tick({end, y});
  }
  for (const double end : {low.v, high.v}) {
    svg_line(svg, {v.right() + 0.5, end}, {x + 1.5, end}, kInk, 0.18);
    tick({x, end});
  }
  svg_text(svg, {(low.u + high.u) / 2, y - 1.2}, kText, Anchor::kMiddle, text_of(faces.high.u - faces.low.u, 2));
  svg_text(svg, {x + 3.2, (low.v + high.v) / 2}, kText, Anchor::kMiddle, text_of(faces.high.v - faces.low.v, 2), false,
           true);
}

void draw_border(SvgWriter& svg, const Box_mm& box, double width) {
  svg.leaf("rect", {{"x", box.x},
                    {"y", box.y},
                    {"width", box.width},
                    {"height", box.height},
                    {"fill", "none"},
                    {"stroke", kInk},
                    {"stroke-width", width}});
}

}  // namespace

Window window_of(const ElevationFaces& faces) {
  constexpr double kRim = 0.02, kSmallest_m = 0.01;
  if (faces.empty) return {{0, 0}, {1, 1}};
  const double size = std::max({faces.high.u - faces.low.u, faces.high.v - faces.low.v, kSmallest_m});
  const Vec2 rim{kRim * size, kRim * size};
  return {faces.low - rim, faces.high + rim};
}

std::string depth_colour(size_t i, size_t n) {
  // ColorBrewer YlGnBu (Harrower & Brewer 2003): lightness falls all the way, also in grey and for the colour-blind.
  constexpr std::array<std::array<double, 3>, 6> kStops{
      {{255, 247, 214}, {199, 233, 180}, {127, 205, 187}, {65, 158, 196}, {38, 98, 168}, {22, 40, 108}}};
  const double t = n > 1 ? static_cast<double>(i) / static_cast<double>(n - 1) * (kStops.size() - 1) : 0.6;
  const size_t k = std::min(static_cast<size_t>(t), kStops.size() - 2);
  const double f = t - static_cast<double>(k);
  constexpr char kHex[] = "0123456789abcdef";
  std::string out = "#";
  for (size_t c = 0; c < 3; ++c) {
    const auto value = static_cast<unsigned>(std::lround(kStops[k][c] + f * (kStops[k + 1][c] - kStops[k][c])));
    out += kHex[value >> 4];
    out += kHex[value & 15];
  }
  return out;
}

std::string draw_elevation(const ElevationFaces& faces, const Sheet& sheet, const ElevationSetting& setting) {
  SvgWriter svg;
  const std::string box = "0 0 " + svg_number(sheet.width) + " " + svg_number(sheet.height);
  svg.open("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
                   {"width", svg_number(sheet.width) + "mm"},
                   {"height", svg_number(sheet.height) + "mm"},
                   {"viewBox", box},
                   {"font-family", "Helvetica, Arial, sans-serif"}});
  svg.element("title", {}, setting.title);
  svg.leaf("rect", {{"width", sheet.width}, {"height", sheet.height}, {"fill", "#ffffff"}});
  define_patterns(svg, sheet);
  const OnPaper on_paper{sheet, window_of(faces)};
  if (faces.empty) {
    svg_text(svg, {sheet.view.x + sheet.view.width / 2, sheet.view.y + sheet.view.height / 2}, 4, Anchor::kMiddle,
             "no planes to draw");
  } else {
    draw_axes(svg, sheet, on_paper, faces);
    draw_faces(svg, on_paper, faces);
    if (setting.labels) draw_labels(svg, sheet, on_paper, faces);
    if (setting.dimensions) draw_dimensions(svg, on_paper, faces);
    draw_legend(svg, faces, sheet);
    draw_scale_bar(svg, sheet);
  }
  draw_border(svg, sheet.view, 0.25);
  if (setting.is_sheet) {
    draw_title_block(svg, faces, sheet, setting);
    draw_border(svg, sheet.frame, 0.5);
  }
  return svg.take();
}

}  // namespace jalon
