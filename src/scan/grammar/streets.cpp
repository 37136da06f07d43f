// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// What has a life at its foot: shops, arcades, factories.
#include <algorithm>

#include "scan/grammar/sketch.h"

namespace jalon::grammar {

namespace {

WindowStyle street_style(Dice& dice) {
  WindowStyle s;
  s.width_m = dice.length(0.9, 1.6);
  s.height_m = dice.length(1.3, 1.9);
  s.sill_m = dice.length(0.7, 0.95);
  s.depth_m = dice.between(0.05, 0.3);
  s.has_sill = dice.chance(0.5);
  s.surround_m = dice.chance(0.3) ? 0.12 : 0;
  s.mullions = dice.count(1, 2);
  s.blinds = dice.chance(0.3) ? 0.4 : 0.05;
  return s;
}

}  // namespace

void plan_shops(Sketch& k) {
  Dice& dice = k.dice();
  const auto [front, floors] = k.sizes(8, 22, 1, 3);
  const double upper_m = dice.length(2.9, 3.3), ground_m = dice.length(3.6, 4.6);
  k.storeys(floors, ground_m, upper_m);
  const double top = k.eaves() + (floors == 1 ? dice.length(0.5, 1.5) : 0.4);
  const size_t wall = k.wall("wall 1", 0, jalon::contour_of({0, front, 0, top}));
  const std::vector<double> shops = k.axes_by(0.3, front - 0.3, 3.2, 5.5);
  const double bay = (front - 0.6) / static_cast<double>(shops.size());
  for (const double u : shops) {
    const double u0 = u - bay / 2 + dice.length(0.2, 0.5), u1 = u + bay / 2 - 0.2;
    const double head = dice.length(2.3, 2.8), depth = dice.between(0.03, 0.3);
    // Some have the door beside the window, some in the middle of it.
    if (dice.chance(0.45) && u1 - u0 > 2.4) {
      const double width = dice.length(0.9, 1.1);
      k.door(wall, u1 - width / 2, width, std::min(head, 2.3), dice.between(0.1, 0.5));
      k.shop_front(wall, u0, u1 - width - 0.3, head, depth);
    } else {
      k.shop_front(wall, u0, u1, head, depth);
    }
    const double low = head + dice.length(0.1, 0.25);
    const double high = std::min(low + dice.length(0.4, 0.9), k.floor(1) - 0.05);
    if (high > low + 0.2 && dice.chance(0.85)) k.sign(wall, u0, u1, low, high);
    if (dice.chance(0.5)) k.canopy(wall, u0, u1, high + 0.03, dice.length(0.7, 1.4));
    if (dice.chance(0.2)) k.vent(wall, u0 + 0.5, high + 0.1, 0.6, 0.3);
  }
  if (floors > 1) {
    const WindowStyle style = street_style(dice);
    const std::vector<double> axes = k.axes_by(0.3, front - 0.3, 2.0, 3.2);
    for (int storey = 1; storey < floors; ++storey) k.window_row(wall, style, axes, storey, 0.1);
  }
  k.finish();
  if (dice.chance(0.3)) k.plinth(wall);
  if (dice.chance(0.4)) k.cornice(wall, top);
  if (dice.chance(0.5)) k.drainpipe(wall, front - 0.1, top);
  k.clutter(wall, 4);
}

void plan_arcade(Sketch& k) {
  Dice& dice = k.dice();
  const auto [front, floors] = k.sizes(12, 20, 2, 4);
  const double upper_m = dice.length(3.0, 3.4), ground_m = dice.length(4.0, 4.8);
  k.storeys(floors, ground_m, upper_m);
  const size_t wall = k.wall("wall 1", 0, jalon::contour_of({0, front, 0, k.eaves() + 0.3}));
  const double passage = dice.length(2.5, 4);
  k.plan().rooms_from_m = 0.5;
  k.plan().rooms_to_m = passage + 3;
  const std::vector<double> arches = k.axes_by(0.2, front - 0.2, 2.8, 4);
  const double bay = (front - 0.4) / static_cast<double>(arches.size());
  const double width = bay - dice.length(0.5, 0.9);
  const double rise = dice.chance(0.6) ? width / 2 : dice.length(0.2, 0.5) * width;
  const double head = std::min(k.floor(1) - 0.5, dice.length(2.1, 2.6) + rise);
  const double shorter = std::min(rise, head - 1.2);
  for (const double u : arches) {
    PlannedOpening o;
    o.shape = Shape::arched({u - width / 2, u + width / 2, 0, head}, shorter);
    o.opening_class = OpeningClass::kRecess;
    o.depth_m = passage;
    o.filling.kind = Filling::Kind::kRecess;
    o.surround_m = dice.chance(0.15) ? 0.2 : 0;
    k.open(wall, o);
  }
  // The back of the passage, with shops.
  const size_t back =
      k.wall("back of the arcade", passage, jalon::contour_of({0, front, 0, k.floor(1) - 0.2}));
  k.plan().blocks.push_back({"soffit", {0, 0.45, k.floor(1) - 0.2}, {front, passage - 0.451, 0.1}});
  for (const double u : arches) {
    if (dice.chance(0.25)) k.door(back, u, 1.1, 2.3, 0.15);
    else k.shop_front(back, u - bay / 2 + 0.3, u + bay / 2 - 0.3, 2.7, dice.between(0.05, 0.2));
  }
  WindowStyle style = street_style(dice);
  if (dice.chance(0.4)) {
    style.form = Shape::Form::kArched;
    style.rise_m = dice.chance(0.5) ? style.width_m / 2 : 0.15;
    style.has_sill = false;
  }
  for (int storey = 1; storey < floors; ++storey) k.window_row(wall, style, arches, storey);
  k.finish();
  if (dice.chance(0.7))
    k.band(wall, "string_course", k.floor(1) - 0.1, k.floor(1) + 0.12, dice.between(0.04, 0.1));
  if (dice.chance(0.6)) k.cornice(wall, k.eaves() + 0.3);
  k.clutter(wall, 4);
}

void plan_factory(Sketch& k) {
  Dice& dice = k.dice();
  const auto [front, floors] = k.sizes(14, 24, 1, 3);
  const double upper_m = dice.length(3.5, 4.2), ground_m = dice.length(4.2, 5.5);
  k.storeys(floors, ground_m, upper_m);
  const double top = k.eaves() + 0.6;
  const size_t wall = k.wall("wall 1", 0, jalon::contour_of({0, front, 0, top}));
  const std::vector<double> axes = k.axes_by(0.4, front - 0.4, 3.6, 6);
  const double bay = (front - 0.8) / static_cast<double>(axes.size());
  const bool has_arches = dice.chance(0.35);
  const auto gate = static_cast<size_t>(dice.count(0, static_cast<int>(axes.size()) - 1));
  WindowStyle s;
  s.width_m = bay - dice.length(0.5, 1.2);
  s.height_m = dice.length(1.4, 2.2);
  s.sill_m = dice.length(1.2, 1.6);
  s.depth_m = dice.between(0.05, 0.25);
  s.form = has_arches ? Shape::Form::kArched : Shape::Form::kFlat;
  s.rise_m = dice.length(0.15, 0.4);
  s.mullions = std::max(2, static_cast<int>(s.width_m / dice.between(0.5, 0.9)));
  s.transoms = dice.count(1, 3);
  s.curtains = 0;
  for (size_t i = 0; i < axes.size(); ++i) {
    if (i == gate) {
      PlannedOpening o;
      const double half = std::min(bay - 0.6, dice.length(2.6, 3.8)) / 2;
      o.shape = Shape::flat({axes[i] - half, axes[i] + half, 0, dice.length(3.0, 3.8)});
      o.opening_class = OpeningClass::kGateway;
      o.depth_m = dice.between(0.08, 0.4);
      o.filling.kind = dice.chance(0.6) ? Filling::Kind::kClosed : Filling::Kind::kNothing;
      k.open(wall, o);
    } else if (dice.chance(0.25)) {
      k.door(wall, axes[i], dice.length(0.9, 1.1), 2.1, 0.1);
    } else {
      k.window(wall, s, axes[i], 0);
    }
    if (dice.chance(0.3)) k.vent(wall, axes[i], top - 0.55, 0.9, 0.35);
  }
  WindowStyle high = s;
  high.sill_m = 0.9;
  for (int storey = 1; storey < floors; ++storey) k.window_row(wall, high, axes, storey);
  k.finish();
  for (size_t i = 0; i + 1 < axes.size(); ++i)
    if (dice.chance(0.5)) {
      const double u = (axes[i] + axes[i + 1]) / 2;
      k.pad(wall, "post", {u - 0.2, u + 0.2, 0, top - 0.2}, 0, dice.between(0.05, 0.25));
    }
  if (dice.chance(0.5)) k.sign(wall, front * 0.3, front * 0.7, k.floor(1) - 0.75, k.floor(1) - 0.1);
  if (dice.chance(0.5))
    k.canopy(wall, axes[gate] - 2, axes[gate] + 2, k.floor(1) - 0.3, dice.length(1, 1.8));
  k.drainpipe(wall, front - 0.2, top);
  k.clutter(wall, 4);
}

}  // namespace jalon::grammar
