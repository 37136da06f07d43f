// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "modelling/edges/find/straighten.h"
#include "modelling/plane/vector_plane.h"

namespace jalon {

/// Forms of one ring, the most wanted first, the chain it came from last.
struct RingForms {
  std::vector<VectorRing> rings;
  std::vector<Polygon> flat;  ///< with chords for arcs
  void add(VectorRing ring, double chord_error_m) {
    if (ring.corners.size() < 2) return;
    flat.push_back(flattened(ring, chord_error_m));
    rings.push_back(std::move(ring));
  }
};

/// Which form of each ring, so that openings lie inside the outline and apart from each other: each
/// ring takes its most wanted form, and rings in conflict step down to the next until none is left.
///
/// Before: rings[0] is the outline; each has a form at least, and their last forms, the chains, do
/// not conflict. After: an index into the forms of each ring. O(rings^2) box tests a round.
std::vector<size_t> nested(std::span<const RingForms> rings);

}  // namespace jalon
