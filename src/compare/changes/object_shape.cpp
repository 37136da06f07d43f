// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/changes/object_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <memory>
#include <set>

namespace jalon {

namespace {

constexpr double kSoft = 1.5;  // thresholds: what is just beyond one has grown from nothing
constexpr double kSoftShare = 0.5;
constexpr size_t kLeastBorder = 10;
constexpr double kRimShare = 0.5;  // of a rim's points have a hidden one beside them
// Thresholds: the margins of the visibility test are of the size of the threshold, and longer than that on surfaces
// that rays graze.
constexpr double kRimDistance = 4;
constexpr double kRimQuantile = 0.9;
constexpr double kParallel = 0.866;  // cosine of 30 degrees: surfaces that face the same way
constexpr uint32_t kPlaneNeighbours = 12;

using Cell = std::array<int64_t, 3>;

Cell cell_at(const Vec3& p, double cell_m) {
  return {static_cast<int64_t>(std::floor(p.x / cell_m)),
          static_cast<int64_t>(std::floor(p.y / cell_m)),
          static_cast<int64_t>(std::floor(p.z / cell_m))};
}

bool touches(const std::set<Cell>& cells, const Cell& at) {
  for (int64_t x = -1; x <= 1; ++x)
    for (int64_t y = -1; y <= 1; ++y)
      for (int64_t z = -1; z <= 1; ++z)
        if (cells.count({at[0] + x, at[1] + y, at[2] + z}) != 0) return true;
  return false;
}

// The unchanged ones of an object's points. What counts is the distance to them and not the cell that holds them: where
// the threshold's height is that of a cell's face, changed and unchanged points share no cell.
class UnchangedPoints {
 public:
  UnchangedPoints(const Epoch& epoch, const std::vector<uint32_t>& points, Task& task) {
    std::vector<Vec3> unchanged;
    Box3 box;
    for (const uint32_t i : points)
      if (epoch.is_compared(i) && epoch.regions.changed[i] == 0) {
        unchanged.push_back(epoch.local(i));
        box.add(unchanged.back());
      }
    if (unchanged.empty()) return;
    xyz_ = Buffer<double>(3 * unchanged.size());
    std::memcpy(xyz_.data(), unchanged.data(), xyz_.size() * sizeof(double));
    tree_ = Octree::build(xyz_, enclosing_cube(box), task);
  }
  bool are_beside(const Vec3& p, double reach_m) const {
    Neighbour nearest{};
    return tree_ != nullptr && tree_->nearest_within(p, reach_m, nearest);
  }

 private:
  Buffer<double> xyz_;
  std::shared_ptr<const Octree> tree_;
};

// Cells around the regions that hold hidden points.
std::set<Cell> hidden_cells(const Epoch& epoch, double cell_m) {
  std::set<Cell> near, hidden;
  for (const ChangeRegion& region : epoch.regions.regions)
    for (const uint32_t i : region.indices) near.insert(cell_at(epoch.local(i), cell_m));
  const auto statuses = epoch.statuses();
  for (size_t i = 0; i < statuses.size(); ++i) {
    if (statuses[i] != static_cast<uint8_t>(CompareStatus::kHidden)) continue;
    const Cell at = cell_at(epoch.local(i), cell_m);
    if (hidden.count(at) == 0 && touches(near, at)) hidden.insert(at);
  }
  return hidden;
}

bool is_rim(const Epoch& epoch, const ChangeRegion& region, const std::set<Cell>& hidden,
            double threshold_m, double cell_m) {
  const auto distance = epoch.comparison->points.require("distance").values<double>();
  std::vector<double> sizes;
  size_t beside = 0;
  for (const uint32_t i : region.indices) {
    beside += touches(hidden, cell_at(epoch.local(i), cell_m)) ? 1 : 0;
    sizes.push_back(std::abs(distance[i]));
  }
  const auto at = sizes.begin() +
                  static_cast<std::ptrdiff_t>(kRimQuantile * static_cast<double>(sizes.size() - 1));
  std::nth_element(sizes.begin(), at, sizes.end());
  return static_cast<double>(beside) >= kRimShare * static_cast<double>(sizes.size()) &&
         *at <= kRimDistance * threshold_m;
}

}  // namespace

Vec3 surface_normal_at(const Octree& tree, const Cloud& cloud, const Vec3& place) {
  std::array<Neighbour, kPlaneNeighbours> found;
  const size_t n = tree.knn(place, kPlaneNeighbours, found);
  Moments moments;
  moments.reference = place;
  for (size_t k = 0; k < n; ++k) moments.add(cloud.point(found[k].index));
  PlaneFit fit;
  return fit_plane(moments, fit) ? fit.plane.normal : Vec3{};
}

void drop_shadow_rims(Epoch& epoch, double threshold_m, double cell_m) {
  const std::set<Cell> hidden = hidden_cells(epoch, cell_m);
  std::vector<ChangeRegion> kept;
  for (ChangeRegion& region : epoch.regions.regions) {
    const bool drop = is_rim(epoch, region, hidden, threshold_m, cell_m);
    if (!drop) region.label = static_cast<uint32_t>(kept.size() + 1);
    for (const uint32_t i : region.indices) epoch.regions.labels[i] = drop ? 0 : region.label;
    if (!drop) kept.push_back(std::move(region));
  }
  epoch.regions.regions = std::move(kept);
}

double BorderOfChange::soft_share(double threshold_m) const {
  if (points < kLeastBorder) return 0;
  const auto soft = std::count_if(parallel_m.begin(), parallel_m.end(),
                                  [&](double d) { return d <= kSoft * threshold_m; });
  return static_cast<double>(soft) / static_cast<double>(points);
}

bool BorderOfChange::is_soft(double threshold_m) const {
  return soft_share(threshold_m) > kSoftShare;
}

BorderOfChange border_of_change(const Epoch& epoch, const Epoch& other,
                                const std::vector<uint32_t>& points, double reach_m, Task& task) {
  BorderOfChange out;
  const UnchangedPoints unchanged(epoch, points, task);
  const auto distance = epoch.comparison->points.require("distance").values<double>();
  const auto tree = epoch.cloud().octree(task), other_tree = other.cloud().octree(task);
  for (const uint32_t i : points) {
    if (epoch.regions.labels[i] == 0 || !unchanged.are_beside(epoch.local(i), reach_m)) continue;
    ++out.points;
    if (epoch.nearest(i) == kNoPoint) continue;
    const Vec3 here = surface_normal_at(*tree, epoch.cloud(), epoch.cloud().point(i));
    const Vec3 there =
        surface_normal_at(*other_tree, other.cloud(), other.cloud().point(epoch.nearest(i)));
    if (std::abs(dot(here, there)) > kParallel) out.parallel_m.push_back(std::abs(distance[i]));
  }
  return out;
}

}  // namespace jalon
