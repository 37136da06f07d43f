// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/evidence/evidence.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "base/parallel.h"
#include "modelling/evidence/cell_decomposition.h"
#include "modelling/evidence/contour_holes.h"
#include "modelling/evidence/drawn_contour.h"
#include "modelling/evidence/places.h"
#include "modelling/evidence/plane_roles.h"
#include "modelling/evidence/recesses.h"
#include "modelling/evidence/settled_openings.h"
#include "modelling/plane/segment_frame.h"
#include "segment/labels/label_groups.h"
#include "segment/upright.h"

namespace jalon {

namespace {

constexpr double kSameWay_wall = 0.985;  // cosine of 10 degrees
// Of what was measured of a wall, along the wall before it: panels have most of it above, below and between them, the
// house next door has stray points there. These are no more of that one, at either end.
constexpr double kMostAlong = 0.5, kStrays = 0.05;

std::vector<OpeningShape> shapes_of(std::span<const OpeningCandidate> candidates,
                                    bool with_narrow) {
  std::vector<OpeningShape> out;
  for (const OpeningCandidate& candidate : candidates)
    if (candidate.is_opening && (with_narrow || !candidate.is_narrow))
      out.push_back(candidate.shape);
  return out;
}

// What relief covers about an opening is none of the wall's own points: their contour may go round it in pieces without
// a hole for it. What is not enclosed has no surround, nor has what is no window: a bay between posts and bands.
std::vector<OpeningShape> covered_openings(const WallEvidence& wall) {
  std::vector<OpeningShape> out;
  for (const OpeningCandidate& o : wall.openings) {
    const RingBox box = o.shape.box();
    if (o.is_opening && o.is_settled && is_enclosed(o) &&
        std::max(box.width(), box.height()) <= kLargestWindow_m)
      out.push_back(o.shape);
  }
  return out;
}

// The foot on a wall of a place that lies behind it by so much at most.
std::optional<Foot> foot_behind(const WallEvidence& front, const Vec3& p, double most_m) {
  const Foot foot(front.cells, p);
  if (!foot.is_on_map || foot.depth_m <= 0 || foot.depth_m > most_m) return {};
  return foot;
}

bool is_measured_at(const WallEvidence& wall, const Foot& foot) {
  return is_wall(wall.cells.at(foot.column, foot.row));
}

// Relief where a place tells so lies beyond the border.
template <class IsOther>
void end_relief(WallCells& cells, IsOther&& is_other) {
  for (size_t k = 0; k < cells.states.size(); ++k) {
    if (cells.states[k] != WallState::kRelief) continue;
    const Vec2 at{static_cast<double>(k % cells.columns) + 0.5,
                  static_cast<double>(k / cells.columns) + 0.5};
    if (is_other(cells.frame.lift(cells.origin + at * cells.cell_m)))
      cells.states[k] = WallState::kOutside;
  }
}

// Whether a place of a wall lies behind what was measured of another one or behind its openings, no deeper than things
// that are fixed to a wall stand out.
bool is_behind_wall(const std::vector<const WallEvidence*>& others, const Vec3& p) {
  return std::any_of(others.begin(), others.end(), [&](const WallEvidence* other) {
    const auto foot = foot_behind(*other, p, CellSetting{}.proud_m);
    return foot && (is_measured_at(*other, *foot) ||
                    std::any_of(other->openings.begin(), other->openings.end(), [&](const auto& o) {
                      return o.is_opening && o.shape.holds(foot->at);
                    }));
  });
}

// The cells that a wall is drawn by: relief that is a wall with windows of its own, as a house that stands forward by a
// hand's breadth is, lies beyond its border. Areas count once.
WallCells drawn_cells(const std::vector<WallEvidence>& all, const WallEvidence& wall) {
  WallCells out = wall.cells;
  std::vector<const WallEvidence*> others;
  for (const WallEvidence& other : all)
    if (&other != &wall && other.is_wall() && other.has_framed_openings() &&
        dot(other.cells.frame.normal, wall.cells.frame.normal) >= kSameWay_wall)
      others.push_back(&other);
  if (others.empty()) return out;
  end_relief(out, [&](const Vec3& p) { return is_behind_wall(others, p); });
  return out;
}

// Whether a wall that looks the same way stands beside a plane, and not before it.
bool stands_beside(const WallEvidence& front, const WallEvidence& plane) {
  const PlaneFrame& frame = plane.cells.frame;
  if (dot(front.cells.frame.normal, frame.normal) < kSameWay_wall) return false;
  std::vector<double> along;
  for_measured(front.cells, [&](const Vec3& p) { along.push_back(frame.project(p).u); });
  if (along.empty()) return false;
  std::sort(along.begin(), along.end());
  const auto strays = static_cast<size_t>(kStrays * static_cast<double>(along.size()));
  const double left = along[strays], right = along[along.size() - 1 - strays];
  size_t on = 0, within = 0;
  for_measured(plane.cells, [&](const Vec3& p) {
    const double u = frame.project(p).u;
    ++on;
    within += u >= left && u <= right;
  });
  return static_cast<double>(within) < kMostAlong * static_cast<double>(on);
}

// What was measured of walls before a plane is no relief of that.
void leave_to(const std::vector<const WallEvidence*>& fronts, double relief_m, WallCells& cells) {
  end_relief(cells, [&](const Vec3& p) {
    return std::any_of(fronts.begin(), fronts.end(), [&](const auto* front) {
      const auto foot = foot_behind(*front, p, relief_m);
      return foot && is_measured_at(*front, *foot);
    });
  });
}

// Whether a wall before a plane frames an opening in the place of one that the plane does not frame.
bool has_own(const WallEvidence& front, const WallEvidence& plane, const OpeningCandidate& opening,
             double relief_m) {
  const Foot foot(front.cells, plane.cells.frame.lift(opening.shape.box().middle()));
  return foot.depth_m > 0 && foot.depth_m <= relief_m &&
         std::any_of(front.openings.begin(), front.openings.end(), [&](const auto& own) {
           return own.is_opening && is_framed(own) && own.shape.holds(foot.at);
         });
}

}  // namespace

void look_at_planes(const Segmentation& segmentation, std::span<const size_t> segments,
                    const EvidenceSetting& setting, std::vector<WallEvidence>& out, Task& task) {
  out.resize(segmentation.segments.size());
  // 1. Planes to look at.
  const LabelGroups groups(segmentation.labels->values<uint32_t>(), out.size(), task);
  std::vector<size_t> walls;
  std::vector<CellSource> sources;
  for (const size_t s : segments) {
    const Segment& segment = segmentation.segments[s];
    const auto indices = groups.of(static_cast<uint32_t>(s + 1));
    out[s] = {};
    if (!segment.has_plane() || segment.area_m2 < setting.least_area_m2 || indices.empty() ||
        std::fabs(segment.fit.plane.normal.z) > kWallSine)
      continue;
    walls.push_back(s);
    sources.push_back(
        {segment_frame(segmentation, segment, indices), indices, segment.fit.sigma, segment.label});
  }
  // 2. One look at the cloud.
  std::vector<WallCells> cells = wall_cells(segmentation, sources, setting.cells, task);
  // 3. Openings.
  parallel_for(task, walls.size(), 1, [&](size_t begin, size_t end) {
    for (size_t w = begin; w < end; ++w) {
      WallEvidence& evidence = out[walls[w]];
      evidence.cells = std::move(cells[w]);
      if (evidence.empty()) continue;
      evidence.openings = setting.openings.by_cells
                              ? decomposed_openings(evidence.cells, setting.openings, task)
                              : find_openings(evidence.cells, setting.openings, task,
                                              {segmentation.cloud.get(), sources[w].points});
      const auto area_of = [&](auto&& counts) {
        const auto& states = evidence.cells.states;
        return static_cast<double>(std::count_if(states.begin(), states.end(), counts)) *
               evidence.cells.cell_m * evidence.cells.cell_m;
      };
      evidence.gross_m2 = area_of([](WallState s) { return s != WallState::kOutside; });
      evidence.measured_m2 = area_of([](WallState s) { return s == WallState::kOn; });
    }
  });
}

void tell_planes(const Segmentation& segmentation, const EvidenceSetting& setting,
                 std::vector<WallEvidence>& out, Task& task) {
  // 1. Surrounds, panes, leaves and rooms.
  tell_roles(out, setting.cells, task);
  // 2. Loggias.
  tell_recesses(segmentation, out, task);
  // 3. Openings whose borders surrounds cover.
  settle_openings(segmentation, setting.cells, out, task);
}

std::vector<WallEvidence> gather_evidence(const Segmentation& segmentation,
                                          const EvidenceSetting& setting, Task& task) {
  std::vector<size_t> all(segmentation.segments.size());
  std::iota(all.begin(), all.end(), size_t{0});
  std::vector<WallEvidence> out;
  look_at_planes(segmentation, all, setting, out, task);
  tell_planes(segmentation, setting, out, task);
  return out;
}

void end_behind_walls(std::vector<WallEvidence>& all, double relief_m, Task& task) {
  for (WallEvidence& plane : all) {
    if (!plane.is_wall()) continue;
    task.checkpoint(0);
    std::vector<const WallEvidence*> fronts;
    for (const WallEvidence& wall : all)
      if (&wall != &plane && wall.is_wall() && wall.has_framed_openings() &&
          stands_beside(wall, plane))
        fronts.push_back(&wall);
    if (fronts.empty()) continue;
    leave_to(fronts, relief_m, plane.cells);
    for (OpeningCandidate& opening : plane.openings) {
      if (!opening.is_opening || is_framed(opening)) continue;
      opening.ends_at_wall = std::any_of(fronts.begin(), fronts.end(), [&](const auto* front) {
        return has_own(*front, plane, opening, relief_m);
      });
      opening.is_opening = !opening.ends_at_wall;
    }
  }
}

ContourMaker contours_by(std::vector<WallEvidence>& evidence) {
  return [&evidence](size_t segment, std::span<const Vec2> points, const ContourSetting& setting,
                     const ForeignTest& foreign, Task& task) {
    WallEvidence& wall = evidence[segment];
    Contour plain = extract_contour(points, setting, task, foreign);
    wall.is_plain = wall.is_wall() && wall.cells.set_back.empty() &&
                    has_holes_for(plain, covered_openings(wall)) &&
                    (shows(plain, shapes_of(wall.openings, true)) ||
                     shows(plain, shapes_of(wall.openings, false)));
    if (!wall.is_drawn()) return plain;
    return drawn_contour(points, wall.openings, plain, drawn_cells(evidence, wall), setting,
                         foreign, task);
  };
}

}  // namespace jalon
