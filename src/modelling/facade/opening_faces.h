// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "modelling/plane/face_builder.h"
#include "modelling/walls/facade_parts.h"

namespace jalon {

/// Chords of a reveal's arc lie at most this far from it: reveals are planar strips (Boulaassal 2010, 4.4.2).
constexpr double kRevealChord_m = 0.001;

/// What fills an opening, under its part: a part "joinery" with a pane parallel to the wall at the
/// opening's depth, of the outline projected along the wall's normal; and a part "reveal" with one
/// planar face a straight edge of the outline, and strips along its arcs.
///
/// After: they use the vertices of the wall's hole, so that no gap is left; where the depth is unknown
/// nothing but, at the wall's border, the opening's own face in the wall's plane; no reveals where the pane does not
/// lie behind the wall.
void append_opening_faces(Model& model, PlaneVertices& wall, const FacadeOpening& opening,
                          uint32_t opening_part, const Face& joinery, bool with_reveals);

/// Sides between a ring at w_front and the same ring at w_back, both seen against the wall's normal: quads that look to
/// the right of the walk when outward, else to its left.
void append_sides(Model& model, PlaneVertices& wall, const VectorRing& ring, double w_front,
                  double w_back, bool to_the_right, uint32_t part);

}  // namespace jalon
