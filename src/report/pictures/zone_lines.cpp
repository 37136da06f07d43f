// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pictures/zone_lines.h"

#include <algorithm>
#include <cmath>

#include "compare/landslide/cell_rings.h"
#include "report/sheet/svg_parts.h"

namespace jalon {

namespace {

constexpr double kZoneLine_mm = 0.5, kUnmeasuredLine_mm = 0.15, kHatchApart_mm = 1.4,
                 kHatchLine_mm = 0.18, kZoneText_mm = 2.5, kKeyStep_mm = 5, kKeyWidth_mm = 5;
constexpr size_t kFewestHatched = 4;  // cells: fewer are gaps between the lines of a scan
// Of the ends of the scale of distances, darker: blue went down, red rose.
constexpr const char *kDownColour = "#08306b", *kUpColour = "#7f0000", *kHatchColour = "#555555";

// The rings of the pieces, each at the mean height of its cells.
std::string path_of(const CellTable& cells, const std::vector<CellPiece>& pieces,
                    const std::function<Vec2(const Vec3&)>& place, const Comparison& comparison) {
  std::string out;
  for (const CellPiece& piece : pieces) {
    double height = 0;
    for (const uint32_t row : piece.rows)
      height += dot(comparison.cloud->point(row) - cells.first, cells.up);
    height /= static_cast<double>(piece.rows.size());
    std::vector<std::vector<Vec2>> rings;
    const auto add = [&](const std::vector<Vec2>& ring) {
      auto& flat = rings.emplace_back();
      for (const Vec2& p : ring)
        flat.push_back(place(cells.first + cells.u * p.u + cells.v * p.v + cells.up * height));
    };
    add(piece.outline);
    for (const auto& opening : piece.openings) add(opening);
    out += svg_rings(rings);
  }
  return out;
}

// A stroke from corner to corner of the cells on every so-manieth diagonal: together they are long lines.
std::string hatching(const CellTable& cells, const std::vector<CellPiece>& pieces,
                     const std::function<Vec2(const Vec3&)>& place, const Comparison& comparison) {
  const Vec2 a = place(cells.first), b = place(cells.first + (cells.u + cells.v) * cells.cell_m);
  const double step_mm = std::max(1e-3, norm(b - a));
  const auto apart = static_cast<int64_t>(std::max(1.0, std::ceil(kHatchApart_mm / step_mm)));
  std::string out;
  for (const CellPiece& piece : pieces)
    for (const uint32_t row : piece.rows) {
      const int64_t c = cells.column[row], r = cells.line[row];
      if ((c - r) % apart != 0) continue;
      const double height = dot(comparison.cloud->point(row) - cells.first, cells.up);
      const Vec2 ends[] = {place(cells.corner(c, r, height)),
                           place(cells.corner(c + 1, r + 1, height))};
      out += svg_polyline(ends);
    }
  return out;
}

}  // namespace

void draw_zone_lines(SvgWriter& svg, const Comparison& comparison,
                     const std::function<Vec2(const Vec3&)>& place) {
  const CellTable cells(comparison);
  const auto unmeasured = cell_pieces(
      cells, [&](size_t row) { return !cells.is_measured(row); }, kFewestHatched);
  for (const bool is_outline : {false, true})
    if (!unmeasured.empty())
      svg.leaf("path", {{"d", is_outline ? path_of(cells, unmeasured, place, comparison)
                                         : hatching(cells, unmeasured, place, comparison)},
                        {"fill", "none"},
                        {"stroke", kHatchColour},
                        {"stroke-width", is_outline ? kUnmeasuredLine_mm : kHatchLine_mm}});
  uint32_t most = 0;
  for (const uint32_t label : cells.zone) most = std::max(most, label);
  for (uint32_t label = 1; label <= most; ++label) {
    double moved = 0;
    for (size_t i = 0; i < cells.size(); ++i)
      if (cells.zone[i] == label) moved += cells.distance[i];
    const auto pieces = cell_pieces(
        cells, [&](size_t row) { return cells.zone[row] == label; }, 1);
    svg.leaf("path", {{"d", path_of(cells, pieces, place, comparison)},
                      {"fill", "none"},
                      {"stroke", moved < 0 ? kDownColour : kUpColour},
                      {"stroke-width", kZoneLine_mm},
                      {"stroke-linejoin", "round"}});
  }
}

void draw_zone_key(SvgWriter& svg, double x, double y) {
  const auto row = [&](int place, const char* text, const char* colour) {
    const double at = y + place * kKeyStep_mm;
    if (colour != nullptr)
      svg_line(svg, {x, at + 1.5}, {x + kKeyWidth_mm, at + 1.5}, colour, kZoneLine_mm);
    else
      for (const double stroke : {0.0, 1.0, 2.0})
        svg_line(svg, {x + stroke, at + 3}, {x + stroke + 3, at}, kHatchColour, kHatchLine_mm);
    svg_text(svg, {x + kKeyWidth_mm + 2, at + 2.4}, kZoneText_mm, Anchor::kStart, text);
  };
  row(0, "not measured", nullptr);
  row(1, "outline: went down", kDownColour);
  row(2, "outline: rose", kUpColour);
}

}  // namespace jalon
