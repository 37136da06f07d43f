// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "modelling/plane/ring_tools.h"
#include "modelling/walls/facade_parts.h"

namespace jalon {

struct PatternSetting;

/// The outline with its arcs as chords.
std::vector<Vec2> outline_points(const VectorRing& ring);

/// Openings of one kind, size and form.
struct Pattern {
  size_t best = 0;              ///< the one to copy
  std::vector<size_t> members;  ///< ascending, the best one among them
  RingBox box;                  ///< of the best one
};

/// Measured well enough to be copied.
bool is_well_measured(const FacadeOpening& opening, const FacadeWall& wall,
                      const PatternSetting& setting);

/// Every well measured opening belongs to one pattern, perhaps alone. After: the pattern of the
/// best measured opening first; no opening in two.
std::vector<Pattern> find_patterns(const FacadeWall& wall, const PatternSetting& setting);

}  // namespace jalon
