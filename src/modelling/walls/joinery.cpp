// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/walls/joinery.h"

#include <algorithm>
#include <iterator>

namespace jalon {

namespace {

constexpr double kLevel_m = 0.05;  // frames stand 2 to 5 cm before their glass
constexpr double kNearShare =
    0.5;  // of the largest level's cells: enough for one before it to be the joinery
constexpr double kBesideShare =
    0.25;  // of the largest level's cells: enough for one behind and beside it
constexpr double kSamePlace =
    0.5;  // share of the smaller one's blocks where both levels show: one before the other
constexpr double kLeastShare = 0.1;  // of a level's cells: less is a handle, a pot, a lamp

// Fillers of nearly one depth.
struct Level {
  std::vector<const HoleFiller*> fillers;  // from the front
  uint32_t cells = 0;
  std::vector<uint32_t> blocks;
};

std::vector<Level> levels_of(const HoleContent& content, double min_depth_m) {
  std::vector<const HoleFiller*> fillers;
  for (const HoleFiller& f : content.parallel)
    if (f.depth_m >= min_depth_m) fillers.push_back(&f);
  std::stable_sort(fillers.begin(), fillers.end(), [](const HoleFiller* a, const HoleFiller* b) {
    return a->depth_m < b->depth_m;
  });
  std::vector<Level> out;
  for (const HoleFiller* f : fillers) {
    if (out.empty() || f->depth_m - out.back().fillers.back()->depth_m > kLevel_m)
      out.emplace_back();
    Level& level = out.back();
    level.fillers.push_back(f);
    level.cells += f->cells;
    std::vector<uint32_t> both;
    std::set_union(level.blocks.begin(), level.blocks.end(), f->blocks.begin(), f->blocks.end(),
                   std::back_inserter(both));
    level.blocks = std::move(both);
  }
  return out;
}

bool share_place(const Level& a, const Level& b) {
  std::vector<uint32_t> common;
  std::set_intersection(a.blocks.begin(), a.blocks.end(), b.blocks.begin(), b.blocks.end(),
                        std::back_inserter(common));
  return static_cast<double>(common.size()) >=
         kSamePlace * static_cast<double>(std::min(a.blocks.size(), b.blocks.size()));
}

// 2. Index of the level that closes the opening.
size_t closing_level(const std::vector<Level>& levels) {
  size_t best = 0;
  for (size_t k = 1; k < levels.size(); ++k)
    if (levels[k].cells > levels[best].cells) best = k;
  const double largest = levels[best].cells;
  for (size_t k = levels.size() - 1; k > best; --k)
    if (levels[k].cells >= kBesideShare * largest && !share_place(levels[k], levels[best]))
      return k;
  for (size_t k = 0; k < best; ++k)
    if (levels[k].cells >= kNearShare * largest && share_place(levels[k], levels[best])) return k;
  return best;
}

// 3. The foremost one that is more than a handle; of many small ones the largest.
const HoleFiller* foremost(const Level& level) {
  const auto found = std::ranges::find_if(
      level.fillers, [&](const HoleFiller* f) { return f->cells >= kLeastShare * level.cells; });
  return found != level.fillers.end()
             ? *found
             : *std::ranges::max_element(level.fillers, {}, &HoleFiller::cells);
}

}  // namespace

Joinery joinery_of(const HoleContent& content, double min_depth_m) {
  Joinery out;
  const std::vector<Level> levels = levels_of(content, min_depth_m);
  double front_m = min_depth_m;
  if (!levels.empty()) {
    const Level& level = levels[closing_level(levels)];
    out.filler = foremost(level);
    front_m = level.fillers.front()->depth_m;
  }
  for (const HoleFiller& f : content.parallel)
    if (f.depth_m < front_m && f.label != 0) out.standing.push_back(f.label);
  return out;
}

}  // namespace jalon
