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
constexpr size_t kLeastBorderPoints = 5;  // of the changed ones beside a changed point, for a plane
constexpr double kUnsureBeside = 5;       // of few points nothing is sure

// Of a plane through them; zero where there is none.
Vec3 normal_of(const Moments& moments) {
  PlaneFit fit;
  return moments.n >= kLeastBorderPoints && fit_plane(moments, fit) ? fit.plane.normal : Vec3{};
}

struct Around {
  Moments changed;
  bool is_border = false;
};

// What lies about a changed point of an epoch.
Around add_around(const Epoch& epoch, const Octree& tree, const Vec3& place, Beside& out) {
  const auto statuses = epoch.statuses();
  std::array<Neighbour, kBesideNeighbours> found;
  const size_t n = tree.knn(place, kBesideNeighbours, found);
  Around around;
  around.changed.reference = place;
  size_t same = 0;
  for (size_t j = 0; j < n; ++j) {
    const uint32_t i = found[j].index;
    if (epoch.regions.labels[i] != 0) {
      around.changed.add(epoch.cloud().point(i));
      continue;
    }
    const bool is_hidden = statuses[i] == static_cast<uint8_t>(CompareStatus::kHidden);
    out.hidden += is_hidden ? 1 : 0;
    same += is_hidden ? 0 : 1;
  }
  out.asked += n;
  out.same += same;
  around.is_border = same > 0;
  return around;
}

double cautious(double sum, size_t n) { return sum / (static_cast<double>(n) + kUnsureBeside); }

// Does the first epoch no more see the surface there, or see that it went?
bool is_gone(const Epoch& other, uint32_t i) {
  return other.regions.labels[i] != 0 ||
         other.statuses()[i] == static_cast<uint8_t>(CompareStatus::kHidden);
}

}  // namespace

double Beside::border_along() const { return cautious(along, borders); }
double Beside::gone_share() const { return cautious(static_cast<double>(gone), measured); }
double Beside::facing_share() const { return cautious(facing, measured); }
double Beside::facing_gone_share() const { return cautious(facing_gone, measured); }

void add_beside(const Epoch& epoch, const Epoch& other, const std::vector<uint32_t>& points,
                double near_m, Task& task, Beside& out) {
  if (points.empty()) return;
  const auto tree = epoch.cloud().octree(task), other_tree = other.cloud().octree(task);
  const auto distance = epoch.comparison->points.require("distance").values<double>();
  for (size_t k = 0; k < points.size(); k += points.size() / kBesideSample + 1) {
    const uint32_t i = points[k];
    if (epoch.regions.labels[i] == 0) continue;
    const Around around = add_around(epoch, *tree, epoch.cloud().point(i), out);
    out.borders += around.is_border ? 1 : 0;
    const uint32_t nearest = epoch.nearest(i);
    if (nearest == kNoPoint) continue;
    const double facing =
        std::abs(dot(normal_of(around.changed),
                     surface_normal_at(*other_tree, other.cloud(), other.cloud().point(nearest))));
    const bool is_gone_there = is_gone(other, nearest);
    ++out.measured;
    out.gone += is_gone_there ? 1 : 0;
    out.facing += facing;
    out.facing_gone += is_gone_there ? facing : 0;
    if (around.is_border && std::abs(distance[i]) <= near_m) out.along += facing;
  }
}

}  // namespace jalon
