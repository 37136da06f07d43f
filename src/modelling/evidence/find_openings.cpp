// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/evidence/find_openings.h"

#include <algorithm>
#include <cmath>

#include "modelling/evidence/box_search.h"
#include "modelling/evidence/cell_regions.h"
#include "modelling/evidence/piers.h"
#include "modelling/evidence/shape_cells.h"
#include "modelling/evidence/shape_fit.h"
#include "modelling/evidence/shape_trim.h"

namespace jalon {

namespace {

// Scores of cells in boxes, hundredths: wall ends a box at once, what was seen through is worth most.
constexpr int64_t kOnScore = -6000, kReliefScore = -2000, kStripScore = -400, kThroughScore = 200,
                  kProudScore = -400, kHiddenScore = 15, kEmptyScore = 100, kOutsideScore = -50,
                  kTakenScore = -300;
constexpr double kLeastArea_m2 = 0.03, kLeastCells = 2.5;
// Between cells with a point of the wall an opening of five spacings leaves two: a place of its own that was seen
// through is one; what nothing was seen through may be a gap between random points, and what is left beside a larger
// box is that one's border.
constexpr double kNarrowCells = 2, kNarrowBoxCells = 6, kSeenOfNarrow = 0.5;
constexpr size_t kMostBoxes = 2000;
constexpr double kLeastSum = 6;     // of weights: three cells that were seen through, and no wall
constexpr double kMostTaken = 0.2;  // of its cells by better ones
// Step 4. Seen through: glass gives few returns, frames are narrow.
constexpr double kThroughShare = 0.05;
constexpr uint32_t kThroughCells = 4;
// All over it: of blocks of a fifth of its sides; a neighbour's floor behind a gateway crosses some of them.
constexpr int kBlocks = 5;
constexpr double kSeenBlocks = 0.3;
// Larger ones that nothing was seen through are gateways or what nobody measured.
constexpr double kEmptyMost_m2 = 8;
constexpr double kDoorStep_m =
    0.5;  // an empty place this near to the wall's foot: leaves of doors are always seen
// What lies far behind may have been seen beside the opening: from below, past a balcony that hides the wall over it.
constexpr double kDeepShare = 0.3, kOneJamb = 0.4;
constexpr double kLeastBordered = 0.2;  // of any: nothing of the wall is about what lies beside it
constexpr double kHiddenMost = 0.25;    // of its cells: rays to the rest went astray
constexpr double kMostSlender =
    4;  // its longer side in shorter ones: empty strips are shadows of gutters

int64_t score_of(WallState state) {
  switch (state) {
    case WallState::kOn:
      return kOnScore;
    case WallState::kRelief:
      return kReliefScore;
    case WallState::kStrip:
      return kStripScore;
    case WallState::kThrough:
      return kThroughScore;
    case WallState::kProud:
      return kProudScore;
    case WallState::kHidden:
      return kHiddenScore;
    case WallState::kOutside:
      return kOutsideScore;
    case WallState::kEmpty:
    case WallState::kDeep:
      break;
  }
  return kEmptyScore;
}

// Step 1.
class BoxSearch {
 public:
  BoxSearch(const WallCells& cells, const OpeningSearch& setting)
      : cells_(cells), regions_(cells.columns, cells.rows), taken_(cells.states.size(), 0) {
    const double least = kLeastArea_m2 / (cells.cell_m * cells.cell_m),
                 width = setting.least_width_m / cells.cell_m;
    broad_ = {std::max(least, kLeastCells * kLeastCells), std::max(kLeastCells, width)};
    narrow_ = {std::max(least, kNarrowBoxCells), std::max(kNarrowCells, width)};
  }

  std::vector<CellBox> run(Task& task) {
    std::vector<uint32_t> open;
    for (size_t k = 0; k < cells_.states.size(); ++k)
      if (!is_wall(cells_.states[k]) && cells_.states[k] != WallState::kOutside)
        open.push_back(static_cast<uint32_t>(k));
    std::vector<CellBox> out;
    std::vector<std::vector<uint32_t>> waiting = regions_.of(open);
    // The first ones are places of their own; what is put behind them are rests.
    size_t whole = waiting.size();
    while (!waiting.empty() && out.size() < kMostBoxes) {
      task.checkpoint(0);
      const bool is_rest = waiting.size() > whole;
      std::vector<uint32_t> region = std::move(waiting.back());
      waiting.pop_back();
      whole = std::min(whole, waiting.size());
      if (static_cast<double>(region.size()) < narrow_.cells) continue;
      const CellBox box = whole_beside_piers(best_in(region));
      if (!broad_.holds(box) && (is_rest || !narrow_.holds(box) || seen_share(box) < kSeenOfNarrow))
        continue;
      out.push_back(box);
      for (uint32_t r = box.r0; r < box.r1; ++r)
        for (uint32_t c = box.c0; c < box.c1; ++c) taken_[size_t{r} * cells_.columns + c] = 1;
      std::erase_if(region, [&](uint32_t k) { return taken_[k] != 0; });
      for (auto& rest : regions_.of(region)) waiting.push_back(std::move(rest));
    }
    return out;
  }

 private:
  // What a box has at least.
  struct LeastBox {
    double cells = 0, side = 0;
    bool holds(const CellBox& box) const {
      return box.width() >= side && box.height() >= side &&
             static_cast<double>(box.width()) * box.height() >= cells;
    }
  };

  CellBox whole_beside_piers(CellBox box) const {
    for (CellBox part = beside_pier(cells_, box); part.width() < box.width();
         part = beside_pier(cells_, box))
      box = part;
    return box;
  }

  double seen_share(const CellBox& box) const {
    size_t seen = 0;
    for (uint32_t r = box.r0; r < box.r1; ++r)
      for (uint32_t c = box.c0; c < box.c1; ++c) seen += cells_.at(c, r) == WallState::kThrough;
    return static_cast<double>(seen) / (static_cast<double>(box.width()) * box.height());
  }

  // The best box in the region's own box.
  CellBox best_in(const std::vector<uint32_t>& region) const {
    const CellBox about = cell_box_of(region, cells_.columns);
    if (about.width() < narrow_.side || about.height() < narrow_.side) return {};
    const CellSums<int64_t> sums(about.width(), about.height(), [&](size_t i) {
      const size_t k =
          (about.r0 + i / about.width()) * cells_.columns + about.c0 + i % about.width();
      return taken_[k] != 0 ? kTakenScore : score_of(cells_.states[k]);
    });
    const ScoredBox best = best_box(sums, about.width(), about.height());
    return {about.c0 + best.box.c0, about.r0 + best.box.r0, about.c0 + best.box.c1,
            about.r0 + best.box.r1};
  }

  const WallCells& cells_;
  CellRegions regions_;
  std::vector<uint8_t> taken_;
  LeastBox broad_, narrow_;
};

// Step 3: whether a shape explains cells of its own, and hardly any of a better one.
bool is_free(const WallCells& cells, const OpeningShape& shape,
             const std::vector<uint8_t>& claimed) {
  constexpr ShapeWeights kWeights;
  double sum = 0;
  size_t all = 0, taken = 0;
  for_cells(cells, shape, [&](uint32_t c, uint32_t r) {
    ++all;
    if (claimed[size_t{r} * cells.columns + c] != 0) ++taken;
    else sum += kWeights.of(cells.at(c, r));
  });
  return sum >= kLeastSum && static_cast<double>(taken) <= kMostTaken * static_cast<double>(all);
}

// Shares of the blocks of a shape in which as much was seen through it as in the whole, for strays are in every block:
// of all, and of those that nothing hides whole, by what is not hidden.
struct SeenBlocks {
  double of_all = 0, of_unhidden = 0;
};

SeenBlocks seen_blocks(const WallCells& cells, const OpeningShape& shape) {
  const RingBox box = shape.box();
  std::array<uint32_t, kBlocks * kBlocks> all{}, unhidden{}, seen{};
  const auto block = [](double at, double low, double size) {
    return std::clamp(static_cast<int>((at - low) / size * kBlocks), 0, kBlocks - 1);
  };
  for_cells(cells, shape, [&](uint32_t c, uint32_t r) {
    const auto k = static_cast<size_t>(block(r + 0.5, box.low.v, box.height()) * kBlocks +
                                       block(c + 0.5, box.low.u, box.width()));
    const WallState state = cells.at(c, r);
    ++all[k];
    unhidden[k] += state != WallState::kHidden;
    seen[k] += state == WallState::kThrough || state == WallState::kDeep;
  });
  const auto share_of = [&](const auto& asked) {
    int has = 0, sees = 0;
    for (size_t k = 0; k < asked.size(); ++k) {
      has += asked[k] > 0;
      sees += seen[k] > 0 && seen[k] >= kThroughShare * asked[k];
    }
    return static_cast<double>(sees) / std::max(1, has);
  };
  return {share_of(all), share_of(unhidden)};
}

// Whether something was seen through a shape, all over it. A parapet before a window of which more than half the border
// was measured, on both sides, hides that part of it: what is seen over the parapet tells.
bool is_seen_through(const OpeningCandidate& c, const SeenBlocks& blocks) {
  if (c.inside.of(WallState::kThrough) < kThroughCells) return false;
  const double share = c.inside.share(WallState::kThrough);
  if (share >= kThroughShare && blocks.of_all >= kSeenBlocks) return true;
  const double unhidden = 1 - c.inside.share(WallState::kHidden);
  return is_framed(c) && c.bordered >= kFramedShare && share >= kThroughShare * unhidden &&
         blocks.of_unhidden >= kSeenBlocks;
}

// Whether a place of which nothing near the wall was seen is a recess: it has a jamb at least. A level strip is what
// something hides; an upright one has the wall all along both sides.
bool is_recess(const OpeningCandidate& c) {
  if (c.inside.share(WallState::kDeep) < kDeepShare) return false;
  const RingBox box = c.shape.box();
  if (box.width() > kMostSlender * box.height()) return false;
  return c.jambs >= (box.height() > kMostSlender * box.width() ? kEnclosedShare : kOneJamb);
}

// Steps 3 and 4. A place that nothing was seen through, at the side of a wall, is where that has its border.
bool is_opening(const OpeningCandidate& c, const SeenBlocks& blocks, const OpenEnds& open,
                double foot_v) {
  if (std::max(c.bordered, c.framed) < kLeastBordered) return false;
  if (is_seen_through(c, blocks)) return true;
  if (is_recess(c)) return true;
  if (open.left || open.right) return false;
  const RingBox box = c.shape.box();
  if (box.low.v <= foot_v + kDoorStep_m) return false;
  if (std::max(box.width(), box.height()) > kLargestWindow_m ||
      box.width() * box.height() > kEmptyMost_m2)
    return false;
  const double longer = std::max(box.width(), box.height()),
               shorter = std::min(box.width(), box.height());
  return c.bordered >= kEnclosedShare && c.inside.share(WallState::kHidden) < kHiddenMost &&
         longer <= kMostSlender * shorter;
}

// Whether a level strip at the wall's foot has the wall over it alone: that ends there, and what hangs lower or stands
// before it farther along reaches below.
bool is_foot_of_wall(const OpeningCandidate& c, const OpenEnds& open) {
  const RingBox box = c.shape.box();
  return open.foot && box.width() > kMostSlender * box.height() && c.jambs < kOneJamb;
}

OpeningCandidate candidate_of(const WallCells& cells, const OpeningShape& shape) {
  OpeningCandidate out = looked_at(cells, shape);
  const OpenEnds open = open_ends(cells, shape);
  out.is_opening = is_opening(out, seen_blocks(cells, shape), open, cells.origin.v) &&
                   !(open.head && open.foot) && !is_foot_of_wall(out, open);
  return out;
}

// A shape that was seen through goes before one that nobody looked into, whatever that covers.
struct JudgedShape {
  FittedShape fitted;
  bool is_opening = false;
};

}  // namespace

uint32_t StateCounts::all() const {
  uint32_t sum = 0;
  for (const uint32_t n : cells) sum += n;
  return sum;
}

OpeningCandidate looked_at(const WallCells& cells, const OpeningShape& shape) {
  OpeningCandidate out;
  for_cells(cells, shape, [&](uint32_t c, uint32_t r) {
    ++out.inside.cells[static_cast<size_t>(cells.at(c, r))];
  });
  out.bordered = bordered_share(cells, shape, Sides::kAll);
  out.framed = framed_share(cells, shape);
  out.jambs = framed_share(cells, shape, Sides::kSteep);
  out.relief = relief_share(cells, shape);
  const RingBox box = shape.box();
  out.is_narrow = std::min(box.width(), box.height()) < kLeastCells;
  out.shape = shape.placed(cells.cell_m, cells.origin);
  out.is_open_above = open_ends(cells, shape).head;
  return out;
}

double StateCounts::share(WallState state) const {
  return of(state) / std::max(1.0, static_cast<double>(all()));
}

std::vector<OpeningCandidate> find_openings(const WallCells& cells, const OpeningSearch& setting,
                                            Task& task, const WallPoints& points) {
  if (cells.empty()) return {};
  // 1. Boxes.
  const std::vector<CellBox> boxes = BoxSearch(cells, setting).run(task);
  // 2. Shapes.
  std::vector<FittedShape> shapes;
  for (const CellBox& box : boxes) {
    task.checkpoint(0);
    const FittedShape fitted = fitted_shape(cells, {}, box, {});
    for (const OpeningShape& part : parts_of(cells, fitted.shape))
      shapes.push_back({part, fitted.score});
  }
  // 3. One for each place.
  std::vector<JudgedShape> judged;
  for (const FittedShape& shape : shapes)
    judged.push_back({shape, candidate_of(cells, shape.shape).is_opening});
  std::stable_sort(judged.begin(), judged.end(), [](const JudgedShape& a, const JudgedShape& b) {
    return a.is_opening != b.is_opening ? a.is_opening : a.fitted.score > b.fitted.score;
  });
  std::vector<OpeningShape> kept;
  std::vector<uint8_t> claimed(cells.states.size(), 0);
  for (const JudgedShape& shape : judged) {
    task.checkpoint(0);
    if (!is_free(cells, shape.fitted.shape, claimed)) continue;
    for_cells(cells, shape.fitted.shape,
              [&](uint32_t c, uint32_t r) { claimed[size_t{r} * cells.columns + c] = 1; });
    kept.push_back(shape.fitted.shape);
  }
  kept = joined_lights(std::move(kept), cells, points);
  // 4. Openings and what is not known.
  std::vector<OpeningCandidate> out;
  for (const OpeningShape& shape : kept) out.push_back(candidate_of(cells, shape));
  std::stable_sort(out.begin(), out.end(),
                   [](const OpeningCandidate& a, const OpeningCandidate& b) {
                     return a.shape.box().low.u < b.shape.box().low.u;
                   });
  return out;
}

}  // namespace jalon
