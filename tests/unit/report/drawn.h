// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/numbers.h"
#include "report/elevation/elevation.h"
#include "unit/report/markup.h"

/// What is read from the SVG of drawings and charts, and drawings made by hand: 10 mm of paper a metre.
namespace drawn {

using namespace jalon;

constexpr double kRounding_mm = 0.0005 + 1e-9;  // numbers of a drawing have three decimals

/// What draw(svg) writes.
template <class Draw>
std::string svg_of(const Draw& draw) {
  SvgWriter svg;
  draw(svg);
  return svg.take();
}

inline double number(const markup::Tag& tag, std::string_view attribute) {
  return markup::number(tag.attribute(attribute));
}

/// The elements of this name, in their order.
inline std::vector<markup::Tag> elements(std::string_view svg, std::string_view name) {
  std::vector<markup::Tag> out;
  for (const markup::Tag& tag : markup::tags(svg))
    if (tag.name == name) out.push_back(tag);
  return out;
}
/// Those of them whose attribute has this value.
inline std::vector<markup::Tag> elements(std::string_view svg, std::string_view name,
                                         std::string_view attribute, std::string_view value) {
  std::vector<markup::Tag> out;
  for (const markup::Tag& tag : elements(svg, name))
    if (tag.attribute(attribute) == value) out.push_back(tag);
  return out;
}

/// Where texts of just these letters stand.
inline std::vector<Vec2> places(std::string_view svg, std::string_view text) {
  std::vector<Vec2> out;
  for (const markup::Tag& tag : elements(svg, "text"))
    if (tag.text_after == text) out.push_back({number(tag, "x"), number(tag, "y")});
  return out;
}

/// The ends of the M and L commands of a path.
inline std::vector<Vec2> corners(const std::string& d) {
  std::vector<Vec2> out;
  for (size_t i = 0; i < d.size(); ++i) {
    if (d[i] != 'M' && d[i] != 'L') continue;
    const size_t gap = d.find(' ', i), end = d.find_first_of("MLAZ", i + 1);
    out.push_back({markup::number(d.substr(i + 1, gap - i - 1)),
                   markup::number(d.substr(gap + 1, end - gap - 1))});
  }
  return out;
}

/// Area between an open line and the level `bottom`, y down.
inline double area_above(const std::vector<Vec2>& line, double bottom) {
  double sum = 0;
  for (size_t i = 1; i < line.size(); ++i)
    sum += (line[i].u - line[i - 1].u) * (bottom - (line[i].v + line[i - 1].v) / 2);
  return sum;
}
inline double bar_area(std::string_view svg) {
  double sum = 0;
  for (const markup::Tag& bar : elements(svg, "rect"))
    sum += number(bar, "width") * number(bar, "height");
  return sum;
}

inline DrawnRing box(const Vec2& low, const Vec2& high) {
  DrawnRing out;
  out.corners = {low, {high.u, low.v}, high, {low.u, high.v}};
  out.polygon = out.corners;
  return out;
}

inline DrawnFace wall(const Vec2& low, const Vec2& high, double depth_m = 0) {
  DrawnFace out;
  out.role = DrawnFace::Role::kWall;
  out.depth_m = depth_m;
  out.rings = {box(low, high)};
  return out;
}

inline DrawnOpening opening(size_t row, const Vec2& low, const Vec2& high, double depth_m = 0) {
  DrawnOpening out;
  out.row = row;
  out.depth_m = depth_m;
  out.contour = {box(low, high)};
  out.low = low;
  out.high = high;
  return out;
}

/// Faces of one colour that fill this box, the ground at its foot.
inline ElevationFaces facade(std::vector<DrawnFace> faces, const Vec2& low, const Vec2& high) {
  ElevationFaces out;
  out.groups = {{0, 0, faces.size(), 0, 0}};
  out.faces = std::move(faces);
  out.low = out.wall_low = low;
  out.high = out.wall_high = high;
  out.ground_m = low.v;
  out.empty = false;
  return out;
}

/// A row of the list and its type, "W1" for the first.
inline void add_type(ElevationFaces& faces, const char* part_class, const char* tag) {
  OpeningRow row;
  row.part = static_cast<uint32_t>(faces.list.rows.size());
  row.part_class = part_class;
  row.type = faces.list.types.size();
  faces.list.rows.push_back(row);
  OpeningType type;
  type.tag = tag;
  type.part_class = part_class;
  faces.list.types.push_back(type);
  faces.has_named_openings = true;
}

/// The drawing 1:100 on paper that holds it; both must outlive it.
inline ElevationDrawing on_a3(const ElevationFaces& faces, const ElevationContent& content) {
  const Window window{faces.low, faces.high};
  const Dimensions dimensions = dimensions_of(faces, content);
  const Sheet sheet =
      lay_out_sheet(window.width(), window.height(), "A3", 100, margins_for(dimensions));
  return {faces,  content, dimensions,
          window, sheet,   {10, {sheet.view.x, sheet.view.bottom()}, window.low}};
}

}  // namespace drawn
