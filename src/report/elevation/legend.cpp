// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/elevation/legend.h"

#include <algorithm>

#include "base/text_number.h"
#include "model/part_classes.h"

namespace jalon {

namespace {

using Sign = LegendItem::Sign;

constexpr double kLegendText = 2.5, kRow = 4.6, kSwatch = 7, kSwatchHeight = 3.4;

std::string depth_text(double depth_m) {
  const std::string number = text_of(depth_m, 2);
  const bool is_positive = number.front() != '-' && number != "0.00";
  return std::string(is_positive ? "+" : "").append(number);
}

std::string group_text(const DepthGroup& group) {
  const std::string from = depth_text(group.from_m), to = depth_text(group.to_m);
  return (from == to ? from : from + " to " + to) +
         (group.faces > 1 ? " (" + std::to_string(group.faces) + ")" : "");
}

// "shop front"; "other opening".
std::string class_text(std::string_view word) {
  if (word == part_class::kOpening) return "other opening";
  std::string out(word);
  std::replace(out.begin(), out.end(), '_', ' ');
  return out;
}

void add_depths(std::vector<LegendItem>& items, const ElevationFaces& faces,
                const ElevationContent& content) {
  if (faces.groups.empty() || content.colours == ElevationColours::kNone) return;
  items.push_back({Sign::kHeading, "", "Depth from main plane (m)", "", ""});
  items.push_back({Sign::kNote, "", "+ behind, - in front; (n) faces", "", ""});
  for (size_t i = 0; i < faces.groups.size(); ++i)
    items.push_back({Sign::kSwatch, group_colour(faces, i, content.colours),
                     group_text(faces.groups[i]), "", ""});
  items.push_back({Sign::kGap, "", "", "", ""});
}

void add_signs(std::vector<LegendItem>& items, const ElevationFaces& faces,
               const ElevationContent& content) {
  const auto add = [&](bool occurs, Sign sign, const std::string& colour, const char* text) {
    if (occurs) items.push_back({sign, colour, text, "", ""});
  };
  const auto any_face = [&](auto test) {
    return std::any_of(faces.faces.begin(), faces.faces.end(), test);
  };
  const auto any_opening = [&](auto test) {
    return std::any_of(faces.openings.begin(), faces.openings.end(),
                       [&](const DrawnOpening& o) { return test(o, faces.list.rows[o.row]); });
  };
  const auto has_class = [&](const char* c) {
    return faces.has_named_openings &&
           any_opening([&](const DrawnOpening&, const OpeningRow& r) { return r.part_class == c; });
  };
  for (const char* word : part_class::kOpenings)
    add(has_class(word), Sign::kLine, opening_colour(word), class_text(word).c_str());
  add(any_opening([](const DrawnOpening&, const OpeningRow& r) { return r.is_copy(); }) ||
          any_face([](const DrawnFace& f) { return f.is_copy; }),
      Sign::kDashes, kInk, "copied: not measured here");
  add(any_opening([](const DrawnOpening& o, const OpeningRow&) { return o.is_empty; }),
      Sign::kCross, kGrey, "nothing seen in it");
  add(any_face([](const DrawnFace& f) {
        return f.kind == DrawnFace::Kind::kEdgeOn && f.role != DrawnFace::Role::kGround;
      }),
      Sign::kLine, kEdgeOn, "plane seen edge-on");
  add(any_face([](const DrawnFace& f) {
        return f.kind == DrawnFace::Kind::kEdgeOn && f.role == DrawnFace::Role::kGround;
      }),
      Sign::kLine, kInk, "ground");
  add(any_face([](const DrawnFace& f) { return f.kind == DrawnFace::Kind::kSlanted; }),
      Sign::kSwatch, kSlantedFill, "plane seen at an angle");
  add(!faces.unknown.empty() ||
          any_face([](const DrawnFace& f) { return f.role == DrawnFace::Role::kNoData; }),
      Sign::kSwatch, "url(#unknown" + content.id + ")", "no data");
}

void add_types(std::vector<LegendItem>& items, const ElevationFaces& faces) {
  if (!faces.has_named_openings || faces.openings.empty()) return;
  items.push_back({Sign::kGap, "", "", "", ""});
  items.push_back({Sign::kHeading, "", "Openings", "", ""});
  items.push_back({Sign::kNote, "", "width x height (m), number", "", ""});
  std::vector<size_t> shown(faces.list.types.size());
  for (const DrawnOpening& opening : faces.openings) ++shown[faces.list.rows[opening.row].type];
  for (size_t i = 0; i < shown.size(); ++i) {
    const OpeningType& type = faces.list.types[i];
    if (shown[i] == 0) continue;
    items.push_back({Sign::kType, opening_colour(type.part_class),
                     text_of(type.width_m, 2) + " x " + text_of(type.height_m, 2) +
                         (type.arched ? " arch" : ""),
                     type.tag, std::to_string(shown[i])});
  }
}

double height_of(const LegendItem& item) {
  return item.sign == Sign::kGap ? 2.5 : item.sign == Sign::kNote ? 4.4 : kRow;
}

void draw_sign(SvgWriter& svg, const LegendItem& item, double x, double y) {
  const double middle = y + kSwatchHeight / 2;
  switch (item.sign) {
    case Sign::kSwatch:
    case Sign::kCross:
      svg.leaf("rect", {{"x", x},
                        {"y", y},
                        {"width", kSwatch},
                        {"height", kSwatchHeight},
                        {"fill", item.sign == Sign::kCross ? "#ffffff" : item.colour},
                        {"stroke", kInk},
                        {"stroke-width", 0.18}});
      if (item.sign == Sign::kSwatch) break;
      svg_line(svg, {x, y}, {x + kSwatch, y + kSwatchHeight}, kGrey, 0.13);
      svg_line(svg, {x, y + kSwatchHeight}, {x + kSwatch, y}, kGrey, 0.13);
      break;
    case Sign::kLine:
    case Sign::kDashes:
      svg.leaf("line", {{"x1", x},
                        {"y1", middle},
                        {"x2", x + kSwatch},
                        {"y2", middle},
                        {"stroke", item.colour},
                        {"stroke-width", 0.4},
                        {"stroke-dasharray", item.sign == Sign::kDashes ? "1.4 0.8" : "none"}});
      break;
    default:
      break;
  }
}

void draw_item(SvgWriter& svg, const LegendItem& item, double x, double y, double width) {
  const double base = y + 2.6;
  switch (item.sign) {
    case Sign::kGap:
      return;
    case Sign::kHeading:
      return svg_text(svg, {x, base}, 2.8, Anchor::kStart, item.text, true);
    case Sign::kNote:
      return svg_text(svg, {x, y + 1.6}, 2, Anchor::kStart, item.text, false, false, kGrey);
    case Sign::kType:
      svg_text(svg, {x, base}, kLegendText, Anchor::kStart, item.tag, true, false,
               item.colour.c_str());
      svg_text(svg, {x + kSwatch + 2, base}, kLegendText, Anchor::kStart, item.text);
      return svg_text(svg, {x + width, base}, kLegendText, Anchor::kEnd, item.count);
    default:
      break;
  }
  draw_sign(svg, item, x, y);
  svg_text(svg, {x + kSwatch + 2, base}, kLegendText, Anchor::kStart, item.text);
}

}  // namespace

std::vector<LegendItem> legend_items(const ElevationFaces& faces, const ElevationContent& content) {
  std::vector<LegendItem> items;
  if (faces.empty) return items;
  add_depths(items, faces, content);
  add_signs(items, faces, content);
  add_types(items, faces);
  return items;
}

double legend_height(const std::vector<LegendItem>& items) {
  double sum = 8;
  for (const LegendItem& item : items) sum += height_of(item);
  return sum;
}

void draw_legend(SvgWriter& svg, const std::vector<LegendItem>& items, const Sheet& sheet) {
  const double x = sheet.legend.x + 3, width = sheet.legend.width - 6;
  double y = sheet.legend.y + 5;
  for (size_t i = 0; i < items.size(); ++i) {
    const bool is_last = i + 1 == items.size();
    if (y + kRow * (is_last ? 1 : 2) > sheet.legend.bottom()) {
      svg_text(svg, {x, y + 2.6}, kLegendText, Anchor::kStart,
               "and " + std::to_string(items.size() - i) + " more lines");
      return;
    }
    draw_item(svg, items[i], x, y, width);
    y += height_of(items[i]);
  }
}

}  // namespace jalon
