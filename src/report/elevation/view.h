// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/model.h"
#include "segment/segmentation.h"

namespace jalon {

/// What an elevation looks at, and from where.
struct ElevationView {
  Transform T_view_world;
  std::string name;         ///< of the facade; "" for the whole model
  std::vector<bool> shown;  ///< one a face; empty: all

  bool shows(size_t face) const { return shown.empty() || shown[face]; }
  /// View coordinates: x to the right, y away from the eye, z world height.
  Vec3 operator()(const Vec3& p) const {
    Vec3 q = T_view_world.point(p);
    q.z -= T_view_world
               .m[11];  // the frame turns about Z: what it adds to the height is taken off again
    return q;
  }
  /// The eye's direction, clockwise from +Y (grid north).
  double azimuth_rad() const;
};

/// Parts of class facade, in their order.
std::vector<uint32_t> facade_parts(const Model& model);

/// facade 0: the whole model from the front of the segmentation's main facade. k = 1 ...: the k-th facade alone, and
/// what belongs to no facade, against the mean normal of its walls: drawing, frame and model tell the same side, that
/// of the segmentation's normals. Throws kInvalidArgument when there are fewer facades.
ElevationView elevation_view(const Segmentation& segmentation, const Model& model, int64_t facade);

}  // namespace jalon
