// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/evidence/contour_holes.h"

#include <algorithm>
#include <cmath>

#include "geometry/polygon2.h"
#include "geometry/polygon_sets.h"

namespace jalon {

namespace {

constexpr double kSameBox = 0.6;  // of both boxes together: a first look
// Area that only one of both has, so wide along the border (a sill's ends beside a window): a hidden corner has more.
constexpr double kApartSpacings = 2;
constexpr double kChord = 0.1;       // spacings
constexpr double kSamePlace = 0.7;   // of the boxes of an opening and a contour's hole, together
constexpr double kLeftOfWall = 0.1;  // of an opening that a contour goes round
constexpr int kLooks = 12;           // along either side of an opening's box
constexpr double kSlit = 0.5;        // spacings

// Area of the cells of a hole outside of the shape that were seen through.
double seen_beyond_m2(const Chain& hole, const RingBox& box, const OpeningShape& shape,
                      const WallCells& cells) {
  const auto line = [&](double at, double origin, uint32_t most) {
    return static_cast<uint32_t>(
        std::clamp((at - origin) / cells.cell_m, 0.0, static_cast<double>(most)));
  };
  size_t seen = 0;
  for (uint32_t r = line(box.low.v, cells.origin.v, cells.rows);
       r < line(box.high.v, cells.origin.v, cells.rows) + 1 && r < cells.rows; ++r)
    for (uint32_t c = line(box.low.u, cells.origin.u, cells.columns);
         c < line(box.high.u, cells.origin.u, cells.columns) + 1 && c < cells.columns; ++c) {
      if (cells.at(c, r) != WallState::kThrough) continue;
      const Vec2 p = cells.origin + Vec2{c + 0.5, r + 0.5} * cells.cell_m;
      seen += !shape.holds(p) && contains(hole, p);
    }
  return static_cast<double>(seen) * cells.cell_m * cells.cell_m;
}

bool has_form(const Chain& hole, const RingBox& box, const OpeningShape& shape,
              const Contour& contour, const WallCells& cells) {
  const std::vector<Vec2> polygon = polygon_of(shape, contour.spacing_m),
                          outline = reversed_chain(hole);
  const PolygonWithHoles a{outline, {}}, b{polygon, {}};
  const double apart =
      signed_area(outline) + signed_area(polygon) - 2 * shared_area({{a}}, {{b}}).both;
  const double most = kApartSpacings * contour.spacing_m * perimeter(polygon);
  return apart <= most || apart - seen_beyond_m2(hole, box, shape, cells) <= most;
}

bool is_solid(const Contour& contour, const Vec2& p) {
  return std::any_of(contour.pieces.begin(), contour.pieces.end(), [&](const ContourPiece& piece) {
    return contains(piece.outline, p) &&
           std::none_of(piece.openings.begin(), piece.openings.end(),
                        [&](const Chain& hole) { return contains(hole, p); });
  });
}

std::vector<RingBox> boxes_of_holes(const Contour& contour) {
  std::vector<RingBox> out;
  for (const ContourPiece& piece : contour.pieces)
    for (const Chain& hole : piece.openings) out.emplace_back().add(hole);
  return out;
}

bool has_hole(const std::vector<RingBox>& holes, const OpeningShape& opening) {
  return std::ranges::any_of(
      holes, [&](const RingBox& hole) { return overlap(hole, opening.box()) >= kSamePlace; });
}

bool is_left_open(const Contour& contour, const OpeningShape& shape) {
  const RingBox box = shape.box();
  int all = 0, solid = 0;
  for (int i = 0; i < kLooks; ++i)
    for (int j = 0; j < kLooks; ++j) {
      const Vec2 p{box.low.u + box.width() * (i + 0.5) / kLooks,
                   box.low.v + box.height() * (j + 0.5) / kLooks};
      if (!shape.holds(p)) continue;
      ++all;
      solid += is_solid(contour, p);
    }
  return solid < kLeftOfWall * all;
}

// The place of a ring that comes nearest to a point.
Vec2 nearest_on(const std::vector<Vec2>& ring, const Vec2& p) {
  Vec2 out = ring.front();
  for (size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i], d = ring[(i + 1) % ring.size()] - a;
    const double length2 = dot(d, d);
    const Vec2 at = length2 > 0 ? a + d * std::clamp(dot(p - a, d) / length2, 0.0, 1.0) : a;
    if (norm(at - p) < norm(out - p)) out = at;
  }
  return out;
}

// A square about the place of the outline that comes nearest to each hole, where that is near. Two rings are nearest at
// a corner of one of them.
std::vector<PolygonWithHoles> short_ways(const std::vector<PolygonWithHoles>& parts,
                                         double near_m) {
  std::vector<PolygonWithHoles> out;
  for (const PolygonWithHoles& part : parts)
    for (const auto& hole : part.holes) {
      double least = INFINITY;
      Vec2 at;
      const auto take = [&](const Vec2& on_outline, const Vec2& on_hole) {
        if (const double d = norm(on_outline - on_hole); d < least) least = d, at = on_outline;
      };
      for (const Vec2& p : part.outline) take(p, nearest_on(hole, p));
      for (const Vec2& p : hole) take(nearest_on(part.outline, p), p);
      if (least > near_m) continue;
      const double r = least + near_m;
      out.push_back({{at + Vec2{-r, -r}, at + Vec2{r, -r}, at + Vec2{r, r}, at + Vec2{-r, r}}, {}});
    }
  return out;
}

std::vector<ContourPiece>::iterator part_about(const Chain& opening,
                                               std::vector<ContourPiece>& parts, double spacing_m) {
  return std::find_if(parts.begin(), parts.end(), [&](const ContourPiece& part) {
    return is_apart(opening, part.outline, spacing_m);
  });
}

}  // namespace

PolygonWithHoles box_polygon(double left, double foot, double right, double head) {
  return {{{left, foot}, {right, foot}, {right, head}, {left, head}}, {}};
}

std::vector<PolygonWithHoles> without(const std::vector<PolygonWithHoles>& region,
                                      std::vector<PolygonWithHoles> others, double spacing_m) {
  std::vector<PolygonWithHoles> left = combined(SetOperation::kDifference, region, others);
  for (const PolygonWithHoles& polygon : left) {
    RingBox around;
    around.add(polygon.outline);
    for (const auto& hole : polygon.holes) {
      RingBox box;
      box.add(hole);
      const double middle = box.middle().u, half = kSlit * spacing_m / 2;
      others.push_back(
          box_polygon(middle - half, around.low.v - 1, middle + half, around.high.v + 1));
    }
  }
  left = combined(SetOperation::kDifference, region, others);
  std::erase_if(left, [](const PolygonWithHoles& polygon) { return !polygon.holes.empty(); });
  return left;
}

std::vector<PolygonWithHoles> cut_out(const PolygonWithHoles& whole,
                                      std::span<const PolygonWithHoles> openings, double near_m) {
  std::vector<PolygonWithHoles> left = combined(SetOperation::kDifference, {{whole}}, openings);
  std::vector<PolygonWithHoles> all = short_ways(left, near_m);
  if (all.empty()) return left;
  all.insert(all.end(), openings.begin(), openings.end());
  return combined(SetOperation::kDifference, {{whole}}, all);
}

std::vector<Vec2> polygon_of(const OpeningShape& shape, double spacing_m) {
  return flattened(shape.ring(), kChord * spacing_m);
}

Chain reversed_chain(Chain chain) {
  std::reverse(chain.begin(), chain.end());
  return chain;
}

std::vector<Chain> holes_of(const Contour& contour, std::span<const OpeningShape> openings,
                            const WallCells& cells) {
  std::vector<Chain> out(openings.size());
  for (const ContourPiece& piece : contour.pieces)
    for (const Chain& hole : piece.openings) {
      RingBox box;
      box.add(hole);
      for (size_t k = 0; k < openings.size(); ++k)
        if (out[k].empty() && overlap(box, openings[k].box()) >= kSameBox &&
            has_form(hole, box, openings[k], contour, cells)) {
          out[k] = hole;
          break;
        }
    }
  return out;
}

bool has_holes_for(const Contour& contour, std::span<const OpeningShape> openings) {
  const std::vector<RingBox> holes = boxes_of_holes(contour);
  return std::ranges::all_of(openings, [&](const OpeningShape& o) { return has_hole(holes, o); });
}

bool shows(const Contour& contour, std::span<const OpeningShape> openings) {
  const std::vector<RingBox> holes = boxes_of_holes(contour);
  size_t shown = 0;
  for (const OpeningShape& opening : openings) {
    const bool is_shown = has_hole(holes, opening);
    shown += is_shown;
    if (!is_shown && !is_left_open(contour, opening)) return false;
  }
  return shown == holes.size();
}

Chain dense(std::span<const Vec2> polygon, double spacing_m) {
  Chain out;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i], d = polygon[(i + 1) % polygon.size()] - a;
    const auto pieces = std::max<size_t>(1, static_cast<size_t>(std::ceil(norm(d) / spacing_m)));
    for (size_t k = 0; k < pieces; ++k)
      out.push_back(a + d * (static_cast<double>(k) / static_cast<double>(pieces)));
  }
  return out;
}

bool is_apart(const std::vector<Vec2>& polygon, const Chain& outline, double spacing_m) {
  RingBox about;
  about.add(polygon);
  about = about.grown(kApart * spacing_m);
  for (const Vec2& p : polygon)
    if (!contains(outline, p)) return false;
  for (size_t i = 0; i < outline.size(); ++i) {
    const Vec2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
    RingBox edge;
    edge.add(a);
    edge.add(b);
    if (!edge.meets(about)) continue;
    if (contains(polygon, a) || border_distance(polygon, a) < kApart * spacing_m) return false;
    for (const Vec2& p : polygon)
      if (segment_distance(p, a, b) < kApart * spacing_m) return false;
  }
  return true;
}

std::vector<PolygonWithHoles> those_meeting(const Chain& ring,
                                            std::span<const PolygonWithHoles> polygons) {
  RingBox around;
  around.add(ring);
  std::vector<PolygonWithHoles> out;
  for (const PolygonWithHoles& polygon : polygons) {
    RingBox box;
    box.add(polygon.outline);
    if (box.meets(around)) out.push_back(polygon);
  }
  return out;
}

std::vector<ContourPiece> parts_left(const ContourPiece& piece,
                                     std::span<const PolygonWithHoles> cut, double spacing_m,
                                     const ContourSetting& setting) {
  std::vector<ContourPiece> out;
  if (cut.empty()) {
    out.push_back({piece.outline, {}, piece.area_m2});
    return out;
  }
  const PolygonWithHoles whole{piece.outline, {}};
  for (const PolygonWithHoles& left : cut_out(whole, cut, kApart * spacing_m)) {
    const double area = signed_area(left.outline);
    if (area >= setting.min_area_m2) out.push_back({dense(left.outline, spacing_m), {}, area});
  }
  return out;
}

std::vector<ContourPiece> cut_at_border(std::vector<ContourPiece> pieces,
                                        std::span<const PolygonWithHoles> cut, double spacing_m,
                                        const ContourSetting& setting) {
  std::vector<ContourPiece> out;
  for (ContourPiece& piece : pieces) {
    std::vector<PolygonWithHoles> here = those_meeting(piece.outline, cut);
    if (here.empty()) {
      out.push_back(std::move(piece));
      continue;
    }
    std::vector<ContourPiece> parts = parts_left(piece, here, spacing_m, setting);
    std::vector<uint8_t> is_at_border(piece.openings.size(), 0);
    // An opening that a place at the border comes near to is at the border then.
    for (bool is_changed = true; is_changed;) {
      is_changed = false;
      for (size_t k = 0; k < piece.openings.size(); ++k) {
        const Chain opening = reversed_chain(piece.openings[k]);
        if (is_at_border[k] != 0 || part_about(opening, parts, spacing_m) != parts.end()) continue;
        here.push_back({opening, {}});
        is_at_border[k] = 1;
        is_changed = true;
      }
      if (is_changed) parts = parts_left(piece, here, spacing_m, setting);
    }
    for (size_t k = 0; k < piece.openings.size(); ++k) {
      if (is_at_border[k] != 0) continue;
      const auto part = part_about(reversed_chain(piece.openings[k]), parts, spacing_m);
      part->openings.push_back(std::move(piece.openings[k]));
      part->forms.push_back(piece.forms.empty() ? VectorRing{} : std::move(piece.forms[k]));
    }
    for (ContourPiece& part : parts) out.push_back(std::move(part));
  }
  return out;
}

}  // namespace jalon
