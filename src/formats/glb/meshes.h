// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/task.h"
#include "model/model.h"

namespace jalon::glb {

using Float3 = std::array<float, 3>;

/// What one part of a model, or its loose triangles, looks like: triangles with normals, and closed lines.
struct Mesh {
  uint32_t part = kNoPart;  ///< kNoPart: triangles of no part
  std::vector<Float3> places, normals;
  std::vector<uint32_t> corners;  ///< of triangles, three each
  std::vector<Float3> outline_places;
  std::vector<uint32_t> outline_ends;  ///< of lines, two each
  double sigma_m = 0;                  ///< the largest of its faces
  double area_m2 = 0;

  bool empty() const { return corners.empty() && outline_ends.empty(); }
};

/// One mesh for each part that has something to show, in their order, then the loose triangles. float32 counts from
/// the origin. No arcs are left in the model.
std::vector<Mesh> meshes_of(const Model& model, const Vec3& origin, Task& task);

}  // namespace jalon::glb
