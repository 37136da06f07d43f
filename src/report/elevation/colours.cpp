// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/elevation/colours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "model/part_classes.h"
#include "report/sheet/svg_parts.h"

namespace jalon {

namespace {

using Colour = std::array<double, 3>;

// ColorBrewer YlGnBu, Reds and Greens (Harrower & Brewer 2003): lightness falls all the way, also in grey; the greens
// lean to blue, so that the colour-blind tell them from the reds.
constexpr std::array<Colour, 6> kDepths{{{255, 247, 214},
                                         {199, 233, 180},
                                         {127, 205, 187},
                                         {65, 158, 196},
                                         {38, 98, 168},
                                         {22, 40, 108}}};
constexpr std::array<Colour, 3> kInFront{{{253, 222, 206}, {246, 172, 145}, {222, 106, 80}}};
constexpr std::array<Colour, 3> kBehind{{{218, 240, 226}, {150, 208, 186}, {76, 160, 146}}};
constexpr const char* kMainPlane = "#f7f3e8";
constexpr const char* kPaper = "#ffffff";

std::string hex(const Colour& colour) {
  constexpr char kHex[] = "0123456789abcdef";
  std::string out = "#";
  for (const double c : colour) {
    const auto value = static_cast<unsigned>(std::lround(c));
    out += kHex[value >> 4];
    out += kHex[value & 15];
  }
  return out;
}

std::string on_scale(std::span<const Colour> stops, double t) {
  t *= static_cast<double>(stops.size() - 1);
  const size_t k = std::min(static_cast<size_t>(t), stops.size() - 2);
  const double f = t - static_cast<double>(k);
  Colour out;
  for (size_t c = 0; c < 3; ++c) out[c] = stops[k][c] + f * (stops[k + 1][c] - stops[k][c]);
  return hex(out);
}

// Place i of n on a scale; a single one stands near its light end.
double place(size_t i, size_t n) {
  return n > 1 ? static_cast<double>(i) / static_cast<double>(n - 1) : 0.35;
}

}  // namespace

std::string group_colour(const ElevationFaces& faces, size_t i, ElevationColours colours) {
  if (colours == ElevationColours::kNone) return kPaper;
  if (colours == ElevationColours::kDepth) return on_scale(kDepths, place(i, faces.groups.size()));
  const DepthGroup& group = faces.groups[i];
  if (group.side == 0) return kMainPlane;
  const auto n =
      static_cast<size_t>(std::count_if(faces.groups.begin(), faces.groups.end(),
                                        [&](const DepthGroup& g) { return g.side == group.side; }));
  return on_scale(
      group.side < 0 ? std::span<const Colour>(kInFront) : std::span<const Colour>(kBehind),
      place(group.rank, n));
}

bool is_dark(std::string_view colour) {
  if (colour.size() != 7) return false;
  const auto digit = [&](size_t i) {
    const char c = colour[i];
    return c >= 'a' ? c - 'a' + 10 : c - '0';
  };
  const auto channel = [&](size_t k) { return 16.0 * digit(2 * k + 1) + digit(2 * k + 2); };
  return 0.30 * channel(0) + 0.59 * channel(1) + 0.11 * channel(2) < 128;  // luma of ITU-R BT.601
}

const char* opening_colour(std::string_view part_class) {
  if (part_class == part_class::kWindow) return "#1d56a5";
  if (part_class == part_class::kDoor) return "#8a4a00";
  // Of doors' and windows' kind, lighter; apart in grey too.
  if (part_class == part_class::kGateway) return "#b3261e";
  if (part_class == part_class::kShopFront) return "#00796b";
  if (part_class == part_class::kVent) return "#6a3d9a";
  if (part_class == part_class::kRecess) return "#5f6b00";
  return kInk;
}

}  // namespace jalon
