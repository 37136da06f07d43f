// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Wings about a middle with a pediment; churches.
#include <algorithm>

#include "scan/grammar/sketch.h"

namespace jalon::grammar {

void plan_wings(Sketch& k) {
  Dice& dice = k.dice();
  const auto [front, floors] = k.sizes(16, 24, 2, 4);
  const double upper_m = dice.length(3.0, 3.5), ground_m = dice.length(3.4, 4.2);
  k.storeys(floors, ground_m, upper_m);
  const double eaves = k.eaves();
  const double wing = front * dice.between(0.25, 0.35);
  const double back = dice.length(0.3, 1.6) * (dice.chance(0.75) ? 1 : -1);
  const double us[] = {0, wing, front - wing, front};
  const double ys[] = {back, 0, back};
  WindowStyle s;
  s.width_m = std::min(dice.length(1.0, 1.4), wing - 0.4);
  s.height_m = dice.length(1.6, 2.1);
  s.sill_m = 0.8;
  s.depth_m = dice.between(0.15, 0.35);
  s.surround_m = dice.chance(0.6) ? dice.length(0.12, 0.2, 0.01) : 0;
  s.has_sill = true;
  s.transoms = dice.count(0, 2);
  const bool has_pediment = dice.chance(0.75);
  for (int i = 0; i < 3; ++i) {
    const double u0 = us[i], u1 = us[i + 1];
    Contour outline{{{u0, 0}}, {{u1, 0}}, {{u1, eaves}}, {{u0, eaves}}};
    const double rise = (u1 - u0) * dice.between(0.2, 0.3);
    if (i == 1 && has_pediment)
      outline.insert(outline.begin() + 3, {{{(u0 + u1) / 2, eaves + rise}}});
    const size_t wall = k.wall("wing " + std::to_string(i + 1), ys[i], outline);
    const std::vector<double> axes = k.axes_by(u0 + 0.2, u1 - 0.2, 2.0, 2.9);
    if (i == 1) {
      PlannedOpening o;
      const double middle = axes[axes.size() / 2],
                   width = std::min(dice.length(1.4, 2.0), u1 - u0 - 0.4);
      o.shape =
          Shape::arched({middle - width / 2, middle + width / 2, 0, 2.1 + width / 2}, width / 2);
      o.opening_class = OpeningClass::kDoor;
      o.depth_m = 0.4;
      o.surround_m = s.surround_m;
      o.filling.kind = Filling::Kind::kLeaf;
      k.open(wall, o);
      if (has_pediment && rise > 1.3) {
        o = {};
        o.shape = Shape::round({(u0 + u1) / 2, eaves + rise * 0.42}, std::min(0.5, rise * 0.22));
        o.storey = floors;
        o.filling.mullions = 0;
        k.open(wall, o);
      }
    }
    WindowStyle own = s;
    if (i == 1 && dice.chance(0.4)) {
      own.form = Shape::Form::kArched;
      own.rise_m = own.width_m / 2;
    }
    for (int storey = 0; storey < floors; ++storey) k.window_row(wall, own, axes, storey);
    if (i > 0) k.joint(u0, ys[i - 1], ys[i], eaves);
  }
  k.finish();
  for (size_t w = 0; w < 3; ++w) {
    if (dice.chance(0.6)) k.plinth(w);
    if (dice.chance(0.5))
      k.band(w, "string_course", k.floor(1) - 0.1, k.floor(1) + 0.1, dice.between(0.04, 0.1));
    k.cornice(w, eaves);
    if (dice.chance(0.6) && (w != 1 || !has_pediment)) k.roof(us[w], us[w + 1], eaves, ys[w]);
  }
}

void plan_church(Sketch& k) {
  Dice& dice = k.dice();
  const double front = k.sizes(10, 16, 1, 1).first;
  k.storeys(1, dice.length(8, 11), 3);
  k.plan().has_rooms = false;
  const double eaves = k.eaves() * dice.between(0.6, 0.8), middle = front / 2;
  k.plan().rooms_top_m = eaves;
  const double ridge = eaves + front * dice.between(0.4, 0.65);
  const size_t wall = k.wall(
      "wall 1", 0, {{{0, 0}}, {{front, 0}}, {{front, eaves}}, {{middle, ridge}}, {{0, eaves}}});
  // 1. The portal.
  PlannedOpening o;
  const double width = dice.length(1.8, 2.6), half = width / 2, head = dice.length(2.8, 3.6);
  o.opening_class = OpeningClass::kDoor;
  o.filling.kind = Filling::Kind::kLeaf;
  o.filling.mullions = 1;
  o.depth_m = dice.between(0.3, 0.7);
  o.surround_m = 0.2;
  const bool is_gothic = dice.chance(0.5);
  const Rect portal{middle - half, middle + half, 0, head + (is_gothic ? 0.9 : 0.5) * width};
  o.shape = is_gothic ? Shape::pointed(portal) : Shape::arched(portal, half);
  k.open(wall, o);
  // 2. The rose above it.
  const double radius = dice.between(0.7, 1.3), rose = portal.v1 + radius + dice.between(0.5, 1);
  o = {};
  o.shape = Shape::round({middle, rose}, radius);
  o.storey = 1;
  o.depth_m = dice.between(0.2, 0.4);
  o.surround_m = dice.chance(0.6) ? 0.18 : 0;
  o.filling.mullions = 3;
  o.filling.transoms = 3;
  k.open(wall, o);
  // 3. Lancets beside them.
  WindowStyle s;
  s.form = is_gothic ? Shape::Form::kPointed : Shape::Form::kArched;
  s.width_m = dice.length(0.6, 1.0);
  s.rise_m = s.width_m / 2;
  s.height_m = dice.length(2.4, 3.4);
  s.sill_m = dice.length(1.8, 2.6);
  s.depth_m = dice.between(0.2, 0.45);
  s.mullions = 1;
  s.transoms = 3;
  s.curtains = 0;
  for (const double u : {front * 0.16, front * 0.84}) k.window(wall, s, u, 0);
  if (front > 13)
    for (const double u : {front * 0.28, front * 0.72}) k.window(wall, s, u, 0);
  // 4. A triangle or a small round window under the ridge.
  const double v = rose + radius + 0.7, side = dice.between(0.45, 0.8);
  o.surround_m = 0;
  o.filling = {};
  o.filling.mullions = 0;
  if (dice.chance(0.5))
    o.shape = Shape::polygon({{middle - side, v}, {middle + side, v}, {middle, v + 1.4 * side}});
  else o.shape = Shape::round({middle, v + side / 2}, side / 2);
  k.open(wall, o);
  k.finish();
  // 5. Buttresses.
  const double high = eaves * dice.between(0.6, 0.9);
  for (const double u : {0.02, front - 0.62})
    k.pad(wall, "buttress", {u, u + 0.6, 0, high}, 0, dice.between(0.3, 0.8));
  k.plinth(wall);
}

}  // namespace jalon::grammar
