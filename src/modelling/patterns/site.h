// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "modelling/plane/ring_tools.h"
#include "modelling/walls/facade_parts.h"

namespace jalon {

// What the wall says about a place where a copy of an opening might go.

/// The face of the wall that this form lies in, or their number.
uint32_t piece_around(const FacadeWall& wall, std::span<const Vec2> form);

/// Spacing of the wall's points beside a box: that of the wall, more where only some of the cells have one (leaves,
/// a net before the wall).
double spacing_beside(const FacadeWall& wall, const RingBox& box);

/// Whether points of the wall lie in the form, or the map says nothing about it.
bool shows_wall(const FacadeWall& wall, std::span<const Vec2> form);

/// Whether more is seen through the hole than the form would let through: then the hole has another form.
bool shows_more(const FacadeWall& wall, const VectorRing& hole, std::span<const Vec2> form);

}  // namespace jalon
