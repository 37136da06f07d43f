// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "modelling/edges/find/edge_shape.h"
#include "modelling/edges/find/guide_lines.h"

namespace jalon {

/// Short edges across, of so few points that their own line is nowhere: put onto a guide near by.

/// Of an exactly vertical or horizontal edge between a and b. Nothing changes without such a guide.
void follow_guide(const GuideLines& guides, double spacing_m, const EdgeShape& a,
                  const EdgeShape& b, EdgeShape& edge);

/// Round a ring: short slanted edges between two vertical or two horizontal ones, and steps between
/// two of them that no edge joins. A step without a guide stands half way.
///
/// Before: edges in their order round the ring. After: the same edges in that order, some put onto
/// a guide, with steps between; every edge changed or added runs forward between its neighbours.
void guide_steps(const GuideLines& guides, double spacing_m, std::vector<EdgeShape>& ring);

}  // namespace jalon
