// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/vec.h"
#include "model/model.h"

namespace jalon {

/// Triangles of a polygon with openings: rings[0] is the outline, the others its openings, in any
/// sense of rotation; indices count through all rings. Every triangle runs counter-clockwise;
/// openings stay open; no vertices are added. Ear clipping with the openings joined to the outline
/// by bridges (Eberly 2002, "Triangulation by Ear Clipping"). O(n r), r = reflex corners. Polygons
/// that cross themselves give n - 2 triangles all the same.
std::vector<std::array<uint32_t, 3>> triangulate(const std::vector<std::vector<Vec2>>& rings);

/// Two axes that make a right-handed frame with the normal.
struct PlaneAxes {
  Vec3 u, v;
  Vec2 project(const Vec3& p, const Vec3& origin) const {
    return {dot(p - origin, u), dot(p - origin, v)};
  }
};
PlaneAxes axes_of(const Vec3& normal);
/// Normal of a polygon by Newell's sums, not normalised.
Vec3 newell_normal(std::span<const Vec3> corners);

/// Adds a polygon without openings to the mesh of a model, as triangles with this face id. Fewer
/// than 3 corners add nothing.
void append_polygon(Model& model, std::span<const uint32_t> corners, uint32_t face_id);
/// Triangles of a face of a model, as vertex numbers, counter-clockwise seen against its normal.
std::vector<std::array<uint32_t, 3>> triangles_of_face(const Model& model, const Face& face);

/// Triangles of the mesh that no face stands for: those whose number is not the id of a face. (A scanned scene has its
/// faces as triangles too.) Ascending.
std::vector<uint32_t> loose_triangles(const Model& model);
/// True when the numbers of a mesh without faces are its parts.
bool is_mesh_by_part(const Model& model);

}  // namespace jalon
