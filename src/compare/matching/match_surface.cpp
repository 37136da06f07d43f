// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/matching/match_surface.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/parallel.h"
#include "geometry/plane.h"

namespace jalon {

namespace {

constexpr uint32_t kNeighbours =
    12;                      // of a local plane: the usual choice for normals of scans (A.2)
constexpr double kFlat = 2;  // times the median scatter; a plane across an edge has many times that

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

MatchSurface::MatchSurface(std::vector<Vec3> points, Task& task)
    : points_(std::move(points)),
      normals_(points_.size()),
      radii_(points_.size()),
      scatter_(points_.size()),
      xyz_(3 * points_.size()) {
  for (size_t i = 0; i < points_.size(); ++i)
    for (int k = 0; k < 3; ++k) xyz_.data()[3 * i + static_cast<size_t>(k)] = points_[i][k];
  for (const Vec3& p : points_) {
    centroid_ += p;
    box_.add(p);
  }
  if (points_.empty()) return;
  centroid_ = centroid_ / static_cast<double>(points_.size());
  tree_ = Octree::build(xyz_, enclosing_cube(box_), task);
  measure(task);
  median_radius_ = median_of(radii_);
  flat_scatter_ = kFlat * median_of(scatter_);
}

void MatchSurface::measure(Task& task) {
  parallel_for(task, points_.size(), 256, [&](size_t begin, size_t end) {
    std::array<Neighbour, kNeighbours> found;
    for (size_t i = begin; i < end; ++i) {
      const size_t n = tree_->knn(points_[i], kNeighbours, found);
      Moments moments;
      moments.reference = points_[i];
      for (size_t k = 0; k < n; ++k) moments.add(points_[found[k].index]);
      PlaneFit fit;
      if (fit_plane(moments, fit)) {
        normals_[i] = fit.plane.normal;
        scatter_[i] = fit.sigma;
      }
      radii_[i] = n > 1 ? std::sqrt(found[n - 1].squared_distance / static_cast<double>(n - 1)) : 0;
    }
  });
}

Neighbour MatchSurface::nearest(const Vec3& p) const {
  std::array<Neighbour, 1> found{};
  tree_->knn(p, 1, found);
  return found[0];
}

std::vector<Vec3> MatchSurface::sample(size_t most) const {
  std::vector<Vec3> out;
  if (most == 0) return out;
  const size_t step = (points_.size() + most - 1) / most;
  for (size_t i = 0; i < points_.size(); i += step) out.push_back(points_[i]);
  return out;
}

}  // namespace jalon
