// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "geometry/vec.h"
#include "modelling/plane/vector_plane.h"

namespace jalon {

/// Upright box of a ring in its plane; empty as made.
struct RingBox {
  Vec2 low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};

  void add(const Vec2& p);
  void add(std::span<const Vec2> points);
  double width() const { return high.u - low.u; }
  double height() const { return high.v - low.v; }
  Vec2 middle() const { return {(low.u + high.u) / 2, (low.v + high.v) / 2}; }
  RingBox grown(double by_m) const {
    return {{low.u - by_m, low.v - by_m}, {high.u + by_m, high.v + by_m}};
  }
  bool holds(const Vec2& p) const {
    return p.u >= low.u && p.u <= high.u && p.v >= low.v && p.v <= high.v;
  }
  bool meets(const RingBox& b) const {
    return low.u <= b.high.u && b.low.u <= high.u && low.v <= b.high.v && b.low.v <= high.v;
  }
};

/// Takes out the straight edges that are shorter than this, with their second corners; a ring keeps three corners.
void drop_short_edges(VectorRing& ring, double least_m);
/// Area that two boxes share, of what they cover together.
double overlap(const RingBox& a, const RingBox& b);
/// The same ring walked the other way: an outline becomes a hole and back. Edges keep their places,
/// sagittas their sides.
VectorRing reversed(const VectorRing& ring);
/// Arcs as straight edges, chords at most chord_error_m from them: the same points whichever way the ring runs.
VectorRing with_chords(const VectorRing& ring, double chord_error_m);
/// Arcs included.
RingBox ring_box(const VectorRing& ring);
/// No two edges of it meet but neighbours in their common corner, arcs as chords. O(n^2) with boxes.
bool is_simple(const VectorRing& ring, double chord_error_m);
/// Outline simple, openings simple, inside it and apart from each other; arcs as chords.
bool is_sound(const VectorFace& face, double chord_error_m);

}  // namespace jalon
