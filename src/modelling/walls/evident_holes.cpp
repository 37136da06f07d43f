// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/walls/evident_holes.h"

#include <algorithm>
#include <cmath>

#include "geometry/polygon2.h"
#include "modelling/plane/ring_tools.h"

namespace jalon {

namespace {

// Of a hole's box and that of the shape it was drawn for, both within some spacings of the true opening.
constexpr double kSameOpening = 0.5;
// Openings cut out of the border are notches of any width, and a vent's height.
constexpr NotchSetting kAnyNotch{0.1, 0.1, 1e6};
constexpr double kShapeInset_spacings = 1;  // drawn_contour.cpp

// Whether the middle of a shape lies in one of the wall's faces: then it was not cut out of it.
bool is_in_a_face(const VectorPlane& wall, const Vec2& p) {
  return std::any_of(wall.faces.begin(), wall.faces.end(), [&](const VectorFace& face) {
    return contains(flattened(face.outline, wall.spacing_m), p);
  });
}

// The piece whose border comes nearest to a place.
uint32_t nearest_piece(const VectorPlane& wall, const Vec2& p) {
  uint32_t nearest = 0;
  double least = INFINITY;
  for (size_t f = 0; f < wall.faces.size(); ++f) {
    const double d = border_distance(flattened(wall.faces[f].outline, wall.spacing_m), p);
    if (d >= least) continue;
    least = d;
    nearest = static_cast<uint32_t>(f);
  }
  return nearest;
}

}  // namespace

int32_t candidate_of(const WallHole& hole, std::span<const OpeningCandidate> candidates) {
  const RingBox box = ring_box(hole.outline);
  int32_t best = -1;
  double most = kSameOpening;
  for (size_t k = 0; k < candidates.size(); ++k) {
    if (!candidates[k].is_opening) continue;
    const double same = overlap(candidates[k].shape.box(), box);
    if (same < most) continue;
    most = same;
    best = static_cast<int32_t>(k);
  }
  return best;
}

std::vector<WallHole> evident_holes(const VectorPlane& wall,
                                    std::span<const OpeningCandidate> candidates) {
  std::vector<WallHole> out = holes_of(wall, kAnyNotch);
  std::vector<uint8_t> is_drawn(candidates.size(), 0);
  std::erase_if(out, [&](const WallHole& hole) {
    const int32_t candidate = candidate_of(hole, candidates);
    if (candidate >= 0) is_drawn[static_cast<size_t>(candidate)] = 1;
    return candidate < 0 && hole.is_notch;
  });
  if (wall.faces.empty()) return out;
  for (size_t k = 0; k < candidates.size(); ++k) {
    if (!candidates[k].is_opening || is_drawn[k] != 0) continue;
    const OpeningShape shape = candidates[k].shape.grown(kShapeInset_spacings * wall.spacing_m);
    const Vec2 middle = shape.box().middle();
    if (is_in_a_face(wall, middle)) continue;
    WallHole bay;
    bay.outline = shape.ring();
    bay.piece = nearest_piece(wall, middle);
    bay.is_notch = bay.is_bay = true;
    out.push_back(std::move(bay));
  }
  return out;
}

}  // namespace jalon
