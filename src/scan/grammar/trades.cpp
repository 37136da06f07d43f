// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Buildings of trades: brick mills, inns whose shutters stand open, parades of shops under awnings.
#include <algorithm>

#include "scan/grammar/sketch.h"

namespace jalon::grammar {

void plan_mill(Sketch& k) {
  Dice& dice = k.dice();
  const auto [front, floors] = k.sizes(14, 28, 3, 5);
  const double upper_m = dice.length(3.2, 3.9), ground_m = dice.length(3.6, 4.4);
  k.storeys(floors, ground_m, upper_m);
  const double top = k.eaves() + 0.7;
  const size_t wall = k.wall("wall 1", 0, jalon::contour_of({0, front, 0, top}));
  // 1. Broad windows under segmental arches, one a bay; a gateway in one of the bays.
  const std::vector<double> axes = k.axes_by(0.4, front - 0.4, 2.6, 3.6);
  const double pitch = axes.size() > 1 ? axes[1] - axes[0] : front - 0.8;
  WindowStyle s;
  s.form = Shape::Form::kArched;
  s.width_m = std::min(dice.length(1.4, 2.2), pitch - 0.9);
  s.height_m = dice.length(1.8, 2.4);
  s.rise_m = s.width_m * dice.between(0.08, 0.16);
  s.sill_m = dice.length(0.6, 0.9);
  s.depth_m = dice.between(0.12, 0.4);
  s.has_sill = dice.chance(0.6);
  s.mullions = dice.count(2, 4);
  s.transoms = dice.count(2, 5);
  s.curtains = 0;
  const auto gate = static_cast<size_t>(dice.count(0, static_cast<int>(axes.size()) - 1));
  PlannedOpening o;
  const double half = std::min(dice.length(2.4, 3.2), pitch - 0.6) / 2;
  o.shape = Shape::arched({axes[gate] - half, axes[gate] + half, 0, ground_m - 0.5}, 0.3 * half);
  o.opening_class = OpeningClass::kGateway;
  o.depth_m = dice.between(0.2, 0.5);
  o.filling.kind = Filling::Kind::kLeaf;
  o.filling.mullions = 1;
  k.open(wall, o);
  for (int storey = 0; storey < floors; ++storey) k.window_row(wall, s, axes, storey, 0.1);
  k.finish();
  // 2. Lesenes between the bays up to a frieze, strips at the floors.
  const double proud = dice.between(0.04, 0.12);
  for (size_t i = 0; i + 1 < axes.size(); ++i) {
    const double u = (axes[i] + axes[i + 1]) / 2;
    k.pad(wall, "pilaster", {u - 0.2, u + 0.2, 0, top - 0.5}, 0, proud);
  }
  k.pad(wall, "frieze", {0, front, top - 0.5, top}, 0, proud);
  if (dice.chance(0.5)) k.plinth(wall);
  k.drainpipe(wall, front - 0.2, top);
  k.clutter(wall, 3);
}

void plan_inn(Sketch& k) {
  Dice& dice = k.dice();
  const auto [front, floors] = k.sizes(9, 18, 2, 4);
  const double upper_m = dice.length(2.6, 3.1), ground_m = dice.length(2.8, 3.5);
  k.storeys(floors, ground_m, upper_m);
  const double eaves = k.eaves();
  const size_t wall = k.wall("wall 1", 0, jalon::contour_of({0, front, 0, eaves}));
  // 1. Every window has its shutters open beside it; those of the top storey are low.
  const std::vector<double> axes = k.axes_by(0.2, front - 0.2, 2.5, 3.2);
  WindowStyle s;
  s.width_m = dice.length(0.8, 1.1);
  s.height_m = dice.length(1.2, 1.7);
  s.sill_m = dice.length(0.7, 0.95);
  s.depth_m = dice.between(0.08, 0.3);
  s.has_shutters = true;
  s.has_sill = dice.chance(0.7);
  s.transoms = dice.count(0, 2);
  WindowStyle low = s;
  low.height_m = dice.length(0.7, 0.9);
  const auto entrance = static_cast<size_t>(dice.count(0, static_cast<int>(axes.size()) - 1));
  const double width = dice.length(1.1, 1.6);
  PlannedOpening o;
  o.shape = Shape::arched({axes[entrance] - width / 2, axes[entrance] + width / 2, 0, 2.35},
                          dice.between(0.1, 0.5) * width);
  o.opening_class = OpeningClass::kDoor;
  o.depth_m = dice.between(0.15, 0.4);
  o.surround_m = dice.chance(0.6) ? 0.16 : 0;
  o.filling.kind = Filling::Kind::kLeaf;
  k.open(wall, o);
  for (int storey = 0; storey < floors; ++storey)
    k.window_row(wall, storey + 1 == floors && floors > 2 ? low : s, axes, storey, 0.08);
  k.finish();
  // 2. A sign over the door, corner stones, a roof that stands out.
  k.sign(wall, axes[entrance] - 1.1, axes[entrance] + 1.1, 2.6, 2.6 + dice.length(0.3, 0.5));
  if (dice.chance(0.5)) k.quoins(wall, eaves);
  if (dice.chance(0.5)) k.plinth(wall);
  k.roof(0, front, eaves, 0);
  k.clutter(wall, 3);
}

void plan_parade(Sketch& k) {
  Dice& dice = k.dice();
  const auto [front, floors] = k.sizes(10, 22, 2, 4);
  const double upper_m = dice.length(2.7, 3.2), ground_m = dice.length(3.5, 4.2);
  k.storeys(floors, ground_m, upper_m);
  const double eaves = k.eaves() + dice.length(0.4, 0.9);
  const size_t wall = k.wall("wall 1", 0, jalon::contour_of({0, front, 0, eaves}));
  // 1. Glass from pier to pier on the ground, awnings over most of the shops.
  const std::vector<double> shops = k.axes_by(0.3, front - 0.3, 3.4, 4.8);
  const double pitch = shops.size() > 1 ? shops[1] - shops[0] : front - 0.6;
  const double half = (pitch - dice.length(0.3, 0.6)) / 2, height = dice.length(2.5, 2.9);
  const double depth = dice.between(0.06, 0.35), reach = dice.between(0.8, 1.6);
  for (const double u : shops) {
    k.shop_front(wall, u - half, u + half, height, depth);
    if (dice.chance(0.7)) k.canopy(wall, u - half, u + half, height + 0.2, reach);
  }
  // 2. Storeys: windows between thin fins.
  WindowStyle s;
  s.width_m = dice.length(0.9, 1.4);
  s.height_m = dice.length(1.3, 1.8);
  s.sill_m = dice.length(0.7, 0.9);
  s.depth_m = dice.between(0.08, 0.25);
  s.has_sill = dice.chance(0.5);
  s.mullions = dice.count(0, 2);
  s.blinds = 0.3;
  const std::vector<double> axes = k.axes_by(0.2, front - 0.2, 1.9, 2.6);
  for (int storey = 1; storey < floors; ++storey) k.window_row(wall, s, axes, storey, 0.05);
  k.finish();
  const double proud = dice.between(0.05, 0.2), fin_m = dice.length(0.06, 0.12, 0.02);
  for (size_t i = 0; i + 1 < axes.size(); ++i) {
    const double u = (axes[i] + axes[i + 1]) / 2;
    k.pad(wall, "fin", {u - fin_m / 2, u + fin_m / 2, ground_m + 0.1, eaves - 0.2}, 0, proud);
  }
  k.sign(wall, 0.4, front - 0.4, height + 0.35, ground_m - 0.15);
  k.clutter(wall, 3);
}

}  // namespace jalon::grammar
