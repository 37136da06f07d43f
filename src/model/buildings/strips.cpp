// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "geometry/polygon_sets.h"
#include "model/buildings/facades.h"

namespace jalon {

namespace {

// Parts of the facade between two cuts, where it is there at all; smaller scraps are of rounding.
std::vector<std::vector<Vec2>> clipped(const std::vector<PolygonWithHoles>& region, double from,
                                       double to, double bottom, double top) {
  const PolygonWithHoles box{{{from, bottom}, {to, bottom}, {to, top}, {from, top}}, {}};
  std::vector<std::vector<Vec2>> outlines;
  constexpr double kScrap_m2 = 1e-3;
  for (PolygonWithHoles& part : combined(SetOperation::kIntersection, region, {&box, 1}))
    if (region_area({&part, 1}) > kScrap_m2) outlines.push_back(std::move(part.outline));
  return outlines;
}

}  // namespace

std::vector<double> strip_cuts(double from_m, double to_m, double width_m,
                               StripRemainder remainder) {
  const double length = to_m - from_m;
  double strips = 0;
  if (remainder == StripRemainder::kEqual) strips = std::max(1.0, std::round(length / width_m));
  else {
    strips = std::floor(length / width_m);
    if (length - strips * width_m >= width_m / 2) ++strips;
    strips = std::max(1.0, strips);
  }
  std::vector<double> cuts;
  for (double k = 0; k < strips; ++k)
    cuts.push_back(from_m + k * (remainder == StripRemainder::kEqual ? length / strips : width_m));
  cuts.push_back(to_m);
  return cuts;
}

std::vector<BuildingStrip> strips_of(const BuildingFacade& facade, uint32_t number,
                                     const BuildingSettings& settings) {
  const std::vector<double> cuts =
      strip_cuts(facade.from_m, facade.to_m, settings.width_m, settings.remainder);
  // Relative to the facade's lower left, for the grid of the polygon operations.
  const Vec2 corner{facade.from_m, facade.bottom_m};
  std::vector<PolygonWithHoles> region;
  if (settings.top == StripTop::kClip) {
    for (const auto& ring : facade.pieces) {
      PolygonWithHoles piece;
      for (const Vec2& p : ring) piece.outline.push_back(p - corner);
      region.push_back(std::move(piece));
    }
    region = combined(SetOperation::kUnion, region, {});
  }
  const double height = facade.top_m - facade.bottom_m;
  std::vector<BuildingStrip> made;
  for (size_t k = 0; k + 1 < cuts.size(); ++k) {
    BuildingStrip strip{number, cuts[k], cuts[k + 1], {}};
    const double from = cuts[k] - corner.u, to = cuts[k + 1] - corner.u;
    if (settings.top == StripTop::kClip) strip.outlines = clipped(region, from, to, 0, height);
    else strip.outlines = {{{from, 0}, {to, 0}, {to, height}, {from, height}}};
    for (auto& outline : strip.outlines)
      for (Vec2& p : outline) p = p + corner;
    if (!strip.outlines.empty()) made.push_back(std::move(strip));
  }
  return made;
}

}  // namespace jalon
