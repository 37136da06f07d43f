// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/evidence/recesses.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

#include "base/parallel.h"
#include "modelling/evidence/cell_regions.h"
#include "modelling/evidence/places.h"
#include "modelling/evidence/plane_roles.h"

namespace jalon {

namespace {

constexpr double kSameWayCosine_recess = 0.985;  // 10 degrees
constexpr double kLeastDepth_m = 0.6;  // panes and leaves stand no deeper (plane_roles.cpp)
constexpr double kMostDepth_m = 4;     // an arcade's
constexpr double kInOpening = 0.6;     // of the cells of a back wall
constexpr double kHeld = 0.05;         // of them, in one opening
constexpr size_t kDepths = 8;          // equal parts of the depth
constexpr double kCoveredShare = 0.8;  // of them, along one side
constexpr double kMostlyJoined = 0.5;  // of the wall's cells in openings
constexpr double kRimCells =
    2;  // of the wall before it: its sides are seen this near to the border
constexpr size_t kRecessPointsPerChunk = 1 << 15;
constexpr size_t kLookedAtCells_recess = 20000;

// Of the measured cells of a plane that faces away, behind the wall before it, within its border.
constexpr double kMostlyWithin = 0.7;
// Of what lies straight behind a wall's measured places, where it hides that: nothing is known, and how much more often
// so than behind its openings. Where it hides nothing: 0, and once; back walls of arcades: 0.5 to 0.9, and 1.6 to 6.
constexpr double kHidden = 0.25, kHidesMore = 1.25;

// Of the border of a window that piers too narrow to frame it enclose, as that of an empty opening (find_openings.cpp).
constexpr double kEnclosingShare = 0.95;

// An opening of a wall and what was measured along its four sides, between the wall and the one behind it.
struct Recess {
  const WallEvidence* front = nullptr;
  OpeningShape outer, inner;
  RingBox box;  ///< of the opening
  double depth_m = 0;
  size_t cells = 0;  ///< of the back wall behind it
  std::array<std::array<uint8_t, kDepths>, 4> seen{};

  void look(const Vec3& p) {
    const PlaneFrame& frame = front->cells.frame;
    const double depth = frame.height - dot(p - frame.origin, frame.normal),
                 on_m = front->cells.on_m;
    if (depth <= on_m || depth >= depth_m - on_m) return;
    const Vec2 q = frame.project(p);
    if (!outer.holds(q) || (inner.is_valid() && inner.holds(q))) return;
    const std::array beside{q.u - box.low.u, box.high.u - q.u, q.v - box.low.v, box.high.v - q.v};
    const auto side =
        static_cast<size_t>(std::min_element(beside.begin(), beside.end()) - beside.begin());
    const auto part = static_cast<size_t>((depth - on_m) / (depth_m - 2 * on_m) * kDepths);
    std::atomic_ref<uint8_t>(seen[side][std::min(part, kDepths - 1)])
        .store(1, std::memory_order_relaxed);
  }
  bool is_joined() const {
    return std::any_of(seen.begin(), seen.end(), [](const auto& side) {
      return static_cast<double>(std::count(side.begin(), side.end(), 1)) >=
             kCoveredShare * kDepths;
    });
  }
};

// The openings of a wall that a plane is seen through; none where it lies elsewhere or at a pane's depth.
std::vector<Recess> recesses_of(const WallEvidence& plane, const WallEvidence& front) {
  std::vector<Recess> out;
  for (const OpeningCandidate& opening : front.openings) {
    if (!opening.is_opening) continue;
    const double rim_m = kRimCells * front.cells.cell_m;
    Recess& recess = out.emplace_back();
    recess.front = &front;
    recess.outer = opening.shape.grown(rim_m);
    recess.inner = opening.shape.grown(-rim_m);
    recess.box = opening.shape.box();
  }
  const WallCells& cells = plane.cells;
  const size_t step = std::max<size_t>(1, cells.states.size() / kLookedAtCells_recess);
  size_t on = 0, in = 0;
  for (size_t k = 0; k < cells.states.size(); k += step) {
    if (cells.states[k] != WallState::kOn) continue;
    const Vec3 p = cells.frame.lift(
        cells.origin + Vec2{(static_cast<double>(k % cells.columns) + 0.5) * cells.cell_m,
                            (static_cast<double>(k / cells.columns) + 0.5) * cells.cell_m});
    ++on;
    const PlaneFrame& frame = front.cells.frame;
    const double depth = frame.height - dot(p - frame.origin, frame.normal);
    const Vec2 q = frame.project(p);
    for (Recess& recess : out) {
      if (!recess.outer.holds(q)) continue;
      recess.depth_m += depth;
      ++recess.cells;
      ++in;
      break;
    }
  }
  for (Recess& recess : out) recess.depth_m /= std::max(1.0, static_cast<double>(recess.cells));
  if (static_cast<double>(in) < kInOpening * static_cast<double>(on)) return {};
  std::erase_if(out, [&](const Recess& recess) {
    return recess.depth_m <= kLeastDepth_m || recess.depth_m > kMostDepth_m ||
           static_cast<double>(recess.cells) < kHeld * static_cast<double>(on);
  });
  return out;
}

// Beside the door of a loggia little of its back wall is seen: too little to frame it, all about it all the same.
bool has_enclosed_openings(const WallEvidence& plane) {
  return std::any_of(plane.openings.begin(), plane.openings.end(), [](const auto& opening) {
    return opening.is_opening &&
           (opening.framed >= kFramedShare || opening.bordered >= kEnclosingShare);
  });
}

// The box of an opening of the wall before, in the plane of the one behind it.
RingBox box_behind(const Recess& recess, const WallCells& cells) {
  const RingBox outer = recess.box.grown(recess.front->cells.cell_m);
  RingBox out;
  for (const Vec2& corner : {outer.low, outer.high})
    out.add(cells.frame.project(recess.front->cells.frame.lift(corner)));
  return out;
}

// Step 4: the foot, and of rectangles the other sides.
void cut_to(const RingBox& box, OpeningShape& shape) {
  if (shape.kind != ShapeKind::kRectangle && shape.kind != ShapeKind::kArch &&
      shape.kind != ShapeKind::kGable)
    return;
  OpeningShape cut = shape;
  cut.sizes[2] = std::max(cut.sizes[2], box.low.v);
  if (shape.kind == ShapeKind::kRectangle) {
    cut.sizes[0] = std::max(cut.sizes[0], box.low.u);
    cut.sizes[1] = std::min(cut.sizes[1], box.high.u);
    cut.sizes[3] = std::min(cut.sizes[3], box.high.v);
  }
  if (cut.is_valid()) shape = cut;
}

// Cells of a plane with a place behind what is the same of a wall before it.
struct Behind {
  size_t all = 0, unknown = 0;
  void add(WallState state) {
    ++all;
    unknown += state == WallState::kOutside;
  }
  double unknown_share() const {
    return static_cast<double>(unknown) / std::max(1.0, static_cast<double>(all));
  }
};

// Two explanations of what is not known of a plane behind a wall: that hides it, or nothing was measured there.
bool is_seen_through(const WallEvidence& plane, const WallEvidence& front) {
  const WallCells& cells = plane.cells;
  std::vector<uint32_t> measured;
  for (size_t k = 0; k < cells.states.size(); ++k)
    if (cells.states[k] == WallState::kOn) measured.push_back(static_cast<uint32_t>(k));
  if (measured.empty()) return false;
  const CellBox box = cell_box_of(measured, cells.columns);
  size_t on = 0, within = 0;
  Behind wall, openings;
  for (uint32_t r = box.r0; r < box.r1; ++r)
    for (uint32_t c = box.c0; c < box.c1; ++c) {
      const WallState state = cells.at(c, r);
      on += state == WallState::kOn;
      const Foot foot(front.cells, cells.frame.lift(cells.origin + Vec2{(c + 0.5) * cells.cell_m,
                                                                        (r + 0.5) * cells.cell_m}));
      if (!foot.is_on_map || foot.depth_m <= kLeastDepth_m || foot.depth_m > kMostDepth_m) continue;
      const WallState before = front.cells.at(foot.column, foot.row);
      if (before == WallState::kOutside) continue;
      within += state == WallState::kOn;
      (is_wall(before) ? wall : openings).add(state);
    }
  return static_cast<double>(within) >= kMostlyWithin * static_cast<double>(on) &&
         wall.unknown_share() >= kHidden &&
         wall.unknown_share() >= kHidesMore * openings.unknown_share();
}

}  // namespace

void tell_recesses(const Segmentation& segmentation, std::vector<WallEvidence>& all, Task& task) {
  for (WallEvidence& plane : all) plane.is_recess = false;
  // 1. Walls behind openings of others. The leaf of a deep portal has no openings of its own.
  std::vector<Recess> recesses;
  std::vector<size_t> back;
  for (size_t s = 0; s < all.size(); ++s)
    for (size_t w = 0; w < all.size(); ++w) {
      if (w == s || !all[w].is_wall() || !all[s].is_wall() || !has_enclosed_openings(all[s]) ||
          dot(all[s].cells.frame.normal, all[w].cells.frame.normal) < kSameWayCosine_recess)
        continue;
      task.checkpoint(0);
      for (const Recess& recess : recesses_of(all[s], all[w])) {
        recesses.push_back(recess);
        back.push_back(s);
      }
    }
  if (recesses.empty()) return;
  // 2. What lies along the sides of these openings.
  const Cloud& cloud = *segmentation.cloud;
  parallel_for(task, cloud.size(), kRecessPointsPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i)
      for (Recess& recess : recesses) recess.look(cloud.point(i));
  });
  // 3. Walls that are joined to the one before them.
  std::vector<size_t> cells(all.size(), 0), joined(all.size(), 0);
  for (size_t k = 0; k < recesses.size(); ++k) {
    cells[back[k]] += recesses[k].cells;
    if (recesses[k].is_joined()) joined[back[k]] += recesses[k].cells;
  }
  for (size_t s = 0; s < all.size(); ++s)
    all[s].is_recess = joined[s] > 0 && static_cast<double>(joined[s]) >=
                                            kMostlyJoined * static_cast<double>(cells[s]);
  // 4. Where their openings end: storeys hide what lies between the openings that they are seen through.
  for (size_t k = 0; k < recesses.size(); ++k) {
    WallEvidence& plane = all[back[k]];
    if (!plane.is_recess) continue;
    const RingBox box = box_behind(recesses[k], plane.cells);
    for (OpeningCandidate& opening : plane.openings)
      if (opening.is_opening && box.holds(opening.shape.box().middle())) cut_to(box, opening.shape);
  }
}

std::vector<size_t> turned_away(const Segmentation& segmentation,
                                const std::vector<WallEvidence>& all, Task& task) {
  std::vector<size_t> out;
  for (size_t s = 0; s < all.size(); ++s) {
    if (all[s].empty() || segmentation.segments[s].front_source == FrontSource::kStation) continue;
    task.checkpoint(0);
    const double explained = explained_m2(all[s]);
    if (std::any_of(all.begin(), all.end(), [&](const WallEvidence& wall) {
          return wall.is_wall() && explained_m2(wall) > explained &&
                 dot(wall.cells.frame.normal, all[s].cells.frame.normal) <=
                     -kSameWayCosine_recess &&
                 is_seen_through(all[s], wall);
        }))
      out.push_back(s);
  }
  return out;
}

}  // namespace jalon
