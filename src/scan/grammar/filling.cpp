// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// What stands in openings.
#include <algorithm>
#include <cmath>

#include "scan/grammar/realise.h"

namespace jalon::grammar {

namespace {

constexpr double kGlassBehind_m = 0.03;  // the frame's front
constexpr double kLeastPane_m = 0.05;

/// A face of the shape at this height over the wall, without the holes.
void add_face(SceneBuilder& out, uint32_t part, const Frame& frame, const Contour& outline,
              const std::vector<Contour>& holes) {
  std::vector<Outline> rings;
  for (const Contour& hole : holes) rings.push_back(chords_of(hole));
  out.polygon_face(part, frame, chords_of(outline), rings);
}

/// A bar between panes: front and sides.
void add_bar(SceneBuilder& out, uint32_t part, const Frame& front, const Rect& rect) {
  if (!(rect.width() > 0 && rect.height() > 0)) return;
  out.face(part, front, rect);
  add_sides(out, part, front, jalon::contour_of(rect), -kGlassBehind_m, 0, false);
}

/// Half the width of the shape's panes at this level; of round ones.
double half_chord(const Rect& r, double away_from_middle) {
  const double radius = r.width() / 2;
  return std::sqrt(std::max(0.0, radius * radius - away_from_middle * away_from_middle));
}

/// Mullions and transoms between the panes of the shape.
void add_bars(SceneBuilder& out, uint32_t part, const Frame& front, const Shape& panes,
              const Filling& f) {
  if (panes.form == Shape::Form::kPolygon) return;
  const Rect r = panes.rect;
  const double width = f.frame_m;
  const bool is_round = panes.form == Shape::Form::kRound;
  const double top = springing_of(panes), mu = (r.u0 + r.u1) / 2, mv = (r.v0 + r.v1) / 2;
  // Short of the border of round panes, which slopes there.
  const auto reach = [&](double off) { return half_chord(r, std::fabs(off) + width / 2) - 0.002; };
  for (int i = 1; i <= f.mullions; ++i) {
    const double u = r.u0 + r.width() * i / (f.mullions + 1);
    if (is_round) {
      const double h = reach(u - mu);
      add_bar(out, part, front, {u - width / 2, u + width / 2, mv - h, mv + h});
    } else {
      add_bar(out, part, front, {u - width / 2, u + width / 2, r.v0, top});
    }
  }
  for (int i = 1; i <= f.transoms; ++i) {
    const double v = r.v0 + (top - r.v0) * i / (f.transoms + 1);
    if (is_round) {
      const double h = reach(v - mv);
      add_bar(out, part, front.raised(-0.002), {mu - h, mu + h, v - width / 2, v + width / 2});
    } else {
      // A little behind the mullions, which pass in front.
      add_bar(out, part, front.raised(-0.002), {r.u0, r.u1, v - width / 2, v + width / 2});
    }
  }
}

void add_curtain(SceneBuilder& out, uint32_t part, const Frame& wall, const PlannedOpening& o,
                 Dice& dice) {
  if (!(o.filling.curtain_share > 0)) return;
  const Rect box = bounds_of(contour_of(o.shape));
  const double behind = dice.between(0.08, 0.3);
  out.face(out.part("curtain", "curtain", part), wall.raised(-o.depth_m - behind),
           {box.u0 - 0.1, box.u0 + (box.width() + 0.1) * o.filling.curtain_share, box.v0 - 0.05,
            box.v1 + 0.1});
}

/// A roller blind that is partly down, before the frame, and its box.
void add_blind(SceneBuilder& out, uint32_t part, const Frame& wall, const PlannedOpening& o) {
  if (!(o.filling.blind_share > 0) || o.shape.form != Shape::Form::kFlat) return;
  const Rect r = o.shape.rect;
  const double depth = std::max(0.02, o.depth_m - 0.05);
  if (depth >= o.depth_m) return;
  out.face(out.part("blind", "blind", part), wall.raised(-depth),
           {r.u0 + 0.005, r.u1 - 0.005, r.v1 - r.height() * o.filling.blind_share + 0.005,
            r.v1 - 0.002});
}

void add_sash(SceneBuilder& out, uint32_t part, const Frame& wall, const PlannedOpening& o,
              Dice& dice) {
  const Filling& f = o.filling;
  const Frame front = wall.raised(-o.depth_m);
  const uint32_t joinery = out.part("joinery", "joinery", part);
  // 1. A solid panel below, of shop fronts and doors.
  Shape glazed = o.shape;
  if (f.stall_m > 0 && o.shape.form == Shape::Form::kFlat &&
      o.shape.rect.height() > 2 * f.stall_m) {
    const Rect& r = o.shape.rect;
    out.face(joinery, front.raised(0.02), {r.u0, r.u1, r.v0, r.v0 + f.stall_m});
    glazed.rect.v0 += f.stall_m;
  }
  // 2. Frame, glass behind it, bars.
  const char* glass = f.mirrors ? "dark" : "glass";
  if (!can_shrink(glazed, f.frame_m + kLeastPane_m)) {
    add_face(out, out.part("glass", glass, part), front, contour_of(glazed), {});
    return;
  }
  const Shape panes = grown(glazed, -f.frame_m, false);
  add_face(out, joinery, front, contour_of(glazed), {contour_of(panes)});
  add_sides(out, joinery, front, contour_of(panes), -kGlassBehind_m, 0, true);
  add_face(out, out.part("glass", glass, part), front.raised(-kGlassBehind_m), contour_of(panes),
           {});
  add_bars(out, joinery, front, panes, f);
  // 3. Before and behind it.
  add_blind(out, part, wall, o);
  add_curtain(out, part, wall, o, dice);
}

/// Closed, with raised panels.
void add_leaf(SceneBuilder& out, uint32_t part, const Frame& wall, const PlannedOpening& o) {
  const Frame front = wall.raised(-o.depth_m);
  const uint32_t leaf = out.part("leaf", "joinery", part);
  add_face(out, leaf, front, contour_of(o.shape), {});
  const Rect box = bounds_of(contour_of(o.shape));
  const double top = std::min(springing_of(o.shape), box.v1) - 0.12;
  const int leaves = std::max(1, o.filling.mullions + 1);
  for (int i = 0; i < leaves; ++i) {
    const double u0 = box.u0 + box.width() * i / leaves + 0.12,
                 u1 = box.u0 + box.width() * (i + 1) / leaves - 0.12;
    const double middle = box.v0 + 1.0;
    for (const Rect& panel :
         {Rect{u0, u1, box.v0 + 0.15, middle - 0.06}, Rect{u0, u1, middle + 0.06, top}})
      if (panel.width() > 0.1 && panel.height() > 0.1) {
        out.face(leaf, front.raised(0.02), panel);
        add_sides(out, leaf, front, jalon::contour_of(panel), 0, 0.02, false);
      }
  }
}

void add_slats(SceneBuilder& out, uint32_t part, const Frame& wall, const PlannedOpening& o) {
  const Frame front = wall.raised(-o.depth_m);
  const uint32_t louvre = out.part("louvre", "joinery", part);
  add_face(out, louvre, front, contour_of(o.shape), {});
  const Rect r = bounds_of(contour_of(o.shape));
  constexpr double kSlat_m = 0.03, kEvery_m = 0.08;
  for (double v = r.v0 + 0.03; v + kSlat_m < r.v1; v += kEvery_m) {
    const Rect slat{r.u0 + 0.02, r.u1 - 0.02, v, v + kSlat_m};
    out.face(louvre, front.raised(0.02), slat);
    add_sides(out, louvre, front, jalon::contour_of(slat), 0, 0.02, false);
  }
}

}  // namespace

void add_filling(SceneBuilder& out, uint32_t part, const Frame& wall, const PlannedOpening& o,
                 Dice& dice) {
  const bool is_recess = o.filling.kind == Filling::Kind::kRecess,
             is_passage = o.filling.kind == Filling::Kind::kNothing;
  // The piers of an arcade are half a metre thick, the sides of a loggia reach to its back wall.
  const double pier = o.opening_class == OpeningClass::kRecess && o.storey == 0 ? 0.45 : o.depth_m;
  add_sides(out, out.part("reveals", "reveal", part), wall, contour_of(o.shape),
            is_recess ? -pier : -o.depth_m, 0, true);
  if (is_recess || is_passage) return;
  switch (o.filling.kind) {
    case Filling::Kind::kLeaf:
      return add_leaf(out, part, wall, o);
    case Filling::Kind::kLouvre:
      return add_slats(out, part, wall, o);
    case Filling::Kind::kClosed:
      return add_face(out, out.part("blind", "blind", part), wall.raised(-o.depth_m),
                      contour_of(o.shape), {});
    default:
      return add_sash(out, part, wall, o, dice);
  }
}

}  // namespace jalon::grammar
