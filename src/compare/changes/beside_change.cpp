// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/changes/beside_change.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "compare/changes/object_shape.h"

namespace jalon {

namespace {

constexpr size_t kBesideSample =
    200;  // points of a change that are asked for what lies beside them
constexpr uint32_t kBesideNeighbours = 24;
constexpr size_t kLeastBorderPoints = 5;  // of the changed ones beside a border point, for a plane
constexpr double kUnsureBorders = 5;      // of few border points nothing is sure

// Of a plane through them; zero where there is none.
Vec3 normal_of(const Moments& moments) {
  PlaneFit fit;
  return moments.n >= kLeastBorderPoints && fit_plane(moments, fit) ? fit.plane.normal : Vec3{};
}

}  // namespace

double Beside::border_along() const {
  return along / (static_cast<double>(borders) + kUnsureBorders);
}

void add_beside(const Epoch& epoch, const Epoch& other, const std::vector<uint32_t>& points,
                double near_m, Task& task, Beside& out) {
  if (points.empty()) return;
  const auto tree = epoch.cloud().octree(task), other_tree = other.cloud().octree(task);
  const auto statuses = epoch.statuses();
  const auto distance = epoch.comparison->points.require("distance").values<double>();
  std::array<Neighbour, kBesideNeighbours> found;
  for (size_t k = 0; k < points.size(); k += points.size() / kBesideSample + 1) {
    if (epoch.regions.labels[points[k]] == 0) continue;
    const Vec3 place = epoch.cloud().point(points[k]);
    const size_t n = tree->knn(place, kBesideNeighbours, found);
    Moments changed;
    changed.reference = place;
    size_t same = 0;
    for (size_t j = 0; j < n; ++j) {
      const uint32_t i = found[j].index;
      ++out.asked;
      if (epoch.regions.labels[i] != 0) {
        changed.add(epoch.cloud().point(i));
        continue;
      }
      const bool is_hidden = statuses[i] == static_cast<uint8_t>(CompareStatus::kHidden);
      out.hidden += is_hidden ? 1 : 0;
      same += is_hidden ? 0 : 1;
    }
    out.same += same;
    if (same == 0) continue;
    ++out.borders;
    const uint32_t nearest = epoch.nearest(points[k]);
    if (nearest == kNoPoint || !(std::abs(distance[points[k]]) <= near_m)) continue;
    out.along += std::abs(dot(normal_of(changed), surface_normal_at(*other_tree, other.cloud(),
                                                                    other.cloud().point(nearest))));
  }
}

}  // namespace jalon
