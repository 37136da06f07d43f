// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "model/model.h"

// What readers must find out of faces that come as bare rings.
namespace jalon {

constexpr size_t kMaxPartLevels = 64;  // of a tree of parts in a file; ours have five

/// Twice the vector area of a ring of vertices (Newell's sums), about a point near it: map coordinates lose nothing.
Vec3 twice_area(const Model& model, std::span<const uint32_t> ring, const Vec3& origin);

/// Plane and area of a face without arcs from its rings: the normal of the outline, the offset of its mean corner.
/// Holes are turned to run clockwise. False, and nothing set, when the outline has no area.
bool measure_face(Model& model, Face& face);

/// The corner of the model's box at whole metres below, from which files of short numbers count; zero for an empty one.
Vec3 whole_metre_corner(const Model& model);

}  // namespace jalon
