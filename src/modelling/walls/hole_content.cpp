// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/walls/hole_content.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace jalon {

namespace {

constexpr double kHoleContentParallel = 0.985;  // 10 degrees, as walls of one facade
constexpr double kHoleContentUpright = 0.174;   // 10 degrees from upright to the wall
constexpr uint32_t kBlock = 4;                  // cells a side

double quantile(std::vector<float>& values, double share) {
  const auto at =
      values.begin() + static_cast<ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

HoleFiller filler_of(std::span<const HolePoint> points, const WallMap& map, Task& task) {
  HoleFiller out;
  out.label = points.front().label;
  out.points = points.size();
  std::vector<float> depths;
  std::vector<uint32_t> cells;
  for (const HolePoint& p : points) {
    depths.push_back(-p.w);
    const auto column = static_cast<uint32_t>((p.u - map.origin.u) / map.cell_m);
    const auto row = static_cast<uint32_t>((p.v - map.origin.v) / map.cell_m);
    cells.push_back(row * map.columns + column);
    out.blocks.push_back(row / kBlock * map.columns + column / kBlock);
  }
  for (auto* list : {&cells, &out.blocks}) {
    task.checkpoint(0);
    std::sort(list->begin(), list->end());
    list->erase(std::unique(list->begin(), list->end()), list->end());
  }
  out.cells = static_cast<uint32_t>(cells.size());
  out.depth_m = quantile(depths, 0.5);
  return out;
}

}  // namespace

HoleContent content_of(const HoleSurvey& hole, const WallMap& map, const Segmentation& segmentation,
                       const Vec3& normal, uint32_t own_label, Task& task) {
  HoleContent out;
  std::map<uint32_t, std::vector<HolePoint>> by_label;
  for (const HolePoint& p : hole.points)
    if (p.label != own_label) by_label[p.label].push_back(p);
  for (const auto& [label, points] : by_label) {
    task.checkpoint(0);
    const HoleFiller filler = filler_of(points, map, task);
    const Segment* segment = filler.label == 0 ? nullptr : &segmentation.segments[filler.label - 1];
    const double cosine = segment != nullptr && segment->has_plane()
                              ? std::fabs(dot(segment->fit.plane.normal, normal))
                              : 0.5;
    (cosine >= kHoleContentParallel  ? out.parallel
     : cosine <= kHoleContentUpright ? out.upright
                                     : out.other)
        .push_back(filler);
  }
  for (auto* fillers : {&out.parallel, &out.upright, &out.other})
    std::stable_sort(fillers->begin(), fillers->end(),
                     [](const HoleFiller& a, const HoleFiller& b) { return a.cells > b.cells; });
  return out;
}

}  // namespace jalon
