// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pictures/facade_section.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "registration/joint/adjusted.h"
#include "report/pictures/drive_plan.h"
#include "report/sheet/svg_parts.h"
#include "report/sheet/ticks.h"

namespace jalon {

namespace {

constexpr double kFacadeSheet_mm = 180, kPanelLeft = 24, kPanelRight = 4, kPanelTop = 12,
                 kPanelBelow = 14, kPanelsApart = 8;
constexpr double kDepthMost_mm = 60;  // that a panel takes across the facade
constexpr double kPanelText = 2.8, kPointSize_mm = 0.25;
constexpr size_t kMostDots = 1500;  // a panel
constexpr const char *kGivenWall = "#1f5fa8", *kGivenPoint = "#c0392b", *kMovedPoint = "#1e8449";

// Along the facade and out of it.
struct Panel {
  std::string name;
  const char *wall, *point;
  std::vector<std::pair<Vec2, Vec2>> strips;
  std::vector<Vec2> dots;
};

struct SectionRange {
  double low = INFINITY, high = -INFINITY;
  void take(double v) { low = std::min(low, v), high = std::max(high, v); }
  double length() const { return high - low; }
};

// The facade's own frame: the first of its strips as given.
struct FacadeFrame {
  Vec2 normal, foot;
  Vec2 of(const Vec2& p) const {
    return {dot({-normal.v, normal.u}, p - foot), dot(normal, p - foot)};
  }
};

FacadeFrame frame_of(const StripScene& scene, uint32_t facade) {
  const auto first = std::ranges::find(scene.strips, facade, &GivenStrip::facade);
  return {first->normal, first->normal * first->offset_m};
}

Panel panel_of(const StripScene& scene, const JointAdjustment& a, uint32_t facade,
               bool is_adjusted) {
  Panel made = is_adjusted ? Panel{"adjusted", kInk, kMovedPoint, {}, {}}
                           : Panel{"as given", kGivenWall, kGivenPoint, {}, {}};
  const FacadeFrame frame = frame_of(scene, facade);
  for (const PlanLine& line : plan_lines(scene, a)) {
    const GivenStrip& strip = scene.strips[line.strip];
    if (strip.facade != facade) continue;
    const Vec2 by = strip.normal * (is_adjusted ? shift_of(strip, line.strip, a.model) : 0.0);
    made.strips.emplace_back(frame.of(line.a + by), frame.of(line.b + by));
  }
  const std::vector<Vec3> points = is_adjusted ? adjusted_points(a) : a.points.at;
  for (size_t i = 0; i < points.size(); ++i) {
    const PointMatch& match = a.matches[i];
    if (match.state != MatchState::kMatched || !(a.weights[i] > 0) ||
        scene.strips[match.strip].facade != facade)
      continue;
    made.dots.push_back(frame.of({points[i].x, points[i].y}));
  }
  const size_t stride = std::max<size_t>(1, (made.dots.size() + kMostDots - 1) / kMostDots);
  std::vector<Vec2> some;
  for (size_t i = 0; i < made.dots.size(); i += stride) some.push_back(made.dots[i]);
  made.dots = std::move(some);
  return made;
}

// The same for both panels.
struct SectionScale {
  SectionRange along, out;
  double mm_per_m = 1, factor = 1;

  explicit SectionScale(const std::vector<Panel>& panels) {
    for (const Panel& panel : panels) {
      for (const auto& [a, b] : panel.strips)
        for (const Vec2& p : {a, b}) along.take(p.u), out.take(p.v);
      for (const Vec2& p : panel.dots) along.take(p.u), out.take(p.v);
    }
    const double air = 0.04 * out.length() + 0.005;
    out.low -= air, out.high += air;
    mm_per_m =
        std::min((kFacadeSheet_mm - kPanelLeft - kPanelRight) / std::max(along.length(), 0.1),
                 kDepthMost_mm / out.length());
    factor = drive_plan_factor(out.length(), mm_per_m, kDepthMost_mm);
  }
  double depth() const { return out.length() * mm_per_m * factor; }
  Vec2 operator()(const Vec2& p, double top) const {
    return {kPanelLeft + mm_per_m * (p.u - along.low), top + mm_per_m * factor * (out.high - p.v)};
  }
};

void draw_panel(SvgWriter& svg, const SectionScale& scale, const Panel& panel, double top) {
  const double bottom = top + scale.depth();
  constexpr double kTicksApart_mm = 14, kRowsApart_mm = 7;
  const Ticks along =
      make_ticks(scale.along.low, scale.along.high, kTicksApart_mm / scale.mm_per_m);
  const Ticks out =
      make_ticks(scale.out.low, scale.out.high, kRowsApart_mm / (scale.mm_per_m * scale.factor));
  for (const double v : out.values) {
    const double y = scale({scale.along.low, v}, top).v;
    svg_line(svg, {kPanelLeft, y}, scale({scale.along.high, v}, top), kFaint, 0.15);
    svg_text(svg, {kPanelLeft - 2, y + 1}, kPanelText, Anchor::kEnd, out.label(v));
  }
  for (const double v : along.values) {
    const double x = scale({v, 0}, top).u;
    svg_line(svg, {x, bottom}, {x, bottom + 1.5}, kInk, 0.2);
    svg_text(svg, {x, bottom + 5}, kPanelText, Anchor::kMiddle, along.label(v));
  }
  svg_line(svg, {kPanelLeft, bottom}, scale({scale.along.high, scale.out.low}, top), kInk, 0.25);
  svg_line(svg, {kPanelLeft, top}, {kPanelLeft, bottom}, kInk, 0.25);
  svg_text(svg, {kPanelLeft, top - 2}, 3, Anchor::kStart, panel.name, true);
  for (const Vec2& p : panel.dots) {
    const Vec2 at = scale(p, top);
    svg.leaf("circle", {{"cx", at.u}, {"cy", at.v}, {"r", kPointSize_mm}, {"fill", panel.point}});
  }
  for (const auto& [a, b] : panel.strips)
    svg_line(svg, scale(a, top), scale(b, top), panel.wall, 0.4);
}

}  // namespace

std::optional<uint32_t> farthest_facade(const StripScene& scene,
                                        const JointAdjustment& adjustment) {
  std::vector<double> sums(scene.facades, 0), counts(scene.facades, 0);
  for (uint32_t s = 0; s < scene.strips.size(); ++s) {
    if (adjustment.strip_points[s] == 0) continue;
    sums[scene.strips[s].facade] += std::fabs(adjustment.strip_distances_m[s]);
    counts[scene.strips[s].facade] += 1;
  }
  std::optional<uint32_t> found;
  for (const double least : {3.0, 1.0}) {
    for (uint32_t f = 0; f < scene.facades; ++f)
      if (counts[f] >= least && (!found || sums[f] / counts[f] > sums[*found] / counts[*found]))
        found = f;
    if (found) break;
  }
  return found;
}

std::string facade_section(const StripScene& scene, const JointAdjustment& adjustment,
                           uint32_t facade) {
  const std::vector<Panel> panels = {panel_of(scene, adjustment, facade, false),
                                     panel_of(scene, adjustment, facade, true)};
  const SectionScale scale(panels);
  const double second = kPanelTop + scale.depth() + kPanelBelow + kPanelsApart,
               height = second + scale.depth() + kPanelBelow;
  SvgWriter svg;
  svg.open("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
                   {"viewBox", "0 0 " + svg_number(kFacadeSheet_mm) + " " + svg_number(height)},
                   {"font-family", "Helvetica, Arial, sans-serif"}});
  svg.element("title", {}, "Section through a facade");
  draw_panel(svg, scale, panels[0], kPanelTop);
  draw_panel(svg, scale, panels[1], second);
  svg_text(svg, {(kPanelLeft + kFacadeSheet_mm - kPanelRight) / 2, height - 3}, 3, Anchor::kMiddle,
           "Along the facade (m)");
  svg_text(svg, {4, (kPanelTop + height - kPanelBelow) / 2}, 3, Anchor::kMiddle,
           "Out of it (m)" + (scale.factor > 1 ? ", x " + svg_number(scale.factor) : ""), false,
           true);
  return svg.take();
}

}  // namespace jalon
