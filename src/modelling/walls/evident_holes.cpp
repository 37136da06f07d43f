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
constexpr double kHeldShare =
    0.2;  // of the smaller box: as shapes may lie over each other (find_openings.h)
constexpr double kShapeInset_spacings = 1;  // drawn_contour.cpp

// Whether the middle of a shape lies in one of the wall's faces: then it was not cut out of it.
bool is_in_a_face(const VectorPlane& wall, const Vec2& p) {
  return std::any_of(wall.faces.begin(), wall.faces.end(), [&](const VectorFace& face) {
    return contains(flattened(face.outline, wall.spacing_m), p);
  });
}

// Whether a box lies over a hole that is there already, in part: a hole that is drawn another way is another opening.
bool is_held(const RingBox& box, std::span<const WallHole> holes) {
  return std::any_of(holes.begin(), holes.end(), [&](const WallHole& hole) {
    const RingBox other = ring_box(hole.outline);
    const double width = std::min(box.high.u, other.high.u) - std::max(box.low.u, other.low.u),
                 height = std::min(box.high.v, other.high.v) - std::max(box.low.v, other.low.v);
    const double least = std::min(box.width() * box.height(), other.width() * other.height());
    return width > 0 && height > 0 && width * height > kHeldShare * least;
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
  std::erase_if(out, [&](const WallHole& hole) {
    return hole.is_notch && candidate_of(hole, candidates) < 0;
  });
  add_bays(wall, candidates, out);
  return out;
}

void add_bays(const VectorPlane& wall, std::span<const OpeningCandidate> candidates,
              std::vector<WallHole>& holes) {
  if (wall.faces.empty()) return;
  std::vector<uint8_t> is_drawn(candidates.size(), 0);
  for (const WallHole& hole : holes)
    if (const int32_t candidate = candidate_of(hole, candidates); candidate >= 0)
      is_drawn[static_cast<size_t>(candidate)] = 1;
  for (size_t k = 0; k < candidates.size(); ++k) {
    if (!candidates[k].is_opening || is_drawn[k] != 0) continue;
    const double inset = candidates[k].is_settled ? 0 : kShapeInset_spacings;
    const OpeningShape shape = candidates[k].shape.grown(inset * wall.spacing_m);
    const Vec2 middle = shape.box().middle();
    if (is_in_a_face(wall, middle) || is_held(shape.box(), holes)) continue;
    WallHole bay;
    bay.outline = shape.ring();
    bay.piece = nearest_piece(wall, middle);
    bay.is_notch = bay.is_bay = true;
    holes.push_back(std::move(bay));
  }
}

}  // namespace jalon
