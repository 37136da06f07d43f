// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "report/elevation/view.h"

namespace jalon {

/// An arc as the drawing shows it: part of a circle seen at an angle, which is an ellipse.
struct DrawnArc {
  double radius_m = 0;            ///< 0: a straight edge
  double flat_m = 0;              ///< the short half axis
  double flat_direction_rad = 0;  ///< of the short half axis, anticlockwise from x
  bool is_large = false;          ///< more than half the circle
  bool is_anticlockwise = false;  ///< on the drawing
};

/// A ring of a face on the drawing: (x, z) in facade metres.
struct DrawnRing {
  std::vector<Vec2> corners;
  std::vector<DrawnArc> arcs;  ///< of the edge from each corner to the next; empty: all straight
  std::vector<Vec2> polygon;   ///< the same with arcs as chords, for boxes and tests
  uint64_t ring = 0;           ///< of the model
};

DrawnRing drawn_ring(const Model& model, const Face& face, uint64_t ring,
                     const ElevationView& view);

/// Scale and place of a drawing on paper.
struct OnPaper {
  double mm_per_m = 1;
  Vec2 origin_mm;  ///< where facade (low.u, low.v) lies on the paper, y down
  Vec2 low;
  Vec2 operator()(const Vec2& p) const {
    return {origin_mm.u + (p.u - low.u) * mm_per_m, origin_mm.v - (p.v - low.v) * mm_per_m};
  }
};

/// d of a <path>: the rings closed, arcs as A commands.
std::string svg_path(const std::vector<DrawnRing>& rings, const OnPaper& on_paper);
std::string svg_path(const DrawnRing& ring, const OnPaper& on_paper);

}  // namespace jalon
