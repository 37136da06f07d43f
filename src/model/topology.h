// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "model/model.h"

namespace jalon {

/// An edge of the rings: straight, or an arc by its end points and sagitta (Boulaassal 2010, 4.3.3).
struct Edge {
  uint32_t from = 0, to = 0;  ///< vertices; from < to
  double sagitta_m = 0;       ///< seen as first_face sees it, walked from `from` to `to`
  uint32_t first_face = kNoFace,
           second_face = kNoFace;  ///< the faces that share it; kNoFace: a border
  uint32_t uses = 0;               ///< how many ring edges it is; above 2 where more faces meet
};

/// Each pair of vertices that rings join, once, ascending by (from, to). Faces by index. O(n log n) for n corners.
std::vector<Edge> find_edges(const Model& model);

/// Centre, radius and bulge of an arc by end points and sagitta: bulge = 2 s / c as in DXF.
struct Arc2 {
  Vec2 centre;
  double radius = 0;
  double bulge = 0;
};
/// sagitta != 0, a != b.
Arc2 arc_of(const Vec2& a, const Vec2& b, double sagitta_m);

/// Points of the arc from a to b without b, chords at most chord_error_m from the arc; only a when sagitta is 0.
void append_arc(std::vector<Vec2>& out, const Vec2& a, const Vec2& b, double sagitta_m,
                double chord_error_m);

}  // namespace jalon
