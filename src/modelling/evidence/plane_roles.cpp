// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/evidence/plane_roles.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "modelling/evidence/places.h"
#include "modelling/evidence/plane_placement.h"

namespace jalon {

namespace {

constexpr double kRoomDepth_m = 12;  // rooms are no deeper
// Of a room's wall: straight behind the front's measured wall, and within its border.
constexpr double kBehindWallShare = 0.08;
// Of a room's wall. Measured on the grammar: rooms 0.29 and more, back walls of arcades and loggias below 0.02.
constexpr double kBehindPanesShare = 0.1;
constexpr double kShopFrontShare = 0.15;  // of the area behind an arcade; rooms have none
constexpr double kCornice_m = 0.6;        // strips of a wall stand no farther before it
constexpr double kFilledShare = 0.5;
constexpr double kGlimpsedShare = 0.2;  // of an opening's cells: past a bay window little is seen
constexpr double kHidingShare = 0.2;    // sills and piers of a bay window, of what lies behind it
constexpr int kHiddenProbes = 16;       // along each side of an opening

bool has_shop_fronts(const WallEvidence& plane) {
  double through_m2 = 0;
  for (const OpeningCandidate& opening : plane.openings)
    if (opening.is_opening && opening.inside.of(WallState::kThrough) > 0)
      through_m2 += area_of(opening, plane.cells);
  return through_m2 >= kShopFrontShare * plane.gross_m2;
}

// Step 1: behind the walls before it, taken together.
bool is_behind_walls(const std::vector<WallEvidence>& all, const std::vector<uint8_t>& is_front,
                     size_t s) {
  const WallEvidence& plane = all[s];
  std::vector<const WallCells*> fronts;
  for (size_t w = 0; w < all.size(); ++w)
    if (w != s && is_front[w] != 0 &&
        dot(all[w].cells.frame.normal, plane.cells.frame.normal) >= kSameWay)
      fronts.push_back(&all[w].cells);
  if (fronts.empty()) return false;
  size_t on = 0, behind = 0, within = 0;
  for_measured(plane.cells, [&](const Vec3& p) {
    bool is_within = false, is_behind = false;
    for (const WallCells* front : fronts) {
      const Foot foot(*front, p);
      if (!foot.is_on_map || foot.depth_m <= kFillingDepth_m || foot.depth_m > kRoomDepth_m)
        continue;
      is_within = is_within || front->at(foot.column, foot.row) != WallState::kOutside;
      is_behind = is_behind || is_well_inside(*front, foot.column, foot.row);
    }
    ++on;
    within += is_within;
    behind += is_behind;
  });
  return ratio_of(within, on) >= kWithinShare && ratio_of(behind, on) >= kBehindWallShare;
}

void tell_rooms(std::vector<WallEvidence>& all, Task& task) {
  std::vector<uint8_t> is_front(all.size(), 0), is_room(all.size(), 0);
  parallel_for(task, all.size(), 1, [&](size_t begin, size_t end) {
    for (size_t s = begin; s < end; ++s)
      is_front[s] = !all[s].empty() && !is_sparse(all[s]) && tall_share(all[s].cells) >= kTallShare;
  });
  parallel_for(task, all.size(), 1, [&](size_t begin, size_t end) {
    for (size_t s = begin; s < end; ++s)
      is_room[s] = !all[s].empty() && !has_shop_fronts(all[s]) && is_behind_walls(all, is_front, s);
  });
  for (size_t s = 0; s < all.size(); ++s)
    if (is_room[s] != 0) all[s].role = PlaneRole::kInside;
}

// Step 2.
PlaneRole role_of(const PlanePlacement& p, const WallEvidence& plane, const WallEvidence& wall,
                  const CellSetting& setting) {
  const WallCells& cells = plane.cells;
  const double on_m = cells.on_m / 2;
  if (p.within < kWithinShare) return PlaneRole::kWall;
  if (p.depth_m < -on_m) {
    const bool is_cover = is_cover_at(p, plane, setting) && !is_house_before(plane, wall);
    const bool is_strip = p.depth_m >= -kCornice_m && !is_broad(cells, kBroad_m);
    return is_cover || is_strip || is_sparse(plane) || tall_share(cells) < kTallShare
               ? PlaneRole::kRelief
               : PlaneRole::kWall;
  }
  if (p.depth_m <= on_m || p.depth_m > kRoomDepth_m) return PlaneRole::kWall;
  if ((p.in_openings >= kFillingShare || is_sparse(plane)) && p.depth_m <= kFillingDepth_m)
    return PlaneRole::kFilling;
  const bool is_room = p.behind_wall >= kBehindWallShare && !has_shop_fronts(plane);
  return is_room ? PlaneRole::kInside : PlaneRole::kWall;
}

// Whether a plane was seen through panes that face its way: a room's wall, where no loggia's back is.
bool is_behind_panes(const WallEvidence& plane, const std::vector<const WallEvidence*>& panes) {
  size_t on = 0, behind = 0;
  for_measured(plane.cells, [&](const Vec3& p) {
    ++on;
    behind += std::any_of(panes.begin(), panes.end(), [&](const WallEvidence* pane) {
      if (dot(pane->cells.frame.normal, plane.cells.frame.normal) < kSameWay) return false;
      const Foot foot(pane->cells, p);
      if (!foot.is_on_map || foot.depth_m <= kFillingDepth_m || foot.depth_m > kRoomDepth_m)
        return false;
      const WallState state = pane->cells.at(foot.column, foot.row);
      return state == WallState::kOn || state == WallState::kStrip;
    });
  });
  return ratio_of(behind, on) >= kBehindPanesShare;
}

// Whether a plane lies a little behind the openings of walls, taken together: panes and leaves of one depth in
// neighbouring houses.
bool fills_openings(const WallEvidence& plane, const std::vector<const WallEvidence*>& walls) {
  const bool is_windowed = plane.has_framed_openings();
  size_t on = 0, inside = 0;
  for_measured(plane.cells, [&](const Vec3& p) {
    ++on;
    inside += std::any_of(walls.begin(), walls.end(), [&](const WallEvidence* wall) {
      const Foot foot(wall->cells, p);
      if (!foot.is_on_map || foot.depth_m <= wall->cells.on_m / 2 || foot.depth_m > kFillingDepth_m)
        return false;
      return is_in_opening(*wall, foot.at, is_windowed);
    });
  });
  return ratio_of(inside, on) >= kFillingShare;
}

// Two explanations of a lattice as far before a plane that has windows as things are fixed to walls: a wall whose
// openings that plane fills, or timbers or lesenes on the wall that it is. The one of which more was measured holds.
bool is_lattice_on(const WallEvidence& lattice, const WallEvidence& wall,
                   const CellSetting& setting) {
  if (!wall.is_wall() || !wall.has_framed_openings() || wall.measured_m2 <= lattice.measured_m2 ||
      dot(wall.cells.frame.normal, lattice.cells.frame.normal) < kSameWay)
    return false;
  const PlanePlacement p = placement_of(lattice, wall);
  return p.within >= kWithinShare && p.depth_m < -wall.cells.on_m / 2 &&
         p.depth_m >= -setting.proud_m;
}

std::vector<size_t> by_what_they_explain(const std::vector<WallEvidence>& all,
                                         const CellSetting& setting, Task& task) {
  std::vector<size_t> order;
  std::vector<double> explained(all.size(), 0);
  std::vector<uint8_t> is_laid(all.size(), 0);
  for (size_t s = 0; s < all.size(); ++s) {
    if (all[s].empty() || !all[s].is_wall()) continue;
    task.checkpoint(0);
    order.push_back(s);
    const bool is_lattice = std::any_of(all.begin(), all.end(), [&](const WallEvidence& wall) {
      return &wall != &all[s] && is_lattice_on(all[s], wall, setting);
    });
    explained[s] = is_lattice ? all[s].measured_m2 : explained_m2(all[s]);
  }
  std::vector<double> least = explained;
  for (const size_t s : order) {
    task.checkpoint(0);
    for (const size_t w : order)
      if (w != s && explained[w] < least[s] && is_laid_on(all[s], all[w], setting)) {
        least[s] = explained[w];
        is_laid[s] = 1;
      }
  }
  // What is laid on a wall comes after it.
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) {
    return least[a] != least[b] ? least[a] > least[b] : is_laid[a] < is_laid[b];
  });
  return order;
}

// Step 3: share of an opening's cells that another wall is measured behind.
double filled_share(const WallCells& cells, const OpeningShape& shape, const WallCells& other) {
  size_t held = 0;
  for_measured(other, [&](const Vec3& p) {
    const Foot foot(cells, p);
    held += foot.depth_m > 0 && shape.holds(foot.at);
  });
  const size_t step = std::max<size_t>(1, other.states.size() / kLookedAtCells);
  const RingBox box = shape.box();
  return static_cast<double>(held * step) * other.cell_m * other.cell_m /
         (box.width() * box.height());
}

// Whether another wall stands before an opening. What lies behind one opening of that alone is seen through it.
bool is_hidden_by(const WallCells& cells, const OpeningShape& shape, const WallCells& other) {
  const RingBox box = shape.box();
  size_t all = 0, within = 0, measured = 0;
  for (int j = 0; j < kHiddenProbes; ++j)
    for (int i = 0; i < kHiddenProbes; ++i) {
      const Vec2 at = box.low + Vec2{box.width() * (i + 0.5) / kHiddenProbes,
                                     box.height() * (j + 0.5) / kHiddenProbes};
      if (!shape.holds(at)) continue;
      ++all;
      const Foot foot(other, cells.frame.lift(at));
      if (!foot.is_on_map || foot.depth_m <= other.on_m / 2) continue;
      const WallState state = other.at(foot.column, foot.row);
      within += state != WallState::kOutside;
      measured += state == WallState::kOn;
    }
  return ratio_of(within, all) >= kFilledShare && ratio_of(measured, all) >= kHidingShare;
}

// Whether a hole is the place of a larger wall that goes on beyond this one: cornice and quoins in this one's plane
// frame it, and its windows lie there, as none of panes do. Loggias' back walls explain less, or end behind this one.
bool is_place_of(const WallEvidence& larger, const OpeningCandidate& opening,
                 const WallEvidence& wall) {
  if (opening.bordered >= kEnclosedShare || explained_m2(larger) <= explained_m2(wall) ||
      placement_of(larger, wall).within >= kWithinShare)
    return false;
  double windows = 0;
  for (const OpeningCandidate& o : larger.openings) {
    const Foot foot(wall.cells, larger.cells.frame.lift(o.shape.box().middle()));
    if (o.is_opening && is_framed(o) && foot.depth_m > 0 && opening.shape.holds(foot.at))
      windows += o.framed * area_of(o, larger.cells) / area_of(opening, wall.cells);
  }
  return windows > 0 &&
         windows + filled_share(wall.cells, opening.shape, larger.cells) >= kFilledShare;
}

// A hole, or the place of another wall: behind one without a frame, before one hardly seen or where the wall ends.
bool ends_at(const WallEvidence& wall, const OpeningCandidate& opening, const WallEvidence& other) {
  const bool goes_on = opening.jambs >= kBothJambs || opening.relief >= kReliefShare;
  if (!is_enclosed(opening) && filled_share(wall.cells, opening.shape, other.cells) >= kFilledShare)
    return true;
  if (is_place_of(other, opening, wall)) return true;
  return !(is_enclosed(opening) && goes_on &&
           opening.inside.share(WallState::kThrough) >= kGlimpsedShare) &&
         is_hidden_by(wall.cells, opening.shape, other.cells);
}

// Where a wall stands little before another both have its windows, once each: they are of the wall that frames them,
// not of that which it covers.
bool is_of_wall_before(const WallEvidence& before, const OpeningCandidate& opening,
                       const WallEvidence& wall, const CellSetting& setting) {
  if (opening.relief < kReliefShare) return false;
  const RingBox box = opening.shape.box();
  return std::any_of(before.openings.begin(), before.openings.end(), [&](const auto& other) {
    if (!other.is_opening || other.framed <= opening.framed) return false;
    const RingBox there = other.shape.box();
    const Foot low(wall.cells, before.cells.frame.lift(there.low)),
        high(wall.cells, before.cells.frame.lift(there.high));
    return low.depth_m < 0 && low.depth_m >= -setting.proud_m &&
           overlap(box, {low.at, high.at}) >= kFilledShare;
  });
}

void end_at(WallEvidence& wall, const std::vector<const WallEvidence*>& others,
            const CellSetting& setting, Task& task) {
  for (OpeningCandidate& opening : wall.openings) {
    task.checkpoint(0);
    if (!opening.is_opening) continue;
    opening.ends_at_wall = std::any_of(others.begin(), others.end(), [&](const auto* other) {
      return other != &wall && other->is_wall() && other->has_framed_openings() &&
             dot(other->cells.frame.normal, wall.cells.frame.normal) >= kSameWay &&
             (ends_at(wall, opening, *other) || is_of_wall_before(*other, opening, wall, setting));
    });
    opening.is_opening = !opening.ends_at_wall;
  }
}

void forget_ends(WallEvidence& plane) {
  for (OpeningCandidate& opening : plane.openings) {
    opening.is_opening = opening.is_opening || opening.ends_at_wall;
    opening.ends_at_wall = false;
  }
}

}  // namespace

double explained_m2(const WallEvidence& plane) {
  double sum = plane.measured_m2;
  for (const OpeningCandidate& opening : plane.openings)
    if (opening.is_opening) sum += opening.framed * area_of(opening, plane.cells);
  return sum;
}

bool is_filling_at(const WallEvidence& wall, const Vec3& p, bool by_border) {
  const Foot foot(wall.cells, p);
  if (!foot.is_on_map || foot.depth_m <= wall.cells.on_m / 2 || foot.depth_m > kFillingDepth_m)
    return false;
  // A cell with a point of the wall ends an opening: frames stand in its rim.
  return std::any_of(wall.openings.begin(), wall.openings.end(), [&](const auto& opening) {
    return opening.is_opening &&
           (is_framed(opening) || (by_border && opening.bordered >= kEnclosedShare)) &&
           opening.shape.grown(wall.cells.cell_m).holds(foot.at);
  });
}

void tell_roles(std::vector<WallEvidence>& all, const CellSetting& setting, Task& task) {
  for (WallEvidence& plane : all) {
    plane.role = PlaneRole::kWall;
    forget_ends(plane);
  }
  // 1. Rooms.
  tell_rooms(all, task);
  // 2. Surrounds, panes and leaves.
  const std::vector<size_t> order = by_what_they_explain(all, setting, task);
  std::vector<const WallEvidence*> walls;
  for (const size_t s : order) {
    WallEvidence& plane = all[s];
    std::vector<const WallEvidence*> parallel;
    for (const WallEvidence* wall : walls)
      if (std::fabs(dot(wall->cells.frame.normal, plane.cells.frame.normal)) >= kSameWay)
        parallel.push_back(wall);
    task.checkpoint(0);
    if (fills_openings(plane, parallel)) plane.role = PlaneRole::kFilling;
    for (size_t w = 0; w < parallel.size() && plane.is_wall(); ++w) {
      task.checkpoint(0);
      plane.role = role_of(placement_of(plane, *parallel[w]), plane, *parallel[w], setting);
    }
    if (!plane.is_wall()) continue;
    // Surrounds in the place of a wall that explains more are not what fills this one's openings.
    end_at(plane, walls, setting, task);
    walls.push_back(&plane);
  }
  // 3. Rooms whose windows leave little of the wall before them.
  std::vector<const WallEvidence*> panes;
  for (const WallEvidence& plane : all)
    if (!plane.empty() && plane.role == PlaneRole::kFilling) panes.push_back(&plane);
  for (const size_t s : order) {
    task.checkpoint(0);
    if (all[s].is_wall() && is_behind_panes(all[s], panes)) all[s].role = PlaneRole::kInside;
  }
  // 4. Where one wall ends and another begins.
  for (const size_t s : order) forget_ends(all[s]);
  for (const size_t s : order)
    if (all[s].is_wall()) end_at(all[s], walls, setting, task);
}

}  // namespace jalon
