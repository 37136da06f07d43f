// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pictures/drive_plan.h"

#include <algorithm>
#include <cmath>

#include "model/trajectory/interpolation.h"
#include "report/sheet/svg_parts.h"
#include "report/sheet/ticks.h"

namespace jalon {

namespace {

constexpr double kPlanLeft = 24, kPlanTop = 13, kPlanBelow = 14, kPlanRight = 4;  // around, mm
constexpr double kPlanWidth_mm = 180, kPlanHeight_mm = 150;  // of the sheet at most
constexpr double kPlanText = 2.8, kPathWidth_mm = 0.5;
constexpr const char *kGivenRed = "#c0392b", *kAdjustedGreen = "#1e8449", *kTrueBlue = "#1f5fa8",
                     *kPale = "#b5b5b5";
constexpr double kChi95 = 2.4477;    // root of the 95 % quantile of chi-square with two degrees
constexpr double kPaperMost_mm = 8;  // length that the greatest correction may take
constexpr size_t kMostEllipses = 40, kMostPoints = 2000;

struct PlanWindow {
  double left = INFINITY, low = INFINITY, right = -INFINITY, high = -INFINITY;
  double mm_per_m = 1;

  void take(const Vec2& p) {
    left = std::min(left, p.u), right = std::max(right, p.u);
    low = std::min(low, p.v), high = std::max(high, p.v);
  }
  // Leaves air around and finds the scale.
  void close() {
    const double air = 0.05 * std::max({right - left, high - low, 1.0});
    left -= air, right += air, low -= air, high += air;
    mm_per_m = std::min((kPlanWidth_mm - kPlanLeft - kPlanRight) / (right - left),
                        (kPlanHeight_mm - kPlanTop - kPlanBelow) / (high - low));
  }
  double height() const { return kPlanTop + kPlanBelow + mm_per_m * (high - low); }
  Vec2 operator()(const Vec2& p) const {
    return {kPlanLeft + mm_per_m * (p.u - left), kPlanTop + mm_per_m * (high - p.v)};
  }
};

void draw_plan_axes(SvgWriter& svg, const PlanWindow& window) {
  const double bottom = kPlanTop + window.mm_per_m * (window.high - window.low),
               end = kPlanLeft + window.mm_per_m * (window.right - window.left);
  constexpr double kApart_mm = 16;
  const Ticks east = make_ticks(window.left, window.right, kApart_mm / window.mm_per_m),
              north = make_ticks(window.low, window.high, kApart_mm / window.mm_per_m);
  for (const double e : east.values) {
    const double x = window({e, window.low}).u;
    svg_line(svg, {x, bottom}, {x, bottom + 1.5}, kInk, 0.2);
    svg_text(svg, {x, bottom + 5}, kPlanText, Anchor::kMiddle, east.label(e));
  }
  for (const double n : north.values) {
    const double y = window({window.left, n}).v;
    svg_line(svg, {kPlanLeft - 1.5, y}, {kPlanLeft, y}, kInk, 0.2);
    svg_text(svg, {kPlanLeft - 2, y + 1}, kPlanText, Anchor::kEnd, north.label(n));
  }
  svg_line(svg, {kPlanLeft, bottom}, {end, bottom}, kInk, 0.25);
  svg_line(svg, {kPlanLeft, kPlanTop}, {kPlanLeft, bottom}, kInk, 0.25);
  svg_text(svg, {(kPlanLeft + end) / 2, bottom + 10.5}, 3, Anchor::kMiddle, "East (m)");
  svg_text(svg, {4, (kPlanTop + bottom) / 2}, 3, Anchor::kMiddle, "North (m)", false, true);
}

void draw_path(SvgWriter& svg, const PlanWindow& window, const std::vector<Vec2>& path,
               const char* colour, double width_mm) {
  std::vector<Vec2> line;
  for (const Vec2& p : path) line.push_back(window(p));
  svg.leaf("path", {{"d", svg_polyline(line)},
                    {"fill", "none"},
                    {"stroke", colour},
                    {"stroke-width", width_mm}});
}

// The drive in plan at the control times and, where it was given closer, at the epochs between.
struct PlanPaths {
  std::vector<Vec2> given, correction;
  std::vector<Vec2> error;  ///< what the correction should have been; empty: not known
  double greatest_m = 0;
};

PlanPaths plan_paths(const JointAdjustment& adjustment, const Trajectory& given,
                     const Trajectory* truth) {
  PlanPaths out;
  const size_t stride = std::max<size_t>(1, (given.size() + kMostPoints - 1) / kMostPoints);
  TimePlace control, there;
  const auto is_known = [&](double t) {
    return truth != nullptr && t >= truth->times_s.front() && t <= truth->times_s.back();
  };
  for (size_t i = 0; i < given.size(); i += stride) {
    const double t = given.times_s[i];
    if (truth != nullptr && !is_known(t)) continue;
    control = time_place(adjustment.trajectory.times_s, t, i, control.epoch);
    const Vec2 at{given.positions[i].x, given.positions[i].y};
    out.given.push_back(at);
    out.correction.push_back(adjustment.trajectory.at(control));
    out.greatest_m = std::max(out.greatest_m, norm(out.correction.back()));
    if (truth == nullptr) continue;
    there = time_place(truth->times_s, t, i, there.epoch);
    const Vec3 was = between(truth->positions, there);
    out.error.push_back(Vec2{was.x, was.y} - at);
    out.greatest_m = std::max(out.greatest_m, norm(out.error.back()));
  }
  return out;
}

std::vector<Vec2> shifted(const std::vector<Vec2>& path, const std::vector<Vec2>& by,
                          double factor) {
  std::vector<Vec2> out;
  for (size_t i = 0; i < path.size(); ++i) out.push_back(path[i] + by[i] * factor);
  return out;
}

void draw_ellipses(SvgWriter& svg, const PlanWindow& window, const JointAdjustment& adjustment,
                   const Trajectory& given, double factor) {
  const std::vector<double>& times = adjustment.trajectory.times_s;
  const size_t stride = std::max<size_t>(1, (times.size() + kMostEllipses - 1) / kMostEllipses);
  TimePlace place;
  for (size_t c = 0; c < times.size(); c += stride) {
    place = time_place(given.times_s, times[c], c, place.epoch);
    const Vec3 at = between(given.positions, place);
    const Vec2 centre = window(Vec2{at.x, at.y} + adjustment.trajectory.by_m[c] * factor),
               axes = adjustment.trajectory_sigmas[c] * (kChi95 * factor * window.mm_per_m);
    svg.leaf("ellipse", {{"cx", centre.u},
                         {"cy", centre.v},
                         {"rx", axes.u},
                         {"ry", axes.v},
                         {"fill", kAdjustedGreen},
                         {"fill-opacity", "0.1"},
                         {"stroke", kAdjustedGreen},
                         {"stroke-width", 0.12}});
  }
}

void draw_key(SvgWriter& svg, double factor, bool has_truth) {
  double at = kPlanLeft, row = 3;
  const auto entry = [&](const char* colour, const std::string& name) {
    svg_line(svg, {at, row}, {at + 6, row}, colour, 0.6);
    svg_text(svg, {at + 7.5, row + 1}, kPlanText, Anchor::kStart, name);
    at += 11 + text_width(name, kPlanText);
  };
  const std::string times = factor > 1 ? " x " + svg_number(factor) : "";
  entry(kGivenRed, "given");
  entry(kAdjustedGreen, "adjusted" + times + ", 95 % ellipses");
  if (has_truth) entry(kTrueBlue, "true" + times);
  at = kPlanLeft, row += 5;
  entry(kInk, "facade held by points");
  entry(kPale, "facade without points");
}

}  // namespace

std::vector<PlanLine> plan_lines(const StripScene& scene, const JointAdjustment& adjustment) {
  struct Extent {
    double low = INFINITY, high = -INFINITY;
  };
  std::vector<Extent> extents(scene.strips.size());
  const auto along = [&](uint32_t s) {
    return Vec2{-scene.strips[s].normal.v, scene.strips[s].normal.u};
  };
  for (size_t t = 0; t < scene.face_of.size(); ++t) {
    const uint32_t s = scene.strip_of_face[scene.face_of[t]];
    if (s == kNoStrip) continue;
    for (size_t k = 0; k < 3; ++k) {
      const Vec3& p = scene.corners[3 * t + k];
      const double at = dot(along(s), {p.x, p.y});
      extents[s].low = std::min(extents[s].low, at),
      extents[s].high = std::max(extents[s].high, at);
    }
  }
  std::vector<PlanLine> lines;
  for (uint32_t s = 0; s < scene.strips.size(); ++s) {
    if (extents[s].low > extents[s].high) continue;
    const Vec2 foot = scene.strips[s].normal * scene.strips[s].offset_m;
    lines.push_back({foot + along(s) * extents[s].low, foot + along(s) * extents[s].high,
                     adjustment.strip_points[s] > 0, s});
  }
  return lines;
}

double drive_plan_factor(double greatest_m, double mm_per_m, double paper_mm) {
  const double paper = greatest_m * mm_per_m;
  if (!(paper > 0) || paper_mm / paper < 2) return 1;
  const double decade = std::pow(10, std::floor(std::log10(paper_mm / paper)));
  for (const double step : {5.0, 2.0})
    if (step * decade * paper <= paper_mm) return step * decade;
  return decade;
}

std::string drive_plan(const StripScene& scene, const JointAdjustment& adjustment,
                       const Trajectory& given, const Trajectory* truth) {
  const std::vector<PlanLine> walls = plan_lines(scene, adjustment);
  const PlanPaths paths = plan_paths(adjustment, given, truth);
  PlanWindow window;
  for (const PlanLine& wall : walls) window.take(wall.a), window.take(wall.b);
  for (const Vec2& p : paths.given) window.take(p);
  window.close();
  const double factor = drive_plan_factor(paths.greatest_m, window.mm_per_m, kPaperMost_mm);
  SvgWriter svg;
  svg.open("svg",
           {{"xmlns", "http://www.w3.org/2000/svg"},
            {"viewBox", "0 0 " + svg_number(kPlanWidth_mm) + " " + svg_number(window.height())},
            {"font-family", "Helvetica, Arial, sans-serif"}});
  svg.element("title", {}, "Plan of the drive");
  draw_plan_axes(svg, window);
  for (const PlanLine& wall : walls)
    svg_line(svg, window(wall.a), window(wall.b), wall.is_held ? kInk : kPale,
             wall.is_held ? 0.5 : 0.3);
  draw_ellipses(svg, window, adjustment, given, factor);
  draw_path(svg, window, paths.given, kGivenRed, kPathWidth_mm);
  draw_path(svg, window, shifted(paths.given, paths.correction, factor), kAdjustedGreen,
            kPathWidth_mm);
  // The truth lies on a good answer: thinner, so that both are seen.
  if (!paths.error.empty())
    draw_path(svg, window, shifted(paths.given, paths.error, factor), kTrueBlue, kPathWidth_mm / 2);
  draw_key(svg, factor, !paths.error.empty());
  return svg.take();
}

}  // namespace jalon
