// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Buildings of towns that keep no plain grid: warehouses, blocks with staggered windows, houses at a street corner.
#include <algorithm>
#include <cstdint>
#include <numbers>

#include "scan/grammar/sketch.h"

namespace jalon::grammar {

namespace {

PlannedOpening door_of(const Shape& shape, OpeningClass opening_class, double depth_m,
                       Filling::Kind filling) {
  PlannedOpening o;
  o.shape = shape;
  o.opening_class = opening_class;
  o.depth_m = depth_m;
  o.filling.kind = filling;
  return o;
}

/// The three windows of a staggered front, by size.
std::vector<WindowStyle> three_sizes(Dice& dice) {
  WindowStyle small;
  small.width_m = small.height_m = dice.length(0.6, 0.9);
  small.sill_m = dice.length(1.0, 1.4);
  small.mullions = 0;
  small.depth_m = dice.between(0.12, 0.35);
  WindowStyle upright = small, lying = small;
  upright.width_m = dice.length(0.8, 1.1);
  upright.height_m = dice.length(1.9, 2.2);
  upright.sill_m = dice.length(0.1, 0.25);
  lying.width_m = dice.length(1.6, 2.2);
  lying.height_m = dice.length(1.2, 1.5);
  lying.sill_m = dice.length(0.7, 0.9);
  lying.mullions = 1;
  return {small, upright, lying};
}

}  // namespace

void plan_warehouse(Sketch& k) {
  Dice& dice = k.dice();
  const auto [front, floors] = k.sizes(9, 18, 3, 6);
  const double upper_m = dice.length(2.7, 3.3), ground_m = dice.length(3.2, 4);
  k.storeys(floors, ground_m, upper_m);
  const double eaves = k.eaves(), proud = dice.between(0.06, 0.15);
  // 1. A gable with a flat top over the hoist; the top storey lies in it.
  const double middle = front / 2, gable_m = dice.length(2.6, 3.4),
               top_half = std::min(dice.length(1.8, 2.4), middle - 1);
  const size_t wall = k.wall("wall 1", 0,
                             {{{0, 0}},
                              {{front, 0}},
                              {{front, eaves}},
                              {{middle + top_half, eaves + gable_m}},
                              {{middle - top_half, eaves + gable_m}},
                              {{0, eaves}}});
  // 2. Loading doors above each other.
  const double half = dice.length(1.2, 1.7) / 2, rise = dice.length(0.1, 0.25),
               depth = dice.between(0.12, 0.4);
  for (int storey = 0; storey <= floors; ++storey) {
    const double v = k.floor(storey) + (storey > 0 ? 0.1 : 0);
    const Rect rect{middle - half, middle + half, v, v + 2.2};
    PlannedOpening o = door_of(Shape::arched(rect, rise),
                               storey == 0 ? OpeningClass::kGateway : OpeningClass::kDoor, depth,
                               dice.chance(0.7) ? Filling::Kind::kLeaf : Filling::Kind::kSash);
    o.storey = storey;
    o.filling.mullions = 1;
    k.open(wall, o);
  }
  // 3. Windows with segmental arches on both sides.
  WindowStyle s;
  s.form = Shape::Form::kArched;
  s.width_m = dice.length(0.9, 1.5);
  s.height_m = dice.length(1.1, 1.6);
  s.rise_m = s.width_m * dice.between(0.1, 0.2);
  s.depth_m = dice.between(0.08, 0.3);
  s.has_sill = dice.chance(0.5);
  s.mullions = dice.count(1, 3);
  s.transoms = dice.count(1, 3);
  s.curtains = 0;
  for (int storey = 0; storey < floors; ++storey)
    for (const auto& [from, to] :
         {std::pair{0.3, middle - half - 0.3}, {middle + half + 0.3, front - 0.3}})
      k.window_row(wall, s, k.axes(from, to, std::max(1, static_cast<int>((to - from) / 2.1))),
                   storey, 0.08);
  for (const double u : {middle - half - 0.8, middle + half + 0.8})
    k.vent(wall, u, eaves + 1, 0.5, 0.5);
  k.finish();
  // 4. Anchors of the beams, the hoist, strips of brick between the storeys.
  if (dice.chance(0.5))
    for (int storey = 1; storey <= floors; ++storey)
      k.band(wall, "string_course", k.floor(storey) - 0.2, k.floor(storey) - 0.05, proud);
  k.plan().blocks.push_back(
      {"hoist", {middle - 0.1, -1.3, eaves + gable_m - 0.25}, {0.2, 1.299, 0.2}});
  if (dice.chance(0.5)) k.plinth(wall);
  k.drainpipe(wall, 0.2, eaves);
  k.clutter(wall, 3);
}

void plan_staggered(Sketch& k) {
  Dice& dice = k.dice();
  const auto [front, floors] = k.sizes(12, 22, 3, 6);
  const double upper_m = dice.length(2.8, 3.1), ground_m = dice.length(3, 3.6);
  k.storeys(floors, ground_m, upper_m);
  const size_t wall = k.wall("wall 1", 0, jalon::contour_of({0, front, 0, k.eaves() + 0.6}));
  const std::vector<WindowStyle> sizes = three_sizes(dice);
  const double depth = dice.length(1.2, 1.8), pitch = dice.length(2.5, 3.2);
  k.plan().rooms_from_m = depth + 0.4;
  // 1. A glazed entrance; beside it what the storeys have.
  const double door_u = front * dice.between(0.25, 0.75), half = dice.length(0.8, 1.4);
  PlannedOpening entrance =
      door_of(Shape::flat({door_u - half, door_u + half, 0, 2.5}), OpeningClass::kDoor,
              dice.between(0.1, 0.6), Filling::Kind::kSash);
  entrance.filling.mullions = 2;
  k.open(wall, entrance);
  // 2. Each storey starts elsewhere and draws sizes of its own; some bays are balconies in recesses.
  for (int storey = 0; storey < floors; ++storey) {
    double u = dice.between(1.3, 1.3 + pitch / 2);
    for (; u < front - 1.3; u += pitch * dice.between(0.85, 1.15)) {
      const double v = k.floor(storey) + 0.05;
      if (storey > 0 && dice.chance(0.2)) {
        const size_t back = k.recess(wall, {u - 1.2, u + 1.2, v, v + 2.4}, depth, storey);
        if (back == SIZE_MAX) continue;
        WindowStyle inner = sizes[1];
        inner.width_m = 1.4;
        inner.height_m = 2.1;
        inner.sill_m = 0.2;
        inner.depth_m = 0.1;
        k.window(back, inner, u - 0.3, storey);
        continue;
      }
      const WindowStyle& s = sizes[static_cast<size_t>(dice.count(0, 2))];
      k.window(wall, s, u + dice.between(-0.15, 0.15), storey);
    }
  }
  k.finish();
  // 3. Plates of another colour beside some windows, a canopy.
  for (int i = dice.count(0, 5); i > 0; --i) {
    const double u = dice.between(0.3, front - 1.5), v = k.floor(dice.count(1, floors - 1)) + 0.4;
    k.pad(wall, "panel", {u, u + dice.length(0.5, 1.1), v, v + dice.length(1, 1.9)}, 0,
          dice.between(0.015, 0.05));
  }
  if (dice.chance(0.5)) k.canopy(wall, door_u - half - 0.3, door_u + half + 0.3, 2.8, 1.2);
  k.clutter(wall, 3);
}

void plan_corner(Sketch& k) {
  Dice& dice = k.dice();
  const auto [front, floors] = k.sizes(8, 15, 3, 5);
  const double upper_m = dice.length(2.8, 3.3), ground_m = dice.length(3.4, 4.2);
  k.storeys(floors, ground_m, upper_m);
  const double eaves = k.eaves();
  // 1. The front, with a notch up to the eaves where the oriel stands out, and the cut corner beside it.
  const double half = dice.length(1.1, 1.5), reach = dice.length(0.5, 0.9);
  const double u = front * dice.between(0.3, 0.65), foot = k.floor(1) + 0.15;
  const size_t wall = k.wall("wall 1", 0,
                             {{{0, 0}},
                              {{front, 0}},
                              {{front, eaves}},
                              {{u + half, eaves}},
                              {{u + half, foot}},
                              {{u - half, foot}},
                              {{u - half, eaves}},
                              {{0, eaves}}});
  const size_t oriel =
      k.wall("oriel", -reach, jalon::contour_of({u - half, u + half, foot, eaves}));
  k.joint(u - half, 0, -reach, eaves);
  k.joint(u + half, -reach, 0, eaves);
  k.plan().blocks.push_back(
      {"soffit", {u - half, -reach, foot - 0.151}, {2 * half, reach - 0.001, 0.15}});
  const double chamfer = dice.length(1.5, 2.5);
  k.plan().plates.push_back({"corner",
                             {{front, 0, 0}, normalized(Vec3{1, 1, 0}), {0, 0, 1}},
                             {0, chamfer * std::numbers::sqrt2, 0, eaves}});
  // 2. Shops on the ground, a door between them.
  const double door = dice.length(0.9, 1.2), height = dice.length(2.4, 2.8);
  const double shop_depth = dice.between(0.05, 0.3);
  k.door(wall, u, door, 2.3, dice.between(0.1, 0.4));
  for (const auto& [from, to] :
       {std::pair{0.35, u - door / 2 - 0.4}, {u + door / 2 + 0.4, front - 0.35}})
    for (const double at : k.axes_by(from, to, 2.4, 4)) {
      const double wide = std::min(3.2, (to - from) * 0.8);
      k.shop_front(wall, std::max(from, at - wide / 2), std::min(to, at + wide / 2), height,
                   shop_depth);
    }
  // 3. Storeys: windows beside the oriel and in it.
  WindowStyle s;
  s.width_m = dice.length(0.9, 1.2);
  s.height_m = dice.length(1.5, 1.9);
  s.sill_m = dice.length(0.6, 0.9);
  s.depth_m = dice.between(0.1, 0.28);
  s.surround_m = dice.chance(0.5) ? 0.14 : 0;
  s.transoms = 1;
  s.has_sill = dice.chance(0.5);
  WindowStyle own = s;
  own.surround_m = 0;
  own.width_m = half * 0.7;
  own.mullions = 0;
  own.depth_m = dice.between(0.06, 0.15);
  for (int storey = 1; storey < floors; ++storey) {
    k.window_row(wall, s, k.axes_by(0.2, u - half - 0.1, 1.9, 2.6), storey);
    k.window_row(wall, s, k.axes_by(u + half + 0.1, front - 0.2, 1.9, 2.6), storey);
    for (const double side : {-0.46, 0.46}) k.window(oriel, own, u + side * half, storey);
  }
  k.finish();
  for (int storey = 1; storey < floors; ++storey)
    k.pad(
        oriel, "panel",
        {u - half * 0.8, u + half * 0.8, k.floor(storey) + 0.2, k.floor(storey) + s.sill_m - 0.15},
        0, dice.between(0.02, 0.05));
  if (dice.chance(0.6)) k.sign(wall, 0.5, u - door / 2 - 0.5, height + 0.1, height + 0.5);
  k.roof(0, front, eaves, 0);
  k.clutter(wall, 3);
}

}  // namespace jalon::grammar
