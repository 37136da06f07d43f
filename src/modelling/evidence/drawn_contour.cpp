// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/evidence/drawn_contour.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "geometry/polygon2.h"
#include "geometry/polygon_sets.h"
#include "modelling/edges/find/edge_shape.h"
#include "modelling/evidence/contour_holes.h"
#include "modelling/evidence/set_back.h"

namespace jalon {

namespace {

// Cells with a point of the wall end a shape; so it lies one spacing inside the opening, on average, and the contour of
// points a third of one outside of it (kSetBack of edge_shape.h).
constexpr double kShapeInset = 1.0, kOutsideOpening = 1.35;  // spacings
constexpr double kRim = 6;            // spacings: more than the contour looks through
constexpr double kAtBorder = 1.5;     // spacings: nearer to the outside an opening ends there
constexpr double kAtBorder_m = 0.06;  // and within this, a sill's or a threshold's thickness
constexpr double kThrough = 3;  // times that: an opening at the border is cut so far beyond it
constexpr int kPlaces = 9;      // along a side
constexpr double kFormSigma =
    0.25;  // spacings: of borders fitted to points; measured on the grammar
constexpr double kBesideOpening = 3;  // spacings from an opening to where nothing was measured

// Step 1: a grid in the rim of each opening.
void add_rim(const OpeningShape& opening, double spacing_m, std::vector<Vec2>& points) {
  const OpeningShape outer = opening.grown(kShapeInset * spacing_m / 2);
  const OpeningShape inner = opening.grown(-kRim * spacing_m);
  const bool is_hollow = inner.is_valid();
  const RingBox box = outer.box(), hole = is_hollow ? inner.box() : RingBox{};
  const auto rows = static_cast<size_t>(box.height() / spacing_m) + 1;
  for (size_t r = 0; r < rows; ++r) {
    const double v = box.low.v + static_cast<double>(r) * spacing_m;
    const Vec2 span = outer.span_at(std::min(v, box.high.v));
    const bool crosses = is_hollow && v > hole.low.v && v < hole.high.v;
    const Vec2 gap = crosses ? inner.span_at(v) : Vec2{INFINITY, -INFINITY};
    for (double u = span.u; u <= span.v; u += spacing_m)
      if (!(u > gap.u && u < gap.v)) points.push_back({u, v});
  }
}

class InOpenings {
 public:
  explicit InOpenings(std::span<const OpeningShape> openings) : openings_(openings) {
    for (const OpeningShape& shape : openings) boxes_.push_back(shape.box());
  }
  bool hold(const Vec2& p) const {
    for (size_t k = 0; k < boxes_.size(); ++k) {
      if (!boxes_[k].holds(p)) continue;
      const Vec2 span = openings_[k].span_at(p.v);
      if (p.u > span.u && p.u < span.v) return true;
    }
    return false;
  }

 private:
  std::span<const OpeningShape> openings_;
  std::vector<RingBox> boxes_;
};

struct Edited {
  std::vector<Vec2> points;
  std::vector<uint32_t> kept;  ///< the index of each of the first ones before
};

Edited edited_points(std::span<const Vec2> points, std::span<const OpeningShape> openings,
                     double spacing_m) {
  Edited out;
  const InOpenings in(openings);
  for (size_t i = 0; i < points.size(); ++i) {
    if (in.hold(points[i])) continue;
    out.points.push_back(points[i]);
    out.kept.push_back(static_cast<uint32_t>(i));
  }
  for (const OpeningShape& shape : openings) add_rim(shape, spacing_m, out.points);
  return out;
}

// Four points a cell: cells are 2.2 spacings wide.
void add_relief(const WallCells& cells, std::span<const OpeningShape> openings,
                std::vector<Vec2>& points) {
  const InOpenings in(openings);
  for (uint32_t r = 0; r < cells.rows; ++r)
    for (uint32_t c = 0; c < cells.columns; ++c) {
      if (cells.at(c, r) != WallState::kRelief) continue;
      for (const Vec2& at : {Vec2{0.25, 0.25}, {0.75, 0.25}, {0.25, 0.75}, {0.75, 0.75}}) {
        const Vec2 p = cells.origin + Vec2{c + at.u, r + at.v} * cells.cell_m;
        if (!in.hold(p)) points.push_back(p);
      }
    }
}

// An opening as the contour draws it.
struct DrawnShape {
  OpeningShape shape;
  Chain hole;  ///< of the contour that shows it; else empty
  VectorRing
      form;  ///< fitted to points, where the opening is inside the wall; else without corners

  std::vector<Vec2> polygon(double spacing_m) const {
    return hole.empty() ? polygon_of(shape, spacing_m) : reversed_chain(hole);
  }
};

// The ring of a hole that was fitted to points.
VectorRing form_of(const OpeningShape& shape, double spacing_m) {
  VectorRing ring = reversed(shape.ring());
  for (VectorEdge& edge : ring.edges) edge.sigma_m = kFormSigma * spacing_m;
  return ring;
}

// By their holes in the contour; others a set-back outside where there is room, apart from each other.
std::vector<DrawnShape> drawn_shapes(std::span<const OpeningShape> openings,
                                     std::span<const uint8_t> is_settled, const Contour& plain,
                                     const WallCells& cells) {
  const double spacing_m = cells.spacing_m;
  std::vector<OpeningShape> out;
  for (size_t k = 0; k < openings.size(); ++k)
    out.push_back(openings[k].grown((is_settled[k] != 0 ? kSetBack : kOutsideOpening) * spacing_m));
  std::vector<Chain> holes = holes_of(plain, out, cells);
  for (size_t k = 0; k < openings.size(); ++k)
    if (is_settled[k] != 0 || has_set_back(cells, openings[k])) holes[k].clear();
  const auto too_near = [&](size_t i, size_t j) {
    const double room = kApart * spacing_m;
    if (!out[i].box().grown(room).meets(out[j].box())) return false;
    const PolygonWithHoles a{polygon_of(out[i].grown(room), spacing_m), {}},
        b{polygon_of(out[j], spacing_m), {}};
    return shared_area({{a}}, {{b}}).both > 0;
  };
  std::vector<uint8_t> is_tight(out.size(), 0);
  for (size_t i = 0; i < out.size(); ++i)
    for (size_t j = i + 1; j < out.size(); ++j)
      if (too_near(i, j)) is_tight[i] = is_tight[j] = 1;
  for (size_t i = 0; i < out.size(); ++i)
    if (is_tight[i] != 0) out[i] = openings[i], holes[i].clear();
  // Shapes that lie over each other as they are: the larger one stays.
  std::vector<uint8_t> is_gone(out.size(), 0);
  for (size_t i = 0; i < out.size(); ++i)
    for (size_t j = i + 1; j < out.size(); ++j) {
      if (is_gone[i] != 0 || is_gone[j] != 0 || !too_near(i, j)) continue;
      const RingBox a = out[i].box(), b = out[j].box();
      (a.width() * a.height() >= b.width() * b.height() ? is_gone[j] : is_gone[i]) = 1;
    }
  std::vector<DrawnShape> kept;
  for (size_t i = 0; i < out.size(); ++i)
    if (is_gone[i] == 0)
      kept.push_back({out[i], std::move(holes[i]),
                      is_settled[i] != 0 ? form_of(openings[i], spacing_m) : VectorRing{}});
  return kept;
}

struct Cutting {
  std::vector<PolygonWithHoles> polygons;  ///< the opening and its ways out
  bool is_at_border = false;
};

Cutting cutting_of(const DrawnShape& drawn, const Chain& outline, double spacing_m) {
  Cutting out;
  const OpeningShape& shape = drawn.shape;
  out.polygons.push_back({drawn.polygon(spacing_m), {}});
  const RingBox box = shape.box();
  const double reach = std::max(kAtBorder * spacing_m, kAtBorder_m), far = kThrough * reach;
  // Most places along a side, this far beyond it: a dent of the outline is no way out.
  const auto way_out = [&](const Vec2& from, const Vec2& to, const PolygonWithHoles& way) {
    int outside = 0;
    for (int k = 0; k < kPlaces; ++k)
      outside += !contains(outline, from + (to - from) * ((k + 0.5) / kPlaces));
    if (2 * outside <= kPlaces) return;
    out.is_at_border = true;
    out.polygons.push_back(way);
  };
  const Vec2 foot = shape.span_at(box.low.v + spacing_m / 10);
  if (foot.v - foot.u > box.width() / 2)
    way_out({foot.u, box.low.v - reach}, {foot.v, box.low.v - reach},
            box_polygon(foot.u, box.low.v - far, foot.v, box.low.v + spacing_m / 2));
  if (shape.kind == ShapeKind::kRectangle) {
    way_out({box.low.u, box.high.v + reach}, {box.high.u, box.high.v + reach},
            box_polygon(box.low.u, box.high.v, box.high.u, box.high.v + far));
    way_out({box.low.u - reach, box.low.v}, {box.low.u - reach, box.high.v},
            box_polygon(box.low.u - far, box.low.v, box.low.u, box.high.v));
    way_out({box.high.u + reach, box.low.v}, {box.high.u + reach, box.high.v},
            box_polygon(box.high.u, box.low.v, box.high.u + far, box.high.v));
  }
  out.is_at_border =
      out.is_at_border || !is_apart(out.polygons.front().outline, outline, spacing_m);
  return out;
}

// Step 3, one piece: openings inside it, and what the others leave of it.
std::vector<ContourPiece> with_openings(const ContourPiece& piece,
                                        std::span<const DrawnShape> shapes, double spacing_m,
                                        const ContourSetting& setting) {
  RingBox around;
  around.add(piece.outline);
  std::vector<PolygonWithHoles> cut;
  std::vector<std::pair<Chain, VectorRing>> inside;
  for (const DrawnShape& drawn : shapes) {
    if (!drawn.shape.box().meets(around)) continue;
    Cutting cutting = cutting_of(drawn, piece.outline, spacing_m);
    const auto& polygon = cutting.polygons.front().outline;
    if (cutting.is_at_border)
      cut.insert(cut.end(), cutting.polygons.begin(), cutting.polygons.end());
    else inside.push_back({drawn.hole.empty() ? dense(polygon, spacing_m) : polygon, drawn.form});
  }
  std::vector<ContourPiece> out = parts_left(piece, cut, spacing_m, setting);
  // The way out of a broad opening may lead to one inside the piece, which is at the border then.
  const auto is_met = [&](const std::pair<Chain, VectorRing>& opening) {
    return std::none_of(out.begin(), out.end(), [&](const ContourPiece& part) {
      return is_apart(opening.first, part.outline, spacing_m);
    });
  };
  while (!cut.empty()) {
    const auto met = std::stable_partition(inside.begin(), inside.end(), std::not_fn(is_met));
    if (met == inside.end()) break;
    for (auto opening = met; opening != inside.end(); ++opening)
      cut.push_back({std::move(opening->first), {}});
    inside.erase(met, inside.end());
    out = parts_left(piece, cut, spacing_m, setting);
  }
  for (auto& [chain, form] : inside)
    for (ContourPiece& part : out)
      if (contains(part.outline, chain.front())) {
        part.openings.push_back(reversed_chain(std::move(chain)));
        part.forms.push_back(std::move(form));
        break;
      }
  return out;
}

// What an opening takes, with room around it. A hole of the contour that draws it may reach beyond its shape.
void add_with_room(const DrawnShape& drawn, double spacing_m, std::vector<PolygonWithHoles>& out) {
  const double room = kBesideOpening * spacing_m;
  out.push_back({polygon_of(drawn.shape.grown(room), spacing_m), {}});
  if (drawn.hole.empty()) return;
  const Chain hole = reversed_chain(drawn.hole);
  out.push_back({hole, {}});
  for (const Vec2& p : dense(hole, spacing_m))
    out.push_back(box_polygon(p.u - room, p.v - room, p.u + room, p.v + room));
}

// What openings take of a hole: with room all; with none above them those that were cut out of the border.
struct Taken {
  std::vector<PolygonWithHoles> with_room, up_to_heads;

  Taken(std::span<const DrawnShape> shapes, std::span<const ContourPiece> pieces,
        double spacing_m) {
    for (const DrawnShape& drawn : shapes) {
      std::vector<PolygonWithHoles> taken;
      add_with_room(drawn, spacing_m, taken);
      with_room.insert(with_room.end(), taken.begin(), taken.end());
      const RingBox box = drawn.shape.box();
      const bool is_inside = std::any_of(pieces.begin(), pieces.end(), [&](const auto& piece) {
        return contains(piece.outline, box.middle());
      });
      if (!is_inside) {
        const RingBox room = box.grown(2 * kBesideOpening * spacing_m);
        taken = combined(SetOperation::kIntersection, taken,
                         {{box_polygon(room.low.u, room.low.v, room.high.u, box.high.v)}});
        taken.push_back({drawn.polygon(spacing_m), {}});
      }
      up_to_heads.insert(up_to_heads.end(), taken.begin(), taken.end());
    }
  }
};

// Places in a hole that nobody measured. Above an opening at the border they go down to its head: a lintel between both
// would be as high as the room around it, and of nothing that was measured.
std::vector<PolygonWithHoles> unseen_places(const Chain& hole, const Taken& taken, double spacing_m,
                                            const ContourSetting& setting) {
  const auto left_by = [&](const std::vector<PolygonWithHoles>& others) {
    return without({{reversed_chain(hole), {}}}, those_meeting(hole, others), spacing_m);
  };
  std::vector<PolygonWithHoles> places = left_by(taken.with_room);
  std::erase_if(places, [&](const PolygonWithHoles& place) {
    const double area = signed_area(place.outline);
    return area < setting.min_opening_area_m2 ||
           equivalent_width(area, perimeter(place.outline)) < setting.min_opening_width_m;
  });
  if (places.empty()) return places;
  std::vector<PolygonWithHoles> out = left_by(taken.up_to_heads);
  std::erase_if(out, [&](const PolygonWithHoles& place) {
    return !(shared_area({{place}}, places).both > 0);
  });
  return out;
}

// Step 4.
void add_unseen(const ContourPiece& piece, std::span<const DrawnShape> shapes, double spacing_m,
                const ContourSetting& setting, std::vector<ContourPiece>& out) {
  if (piece.openings.empty()) return;
  const Taken taken(shapes, out, spacing_m);
  std::vector<PolygonWithHoles> cut;
  for (const Chain& hole : piece.openings)
    for (PolygonWithHoles& place : unseen_places(hole, taken, spacing_m, setting)) {
      const auto part = std::find_if(out.begin(), out.end(), [&](const ContourPiece& p) {
        return is_apart(place.outline, p.outline, spacing_m);
      });
      if (part == out.end()) {
        cut.push_back(std::move(place));
        continue;
      }
      part->openings.push_back(reversed_chain(dense(place.outline, spacing_m)));
      part->forms.emplace_back();
    }
  if (!cut.empty()) out = cut_at_border(std::move(out), cut, spacing_m, setting);
}

}  // namespace

Contour drawn_contour(std::span<const Vec2> points, std::span<const OpeningCandidate> candidates,
                      const Contour& plain, const WallCells& cells, const ContourSetting& setting,
                      const ForeignTest& foreign, Task& task) {
  const double spacing_m = cells.spacing_m;
  std::vector<OpeningShape> openings;
  std::vector<uint8_t> is_settled;
  for (const OpeningCandidate& candidate : candidates) {
    if (!candidate.is_opening) continue;
    openings.push_back(candidate.shape);
    is_settled.push_back(candidate.is_settled);
  }
  // 1. Points.
  Edited edited = edited_points(points, openings, spacing_m);
  add_relief(cells, openings, edited.points);
  ForeignTest still_foreign;
  if (foreign)
    still_foreign = [&](uint32_t point, double typical_m) {
      return point < edited.kept.size() && foreign(edited.kept[point], typical_m);
    };
  // 2. Contour.
  Contour contour = extract_contour(edited.points, setting, task, still_foreign);
  task.checkpoint(0);
  // 3. and 4.
  const std::vector<DrawnShape> shapes = drawn_shapes(openings, is_settled, plain, cells);
  std::vector<ContourPiece> pieces;
  for (const ContourPiece& piece : contour.pieces) {
    std::vector<ContourPiece> parts = with_openings(piece, shapes, spacing_m, setting);
    add_unseen(piece, shapes, spacing_m, setting, parts);
    for (ContourPiece& part : parts) pieces.push_back(std::move(part));
  }
  std::stable_sort(pieces.begin(), pieces.end(), [](const ContourPiece& a, const ContourPiece& b) {
    return a.area_m2 > b.area_m2;
  });
  contour.pieces = std::move(pieces);
  return contour;
}

}  // namespace jalon
