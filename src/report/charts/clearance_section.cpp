// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/charts/clearance_section.h"

#include <algorithm>
#include <cmath>

#include "base/text_number.h"
#include "formats/drawings/svg_writer.h"
#include "geometry/polygon2.h"
#include "report/charts/section_cut.h"
#include "report/sheet/sheet.h"
#include "report/sheet/svg_parts.h"
#include "report/sheet/ticks.h"

namespace jalon {

namespace {

// Of the drawing, in millimetres.
constexpr double kCutLeft = 15, kCutTop = 15, kCutBelow = 12, kCutRight = 6, kCutMost = 130,
                 kCutText = 2.6;
constexpr double kCutAir_m = 1;      ///< around the gauge and the place
constexpr size_t kCutPoints = 6000;  ///< at most so many are drawn, evenly taken

using Outlines = std::vector<std::vector<Vec2>>;

Vec2 across(const Vec3& in_section) { return {in_section.x, in_section.y}; }

// Seen along the travel a convex piece is the hull of its points: what it sweeps while it runs straight.
Outlines outlines_of(std::span<const std::vector<Vec3>> gauge, const Transform& section_of_gauge) {
  Outlines out;
  for (const std::vector<Vec3>& piece : gauge) {
    std::vector<Vec2> flat, ring;
    for (const Vec3& p : piece) flat.push_back(across(section_of_gauge.point(p)));
    for (const uint32_t corner : convex_hull(std::span<const Vec2>(flat)))
      ring.push_back(flat[corner]);
    out.push_back(std::move(ring));
  }
  return out;
}

struct CutWindow {
  Vec2 low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};  // metres
  double denominator = 1;

  void add(const Vec2& p) {
    low = {std::min(low.u, p.u), std::min(low.v, p.v)};
    high = {std::max(high.u, p.u), std::max(high.v, p.v)};
  }
  bool holds(const Vec2& p) const {
    return p.u > low.u && p.u < high.u && p.v > low.v && p.v < high.v;
  }
  double mm(double metres) const { return metres * 1000 / denominator; }
  Vec2 at(const Vec2& p) const { return {kCutLeft + mm(p.u - low.u), kCutTop + mm(high.v - p.v)}; }
  double right() const { return kCutLeft + mm(high.u - low.u); }
  double bottom() const { return kCutTop + mm(high.v - low.v); }
};

CutWindow window_of(const Outlines& outlines, const TightPlace& place) {
  CutWindow window;
  for (const std::vector<Vec2>& ring : outlines)
    for (const Vec2& p : ring) window.add(p);
  window.add({0, 0});
  window.add(across(place.in_section));
  window.add(across(place.gauge_in_section));
  window.low = window.low - Vec2{kCutAir_m, kCutAir_m};
  window.high = window.high + Vec2{kCutAir_m, kCutAir_m};
  window.denominator = round_up_125(
      1000 * std::max(window.high.u - window.low.u, window.high.v - window.low.v) / kCutMost);
  return window;
}

// One path of dots: an element each would be megabytes.
void draw_cut_points(SvgWriter& svg, const CutWindow& window, const Cloud& cloud,
                     const Transform& section, double back_m) {
  std::vector<Vec2> dots;
  for (size_t i = 0; i < cloud.size(); ++i) {
    const Vec3 p = section.point(cloud.point(i));
    if (std::abs(p.z - back_m) <= kSectionHalf_m && window.holds(across(p)))
      dots.push_back(window.at(across(p)));
  }
  std::string path;
  const size_t stride = std::max<size_t>(1, (dots.size() + kCutPoints - 1) / kCutPoints);
  for (size_t i = 0; i < dots.size(); i += stride)
    path += "M" + svg_number(dots[i].u, 2) + " " + svg_number(dots[i].v, 2) + "h0";
  if (!path.empty())
    svg.leaf("path", {{"d", path},
                      {"fill", "none"},
                      {"stroke", "#4a5a66"},
                      {"stroke-width", 0.35},
                      {"stroke-linecap", "round"}});
}

// Of lines that reach beyond the window its border shows the part within.
void draw_cut_surface(SvgWriter& svg, const CutWindow& window,
                      std::span<const std::array<Vec2, 2>> lines) {
  std::string path;
  for (const auto& line : lines) {
    const auto within = clipped_to(window.low, window.high, line);
    if (!within) continue;
    const Vec2 from = window.at((*within)[0]), to = window.at((*within)[1]);
    path += "M" + svg_number(from.u, 2) + " " + svg_number(from.v, 2) + "L" + svg_number(to.u, 2) +
            " " + svg_number(to.v, 2);
  }
  if (!path.empty())
    svg.leaf("path", {{"d", path},
                      {"fill", "none"},
                      {"stroke", kInk},
                      {"stroke-width", 0.4},
                      {"stroke-linecap", "round"}});
}

void draw_cut_gauge(SvgWriter& svg, const CutWindow& window, const Outlines& outlines) {
  Outlines rings;
  for (const std::vector<Vec2>& ring : outlines) {
    rings.emplace_back();
    for (const Vec2& p : ring) rings.back().push_back(window.at(p));
  }
  if (!rings.empty())
    svg.leaf("path", {{"d", svg_rings(rings)},
                      {"fill", "#2c728e"},
                      {"fill-opacity", 0.15},
                      {"stroke", "#2c728e"},
                      {"stroke-width", 0.35}});
  const Vec2 o = window.at({0, 0});
  svg_line(svg, {o.u - 2, o.v}, {o.u + 2, o.v}, "#2c728e", 0.25);
  svg_line(svg, {o.u, o.v - 2}, {o.u, o.v + 2}, "#2c728e", 0.25);
}

void draw_cut_axes(SvgWriter& svg, const CutWindow& window) {
  constexpr double kApart = 12;  // mm, at least
  const double apart_m = kApart * window.denominator / 1000;
  const Ticks along = make_ticks(window.low.u, window.high.u, apart_m),
              up = make_ticks(window.low.v, window.high.v, apart_m);
  for (const double u : along.values) {
    const double x = window.at({u, 0}).u;
    svg_line(svg, {x, window.bottom()}, {x, window.bottom() + 1.2}, kInk, 0.2);
    svg_text(svg, {x, window.bottom() + 4.4}, kCutText, Anchor::kMiddle, along.label(u));
  }
  for (const double v : up.values) {
    const double y = window.at({0, v}).v;
    svg_line(svg, {kCutLeft - 1.2, y}, {kCutLeft, y}, kInk, 0.2);
    svg_text(svg, {kCutLeft - 1.8, y + 0.9}, kCutText, Anchor::kEnd, up.label(v));
  }
  svg.leaf("rect", {{"x", kCutLeft},
                    {"y", kCutTop},
                    {"width", window.right() - kCutLeft},
                    {"height", window.bottom() - kCutTop},
                    {"fill", "none"},
                    {"stroke", kInk},
                    {"stroke-width", 0.2}});
  svg_text(svg, {(kCutLeft + window.right()) / 2, window.bottom() + 9}, kCutText, Anchor::kMiddle,
           "right of the gauge's origin (m)");
  svg_text(svg, {4, (kCutTop + window.bottom()) / 2}, kCutText, Anchor::kMiddle, "above it (m)",
           false, true);
}

// The obstacle, and from it what is free up to the gauge or what stands in it.
void draw_cut_place(SvgWriter& svg, const CutWindow& window, const TightPlace& place) {
  const Vec2 obstacle = window.at(across(place.in_section)),
             gauge = window.at(across(place.gauge_in_section));
  svg_line(svg, obstacle, gauge, "#c0392b", 0.4);
  svg.leaf("circle", {{"cx", obstacle.u},
                      {"cy", obstacle.v},
                      {"r", 1.1},
                      {"fill", "none"},
                      {"stroke", "#c0392b"},
                      {"stroke-width", 0.4}});
  const bool is_left =
      obstacle.u > (kCutLeft + window.right()) / 2;  // the text stands where there is room
  const Vec2 at{obstacle.u + (is_left ? -2.2 : 2.2), obstacle.v - 1.6};
  svg.open("g", {{"stroke", "#ffffff"}, {"stroke-width", 1}, {"paint-order", "stroke"}});
  svg_text(svg, at, 3, is_left ? Anchor::kEnd : Anchor::kStart,
           text_of(place.clearance_m, 3) + " m", true, false, "#c0392b");
  svg.close();
}

}  // namespace

std::string clearance_section(const TightPlace& place, size_t number, const GaugePath& path,
                              std::span<const std::vector<Vec3>> gauge, const Cloud* cloud,
                              const PartTriangles* surface) {
  const Outlines outlines = outlines_of(gauge, path.section_of_gauge(place.parameter));
  const CutWindow window = window_of(outlines, place);
  Sheet sheet;
  constexpr double kHeadWidth = 86;  // mm that the lines above take
  sheet.width = std::max(window.right(), kHeadWidth) + kCutRight;
  sheet.height = window.bottom() + kCutBelow;
  SvgWriter svg;
  open_figure(svg, sheet, "Section at place " + std::to_string(number));
  svg_text(svg, {kCutLeft, 5.5}, 3.4, Anchor::kStart,
           "Place " + std::to_string(number) + ", at " + text_of(place.chainage_m, 2) + " m", true);
  svg_text(svg, {kCutLeft, 10.5}, kCutText, Anchor::kStart,
           "1 : " + text_of(window.denominator) + ", seen along the travel" +
               (cloud != nullptr ? ", points within " + text_of(kSectionHalf_m, 2) + " m" : ""));
  draw_cut_gauge(svg, window, outlines);
  if (cloud != nullptr)
    draw_cut_points(svg, window, *cloud, path.section(place.parameter), place.in_section.z);
  if (surface != nullptr)
    draw_cut_surface(svg, window,
                     section_cut(*surface, path.section(place.parameter), place.in_section.z));
  draw_cut_axes(svg, window);
  draw_cut_place(svg, window, place);
  return svg.take();
}

}  // namespace jalon
