// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/flat_triangles.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace jalon {

namespace {

constexpr size_t kGrain = 1 << 14;  // triangles a chunk: about 1 ms
/// Corners of a triangle without area give no plane: below this share of the longest side squared.
constexpr double kSliver = 1e-12;
constexpr double kOfFace_m = 1e-5;  // of a triangle's corners from the plane of its face

}  // namespace

FlatTriangles::FlatTriangles(const Model& model, Task& task)
    : model_(model), planes_(model.triangles.size()) {
  if (!model.triangles.empty()) {
    const Vec3& first = model.vertices[model.triangles[0][0]];
    origin_ = {std::floor(first.x), std::floor(first.y), std::floor(first.z)};
  }
  for (uint32_t f = 0; f < model.faces.size(); ++f) face_of_id_.try_emplace(model.faces[f].id, f);
  parallel_for(task, planes_.size(), kGrain, [&](size_t begin, size_t end) {
    for (size_t t = begin; t < end; ++t) planes_[t] = plane_of(static_cast<uint32_t>(t));
  });
}

const Face* FlatTriangles::face(uint32_t t) const {
  const auto found = face_of_id_.find(model_.triangle_faces[t]);
  return found == face_of_id_.end() ? nullptr : &model_.faces[found->second];
}

Plane FlatTriangles::plane_of(uint32_t t) const {
  const Plane none{{}, 0};
  const Face* const face = this->face(t);
  if (face == nullptr && !model_.faces.empty()) return none;
  const Vec3 a = corner(t, 1) - corner(t, 0), b = corner(t, 2) - corner(t, 0), twice = cross(a, b);
  const double length = norm(twice);
  if (!(length > kSliver * std::max(squared_norm(a), squared_norm(b)))) return none;
  // The face's plane says more than the rounded corners of a narrow triangle, unless the id is of several planes.
  if (face != nullptr) {
    const Plane plane{face->plane.normal, face->plane.offset - dot(face->plane.normal, origin_)};
    bool lies = true;
    for (size_t k = 0; k < 3; ++k)
      lies = lies && std::abs(plane.distance(corner(t, k))) <= kOfFace_m;
    if (lies) return plane;
  }
  return {twice / length, dot(twice / length, corner(t, 0))};
}

Box3 FlatTriangles::box(uint32_t t) const {
  Box3 box;
  for (size_t k = 0; k < 3; ++k) box.add(corner(t, k));
  return box;
}

bool FlatTriangles::lies_in(uint32_t t, const Plane& plane) const {
  for (size_t k = 0; k < 3; ++k)
    if (!(std::abs(plane.distance(corner(t, k))) <= kTouching_m)) return false;
  return true;
}

bool FlatTriangles::are_coplanar(uint32_t a, uint32_t b) const {
  return norm(cross(plane(a).normal, plane(b).normal)) <= kSamePlane_rad && lies_in(a, plane(b)) &&
         lies_in(b, plane(a));
}

}  // namespace jalon
