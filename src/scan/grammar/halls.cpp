// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Long buildings of few storeys: schools, sheds with a saw-tooth roof, naves seen from the side.
#include <algorithm>

#include "scan/grammar/sketch.h"

namespace jalon::grammar {

void plan_school(Sketch& k) {
  Dice& dice = k.dice();
  const auto [front, floors] = k.sizes(16, 30, 2, 4);
  const double upper_m = dice.length(3.0, 3.5), ground_m = dice.length(3.2, 3.8);
  k.storeys(floors, ground_m, upper_m);
  const double eaves = k.eaves(), stair = std::min(front * 0.3, dice.length(3, 4.5));
  const double forward = -dice.length(0.3, 1.5), tower_top = eaves + dice.length(0.8, 2);
  const size_t tower = k.wall("stair", forward, jalon::contour_of({0, stair, 0, tower_top}));
  const size_t wall = k.wall("wall 1", 0, jalon::contour_of({stair, front, 0, eaves + 0.5}));
  k.joint(stair, forward, 0, tower_top);
  // 1. The stair: a glazed door below, small square windows at every landing.
  PlannedOpening o;
  const double half = std::min(stair / 2 - 0.3, dice.length(0.8, 1.2));
  o.shape = Shape::flat({stair / 2 - half, stair / 2 + half, 0, 2.4});
  o.opening_class = OpeningClass::kDoor;
  o.depth_m = dice.between(0.1, 0.5);
  o.filling.mullions = 2;
  o.filling.stall_m = 0.3;
  k.open(tower, o);
  WindowStyle landing;
  landing.width_m = landing.height_m = dice.length(0.5, 0.9);
  landing.depth_m = dice.between(0.05, 0.2);
  landing.mullions = 0;
  for (int storey = 1; storey < floors; ++storey) {
    landing.sill_m = -0.6;
    for (const double side : {-0.25, 0.25}) k.window(tower, landing, stair * (0.5 + side), storey);
  }
  // 2. Ribbons between narrow piers, with screens over or between them.
  const std::vector<double> axes = k.axes_by(stair + 0.3, front - 0.3, 3.5, 7);
  const double bay = (front - stair - 0.6) / static_cast<double>(axes.size());
  WindowStyle s;
  s.width_m = bay - dice.length(0.15, 0.4);
  s.height_m = dice.length(1.2, 2);
  s.sill_m = dice.length(0.8, 1.1);
  s.depth_m = dice.between(0.04, 0.2);
  s.mullions = std::max(2, static_cast<int>(s.width_m / dice.between(0.8, 1.3)));
  s.transoms = dice.count(0, 1);
  s.blinds = 0.5;
  const bool has_visors = dice.chance(0.5), has_fins = !has_visors && dice.chance(0.6);
  const double reach = dice.length(0.4, 0.9);
  for (int storey = 0; storey < floors; ++storey) {
    k.window_row(wall, s, axes, storey);
    const double head = k.floor(storey) + s.sill_m + s.height_m;
    if (has_visors)
      k.plan().blocks.push_back({"screen",
                                 {stair + 0.2, -reach - 0.002, head + 0.1},
                                 {front - stair - 0.4, reach, 0.06}});
    if (has_fins)
      for (size_t i = 0; i + 1 < axes.size(); ++i)
        k.plan().blocks.push_back(
            {"screen",
             {(axes[i] + axes[i + 1]) / 2 - 0.04, -reach - 0.002, head - s.height_m},
             {0.08, reach, s.height_m}});
  }
  k.finish();
  k.canopy(tower, 0.2, stair - 0.2, 2.9, dice.length(0.8, 1.6));
  if (dice.chance(0.5)) k.drainpipe(wall, front - 0.15, eaves);
}

void plan_sheds(Sketch& k) {
  Dice& dice = k.dice();
  const double front = k.sizes(15, 30, 1, 1).first;
  k.storeys(1, dice.length(4.5, 6.5), 3);
  k.plan().has_rooms = false;
  const double eaves = k.eaves();
  k.plan().rooms_top_m = eaves;
  const int teeth = std::max(1, static_cast<int>(front / dice.between(4.5, 7.5)));
  const double tooth = front / teeth, rise = tooth * dice.between(0.25, 0.45);
  const bool falls_right = dice.chance(0.5);
  // 1. The saw teeth, from the right: each upright at one side, sloping to the other.
  Contour outline{{{0, 0}}, {{front, 0}}};
  for (int i = teeth; i-- > 0;) {
    const double right = tooth * (i + 1), left = tooth * i;
    outline.push_back({{right, falls_right ? eaves : eaves + rise}});
    outline.push_back({{left, falls_right ? eaves + rise : eaves}});
  }
  const size_t wall = k.wall("wall 1", 0, outline);
  // 2. Strips of windows high up, gates and a door below.
  const std::vector<double> axes = k.axes(0, front, teeth);
  WindowStyle s;
  s.width_m = tooth - dice.length(0.6, 1.4);
  s.height_m = dice.length(0.7, 1.2);
  s.sill_m = eaves - s.height_m - dice.length(0.3, 0.6);
  s.depth_m = dice.between(0.04, 0.3);
  s.mullions = std::max(2, static_cast<int>(s.width_m / dice.between(0.5, 1)));
  s.curtains = 0;
  k.window_row(wall, s, axes, 0, 0.1);
  const auto gate = static_cast<size_t>(dice.count(0, teeth - 1));
  for (size_t i = 0; i < axes.size(); ++i) {
    PlannedOpening o;
    const double wide = std::min(tooth - 1, dice.length(2.4, 3.6)) / 2;
    o.shape = Shape::flat({axes[i] - wide, axes[i] + wide, 0, std::min(s.sill_m - 0.3, 3.2)});
    o.opening_class = OpeningClass::kGateway;
    o.depth_m = dice.between(0.06, 0.3);
    o.filling.kind = dice.chance(0.7) ? Filling::Kind::kClosed : Filling::Kind::kNothing;
    if (i == gate || dice.chance(0.25)) k.open(wall, o);
    else if (dice.chance(0.5)) k.door(wall, axes[i], 1, 2.1, dice.between(0.05, 0.15));
    if (rise > 1.6 && dice.chance(0.5))
      k.vent(wall, tooth * (static_cast<double>(i) + (falls_right ? 0.2 : 0.8)), eaves + 0.2, 0.7,
             0.5);
  }
  k.finish();
  if (dice.chance(0.6)) k.plinth(wall);
  for (int i = 1; i < teeth; ++i)
    if (dice.chance(0.7)) k.drainpipe(wall, tooth * i, eaves);
  if (dice.chance(0.5)) k.sign(wall, front * 0.35, front * 0.65, s.sill_m - 0.25, s.sill_m - 0.05);
  k.clutter(wall, 3);
}

void plan_nave(Sketch& k) {
  Dice& dice = k.dice();
  const double front = k.sizes(14, 26, 1, 1).first;
  k.storeys(1, dice.length(6, 9), 3);
  k.plan().has_rooms = false;
  const double eaves = k.eaves();
  k.plan().rooms_top_m = eaves;
  const size_t wall = k.wall("wall 1", 0, jalon::contour_of({0, front, 0, eaves}));
  const std::vector<double> axes = k.axes_by(0.3, front - 0.3, 2.8, 4.5);
  const double bay = (front - 0.6) / static_cast<double>(axes.size());
  const bool is_gothic = dice.chance(0.6), are_pairs = bay > 3.2 && dice.chance(0.5);
  WindowStyle s;
  s.form = is_gothic ? Shape::Form::kPointed : Shape::Form::kArched;
  s.width_m = are_pairs ? dice.length(0.6, 0.8) : dice.length(0.8, 1.4);
  s.rise_m = s.width_m / 2;
  s.height_m = dice.length(2.2, eaves - 3.6);
  s.sill_m = dice.length(2.0, 2.6);
  s.depth_m = dice.between(0.2, 0.5);
  s.surround_m = are_pairs || dice.chance(0.5) ? 0 : 0.15;
  s.transoms = dice.count(2, 4);
  s.curtains = 0;
  const auto door = static_cast<size_t>(dice.count(0, static_cast<int>(axes.size()) - 1));
  for (size_t i = 0; i < axes.size(); ++i) {
    if (i == door) {
      PlannedOpening o;
      const double width = dice.length(1.1, 1.5), head = dice.length(2.0, 2.4);
      const Rect rect{axes[i] - width / 2, axes[i] + width / 2, 0,
                      head + (is_gothic ? 0.85 : 0.5) * width};
      o.shape = is_gothic ? Shape::pointed(rect) : Shape::arched(rect, width / 2);
      o.opening_class = OpeningClass::kDoor;
      o.depth_m = dice.between(0.2, 0.5);
      o.filling.kind = Filling::Kind::kLeaf;
      k.open(wall, o);
      o = {};
      o.shape = Shape::round({axes[i], rect.v1 + 1.2}, 0.5);
      o.depth_m = s.depth_m;
      o.filling.transoms = 1;
      k.open(wall, o);
    } else if (are_pairs) {
      for (const double side : {-0.5, 0.5}) k.window(wall, s, axes[i] + side, 0);
    } else {
      k.window(wall, s, axes[i], 0);
    }
  }
  k.finish();
  // Buttresses between the bays, that stand well forward, with a step.
  const double high = eaves * dice.between(0.65, 0.9), reach = dice.between(0.4, 1.1);
  for (size_t i = 0; i + 1 < axes.size(); ++i) {
    const double u = (axes[i] + axes[i + 1]) / 2;
    k.pad(wall, "buttress", {u - 0.25, u + 0.25, 0, high * 0.55}, 0, reach);
    k.pad(wall, "buttress", {u - 0.25, u + 0.25, high * 0.55, high}, 0, reach * 0.6);
  }
  k.plinth(wall);
  if (dice.chance(0.6)) k.cornice(wall, eaves);
  k.roof(0, front, eaves, 0);
}

}  // namespace jalon::grammar
