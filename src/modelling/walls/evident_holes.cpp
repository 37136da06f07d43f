// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/walls/evident_holes.h"

#include <algorithm>
#include <cmath>

#include "geometry/polygon2.h"
#include "geometry/polygon_sets.h"
#include "modelling/evidence/contour_holes.h"
#include "modelling/evidence/joined_lights.h"
#include "modelling/plane/ring_tools.h"

namespace jalon {

namespace {

// Of a hole's box and that of the shape it was drawn for, both within some spacings of the true opening.
constexpr double kSameOpening = 0.5;
// With the middle of each in the other: of a vent five spacings high the shape, a spacing inside it, is three high.
constexpr double kSameSmallOpening = 0.3;
constexpr double kMostOfNotch = 0.7;               // of its box: the notch is that opening's
constexpr double kUpThePier[] = {0.5, 0.75, 0.9};  // of its height: its foot may be hidden
// Openings cut out of the border are notches of any width, and a vent's height.
constexpr NotchSetting kAnyNotch{0.1, 0.1, 1e6};
constexpr double kHeldShare =
    0.2;  // of the smaller box: as shapes may lie over each other (find_openings.h)
constexpr double kShapeInset_spacings = 1;  // drawn_contour.cpp
// Of a notch beyond the shape, so wide along its border: as holes of a contour have (contour_holes.cpp).
constexpr double kMoreSpacings = 2;
constexpr double kChordOfNotch = 0.1;  // spacings
// Of the steep sides of a bay, with a face of the wall this near: piers whose feet nobody saw leave most of them bare.
constexpr double kLeastBeside = 0.2, kBeside_m = 0.6;
constexpr int kPlacesBeside = 16;  // up each side
// Of its border, beyond which the wall is broad: of any (find_openings.cpp).
constexpr double kLeastFramed = 0.2;

// Whether the middle of a shape lies in one of the wall's faces: then it was not cut out of it.
bool is_in_a_face(const VectorPlane& wall, const Vec2& p) {
  return std::any_of(wall.faces.begin(), wall.faces.end(), [&](const VectorFace& face) {
    return contains(flattened(face.outline, wall.spacing_m), p);
  });
}

// Whether faces of the wall are beside a box. Stray points in the wall's plane, far from all that was drawn of it, may
// enclose a place, and what lies between them is no opening.
bool has_faces_beside(const VectorPlane& wall, const RingBox& box) {
  std::vector<std::vector<Vec2>> faces;
  for (const VectorFace& face : wall.faces)
    faces.push_back(flattened(face.outline, wall.spacing_m));
  const auto is_faced = [&](double u, double v, double outward) {
    for (double out = wall.spacing_m; out <= kBeside_m; out += wall.spacing_m)
      if (std::any_of(faces.begin(), faces.end(), [&](const auto& face) {
            return contains(face, {u + outward * out, v});
          }))
        return true;
    return false;
  };
  int beside = 0;
  for (int k = 0; k < kPlacesBeside; ++k) {
    const double v = box.low.v + (k + 0.5) / kPlacesBeside * box.height();
    beside += is_faced(box.low.u, v, -1) + is_faced(box.high.u, v, 1);
  }
  return beside >= kLeastBeside * 2 * kPlacesBeside;
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

OpeningShape drawn_shape(const OpeningCandidate& candidate, double spacing_m) {
  return candidate.shape.grown((candidate.is_settled ? 0 : kShapeInset_spacings) * spacing_m);
}

// Whether a notch is the opening alone. One that goes on where something hides the wall beside or above the opening is
// no more of it.
bool has_its_form(const WallHole& notch, const OpeningCandidate& candidate, double spacing_m) {
  const OpeningShape drawn = drawn_shape(candidate, spacing_m);
  const std::vector<Vec2> shape = polygon_of(drawn, spacing_m),
                          outline = flattened(notch.outline, kChordOfNotch * spacing_m);
  const RingBox box = ring_box(notch.outline), own = drawn.box();
  // Below the opening it may go on to a foot that nobody saw.
  const double foot = own.low.v, head = std::max(foot, box.high.v);
  const auto within_m2 = [&](const PolygonWithHoles& part) {
    const PolygonWithHoles whole{outline, {}};
    return shared_area({{whole}}, {{part}}).both;
  };
  const double most_m = kMoreSpacings * spacing_m,
               more_m2 = within_m2(box_polygon(box.low.u, foot, box.high.u, head)) -
                         within_m2({shape, {}});
  if (more_m2 > most_m * perimeter(shape)) return false;
  // Nor all of it above the opening, where nobody measured up to it.
  return head <= own.high.v ||
         within_m2(box_polygon(own.low.u, own.high.v, own.high.u, head)) <= most_m * own.width();
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

void drop_second_notches(std::span<const OpeningCandidate> candidates,
                         std::vector<WallHole>& holes) {
  std::vector<int32_t> candidate(holes.size());
  std::vector<double> most(candidates.size(), 0);
  std::vector<size_t> first(candidates.size(), holes.size());
  const auto same_as = [&](size_t h) {
    return overlap(ring_box(holes[h].outline),
                   candidates[static_cast<size_t>(candidate[h])].shape.box());
  };
  for (size_t h = 0; h < holes.size(); ++h) {
    candidate[h] = candidate_of(holes[h], candidates);
    if (candidate[h] < 0) continue;
    const auto k = static_cast<size_t>(candidate[h]);
    if (const double same = same_as(h); same > most[k]) most[k] = same, first[k] = h;
  }
  std::vector<WallHole> kept;
  for (size_t h = 0; h < holes.size(); ++h)
    if (!holes[h].is_notch || candidate[h] < 0 || first[static_cast<size_t>(candidate[h])] == h)
      kept.push_back(std::move(holes[h]));
  holes = std::move(kept);
}

int32_t candidate_of(const WallHole& hole, std::span<const OpeningCandidate> candidates) {
  const RingBox box = ring_box(hole.outline);
  int32_t best = -1;
  double most = 0;
  for (size_t k = 0; k < candidates.size(); ++k) {
    if (!candidates[k].is_opening) continue;
    const RingBox own = candidates[k].shape.box();
    const bool is_centred = box.holds(own.middle()) && own.holds(box.middle());
    const double same = overlap(own, box);
    if (same < (is_centred ? kSameSmallOpening : kSameOpening) || same <= most) continue;
    most = same;
    best = static_cast<int32_t>(k);
  }
  return best;
}

bool holds_several(const WallHole& hole, std::span<const OpeningCandidate> candidates) {
  const RingBox box = ring_box(hole.outline);
  std::vector<RingBox> held;
  for (const OpeningCandidate& c : candidates)
    if (c.is_opening && box.holds(c.shape.box().middle())) held.push_back(c.shape.box());
  const bool is_one = std::any_of(held.begin(), held.end(), [&](const RingBox& own) {
    return overlap(own, box) >= kMostOfNotch;
  });
  if (held.size() < 2 || is_one) return false;
  const std::vector<Vec2> outline = flattened(hole.outline, box.width() / 100);
  for (const RingBox& a : held)
    for (const RingBox& b : held) {
      if (b.low.u - a.high.u < kMullion_m) continue;
      const double foot = std::max(a.low.v, b.low.v), head = std::min(a.high.v, b.high.v);
      for (const double up : kUpThePier)
        if (!contains(outline, {(a.high.u + b.low.u) / 2, foot + up * (head - foot)})) return true;
    }
  return false;
}

std::vector<WallHole> evident_holes(const VectorPlane& wall,
                                    std::span<const OpeningCandidate> candidates) {
  std::vector<WallHole> out = holes_of(wall, kAnyNotch);
  std::erase_if(out, [&](const WallHole& hole) {
    if (!hole.is_notch) return false;
    const int32_t candidate = candidate_of(hole, candidates);
    return candidate < 0 || holds_several(hole, candidates) ||
           !has_its_form(hole, candidates[static_cast<size_t>(candidate)], wall.spacing_m);
  });
  drop_second_notches(candidates, out);
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
    const OpeningShape shape = drawn_shape(candidates[k], wall.spacing_m);
    const Vec2 middle = shape.box().middle();
    if (is_in_a_face(wall, middle) || is_held(shape.box(), holes) ||
        (candidates[k].framed < kLeastFramed && !has_faces_beside(wall, shape.box())))
      continue;
    WallHole bay;
    bay.outline = shape.ring();
    bay.piece = nearest_piece(wall, middle);
    bay.is_notch = bay.is_bay = true;
    bay.is_evident = candidates[k].jambs >= kFramedShare;  // gaps between parapets have none
    holes.push_back(std::move(bay));
  }
}

}  // namespace jalon
