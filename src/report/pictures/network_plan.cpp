// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pictures/network_plan.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <vector>

#include "base/text_number.h"
#include "registration/network/network_tables.h"
#include "report/elevation/title_block.h"
#include "report/pictures/drive_plan.h"
#include "report/pictures/picture_axes.h"
#include "report/sheet/svg_parts.h"
#include "report/sheet/ticks.h"

namespace jalon {

namespace {

constexpr double kNetworkRoom = 0.06, kLeastNetwork_m = 1;  // of the longer side, about the points
constexpr double kLargestEllipse_mm = 8;                    // semi-axis on paper
constexpr double kLeastEllipse_mm = 0.05;                   // nothing is seen of smaller ones
constexpr double kLongestName_mm = 18;                      // of a point: some twelve letters
constexpr double kStation_mm = 1.5, kSighted_mm = 0.4, kKeyText = 2.5, kPointText = 1.9,
                 kKeyRow = 4.4;
constexpr double kSight_mm = 0.1, kBetweenStations_mm = 0.25, kEllipse_mm = 0.2;
constexpr const char *kSightInk = "#b9c3cc", *kBetweenInk = "#5b6b78", *kOutlierInk = "#c81e1e",
                     *kEllipseInk = "#1b63b0", *kFixedInk = "#1a1a1a", *kWeakInk = "#8a8a8a";

enum class Role { kPoint, kWeak, kFixed };

struct NetworkPlan {
  const NetworkAdjustment& network;
  LabelRaster window;  ///< without labels: where the axes lie
  Sheet sheet;
  std::vector<bool> is_station;
  double factor = 1;          ///< of the ellipses
  std::vector<Box_mm> taken;  ///< by marks and names
  size_t without_room = 0;

  Vec2 at(size_t point) const {
    const Vec3& p = network.points[point].position;
    return {sheet.view.x + sheet.mm_of(p.x - window.low.u),
            sheet.view.bottom() - sheet.mm_of(p.y - window.low.v)};
  }
  Role role(size_t point) const {
    const Vec3& sigma = network.survey.points[point].sigma_m;
    if (sigma.x == 0 && sigma.y == 0) return Role::kFixed;
    return sigma.x >= 0 || sigma.y >= 0 ? Role::kWeak : Role::kPoint;
  }
};

LabelRaster window_of(const NetworkAdjustment& network) {
  constexpr double kCells = 1000;
  Box3 box;
  for (const AdjustedPoint& p : network.points) box.add(p.position);
  const double longer = std::max(box.max.x - box.min.x, box.max.y - box.min.y);
  const double room = std::max(kLeastNetwork_m, kNetworkRoom * longer);
  LabelRaster window;
  window.low = {box.min.x - room, box.min.y - room};
  window.pixel_m = (longer + 2 * room) / kCells;
  const auto cells = [&](double extent) {
    return static_cast<uint32_t>(std::ceil((extent + 2 * room) / window.pixel_m));
  };
  window.columns = cells(box.max.x - box.min.x);
  window.rows = cells(box.max.y - box.min.y);
  return window;
}

struct Sight {
  size_t from, to;
  bool operator<(const Sight& b) const { return from != b.from ? from < b.from : to < b.to; }
};

void draw_sights(SvgWriter& svg, const NetworkPlan& plan) {
  std::set<Sight> all, outlying;
  for (size_t i = 0; i < plan.network.kinds.size(); ++i) {
    const NetworkObservation& o = plan.network.kinds[i];
    if (o.kind > ObservationKind::kDistance) continue;
    const SurveySight& s = plan.network.survey.sightings[o.sighting];
    const Sight sight{plan.network.survey.setups[s.setup].station, s.target};
    all.insert(sight);
    if (plan.network.observations[i].is_outlier) outlying.insert(sight);
  }
  const auto draw = [&](const Sight& s, const char* colour, double width) {
    svg_line(svg, plan.at(s.from), plan.at(s.to), colour, width);
  };
  for (const Sight& s : all)
    if (!plan.is_station[s.to]) draw(s, kSightInk, kSight_mm);
  for (const Sight& s : all)
    if (plan.is_station[s.to]) draw(s, kBetweenInk, kBetweenStations_mm);
  for (const Sight& s : outlying) draw(s, kOutlierInk, kBetweenStations_mm);
}

void draw_ellipse(SvgWriter& svg, const Vec2& at, double major_mm, double minor_mm,
                  double azimuth_rad) {
  const double degrees = azimuth_rad * 180 / std::numbers::pi - 90;  // from the right, clockwise
  svg.leaf("ellipse", {{"rx", major_mm},
                       {"ry", minor_mm},
                       {"transform", "translate(" + text_of(at.u, 4) + " " + text_of(at.v, 4) +
                                         ") rotate(" + text_of(degrees, 4) + ")"},
                       {"fill", kEllipseInk},
                       {"fill-opacity", 0.12},
                       {"stroke", kEllipseInk},
                       {"stroke-width", kEllipse_mm}});
}

void draw_ellipses(SvgWriter& svg, const NetworkPlan& plan, const FieldTable& points) {
  const auto major = points.require("ellipse_major").values<double>(),
             minor = points.require("ellipse_minor").values<double>(),
             azimuth = points.require("ellipse_azimuth").values<double>();
  const double mm_per_m = kEllipse95 * plan.factor * plan.sheet.mm_of(1);
  for (size_t i = 0; i < major.size(); ++i)
    if (major[i] * mm_per_m > kLeastEllipse_mm)
      draw_ellipse(svg, plan.at(i), major[i] * mm_per_m, minor[i] * mm_per_m, azimuth[i]);
}

void draw_mark(SvgWriter& svg, const Vec2& at, bool is_station, Role role) {
  const char* fill = role == Role::kFixed ? kFixedInk : role == Role::kWeak ? kWeakInk : "#ffffff";
  const double r = is_station             ? kStation_mm
                   : role == Role::kPoint ? kSighted_mm
                                          : kStation_mm * 0.6;
  if (is_station || role != Role::kPoint) {
    const std::vector<Vec2> station{
        {at.u, at.v - r}, {at.u + r, at.v + 0.7 * r}, {at.u - r, at.v + 0.7 * r}};
    const std::vector<Vec2> square{
        {at.u - r, at.v - r}, {at.u + r, at.v - r}, {at.u + r, at.v + r}, {at.u - r, at.v + r}};
    svg.leaf("path", {{"d", svg_polyline(is_station ? station : square) + "Z"},
                      {"fill", fill},
                      {"stroke", kInk},
                      {"stroke-width", 0.2}});
    return;
  }
  svg.leaf("circle", {{"cx", at.u}, {"cy", at.v}, {"r", r}, {"fill", kInk}});
}

// Beside its mark, where nothing stands yet; none without room.
void draw_name(SvgWriter& svg, NetworkPlan& plan, size_t point, bool is_bold) {
  const std::string name =
      fitted_text(plan.network.survey.points[point].id, kPointText, kLongestName_mm);
  const Vec2 at = plan.at(point);
  const double width = text_width(name, kPointText), gap = is_bold ? kStation_mm + 0.6 : 0.9;
  const Vec2 places[] = {{at.u + gap, at.v - kPointText / 2},
                         {at.u - gap - width, at.v - kPointText / 2},
                         {at.u - width / 2, at.v - gap - kPointText},
                         {at.u - width / 2, at.v + gap}};
  const Box_mm& view = plan.sheet.view;
  for (const Vec2& place : places) {
    const Box_mm box{place.u, place.v, width, kPointText};
    if (box.x < view.x || box.y < view.y || box.right() > view.right() ||
        box.bottom() > view.bottom())
      continue;
    const auto meets = [&](const Box_mm& b) {
      return box.x < b.right() && b.x < box.right() && box.y < b.bottom() && b.y < box.bottom();
    };
    if (std::any_of(plan.taken.begin(), plan.taken.end(), meets)) continue;
    plan.taken.push_back(box);
    return svg_text(svg, {box.x, box.bottom() - 0.2 * kPointText}, kPointText, Anchor::kStart, name,
                    is_bold);
  }
  ++plan.without_room;
}

void draw_points(SvgWriter& svg, NetworkPlan& plan) {
  const size_t n = plan.network.points.size();
  for (size_t i = 0; i < n; ++i) {
    const Vec2 at = plan.at(i);
    const double r = plan.is_station[i] ? kStation_mm : kSighted_mm;
    draw_mark(svg, at, plan.is_station[i], plan.role(i));
    plan.taken.push_back({at.u - r, at.v - r, 2 * r, 2 * r});
  }
  for (const bool stations : {true, false})
    for (size_t i = 0; i < n; ++i)
      if (plan.is_station[i] == stations) draw_name(svg, plan, i, stations);
}

void draw_network_key(SvgWriter& svg, const NetworkPlan& plan) {
  const Box_mm& box = plan.sheet.legend;
  const double x = box.x + 3, text_x = x + 9, room = box.right() - text_x - 1;
  double y = std::max(box.y + 4, plan.sheet.view.y);
  const auto entry = [&](const std::string& text) {
    svg_text(svg, {text_x, y + 2.4}, kKeyText, Anchor::kStart, fitted_text(text, kKeyText, room));
    y += kKeyRow;
  };
  const auto mark = [&](bool is_station, Role role, const char* text) {
    draw_mark(svg, {x + 3, y + 1.6}, is_station, role);
    entry(text);
  };
  const auto line = [&](const char* colour, double width, const char* text) {
    svg_line(svg, {x, y + 1.6}, {x + 6, y + 1.6}, colour, width);
    entry(text);
  };
  svg_text(svg, {x, y + 2}, 2.8, Anchor::kStart, "Network", true);
  y += 5;
  mark(true, Role::kPoint, "station");
  mark(true, Role::kFixed, "station on a fixed point");
  mark(false, Role::kFixed, "fixed point");
  mark(false, Role::kWeak, "weak point (grey)");
  mark(false, Role::kPoint, "sighted point");
  line(kBetweenInk, kBetweenStations_mm, "sight between stations");
  line(kSightInk, 2 * kSight_mm, "sight of a point");
  line(kOutlierInk, kBetweenStations_mm, "with an outlier");
  y += 2;
  svg_text(svg, {x, y + 2}, 2.8, Anchor::kStart, "Precision", true);
  y += 5;
  draw_ellipse(svg, {x + 3, y + 1.6}, 3, 1.5, std::numbers::pi / 2);
  entry("95 % ellipse,");
  entry(grouped(static_cast<uint64_t>(plan.factor)) + " times larger");
  // A bar about as long as the largest ellipse.
  const double mm_per_m = plan.factor * plan.sheet.mm_of(1);
  const double bar_m = round_up_125(kLargestEllipse_mm / mm_per_m), bar_mm = bar_m * mm_per_m;
  y += 1;
  const double bar_y = y + 1.6;
  svg_line(svg, {x, bar_y}, {x + bar_mm, bar_y}, kEllipseInk, 0.4);
  for (const double end : {0.0, bar_mm})
    svg_line(svg, {x + end, bar_y - 1}, {x + end, bar_y + 1}, kEllipseInk, 0.4);
  svg_text(svg, {x + bar_mm + 2, y + 2.4}, kKeyText, Anchor::kStart, text_of(1000 * bar_m) + " mm");
  y += kKeyRow + 1;
  if (plan.without_room > 0)
    svg_text(svg, {x, y + 2.4}, 2, Anchor::kStart,
             grouped(plan.without_room) + " names have no room here", false, false, kGrey);
}

}  // namespace

std::string network_plan_svg(const NetworkAdjustment& network, const std::string& title,
                             Task& task) {
  const ProgressSpan span(task, 0, 1, "drawing the plan");
  NetworkPlan plan{network, window_of(network), {}, {}, 1, {}, 0};
  plan.sheet = lay_out_figure(plan.window.width_m(), plan.window.height_m());
  plan.is_station.assign(network.points.size(), false);
  for (const SurveySetup& s : network.survey.setups) plan.is_station[s.station] = true;
  const FieldTable points = network_points(network);
  double greatest = 0;
  for (const double major : points.require("ellipse_major").values<double>())
    greatest = std::max(greatest, kEllipse95 * major);
  const Sheet& sheet = plan.sheet;
  plan.factor = drive_plan_factor(greatest, sheet.mm_of(1), kLargestEllipse_mm);
  SvgWriter svg;
  const std::string text = (title.empty() ? "Network, " : title + ": ") +
                           grouped(network.points.size()) + " points, " +
                           grouped(network.survey.setups.size()) + " setups";
  open_figure(svg, sheet, text);
  draw_picture_title(svg, sheet, text);
  draw_picture_frame(svg, sheet);
  draw_sights(svg, plan);
  draw_ellipses(svg, plan, points);
  draw_points(svg, plan);
  draw_north_arrow(svg, sheet);
  draw_axes(svg, plan.window, sheet, {"East (m)", "North (m)"});
  draw_network_key(svg, plan);
  draw_scale_bar(svg, sheet);
  return svg.take();
}

}  // namespace jalon
