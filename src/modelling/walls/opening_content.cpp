// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/walls/opening_content.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "modelling/plane/ring_tools.h"

namespace jalon {

namespace {

constexpr double kJoineryThick_m = 0.06;  // frame, pane and leaf: joinery.cpp has one level so

enum Holds : uint8_t { kAny = 1, kJoinery = 2, kBehindJoinery = 4 };

}  // namespace

OpeningContent opening_content(const HoleSurvey& survey, const WallMap& map,
                               const FacadeOpening& opening, double tolerance_m) {
  const RingBox box = ring_box(opening.outline);
  const double depth_m = std::isfinite(opening.depth_m) ? opening.depth_m : 0;
  std::map<uint32_t, uint8_t> cells;
  for (const HolePoint& p : survey.points) {
    if (!box.holds({p.u, p.v})) continue;
    const auto column = static_cast<uint32_t>((p.u - map.origin.u) / map.cell_m);
    const auto row = static_cast<uint32_t>((p.v - map.origin.v) / map.cell_m);
    uint8_t& cell = cells[row * map.columns + column];
    cell |= kAny;
    if (std::fabs(-p.w - depth_m) <= kJoineryThick_m) cell |= kJoinery;
    if (-p.w > std::max(depth_m + kJoineryThick_m, tolerance_m)) cell |= kBehindJoinery;
  }
  const double all = std::max(1.0, box.width() * box.height() / (map.cell_m * map.cell_m));
  const auto share = [&](uint8_t what) {
    const auto n = std::count_if(cells.begin(), cells.end(),
                                 [&](const auto& cell) { return (cell.second & what) != 0; });
    return std::min(1.0, static_cast<double>(n) / all);
  };
  return {share(kJoinery), share(kBehindJoinery), 1 - share(kAny)};
}

}  // namespace jalon
