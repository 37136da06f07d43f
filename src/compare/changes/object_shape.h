// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "compare/changes/change_objects.h"
#include "spatial/octree/octree.h"

namespace jalon {

/// Normal of the local plane at a place of a cloud; zero where there is none.
Vec3 surface_normal_at(const Octree& tree, const Cloud& cloud, const Vec3& place);

/// How a change meets the unchanged part of the same object.
struct BorderOfChange {
  size_t points = 0;  ///< changed ones with an unchanged one within reach
  std::vector<double>
      parallel_m;  ///< distances of those whose surface faces as that of the other epoch does

  /// Share of the border where the distance grows from nothing, surface along surface: a dent or a bulge. The foot of a
  /// thing that was put there has small distances too, but stands up from the surface.
  double soft_share(double threshold_m) const;
  bool is_soft(double threshold_m) const;
};

/// points: of the object in this epoch, ascending. reach_m: within which an unchanged point lies beside a changed one.
BorderOfChange border_of_change(const Epoch& epoch, const Epoch& other,
                                const std::vector<uint32_t>& points, double reach_m, Task& task);

/// Takes away changed regions that are but the rim of a shadow: most of their points lie beside hidden ones, and within
/// the margin of the visibility test; there a point is called visible though another surface is nearer to the scanner.
void drop_shadow_rims(Epoch& epoch, double threshold_m, double cell_m);

}  // namespace jalon
