// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "base/buffer.h"
#include "base/task.h"
#include "model/model.h"

namespace jalon {

/// The triangles of a model that may belong to a plane, and their planes, relative to an origin of whole metres. The
/// model must be valid and outlive it.
class FlatTriangles {
 public:
  FlatTriangles(const Model& model, Task& task);

  uint32_t size() const { return static_cast<uint32_t>(planes_.size()); }
  const Vec3& origin() const { return origin_; }
  /// False without area and, in a model with faces, for a triangle whose id is no face's: a curved surface.
  bool is_flat(uint32_t t) const { return !(planes_[t].normal == Vec3{}); }
  const Plane& plane(uint32_t t) const { return planes_[t]; }
  Vec3 corner(uint32_t t, size_t k) const {
    return model_.vertices[model_.triangles[t][k % 3]] - origin_;
  }
  double area(uint32_t t) const {
    return norm(cross(corner(t, 1) - corner(t, 0), corner(t, 2) - corner(t, 0))) / 2;
  }
  Box3 box(uint32_t t) const;
  /// The first face of the triangle's id, or nullptr.
  const Face* face(uint32_t t) const;
  bool lies_in(uint32_t t, const Plane& plane) const;
  /// Normals within 0.001 degrees (whichever side), and the corners of each within 0.1 mm of the other's plane.
  bool are_coplanar(uint32_t a, uint32_t b) const;

 private:
  Plane plane_of(uint32_t t) const;

  const Model& model_;
  Vec3 origin_;
  std::unordered_map<uint32_t, uint32_t> face_of_id_;
  Buffer<Plane> planes_;
};

constexpr double kSamePlane_rad = 1.7453292519943296e-5;  ///< 0.001 degrees
constexpr double kTouching_m = 1e-4;  ///< 0.1 mm: as far apart as triangles of a plane may be

}  // namespace jalon
