// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Houses of one family, and rows of them.
#include <algorithm>

#include "scan/grammar/sketch.h"

namespace jalon::grammar {

namespace {

WindowStyle house_style(Dice& dice) {
  WindowStyle s;
  s.width_m = dice.length(0.8, 1.25);
  s.height_m = dice.length(1.3, 1.9);
  s.sill_m = dice.length(0.6, 0.95);
  if (dice.chance(0.35)) {
    s.form = Shape::Form::kArched;
    s.rise_m = dice.length(0.08, 0.2, 0.01);
  }
  s.depth_m = dice.between(0.1, 0.3);
  s.surround_m = dice.chance(0.5) ? dice.length(0.12, 0.2, 0.01) : 0;
  s.proud_m = dice.between(0.03, 0.05);
  s.has_sill = dice.chance(0.6);
  s.has_shutters = s.form == Shape::Form::kFlat && dice.chance(0.4);
  s.transoms = dice.count(0, 2);
  s.blinds = dice.chance(0.3) ? 0.3 : 0;
  return s;
}

/// French windows with a railing in front.
WindowStyle french(WindowStyle s, Dice& dice) {
  s.sill_m = 0.05;
  s.height_m = dice.length(2.1, 2.4);
  s.has_sill = false;
  return s;
}

/// One door on an axis of the ground floor, windows or a shop on the others, vents of the cellar below these.
void ground_floor(Sketch& k, size_t wall, const WindowStyle& style,
                  const std::vector<double>& axes) {
  Dice& dice = k.dice();
  const auto door = static_cast<size_t>(dice.count(0, static_cast<int>(axes.size()) - 1));
  const bool has_shop = dice.chance(0.2);
  for (size_t i = 0; i < axes.size(); ++i) {
    if (i == door) {
      const double deep = dice.between(0.1, 0.4), high = dice.length(2.1, 2.7),
                   wide = dice.length(0.9, 1.4);
      k.door(wall, axes[i], wide, high, deep);
      continue;
    }
    if (has_shop) {
      const double deep = dice.between(0.05, 0.25), high = dice.length(2.2, 2.6);
      k.shop_front(wall, axes[i] - 0.85, axes[i] + 0.85, high, deep);
      continue;
    }
    WindowStyle low = style;
    low.height_m = std::min(style.height_m, k.floor(1) - 1.5);
    low.sill_m = std::max(0.9, style.sill_m);
    k.window(wall, low, axes[i], 0);
    if (dice.chance(0.25)) k.vent(wall, axes[i], 0.1, 0.6, 0.25);
  }
  if (dice.chance(0.3)) k.niche(wall, axes[door] + 1.05, 0.9, 0.4, 0.7);
}

/// One house between two sides; gives its wall.
size_t house(Sketch& k, double u0, double u1, double y_m, int floors) {
  Dice& dice = k.dice();
  const size_t wall = k.wall("wall " + std::to_string(k.plan().walls.size() + 1), y_m,
                             jalon::contour_of({u0, u1, 0, k.floor(floors)}));
  const std::vector<double> axes = k.axes_by(u0 + 0.3, u1 - 0.3, 1.9, 2.8);
  const WindowStyle style = house_style(dice);
  ground_floor(k, wall, style, axes);
  const bool are_coupled = dice.chance(0.12);
  for (int storey = 1; storey < floors; ++storey) {
    WindowStyle s = style;
    const double clear_m = k.floor(storey + 1) - k.floor(storey);
    s.height_m = std::min(s.height_m, clear_m - s.sill_m - 0.45);
    const bool has_balconies = dice.chance(0.2);
    if (has_balconies) s = french(s, dice);
    if (are_coupled) {
      s.width_m = std::min(s.width_m, 0.85);
      s.has_shutters = false;
      s.surround_m = 0;
      for (const double u : axes)
        for (const double side : {-0.5, 0.5}) k.window(wall, s, u + side, storey);
      continue;
    }
    k.window_row(wall, s, axes, storey, 0.04);
    if (has_balconies)
      for (const double u : axes)
        k.balcony(wall, u - s.width_m / 2 - 0.2, u + s.width_m / 2 + 0.2, k.floor(storey),
                  dice.between(0.3, 0.9), false);
  }
  return wall;
}

void trimmings(Sketch& k, size_t wall, double u0, double u1, double top_v) {
  Dice& dice = k.dice();
  if (dice.chance(0.3)) k.quoins(wall, top_v - 0.5);
  if (dice.chance(0.6)) k.plinth(wall);
  if (dice.chance(0.5))
    k.band(wall, "string_course", k.floor(1) - 0.12, k.floor(1) + 0.08, dice.between(0.03, 0.1));
  if (dice.chance(0.6)) k.cornice(wall, top_v);
  if (dice.chance(0.6)) k.drainpipe(wall, dice.chance(0.5) ? u0 + 0.12 : u1 - 0.12, top_v);
}

}  // namespace

void plan_town_house(Sketch& k) {
  Dice& dice = k.dice();
  const auto [front, floors] = k.sizes(6, 15, 3, 5);
  const double shrink = dice.between(0.93, 1), upper_m = dice.length(2.8, 3.4),
               ground_m = dice.length(3.2, 4.0);
  k.storeys(floors, ground_m, upper_m, shrink);
  const size_t wall = house(k, 0, front, 0, floors);
  if (dice.chance(0.35)) k.sign(wall, 0.5, front / 2, k.floor(1) - 0.6, k.floor(1) - 0.15);
  k.finish();
  trimmings(k, wall, 0, front, k.eaves());
  k.clutter(wall, 4);
  if (dice.chance(0.7)) k.roof(0, front, k.eaves(), 0);
}

void plan_terrace(Sketch& k) {
  Dice& dice = k.dice();
  const auto [front, floors] = k.sizes(14, 22, 2, 4);
  const double upper_m = dice.length(2.7, 3.2), ground_m = dice.length(3.0, 3.6);
  k.storeys(floors, ground_m, upper_m);
  const int houses = std::max(1, std::min(dice.count(3, 4), static_cast<int>(front / 4)));
  std::vector<double> ys;
  for (int i = 0; i < houses; ++i) {
    const double u0 = front * i / houses, u1 = front * (i + 1) / houses;
    // A few centimetres, so that neighbours are nearly one plane; now and then a step.
    ys.push_back(i == 0 ? 0 : dice.chance(0.7) ? dice.between(0, 0.12) : dice.between(0.3, 0.8));
    const int own = std::max(1, floors - (dice.chance(0.3) ? 1 : 0));
    const size_t wall = house(k, u0, u1, ys.back(), own);
    if (i > 0) k.joint(u0, ys[ys.size() - 2], ys.back(), k.eaves());
    if (dice.chance(0.8)) k.drainpipe(wall, u1 - 0.1, k.floor(own));
    if (dice.chance(0.5)) k.roof(u0, u1, k.floor(own), ys.back());
  }
  k.finish();
  for (size_t w = 0; w < k.plan().walls.size(); ++w) {
    if (dice.chance(0.5)) k.plinth(w);
    if (dice.chance(0.4)) k.cornice(w, bounds_of(k.at(w).outline).v1);
    k.clutter(w, 2);
  }
}

void plan_gabled(Sketch& k) {
  Dice& dice = k.dice();
  const auto [front, floors] = k.sizes(7, 12, 2, 3);
  const double upper_m = dice.length(2.6, 3.0), ground_m = dice.length(2.8, 3.3);
  k.storeys(floors, ground_m, upper_m);
  const double eaves = k.eaves();
  const double rise = front * dice.between(0.3, 0.55), ridge = front * dice.between(0.35, 0.65);
  const bool has_steps = dice.chance(0.25);
  Contour outline{{{0, 0}}, {{front, 0}}};
  if (has_steps) {  // a stepped gable
    constexpr int kSteps = 4;
    for (int i = 0; i < kSteps; ++i) {
      const double u = front - (front - ridge) * i / (kSteps + 0.5);
      outline.push_back({{u, eaves + rise * i / kSteps}});
      outline.push_back({{u, eaves + rise * (i + 1) / kSteps}});
    }
    for (int i = kSteps; i-- > 0;) {
      const double u = ridge * i / (kSteps + 0.5);
      outline.push_back({{u, eaves + rise * (i + 1) / kSteps}});
      outline.push_back({{u, eaves + rise * i / kSteps}});
    }
  } else {
    outline.insert(outline.end(), {{{front, eaves}}, {{ridge, eaves + rise}}, {{0, eaves}}});
  }
  const size_t wall = k.wall("wall 1", 0, outline);
  const std::vector<double> axes = k.axes_by(0.3, front - 0.3, 2.1, 3.2);
  const WindowStyle style = house_style(dice);
  ground_floor(k, wall, style, axes);
  for (int storey = 1; storey < floors; ++storey) {
    WindowStyle s = style;
    s.height_m = std::min(s.height_m, k.floor(storey + 1) - k.floor(storey) - s.sill_m - 0.3);
    k.window_row(wall, s, axes, storey, 0.05);
  }
  // The gable: triangles along its slopes, a round or a plain window in its middle.
  const auto under_roof = [eaves, rise, ridge, end = front](double u) {
    const double share = u < ridge ? u / ridge : (end - u) / (end - ridge);
    return eaves + rise * share - 0.45;
  };
  PlannedOpening o;
  o.storey = floors;
  o.depth_m = dice.between(0.08, 0.25);
  o.filling.mullions = 0;
  const double low = eaves + dice.between(0.1, 0.3);
  const bool has_triangles = !has_steps && dice.chance(0.7);
  if (has_triangles) {
    const double a = ridge * 0.35, b = ridge - dice.length(0.5, 0.9), c = 2 * ridge - b,
                 d = front - (front - ridge) * 0.35;
    o.shape = Shape::polygon({{a, low}, {b, low}, {b, under_roof(b)}});
    k.open(wall, o);
    o.shape = Shape::polygon({{c, low}, {d, low}, {c, under_roof(c)}});
    if (dice.chance(0.5))  // a sloping head
      o.shape = Shape::polygon({{c, low}, {d, low}, {d, under_roof(d)}, {c, under_roof(c)}});
    k.open(wall, o);
  }
  if (dice.chance(0.6)) {
    o.shape = Shape::round({ridge, eaves + rise * 0.55}, dice.between(0.25, 0.4));
    k.open(wall, o);
  } else {
    o.shape = Shape::flat({ridge - 0.4, ridge + 0.4, low, low + std::min(1.2, rise * 0.4)});
    k.open(wall, o);
  }
  k.finish();
  if (dice.chance(0.6)) k.plinth(wall);
  if (dice.chance(0.4))
    k.band(wall, "string_course", k.floor(1) - 0.1, k.floor(1) + 0.1, dice.between(0.03, 0.08));
  if (dice.chance(0.5)) k.canopy(wall, front * 0.3, front * 0.6, k.floor(1) - 0.2, 0.8);
}

}  // namespace jalon::grammar
