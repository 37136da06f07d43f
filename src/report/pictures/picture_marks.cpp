// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pictures/picture_marks.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/polygon2.h"
#include "report/sheet/svg_parts.h"

namespace jalon {

namespace {

constexpr double kMarkText = 2.6, kPad = 0.6, kApart = 0.8, kOutline = 0.35, kLeast = 1.2;  // mm
constexpr const char* kMarkColour = "#0b3c8c";  // neither of a distance nor of what has none

using Outline = std::vector<Vec2>;

// What is smaller than a pencil's dot is drawn as a square of that size.
Outline outline_of(const PictureMark& mark, const std::function<Vec2(const Vec3&)>& place) {
  std::vector<Vec2> flat;
  for (const Vec3& p : mark.points) flat.push_back(place(p));
  Vec2 low = flat.front(), high = low;
  for (const Vec2& p : flat) {
    low = {std::min(low.u, p.u), std::min(low.v, p.v)};
    high = {std::max(high.u, p.u), std::max(high.v, p.v)};
  }
  Outline out;
  for (const uint32_t i : convex_hull(flat)) out.push_back(flat[i]);
  if (out.size() >= 3 && std::min(high.u - low.u, high.v - low.v) >= kLeast) return out;
  const double u = std::max(0.0, kLeast - (high.u - low.u)) / 2,
               v = std::max(0.0, kLeast - (high.v - low.v)) / 2;
  return {{low.u - u, low.v - v},
          {high.u + u, low.v - v},
          {high.u + u, high.v + v},
          {low.u - u, high.v + v}};
}

Box_mm box_of(const Outline& outline) {
  Vec2 low = outline.front(), high = low;
  for (const Vec2& p : outline) {
    low = {std::min(low.u, p.u), std::min(low.v, p.v)};
    high = {std::max(high.u, p.u), std::max(high.v, p.v)};
  }
  return {low.u, low.v, high.u - low.u, high.v - low.v};
}

double common_area(const Box_mm& a, const Box_mm& b) {
  const double width = std::min(a.right(), b.right()) - std::max(a.x, b.x),
               height = std::min(a.bottom(), b.bottom()) - std::max(a.y, b.y);
  return width > 0 && height > 0 ? width * height : 0;
}

// Of the places about the outline the one that covers least of what stands there already.
Box_mm label_place(const Box_mm& of, double width, const Box_mm& within,
                   const std::vector<Box_mm>& taken) {
  const double height = kMarkText + 2 * kPad, middle_x = of.x + (of.width - width) / 2,
               middle_y = of.y + (of.height - height) / 2;
  const std::array<Box_mm, 6> places{{{of.right() + kApart, of.y - height, width, height},
                                      {middle_x, of.y - height - kApart, width, height},
                                      {of.x - width - kApart, of.y - height, width, height},
                                      {of.right() + kApart, middle_y, width, height},
                                      {of.x - width - kApart, middle_y, width, height},
                                      {middle_x, of.bottom() + kApart, width, height}}};
  const auto cost = [&](const Box_mm& box) {
    double sum = width * height - common_area(box, within);
    for (const Box_mm& other : taken) sum += common_area(box, other);
    return sum;
  };
  Box_mm best =
      *std::min_element(places.begin(), places.end(),
                        [&](const Box_mm& a, const Box_mm& b) { return cost(a) < cost(b); });
  best.x = std::clamp(best.x, within.x, std::max(within.x, within.right() - width));
  best.y = std::clamp(best.y, within.y, std::max(within.y, within.bottom() - height));
  return best;
}

}  // namespace

void draw_picture_marks(SvgWriter& svg, std::span<const PictureMark> marks,
                        const std::function<Vec2(const Vec3&)>& place, const Box_mm& within) {
  std::vector<Box_mm> taken;
  std::vector<std::pair<const PictureMark*, Box_mm>> drawn;
  for (const PictureMark& mark : marks) {
    if (mark.points.empty()) continue;
    const std::vector<Outline> rings{outline_of(mark, place)};
    svg.leaf("path", {{"d", svg_rings(rings)},
                      {"fill", "none"},
                      {"stroke", kMarkColour},
                      {"stroke-width", kOutline},
                      {"stroke-linejoin", "round"}});
    drawn.emplace_back(&mark, box_of(rings.front()));
    taken.push_back(drawn.back().second);
  }
  for (const auto& [mark, of] : drawn) {
    if (mark->text.empty()) continue;
    const Box_mm box = label_place(of, text_width(mark->text, kMarkText) + 2 * kPad, within, taken);
    taken.push_back(box);
    svg.leaf("rect", {{"x", box.x},
                      {"y", box.y},
                      {"width", box.width},
                      {"height", box.height},
                      {"rx", kPad},
                      {"fill", "#ffffff"},
                      {"fill-opacity", 0.85},
                      {"stroke", kMarkColour},
                      {"stroke-width", kOutline / 2}});
    svg_text(svg, {box.x + box.width / 2, box.bottom() - kPad - 0.25 * kMarkText}, kMarkText,
             Anchor::kMiddle, mark->text, true, false, kMarkColour);
  }
}

}  // namespace jalon
