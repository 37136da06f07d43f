// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pictures/code_plan.h"

#include <algorithm>
#include <cmath>

#include "cloud/cloud.h"
#include "report/elevation/title_block.h"
#include "report/pictures/picture_axes.h"
#include "report/pictures/shown_image.h"
#include "report/sheet/svg_parts.h"

namespace jalon {

namespace {

constexpr double kCodePlanText = 2.5, kCodeText = 1.5, kCodePlanRow = 4.2, kCodeSwatch = 6;
constexpr double kRoomAround = 0.04;    // of the longer side, about the objects
constexpr double kLeastRoom_m = 1;      // about the objects
constexpr double kReach_m = 1e5;        // from the scan: what is told to be farther off is a slip
constexpr double kLeastPixel_m = 0.01;  // a scan's own spacing is no finer on paper
constexpr double kOutline_mm = 0.25, kOpening_mm = 0.6, kPoint_mm = 0.3, kLeastGutter_mm = 0.6;
constexpr const char *kOpeningInk = "#7a3b00", *kGutterInk = "#a00000";
constexpr Rgb kClassColours[] = {{0xc4, 0xd8, 0xf0}, {0x5d, 0xb0, 0x6a}, {0xf2, 0xd1, 0x1b},
                                 {0xf2, 0x8c, 0x28}, {0xd6, 0x27, 0x28}, {0x8e, 0x6b, 0xbf},
                                 {0x9c, 0x75, 0x5f}, {0x4f, 0x9d, 0xa6}};

struct CodePlan {
  const Segmentation& segmentation;
  const CodedNotes& notes;
  LabelRaster raster;  ///< place in kClassColours + 1
  Sheet sheet;
  std::vector<Box_mm> taken;  ///< by codes
  size_t without_room = 0;

  Vec2 at(const Vec3& p) const {
    return {sheet.view.x + sheet.mm_of(p.x - raster.low.u),
            sheet.view.bottom() - sheet.mm_of(p.y - raster.low.v)};
  }
};

uint32_t colour_of_class(int64_t class_code) {
  constexpr int64_t kKnown = 5, kOthers = 3;
  return static_cast<uint32_t>(class_code < kKnown ? class_code
                                                   : kKnown + (class_code - kKnown) % kOthers);
}

Box3 code_window(const Segmentation& segmentation, const CodedNotes& notes) {
  const Cloud& cloud = *segmentation.cloud;
  const Vec3 here = cloud.size() > 0 ? cloud.point(0) : Vec3{};
  Box3 box;
  const auto add = [&](const Vec3& p) {
    if (std::abs(p.x - here.x) <= kReach_m && std::abs(p.y - here.y) <= kReach_m) box.add(p);
  };
  for (const NotedObject& o : notes.objects) {
    for (const NotedPoint& p : o.surveyed) add(p.place);
    for (const Vec3& p : o.outline) add(p);
    for (const Vec3& p : o.axis) add(p);
  }
  const auto labels = segmentation.labels->values<uint32_t>();
  for (size_t i = 0; i < labels.size(); ++i)  // walls reach beyond their targets
    if (labels[i] != 0) add(cloud.point(i));
  if (box.empty())
    for (size_t i = 0; i < cloud.size(); ++i) add(cloud.point(i));
  if (box.empty()) box.add(here);
  const double room =
      std::max(kLeastRoom_m, kRoomAround * std::max(box.max.x - box.min.x, box.max.y - box.min.y));
  return {{box.min.x - room, box.min.y - room, 0}, {box.max.x + room, box.max.y + room, 0}};
}

// The highest class of each pixel's points: a plan sees windows and gutters under eaves and roofs.
LabelRaster class_raster(const Segmentation& segmentation, const CodedNotes& notes, Task& task) {
  const Box3 box = code_window(segmentation, notes);
  const double width = box.max.x - box.min.x, height = box.max.y - box.min.y;
  LabelRaster raster;
  raster.pixel_m = std::max(kLeastPixel_m, std::sqrt(width * height / kMaxPicturePixels));
  raster.columns = static_cast<uint32_t>(std::ceil(width / raster.pixel_m));
  raster.rows = static_cast<uint32_t>(std::ceil(height / raster.pixel_m));
  raster.low = {box.min.x, box.min.y};
  raster.labels.assign(size_t{raster.columns} * raster.rows, LabelRaster::kEmpty);
  std::vector<uint32_t> colour(segmentation.segments.size() + 1, 1);
  for (const NotedObject& o : notes.objects)
    if (o.label != 0 && o.label < colour.size())
      colour[o.label] = 1 + colour_of_class(o.class_code);
  const auto labels = segmentation.labels->values<uint32_t>();
  constexpr size_t kPointsPerLook = 1 << 20;
  for (size_t i = 0; i < labels.size(); ++i) {
    if (i % kPointsPerLook == 0)
      task.checkpoint(static_cast<double>(i) / static_cast<double>(labels.size()));
    const Vec3 p = segmentation.cloud->point(i);
    const double column = (p.x - raster.low.u) / raster.pixel_m,
                 row = (p.y - raster.low.v) / raster.pixel_m;
    if (!(column >= 0 && row >= 0 && column < raster.columns && row < raster.rows)) continue;
    const size_t from_top = raster.rows - 1 - static_cast<size_t>(row);
    uint32_t& pixel = raster.labels[from_top * raster.columns + static_cast<size_t>(column)];
    pixel = std::max(pixel, colour[labels[i]]);
  }
  return raster;
}

void draw_class_points(SvgWriter& svg, const CodePlan& plan) {
  IndexedImage image{plan.raster.columns, plan.raster.rows, {}, {{0xff, 0xff, 0xff}}};
  for (const Rgb& colour : kClassColours) image.palette.push_back(colour);
  for (const uint32_t label : plan.raster.labels)
    image.pixels.push_back(static_cast<uint8_t>(label));
  draw_shown_image(svg, plan.sheet.view, image);
}

void draw_lines(SvgWriter& svg, const std::vector<Vec2>& points, bool is_closed, const char* colour,
                double width_mm, bool is_dashed = false) {
  std::string d = svg_polyline(points);
  if (is_closed) d += "Z";
  svg.leaf("path", {{"d", d},
                    {"fill", "none"},
                    {"stroke", colour},
                    {"stroke-width", width_mm},
                    {"stroke-linejoin", "round"},
                    {"stroke-dasharray", is_dashed ? "1.2 0.8" : "none"}});
}

void draw_object(SvgWriter& svg, const CodePlan& plan, const NotedObject& o) {
  std::vector<Vec2> line;
  for (const Vec3& p : o.outline) line.push_back(plan.at(p));
  if (o.shape == "prism") return draw_lines(svg, line, true, kInk, kOutline_mm);
  if (!line.empty()) {
    // In plan an opening is the line between its two ends.
    const auto ends = std::minmax_element(
        line.begin(), line.end(),
        [](const Vec2& a, const Vec2& b) { return a.u != b.u ? a.u < b.u : a.v < b.v; });
    return draw_lines(svg, {*ends.first, *ends.second}, false, kOpeningInk, kOpening_mm);
  }
  if (o.shape == "cylinder" && !o.axis.empty()) {
    for (const Vec3& p : o.axis) line.push_back(plan.at(p));
    if (line.size() > 2) draw_lines(svg, line, false, kGutterInk, kOutline_mm);
    svg.leaf("circle", {{"cx", line.front().u},
                        {"cy", line.front().v},
                        {"r", std::max(kLeastGutter_mm, plan.sheet.mm_of(o.radius_m))},
                        {"fill", "none"},
                        {"stroke", kGutterInk},
                        {"stroke-width", kOutline_mm}});
    return;
  }
  for (const NotedPoint& p : o.surveyed) line.push_back(plan.at(p.place));
  if (o.geometry == "line" || o.geometry == "window_target")
    draw_lines(svg, line, false, kGrey, kOutline_mm, true);
}

// Right, left, above or below its point, where no other code stands; none without room.
void draw_code(SvgWriter& svg, CodePlan& plan, const NotedPoint& point) {
  const Vec2 at = plan.at(point.place);
  const double width = text_width(point.code, kCodeText), gap = 1.0;
  const struct {
    double x, y;
  } places[] = {{at.u + gap, at.v - kCodeText / 2},
                {at.u - gap - width, at.v - kCodeText / 2},
                {at.u - width / 2, at.v - gap - kCodeText},
                {at.u - width / 2, at.v + gap}};
  const Box_mm& view = plan.sheet.view;
  for (const auto& place : places) {
    const Box_mm box{place.x, place.y, width, kCodeText};
    const bool is_inside = box.x > view.x && box.y > view.y && box.right() < view.right() &&
                           box.bottom() < view.bottom();
    const bool is_free =
        std::none_of(plan.taken.begin(), plan.taken.end(), [&](const Box_mm& other) {
          return box.x < other.right() && other.x < box.right() && box.y < other.bottom() &&
                 other.y < box.bottom();
        });
    if (!is_inside || !is_free) continue;
    plan.taken.push_back(box);
    svg_text(svg, {box.x, box.bottom() - 0.2 * kCodeText}, kCodeText, Anchor::kStart, point.code);
    return;
  }
  ++plan.without_room;
}

void draw_surveyed(SvgWriter& svg, CodePlan& plan) {
  for (const NotedObject& o : plan.notes.objects)
    for (const NotedPoint& p : o.surveyed) {
      const Vec2 at = plan.at(p.place);
      svg.leaf("circle", {{"cx", at.u}, {"cy", at.v}, {"r", kPoint_mm}, {"fill", kInk}});
    }
  for (const NotedObject& o : plan.notes.objects)
    if (!o.axis.empty() && o.shape == "cylinder") {
      const Vec2 at = plan.at(o.axis.front());
      const double r = std::max(kLeastGutter_mm, plan.sheet.mm_of(o.radius_m)) + kOutline_mm;
      plan.taken.push_back({at.u - r, at.v - r, 2 * r, 2 * r});
    }
  // Corners of buildings first, then one code an object.
  for (const NotedObject& o : plan.notes.objects)
    if (o.shape == "prism")
      for (const NotedPoint& p : o.surveyed) draw_code(svg, plan, p);
  for (const NotedObject& o : plan.notes.objects)
    if (o.shape != "prism" && !o.surveyed.empty()) draw_code(svg, plan, o.surveyed.front());
}

std::string name_of_class(const CodedNotes& notes, uint32_t colour) {
  std::string names;
  for (const NotedObject& o : notes.objects)
    if (colour_of_class(o.class_code) == colour && names.find(o.kind) == std::string::npos)
      names += (names.empty() ? "" : ", ") + o.kind;
  return colour == 0 ? "rest" : names;
}

void draw_code_key(SvgWriter& svg, const CodePlan& plan) {
  const Box_mm& box = plan.sheet.legend;
  const double x = box.x + 3, text_x = x + kCodeSwatch + 2, room = box.right() - text_x - 1;
  double y = std::max(box.y + 4, plan.sheet.view.y);
  const auto heading = [&](const char* text) {
    svg_text(svg, {x, y + 2}, 2.8, Anchor::kStart, text, true);
    y += 4.5;
  };
  const auto entry = [&](const std::string& text) {
    svg_text(svg, {text_x, y + 2.5}, kCodePlanText, Anchor::kStart,
             fitted_text(text, kCodePlanText, room));
    y += kCodePlanRow;
  };
  std::array<uint64_t, std::size(kClassColours)> points{};
  points[0] = plan.segmentation.cloud->size();
  for (const NotedObject& o : plan.notes.objects) {
    points[colour_of_class(o.class_code)] += o.points;
    points[0] -= o.points;
  }
  heading("Classes (points)");
  for (uint32_t c = 0; c < points.size(); ++c) {
    const std::string name = name_of_class(plan.notes, c);
    if (name.empty()) continue;
    svg.leaf("rect", {{"x", x},
                      {"y", y},
                      {"width", kCodeSwatch},
                      {"height", 3},
                      {"fill", hex_of(kClassColours[c])},
                      {"stroke", kInk},
                      {"stroke-width", 0.18}});
    entry(name + "  (" + grouped(points[c]) + ")");
  }
  y += 2;
  heading("Coded objects");
  const auto symbol = [&](const char* colour, double width_mm, const char* text) {
    svg_line(svg, {x, y + 1.6}, {x + kCodeSwatch, y + 1.6}, colour, width_mm);
    entry(text);
  };
  symbol(kInk, kOutline_mm, "outline of a building");
  symbol(kOpeningInk, kOpening_mm, "door or window");
  svg.leaf("circle", {{"cx", x + kCodeSwatch / 2},
                      {"cy", y + 1.6},
                      {"r", kLeastGutter_mm},
                      {"fill", "none"},
                      {"stroke", kGutterInk},
                      {"stroke-width", kOutline_mm}});
  entry("gutter");
  svg.leaf("circle",
           {{"cx", x + kCodeSwatch / 2}, {"cy", y + 1.6}, {"r", kPoint_mm}, {"fill", kInk}});
  entry("surveyed point, code");
  if (plan.without_room > 0)
    svg_text(svg, {x, y + 2.5}, 2, Anchor::kStart,
             std::to_string(plan.without_room) + " codes have no room here", false, false, kGrey);
}

}  // namespace

Rgb class_colour(int64_t class_code) { return kClassColours[colour_of_class(class_code)]; }

std::string code_plan_svg(const Segmentation& segmentation, const CodedNotes& notes,
                          const std::string& title, Task& task) {
  const ProgressSpan span(task, 0, 1, "drawing the plan");
  CodePlan plan{segmentation, notes, class_raster(segmentation, notes, task), {}, {}, 0};
  plan.sheet = lay_out_figure(plan.raster.width_m(), plan.raster.height_m());
  const Sheet& sheet = plan.sheet;
  SvgWriter svg;
  const std::string text = (title.empty() ? "Plan, " : title + ": plan, ") +
                           grouped(notes.objects.size()) + " coded objects, " +
                           grouped(segmentation.cloud->size()) + " points";
  open_figure(svg, sheet, text);
  draw_picture_title(svg, sheet, text);
  draw_class_points(svg, plan);
  draw_picture_frame(svg, sheet);
  for (const NotedObject& o : notes.objects) draw_object(svg, plan, o);
  draw_surveyed(svg, plan);
  draw_north_arrow(svg, sheet);
  draw_axes(svg, plan.raster, sheet, {"East (m)", "North (m)"});
  draw_code_key(svg, plan);
  draw_scale_bar(svg, sheet);
  return svg.take();
}

}  // namespace jalon
