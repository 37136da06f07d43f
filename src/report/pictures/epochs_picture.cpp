// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pictures/epochs_picture.h"

#include <algorithm>
#include <cmath>

#include "formats/drawings/pixels.h"
#include "report/pictures/deviation_raster.h"
#include "geometry/plane.h"
#include "report/pictures/shown_image.h"
#include "report/sheet/svg_parts.h"
#include "report/sheet/ticks.h"

namespace jalon {

namespace {

// Millimetres of the figure.
constexpr double kEpochsWidth = 180, kEpochsGap = 6, kEpochsMostHeight = 80, kEpochsAbove = 7,
                 kEpochsBelow = 10, kEpochsRim = 0.4, kEpochsText = 3;
constexpr double kBarShare = 0.25;  // of a panel's width, at least, that the scale bar takes

// The points of a comparison within the window, with what is drawn of them.
Comparison part_of(const Comparison& comparison, const Box3& window, Task& task) {
  const Vec3 centre = (window.min + window.max) * 0.5;
  std::vector<Neighbour> found;
  comparison.cloud->octree(task)->radius(centre, norm(window.max - window.min) / 2, found);
  std::vector<uint64_t> kept;
  for (const Neighbour& n : found)
    if (window.contains(comparison.cloud->point(n.index))) kept.push_back(n.index);
  std::sort(kept.begin(), kept.end());
  const auto distance = comparison.points.require("distance").values<double>();
  const auto status = comparison.points.require("status").values<uint8_t>();
  Buffer<double> xyz(3 * kept.size());
  std::vector<double> distances;
  std::vector<uint8_t> statuses;
  for (size_t k = 0; k < kept.size(); ++k) {
    const Vec3 p = comparison.cloud->point(kept[k]);
    for (size_t c = 0; c < 3; ++c) xyz[3 * k + c] = p[static_cast<int>(c)];
    distances.push_back(distance[kept[k]]);
    statuses.push_back(status[kept[k]]);
  }
  Comparison out;
  out.cloud = std::make_shared<const Cloud>(make_cloud(std::move(xyz)));
  out.points.set(make_column<double>({"distance", ElementType::kFloat64, 1, "m"}, distances));
  out.points.set(make_column<uint8_t>({"status", ElementType::kUint8, 1, ""}, statuses));
  return out;
}

void draw_points(SvgWriter& svg, const LabelRaster& raster, const DeviationScale& scale,
                 const Vec2& low, const Vec2& high, const Box_mm& at) {
  const double mm = at.width / (high.u - low.u);
  svg.open("svg", {{"x", at.x}, {"y", at.y}, {"width", at.width}, {"height", at.height}});
  if (!raster.labels.empty())
    draw_shown_image(
        svg,
        {(raster.low.u - low.u) * mm, at.height - (raster.low.v + raster.height_m() - low.v) * mm,
         raster.width_m() * mm, raster.height_m() * mm},
        deviation_image(raster, scale));
  svg.close();
}

void draw_bar(SvgWriter& svg, const Box_mm& panel, double mm_a_metre) {
  const double metres = round_up_125(kBarShare * panel.width / mm_a_metre);
  const double y = panel.bottom() + 3, end = panel.x + metres * mm_a_metre;
  svg_line(svg, {panel.x, y}, {end, y}, kInk, 0.5);
  for (const double x : {panel.x, end}) svg_line(svg, {x, y - 1}, {x, y + 1}, kInk, 0.3);
  const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(metres) - 1e-9)));
  svg_text(svg, {end + 1.5, y + 1}, kEpochsText, Anchor::kStart, text_of(metres, decimals) + " m");
}

// What is looked at, and how: a plane that changed from before it, what lies level from above; heights stay upright.
struct EpochsView {
  Projection projection;
  Vec2 low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
  const char* axes = "X to the right, Y up";
};

EpochsView view_of(std::span<const Vec3> changed, double around_m) {
  constexpr double kUpright = 0.7;  // |z| of the normal of what is looked at from the side
  Moments moments;
  moments.reference = changed.front();
  for (const Vec3& p : changed) moments.add(p);
  const Vec3 n = symmetric_eigen(moments.covariance()).vectors[0];
  EpochsView out;
  out.projection = {moments.centroid(), {1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {}};
  if (std::abs(n.z) < kUpright) {
    const Vec3 level = normalized(Vec3{n.x, n.y, 0}), right{level.y, -level.x, 0};
    const double side = right.x + right.y > 0 ? 1 : -1;
    out.projection.right = right * side;
    out.projection.up = {0, 0, 1};
    out.projection.into = level * side;
    out.axes = "seen from the side, Z up";
  }
  for (const Vec3& p : changed) {
    const Vec2 at = out.projection.flat(p);
    out.low = {std::min(out.low.u, at.u - around_m), std::min(out.low.v, at.v - around_m)};
    out.high = {std::max(out.high.u, at.u + around_m), std::max(out.high.v, at.v + around_m)};
  }
  return out;
}

}  // namespace

std::string epochs_svg(std::span<const EpochPanel> panels, std::span<const Vec3> changed,
                       double around_m, const DeviationScale& scale, Task& task) {
  const EpochsView view = view_of(changed, around_m);
  const Vec2 low = view.low, high = view.high;
  const auto count = static_cast<double>(std::max<size_t>(1, panels.size()));
  const double room = (kEpochsWidth - (count - 1) * kEpochsGap) / count - kEpochsRim;
  const double mm = std::min(room / (high.u - low.u), kEpochsMostHeight / (high.v - low.v));
  const Box_mm first{0, kEpochsAbove, (high.u - low.u) * mm, (high.v - low.v) * mm};
  SvgWriter svg;
  svg.open("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
                   {"xmlns:xlink", "http://www.w3.org/1999/xlink"},
                   {"viewBox", "0 0 " + svg_number(kEpochsWidth) + " " +
                                   svg_number(first.bottom() + kEpochsBelow)},
                   {"font-family", "Helvetica, Arial, sans-serif"}});
  svg.element("title", {}, "Both epochs of the place");
  Box3 window;
  for (const Vec3& p : changed) window.add(p);
  const Vec3 around{around_m, around_m, around_m};
  window = {window.min - around, window.max + around};
  for (size_t k = 0; k < panels.size(); ++k) {
    Box_mm at = first;
    at.x = static_cast<double>(k) * (room + kEpochsGap) + kEpochsRim / 2;
    svg_text(svg, {at.x, kEpochsAbove - 2}, kEpochsText, Anchor::kStart, panels[k].caption, true);
    const Comparison part = part_of(*panels[k].comparison, window, task);
    draw_points(svg, deviation_raster(part, scale, view.projection, false, task), scale, low, high,
                at);
    const PictureMark mark[] = {{"", {changed.begin(), changed.end()}}};
    const auto place = [&](const Vec3& p) {
      const Vec2 flat = view.projection.flat(p);
      return Vec2{at.x + (flat.u - low.u) * mm, at.bottom() - (flat.v - low.v) * mm};
    };
    draw_picture_marks(svg, mark, place, at);
    svg.leaf("rect", {{"x", at.x},
                      {"y", at.y},
                      {"width", at.width},
                      {"height", at.height},
                      {"fill", "none"},
                      {"stroke", kInk},
                      {"stroke-width", 0.25}});
  }
  Box_mm below = first;
  below.x = kEpochsRim / 2;
  draw_bar(svg, below, mm);
  svg_text(svg, {below.x, below.bottom() + 8.5}, 0.85 * kEpochsText, Anchor::kStart, view.axes,
           false, false, kGrey);
  return svg.take();
}

}  // namespace jalon
