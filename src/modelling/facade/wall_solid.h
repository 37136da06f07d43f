// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "modelling/plane/face_builder.h"
#include "modelling/facade/plan.h"

namespace jalon {

/// Draws all arcs of the walls and their openings as chords, the same in faces, openings and shadows.
void draw_chords(FacadePlan& plan, double chord_error_m);

/// Thickness of each facade's walls: the median depth of its openings (Boulaassal 2010, 4.4.2), or that of all facades'
/// where it has none with a known depth. given_m > 0 overrides. Throws kInsufficientData when nothing tells it.
std::vector<double> wall_thicknesses(const FacadePlan& plan, double given_m);

/// A wall's face (straight edges) as a closed volume: the front; the back, thickness_m behind it; the sides between
/// both, of the outline under front.part, of opening k under reveal_parts[k]. hole_parts[k]: what fills opening k. The
/// normals look outward; every edge is shared by two of the faces.
void append_wall_solid(Model& model, PlaneVertices& vertices, const VectorFace& face,
                       const Face& front, const std::vector<uint32_t>& hole_parts,
                       const std::vector<uint32_t>& reveal_parts, double thickness_m);

}  // namespace jalon
