// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "base/task.h"
#include "solid/convex_piece.h"
#include "solid/triangle_boxes.h"
#include "spatial/triangles/nearest.h"

namespace jalon {

/// Triangles of a part of a model, and whether they enclose a volume: only then is there an inside to be in.
class PartSurface {
 public:
  /// Triangles that enclose a volume but face inward are turned.
  PartSurface(std::vector<Vec3> vertices, std::vector<std::array<uint32_t, 3>> triangles,
              Task& task);

  const TriangleBoxes& boxes() const { return *boxes_; }
  const NearestTriangles& nearest() const { return *nearest_; }
  /// Every side of a triangle is that of one other, which runs along it the other way (equal corners are one).
  bool is_closed() const { return closed_; }
  /// The volume, where it is convex and has few corners.
  const std::optional<ConvexPiece>& convex() const { return convex_; }

 private:
  std::unique_ptr<const TriangleBoxes> boxes_;
  std::shared_ptr<const NearestTriangles> nearest_;
  bool closed_ = false;
  std::optional<ConvexPiece> convex_;
};

}  // namespace jalon
