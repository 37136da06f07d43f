// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/buffer.h"
#include "base/task.h"
#include "cloud/cloud.h"

namespace jalon {

/// The cloud as beams are held against it: one point a cell, the one nearest to the cell's middle, in the segments'
/// frame.
struct SparsePlaces {
  double cell_m = 0.1;
  Buffer<double> xyz;  ///< 3 a place, in an order that is not the points'
};
/// O(points). In scenes so wide that a bit for each cell of their box were much beside the points, the centroids of the
/// cells.
SparsePlaces sparse_places(const Cloud& cloud, const Vec3& origin, Task& task);

}  // namespace jalon
