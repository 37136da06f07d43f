// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scan/builder/builder.h"

namespace jalon {

/// A corner of a contour and the edge to the next one.
struct ContourCorner {
  Vec2 at;
  /// 0: the edge is straight; else an arc, positive where it bulges to the right of the walk, as Model::sagittas.
  double sagitta_m = 0;
};

/// A closed chain of straight edges and arcs in a face's own coordinates, counter-clockwise.
using Contour = std::vector<ContourCorner>;

Contour contour_of(const Rect& rect);
/// With chords for arcs, within 0.1 mm.
Outline chords_of(const Contour& contour);
Rect bounds_of(const Contour& contour);
double area_of(const Contour& contour);

/// The outline without the openings that stand with one edge on its edges: there it walks round them. Such an edge lies
/// within 0.1 um of the outline's; openings do not touch each other.
Contour notched(const Contour& outline, const std::vector<Contour>& openings);
/// Whether an edge of the opening lies on one of the outline's, in the same direction.
bool touches_border(const Contour& outline, const Contour& opening);

/// The sides of a prism over the contour between two heights over the frame's plane: a face for every straight edge,
/// curved strips for arcs. Seen from outside, or from inside: the reveals of an opening.
void add_sides(SceneBuilder& out, uint32_t part, const Frame& frame, const Contour& contour,
               double low_m, double high_m, bool from_inside);

}  // namespace jalon
