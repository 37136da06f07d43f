// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/evidence/settled_openings.h"

#include <cmath>

#include "base/parallel.h"
#include "modelling/evidence/point_fit.h"
#include "segment/labels/label_groups.h"

namespace jalon {

namespace {

constexpr double kCoveringParallel = 0.985;  // cosine of 10 degrees

struct CoveredOpening {
  OpeningCandidate* opening = nullptr;
  RingBox window;
  std::vector<Vec2> solid;
};

std::vector<CoveredOpening> covered_openings(WallEvidence& wall) {
  std::vector<CoveredOpening> out;
  if (!wall.is_wall()) return out;
  for (OpeningCandidate& opening : wall.openings)
    if (opening.is_opening && opening.relief >= kReliefShare && !opening.is_settled)
      out.push_back({&opening, fitting_window(opening.shape, wall.cells), {}});
  return out;
}

bool is_relief_at(const WallCells& cells, const Vec2& p) {
  const double c = (p.u - cells.origin.u) / cells.cell_m, r = (p.v - cells.origin.v) / cells.cell_m;
  return c >= 0 && r >= 0 && c < cells.columns && r < cells.rows &&
         cells.at(static_cast<uint32_t>(c), static_cast<uint32_t>(r)) == WallState::kRelief;
}

bool covers(const WallEvidence& plane, const WallEvidence& wall) {
  return !plane.empty() && plane.role == PlaneRole::kRelief &&
         std::fabs(dot(plane.cells.frame.normal, wall.cells.frame.normal)) >= kCoveringParallel;
}

}  // namespace

void settle_openings(const Segmentation& segmentation, const CellSetting& cells,
                     std::vector<WallEvidence>& all, Task& task) {
  const Cloud& cloud = *segmentation.cloud;
  const LabelGroups groups(segmentation.labels->values<uint32_t>(), all.size(), task);
  parallel_for(task, all.size(), 1, [&](size_t begin, size_t end) {
    for (size_t w = begin; w < end; ++w) {
      WallEvidence& wall = all[w];
      std::vector<CoveredOpening> covered = covered_openings(wall);
      if (covered.empty()) continue;
      const PlaneFrame& frame = wall.cells.frame;
      for (size_t s = 0; s < all.size(); ++s) {
        if (s != w && !covers(all[s], wall)) continue;
        task.checkpoint(0);
        for (const uint32_t i : groups.of(static_cast<uint32_t>(s + 1))) {
          const Vec3 p = cloud.point(i);
          const double out = dot(p - frame.origin, frame.normal) - frame.height;
          if (s != w && (out < 0 || out > cells.proud_m)) continue;
          const Vec2 q = frame.project(p);
          if (s != w && out > cells.relief_m && !is_relief_at(wall.cells, q)) continue;
          if (s == w && wall.cells.is_set_back(q)) continue;
          for (CoveredOpening& c : covered)
            if (c.window.holds(q)) c.solid.push_back(q);
        }
      }
      for (const CoveredOpening& c : covered) {
        task.checkpoint(0);
        c.opening->shape = fitted_to_points(c.opening->shape, wall.cells, c.solid);
        c.opening->is_settled = true;
      }
    }
  });
}

}  // namespace jalon
