// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/task.h"
#include "modelling/plane/cell_rows.h"
#include "modelling/plane/plane_frame.h"
#include "segment/segmentation.h"

namespace jalon {

/// What of the cloud is looked at about the edges of a plane.
struct NearSetting {
  double reach_m = 0.1;    ///< from the edges, in the plane (at least)
  double depth_m = 0.3;    ///< behind and in front of the plane (at least)
  double window_m = 0.01;  ///< half-thickness: points this near to the plane lie on it
};

/// The points of the whole cloud near the edges of one plane, in its coordinates.
struct NearPoints : PointRows {
  std::vector<float> heights_m;  ///< in front of the plane; negative behind
  std::vector<uint8_t>
      on_plane;  ///< 1: within the window, and not of another surface parallel to it
};

/// Looks up the octree cells along the polylines (plane coordinates): the cost follows the length
/// of the edges, about 30 ns a point there.
///
/// Before: planes_parallel[s] tells whether segment s + 1 is another surface parallel to this
/// plane. After: each point once, heights_m and on_plane as long as points; sorted into rows, so
/// that boxes can be looked up. Some points farther than reach_m and depth_m may be among them.
NearPoints points_near(const Segmentation& segmentation, const Octree& tree,
                       const PlaneFrame& frame, std::span<const std::vector<Vec2>> rings,
                       std::span<const uint8_t> planes_parallel, const NearSetting& setting,
                       Task& task);

}  // namespace jalon
