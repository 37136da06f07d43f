// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Large blocks: flats, offices, hotels.
#include <algorithm>
#include <cstdint>

#include "scan/grammar/sketch.h"

namespace jalon::grammar {

namespace {

PlannedOpening entrance(Dice& dice, double u, double width_m, double height_m) {
  PlannedOpening o;
  o.shape = Shape::flat({u - width_m / 2, u + width_m / 2, 0, height_m});
  o.opening_class = OpeningClass::kDoor;
  o.depth_m = dice.between(0.15, 0.6);
  o.filling.kind = dice.chance(0.5) ? Filling::Kind::kSash : Filling::Kind::kLeaf;
  o.filling.frame_m = 0.08;
  o.filling.stall_m = 0.25;
  return o;
}

PlannedOpening gateway(Dice& dice, double u, double width_m, double height_m, bool is_arched) {
  PlannedOpening o;
  const Rect rect{u - width_m / 2, u + width_m / 2, 0, height_m};
  o.shape = is_arched ? Shape::arched(rect, dice.chance(0.5) ? width_m / 2 : 0.18 * width_m)
                      : Shape::flat(rect);
  o.opening_class = OpeningClass::kGateway;
  o.depth_m = dice.between(0.25, 0.6);
  o.filling.kind = dice.chance(0.5) ? Filling::Kind::kLeaf : Filling::Kind::kNothing;
  return o;
}

}  // namespace

void plan_apartments(Sketch& k) {
  Dice& dice = k.dice();
  const auto [front, floors] = k.sizes(12, 22, 4, 6);
  const double upper_m = dice.length(2.6, 2.9), ground_m = dice.length(2.8, 3.6);
  k.storeys(floors, ground_m, upper_m);
  const size_t wall = k.wall("wall 1", 0, jalon::contour_of({0, front, 0, k.eaves() + 0.5}));
  const std::vector<double> axes = k.axes_by(0.4, front - 0.4, 2.6, 3.8);
  const int door = dice.count(0, static_cast<int>(axes.size()) - 1);
  const bool has_garages = dice.chance(0.4);
  WindowStyle window;
  window.width_m = dice.length(1.1, 1.8);
  window.height_m = dice.length(1.2, 1.5);
  window.depth_m = dice.between(0.08, 0.25);
  window.blinds = 0.4;
  window.has_sill = dice.chance(0.5);
  WindowStyle tall = window;
  tall.width_m = dice.length(1.4, 2.2);
  tall.height_m = 2.2;
  tall.sill_m = 0.02;
  tall.has_sill = false;
  for (size_t i = 0; i < axes.size(); ++i) {
    const double u = axes[i];
    if (static_cast<int>(i) == door) {
      const double high = dice.length(2.1, 2.4), wide = dice.length(1.0, 1.4);
      k.open(wall, entrance(dice, u, wide, high));
    } else if (has_garages) {
      const double high = dice.length(2.0, 2.3), wide = dice.length(2.2, 2.5);
      k.open(wall, gateway(dice, u, wide, high, false));
    } else {
      k.window(wall, window, u, 0);
    }
    if (static_cast<int>(i) == door && dice.chance(0.5)) k.niche(wall, u + 1.1, 0.8, 0.6, 1.0);
    const bool has_balcony = dice.chance(0.55), is_solid = dice.chance(0.5);
    const double reach = dice.length(0.9, 1.5);
    for (int storey = 1; storey < floors; ++storey) {
      if (!has_balcony) {
        k.window(wall, window, u, storey);
        continue;
      }
      k.window(wall, tall, u, storey);
      k.balcony(wall, u - tall.width_m / 2 - 0.3, u + tall.width_m / 2 + 0.3, k.floor(storey),
                reach, is_solid);
    }
  }
  k.finish();
  if (dice.chance(0.4)) k.plinth(wall);
  if (dice.chance(0.6)) k.cornice(wall, k.eaves() + 0.5);
  k.drainpipe(wall, 0.15, k.eaves());
  k.clutter(wall, 4);
}

void plan_offices(Sketch& k) {
  Dice& dice = k.dice();
  const auto [front, floors] = k.sizes(14, 22, 3, 6);
  const double upper_m = dice.length(3.1, 3.5), ground_m = dice.length(3.4, 4.2);
  k.storeys(floors, ground_m, upper_m);
  const size_t wall = k.wall("wall 1", 0, jalon::contour_of({0, front, 0, k.eaves() + 0.8}));
  const bool has_ribbons = dice.chance(0.35);
  const std::vector<double> axes =
      has_ribbons ? k.axes_by(0.3, front - 0.3, 5, 8) : k.axes_by(0.3, front - 0.3, 1.8, 3.4);
  const double bay = (front - 0.6) / static_cast<double>(axes.size());
  WindowStyle s;
  s.width_m = bay - (has_ribbons ? 0.3 : dice.length(0.35, 0.8));
  s.height_m = dice.length(1.5, 2.1);
  s.sill_m = dice.length(0.6, 0.95);
  s.depth_m = dice.between(0.06, 0.35);
  s.mullions = std::max(1, static_cast<int>(s.width_m / dice.between(0.9, 1.4)));
  s.transoms = dice.count(0, 1);
  s.blinds = 0.35;
  s.curtains = 0.15;
  const auto door = static_cast<size_t>(dice.count(0, static_cast<int>(axes.size()) - 1));
  for (size_t i = 0; i < axes.size(); ++i)
    if (i == door) k.open(wall, entrance(dice, axes[i], std::min(bay - 0.4, 2.4), 2.4));
    else if (dice.chance(0.5))
      k.shop_front(wall, axes[i] - s.width_m / 2, axes[i] + s.width_m / 2, 2.7,
                   dice.between(0.06, 0.3));
    else k.window(wall, s, axes[i], 0);
  for (int storey = 1; storey < floors; ++storey) k.window_row(wall, s, axes, storey);
  for (const double u : k.axes(0.3, front - 0.3, 3)) k.vent(wall, u, k.eaves() + 0.1, 0.8, 0.4);
  k.finish();
  // Panels between the windows, 3 to 5 cm proud; posts between the axes.
  const double proud = dice.between(0.03, 0.05);
  if (dice.chance(0.7))
    for (int storey = 1; storey < floors; ++storey)
      for (const double u : axes) {
        const double v = k.floor(storey);
        k.pad(wall, "panel",
              {u - s.width_m / 2 + 0.02, u + s.width_m / 2 - 0.02, v - 0.25, v + s.sill_m - 0.06},
              0, proud);
      }
  if (!has_ribbons && dice.chance(0.5))
    for (size_t i = 0; i + 1 < axes.size(); ++i) {
      const double u = (axes[i] + axes[i + 1]) / 2, half = (bay - s.width_m) / 2 - 0.06;
      if (half > 0.06) k.pad(wall, "post", {u - half, u + half, k.floor(1), k.eaves()}, 0, 0.12);
    }
}

void plan_loggias(Sketch& k) {
  Dice& dice = k.dice();
  const auto [front, floors] = k.sizes(12, 20, 3, 5);
  const double upper_m = dice.length(2.8, 3.2), ground_m = dice.length(3.4, 4.2);
  k.storeys(floors, ground_m, upper_m);
  const size_t wall = k.wall("wall 1", 0, jalon::contour_of({0, front, 0, k.eaves() + 0.4}));
  const std::vector<double> axes = k.axes_by(0.4, front - 0.4, 2.8, 4.2);
  const double bay = (front - 0.8) / static_cast<double>(axes.size());
  const auto gate = static_cast<size_t>(dice.count(0, static_cast<int>(axes.size()) - 1));
  WindowStyle s;
  s.width_m = dice.length(1.0, 1.5);
  s.height_m = dice.length(1.3, 1.6);
  s.depth_m = dice.between(0.1, 0.3);
  s.surround_m = dice.chance(0.3) ? 0.12 : 0;
  s.blinds = 0.25;
  const double depth = dice.length(1.1, 1.9);
  k.plan().rooms_from_m = depth + 0.4;
  for (size_t i = 0; i < axes.size(); ++i) {
    const double u = axes[i];
    if (i == gate) {
      const bool is_arched = dice.chance(0.6);
      const double high = dice.length(2.5, 3.0), wide = dice.length(2.2, 3.2);
      k.open(wall, gateway(dice, u, std::min(bay - 0.6, wide), high, is_arched));
    } else if (dice.chance(0.3)) {
      k.door(wall, u, dice.length(0.9, 1.4), 2.2, 0.25);
    } else {
      k.window(wall, s, u, 0);
    }
    const bool has_loggias = dice.chance(0.5);
    for (int storey = 1; storey < floors; ++storey) {
      if (!has_loggias) {
        k.window(wall, s, u, storey);
        continue;
      }
      const double half = std::min(bay / 2 - 0.3, 1.6), v = k.floor(storey) + 0.1;
      const size_t back = k.recess(wall, {u - half, u + half, v, v + 2.4}, depth, storey);
      if (back == SIZE_MAX) continue;
      WindowStyle inner = s;
      inner.sill_m = 0.2;
      inner.height_m = 2.0;
      inner.width_m = std::min(half, 1.2);
      inner.depth_m = 0.12;
      inner.surround_m = 0;
      k.window(back, inner, u, storey);
    }
  }
  k.finish();
  if (dice.chance(0.5)) k.plinth(wall);
  if (dice.chance(0.5)) k.cornice(wall, k.eaves() + 0.4);
}

void plan_mansard(Sketch& k) {
  Dice& dice = k.dice();
  const auto [front, floors] = k.sizes(10, 18, 4, 6);
  const double shrink = dice.between(0.94, 0.98), upper_m = dice.length(3.0, 3.5),
               ground_m = dice.length(3.6, 4.4);
  k.storeys(floors, ground_m, upper_m, shrink);
  const double eaves = k.eaves();
  const size_t wall = k.wall("wall 1", 0, jalon::contour_of({0, front, 0, eaves}));
  const std::vector<double> axes = k.axes_by(0.4, front - 0.4, 2.1, 2.9);
  WindowStyle s;
  s.width_m = dice.length(1.0, 1.3);
  s.height_m = dice.length(1.9, 2.3);
  s.sill_m = 0.15;
  s.form = dice.chance(0.5) ? Shape::Form::kArched : Shape::Form::kFlat;
  s.rise_m = dice.chance(0.5) ? s.width_m / 2 : dice.length(0.1, 0.25, 0.01);
  s.depth_m = dice.between(0.15, 0.35);
  s.surround_m = dice.length(0.12, 0.2, 0.01);
  s.transoms = 1;
  // Ground floor: arches with shops, and a gateway or a door.
  const auto gate = static_cast<size_t>(dice.count(0, static_cast<int>(axes.size()) - 1));
  for (size_t i = 0; i < axes.size(); ++i) {
    PlannedOpening o = gateway(dice, axes[i], 1.6, 2.9, true);
    if (i != gate) {
      o.opening_class = OpeningClass::kShopFront;
      o.filling = {};
      o.filling.stall_m = dice.chance(0.5) ? 0.5 : 0;
      o.depth_m = dice.between(0.1, 0.4);
    }
    k.open(wall, o);
  }
  const int long_balcony = dice.count(1, 2);
  for (int storey = 1; storey < floors; ++storey) {
    WindowStyle own = s;
    own.height_m = std::min(s.height_m, k.floor(storey + 1) - k.floor(storey) - own.sill_m - 0.45);
    k.window_row(wall, own, axes, storey);
    if (storey == long_balcony)
      k.balcony(wall, 0.3, front - 0.3, k.floor(storey), dice.between(0.6, 0.9), false);
    else
      for (const double u : axes) k.balcony(wall, u - 0.8, u + 0.8, k.floor(storey), 0.25, false);
  }
  k.finish();
  for (int storey = 1; storey < floors; ++storey)
    if (storey != long_balcony)
      k.band(wall, "string_course", k.floor(storey) - 0.25, k.floor(storey) - 0.17, 0.08);
  k.cornice(wall, eaves);
  // The steep roof with dormers: walls of their own, set back.
  const double back = dice.between(0.25, 0.5);
  k.plan().plates.push_back(
      {"roof", {{0, back, eaves}, {1, 0, 0}, normalized(Vec3{0, 0.35, 1})}, {0, front, 0, 2.9}});
  for (const double u : axes) {
    const double half = s.width_m / 2 + 0.3;
    const size_t dormer = k.wall("dormer " + std::to_string(k.plan().walls.size()), back - 0.1,
                                 jalon::contour_of({u - half, u + half, eaves, eaves + 2.2}));
    PlannedOpening o;
    o.storey = floors;
    o.depth_m = 0.12;
    if (dice.chance(0.25)) o.shape = Shape::round({u, eaves + 1.2}, s.width_m / 2);
    else
      o.shape = Shape::arched({u - s.width_m / 2, u + s.width_m / 2, eaves + 0.3, eaves + 1.9},
                              dice.chance(0.5) ? s.width_m / 2 : 0.15);
    k.open(dormer, o);
    for (const double side : {u - half, u + half})
      k.plan().plates.push_back(
          {"return", {{side, back - 0.1, eaves}, {0, 1, 0}, {0, 0, 1}}, {0, 1.0, 0, 2.2}});
    k.plan().plates.push_back({"roof",
                               {{u - half - 0.1, back - 0.25, eaves + 2.2}, {1, 0, 0}, {0, 1, 0}},
                               {0, 2 * half + 0.2, 0, 1.2}});
  }
}

}  // namespace jalon::grammar
