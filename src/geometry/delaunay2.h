// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "geometry/vec.h"

namespace jalon {

class Task;

/// Snapping step of delaunay(): a tenth of a millimetre.
constexpr double kDelaunayGrid_m = 1e-4;

/// 2D Delaunay triangles, anticlockwise, as indices of the points; the convex hull is covered.
///
/// Points are snapped to a grid of grid_m about the lowest corner of their box, so that every
/// decision is exact (integers).
/// - Of the points on one grid node the first takes part, the others are in no triangle.
/// - Fewer than three distinct nodes, or collinear ones: no triangles.
/// - Where four or more nodes lie on one circle any split is right; the same one is taken on every machine.
/// - Coordinates must be finite and span less than 2^30 steps: else Error(kLimit).
/// - task (optional) is asked now and then whether to stop.
/// O(n log n); about 1.5 us a point at a million.
/// Source: Guibas & Stolfi 1985, divide and conquer.
std::vector<std::array<uint32_t, 3>> delaunay(std::span<const Vec2> points,
                                              double grid_m = kDelaunayGrid_m,
                                              Task* task = nullptr);

/// The same with memory kept between calls, for very many small sets.
class Delaunay {
 public:
  Delaunay();
  ~Delaunay();
  Delaunay(const Delaunay&) = delete;
  Delaunay& operator=(const Delaunay&) = delete;
  /// Valid until the next call.
  std::span<const std::array<uint32_t, 3>> run(std::span<const Vec2> points, double grid_m,
                                               Task* task = nullptr);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace jalon
