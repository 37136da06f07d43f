// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "modelling/edges/adjust/edge_blocks.h"
#include "modelling/plane/vector_plane.h"

namespace jalon {

/// The upright and level sides of a ring that is drawn as a given form, one an edge of the ring, with the sigma and
/// source that the form has; what is slanted or curved has no length.
std::vector<MeasuredEdge> sides_of(const VectorRing& form);

/// The form with its sides where they were measured. sides: of sides_of(form), moved across themselves. Slanted and
/// curved edges go along with their ends. A ring that would turn inside out stays as it is.
VectorRing with_sides(const VectorRing& form, std::span<const MeasuredEdge> sides);

}  // namespace jalon
