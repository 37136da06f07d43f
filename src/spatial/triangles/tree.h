// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>

#include "base/task.h"
#include "geometry/vec.h"

namespace jalon {

/// Points origin + t * direction with t_min <= t <= t_max; the direction need not be a unit vector.
struct Ray {
  Vec3 origin, direction;
  double t_min = 0, t_max = std::numeric_limits<double>::infinity();
};

struct RayHit {
  double t = 0;
  uint32_t triangle = 0;
};

/// Bounding volume hierarchy over triangles, four boxes a node. Immutable; any number of threads may query it.
///
/// It copies the corners as doubles relative to origin(), a whole metre, so that map coordinates lose nothing and a
/// shift by whole metres changes no bit. Boxes are floats, rounded outward. Triangles are seen from both sides; the
/// test is that of Woop, Benthin & Wald 2013 in doubles: no ray slips through between two triangles that share an
/// edge, and a ray that touches a corner or an edge hits. Answers equal a search of all triangles exactly: the least
/// t, then the least index. Triangles without area are no target.
class TriangleTree {
 public:
  /// vertices must be finite and the indices in range (see validate in model/). Throws kLimit above 2^32 - 2
  /// triangles or when the mesh spans more than 1e9 m. Parallel; the same bits for any number of threads.
  static std::shared_ptr<const TriangleTree> build(
      std::span<const Vec3> vertices, std::span<const std::array<uint32_t, 3>> triangles,
      Task& task);
  ~TriangleTree();

  size_t size() const;
  const Vec3& origin() const;
  /// Box of the corners relative to origin(); empty without triangles.
  const Box3& local_bounds() const;
  size_t memory_bytes() const;

  /// The nearest triangle on the ray; false when there is none. A direction of zero length or one that is not finite
  /// meets nothing.
  bool nearest(const Ray& ray, RayHit& hit) const;
  /// Whether any triangle is on the ray.
  bool occluded(const Ray& ray) const;

 private:
  TriangleTree();
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace jalon
