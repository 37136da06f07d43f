// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/evidence/evidence.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/parallel.h"
#include "modelling/evidence/cell_decomposition.h"
#include "modelling/evidence/contour_holes.h"
#include "modelling/evidence/drawn_contour.h"
#include "modelling/evidence/plane_roles.h"
#include "modelling/evidence/recesses.h"
#include "modelling/evidence/settled_openings.h"
#include "modelling/plane/segment_frame.h"
#include "segment/labels/label_groups.h"
#include "segment/upright.h"

namespace jalon {

namespace {

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
    return drawn_contour(points, wall.openings, plain, wall.cells, setting, foreign, task);
  };
}

}  // namespace jalon
