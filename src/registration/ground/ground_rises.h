// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/task.h"
#include "cloud/cloud.h"
#include "model/model.h"
#include "model/trajectory/trajectory.h"
#include "registration/ground/height_chain.h"
#include "spatial/triangles/tree.h"

namespace jalon {

/// The ground of a model: its faces of class "ground", as triangles; nullptr without any.
std::shared_ptr<const TriangleTree> ground_of(const Model& model, Task& task);

struct GroundSearch {
  std::vector<double> greatest_m;  ///< a point may be off the ground by that, of each control time
  double noise_m = 0;              ///< of a point's height
  uint64_t least_points = 1;       ///< of an interval; with fewer it tells nothing
};

/// For each interval between control times the median of how far the ground is above the points under the vehicle:
/// those within half a carriageway of it in plan. cloud: with "time", where drive has it. O(points log triangles),
/// parallel.
std::vector<GroundRise> ground_rises(const Cloud& cloud, const Trajectory& drive,
                                     std::span<const double> control_times_s,
                                     const TriangleTree& ground, const GroundSearch& search,
                                     Task& task);

}  // namespace jalon
