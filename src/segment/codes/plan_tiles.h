// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "cloud/cloud.h"
#include "segment/codes/coded_object.h"

namespace jalon {

/// The points of a cloud by tiles of its plan, 4 bytes a point: what is near a place of a list is found without a pass
/// through the cloud.
class PlanTiles {
 public:
  /// Places are relative to origin.
  PlanTiles(const Cloud& cloud, const Vec3& origin, Task& task);

  /// Indices, ascending, of the points of all tiles that a circle in plan meets.
  std::vector<uint32_t> points_about(const Vec2& place, double radius_m) const;

 private:
  size_t tile_of(const Vec3& p) const;

  Vec2 low_;
  double tile_m_ = 1;
  size_t columns_ = 0, rows_ = 0;
  std::vector<uint64_t> first_;  ///< of each tile among members_, and their number
  std::vector<uint32_t> members_;
};

}  // namespace jalon
