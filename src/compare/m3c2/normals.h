// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "cloud/cloud.h"
#include "compare/m3c2/settings.h"
#include "spatial/neighbours/ball_ranges.h"
#include "spatial/neighbours/range_sums.h"
#include "spatial/neighbours/shape_search.h"

namespace jalon {

/// The directions along which core points are compared (step 1 of Lague, Brodu & Leroux 2013).
class CoreNormals {
 public:
  CoreNormals(const M3c2Settings& settings, const CloudPtr& source, const CloudPtr& core,
              Task& task);

  /// What one thread keeps between core points; its search is null where no points are looked at.
  struct Work {
    std::unique_ptr<ShapeSearch> search;
    std::vector<double> squared_m2;  ///< distances of the points around from the core point
    std::vector<BallRanges> balls;   ///< of each radius, where the cloud has crowds
  };
  Work work() const;

  struct Normal {
    Vec3 direction;
    double radius_m = 0;  ///< of the ball it comes from, 0 if none
    bool known = false;   ///< false: fewer than three points around, or all on a line
  };
  Normal at(size_t core_point, Work& work) const;
  /// Is it that of its place? Else it comes with the core point.
  bool is_of_place() const { return kind_ != M3c2Settings::Normals::kGiven; }

 private:
  using Sums = RangeSums<2, exact_place>;
  Normal plane_at(const Vec3& centre, Work& work) const;
  Normal plane_of_ranges(const Vec3& centre, Work& work) const;
  bool are_many_at(const Vec3& centre, Work& work) const;
  Vec3 oriented(const Vec3& centre, Vec3 normal, Work& work) const;
  uint32_t nearest_position(const Vec3& centre, Work& work) const;
  Vec3 given(size_t core_point) const;

  M3c2Settings::Normals kind_;
  M3c2Settings::Orientation orientation_;
  std::vector<double> radii_m_;  ///< ascending
  Vec3 direction_, viewpoint_;
  CloudPtr source_, core_;
  std::shared_ptr<const Octree> tree_;
  std::optional<Sums> sums_;  ///< of a cloud that has crowds: its balls may hold most of it
  ColumnPtr given_;
  bool by_station_ = false;
};

}  // namespace jalon
