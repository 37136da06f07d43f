// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Houses that no street ranks: half-timbered ones and villas.
#include <algorithm>

#include "scan/grammar/sketch.h"

namespace jalon::grammar {

namespace {

/// Sides of bays, the last one at the end: no two of one width.
std::vector<double> uneven_bays(Dice& dice, double end, double least_m, double most_m) {
  std::vector<double> out{0};
  while (end - out.back() > most_m + least_m)
    out.push_back(out.back() + dice.length(least_m, most_m));
  if (end - out.back() > 2 * least_m) out.push_back((out.back() + end) / 2);
  out.push_back(end);
  return out;
}

/// Rails, posts and braces of a storey between two levels.
void timber(Sketch& k, size_t wall, const std::vector<double>& bays, double v0, double v1,
            double proud_m) {
  constexpr double kBeam_m = 0.2, kHalf_m = kBeam_m / 2;
  k.band(wall, "timber", v0, v0 + kBeam_m, proud_m);
  k.band(wall, "timber", v1 - kBeam_m, v1, proud_m);
  const double low = v0 + kBeam_m, high = v1 - kBeam_m;
  for (size_t i = 0; i < bays.size(); ++i) {
    const double u = std::clamp(bays[i], bays.front() + kHalf_m, bays.back() - kHalf_m);
    k.pad(wall, "timber", {u - kHalf_m, u + kHalf_m, low, high}, 0, proud_m);
    if (i + 1 < bays.size() && k.dice().chance(0.4))
      k.brace(wall, {bays[i] + kHalf_m, low}, {bays[i + 1] - kHalf_m, high}, kBeam_m, proud_m);
  }
}

}  // namespace

void plan_timbered(Sketch& k) {
  Dice& dice = k.dice();
  const auto [front, floors] = k.sizes(6, 14, 2, 4);
  const double upper_m = dice.length(2.4, 2.8), ground_m = dice.length(2.6, 3.2);
  k.storeys(floors, ground_m, upper_m);
  const double jetty = dice.chance(0.6) ? dice.length(0.1, 0.35) : 0,
               proud = dice.between(0.015, 0.04);
  const bool has_gable = front < 11 && dice.chance(0.6);
  // 1. Each storey stands out over the one below, on a beam.
  for (int storey = 0; storey < floors; ++storey) {
    const double y = -jetty * storey, v0 = k.floor(storey), v1 = k.floor(storey + 1);
    Contour outline{{{0, v0}}, {{front, v0}}, {{front, v1}}, {{0, v1}}};
    if (has_gable && storey + 1 == floors)
      outline.insert(outline.begin() + 3, {{{front / 2, v1 + front * dice.between(0.45, 0.6)}}});
    const size_t wall = k.wall("storey " + std::to_string(storey + 1), y, outline);
    if (storey > 0 && jetty > 0)
      k.plan().blocks.push_back({"soffit", {0, y, v0 - 0.15}, {front, jetty - 0.001, 0.15}});
    // 2. A window or two in some bays, a door on the ground.
    const std::vector<double> bays = uneven_bays(dice, front, 0.9, 2.2);
    const auto door = static_cast<size_t>(dice.count(0, static_cast<int>(bays.size()) - 2));
    WindowStyle s;
    s.height_m = dice.length(0.9, 1.3);
    s.sill_m = dice.length(0.7, 0.95);
    s.depth_m = dice.between(0.04, 0.14);
    s.has_shutters = dice.chance(0.2);
    for (size_t i = 0; i + 1 < bays.size(); ++i) {
      const double clear = bays[i + 1] - bays[i] - 0.3, middle = (bays[i] + bays[i + 1]) / 2;
      if (storey == 0 && i == door) {
        k.door(wall, middle, std::min(1.1, clear), 2.1, dice.between(0.08, 0.25));
        continue;
      }
      s.width_m = std::min(clear, dice.length(0.6, 1.3));
      s.mullions = s.width_m > 0.9 ? 2 : 1;
      s.transoms = dice.count(0, 2);
      if (dice.chance(0.7)) k.window(wall, s, middle, storey);
    }
    if (has_gable && storey + 1 == floors) {
      WindowStyle small = s;
      small.width_m = 0.6;
      small.height_m = 0.7;
      small.sill_m = v1 - v0 + 0.5;
      small.has_shutters = false;
      for (const double u : {front / 2 - 0.55, front / 2 + 0.55}) k.window(wall, small, u, storey);
    }
    k.finish(wall);
    if (storey > 0 || dice.chance(0.3)) timber(k, wall, bays, v0, v1, proud);
    else k.plinth(wall);
  }
  if (!has_gable) k.roof(0, front, k.eaves(), -jetty * (floors - 1));
}

void plan_villa(Sketch& k) {
  Dice& dice = k.dice();
  const auto [front, floors] = k.sizes(9, 16, 2, 3);
  const double upper_m = dice.length(2.7, 3.2), ground_m = dice.length(3.0, 3.6);
  k.storeys(floors, ground_m, upper_m);
  const double eaves = k.eaves(), split = front * dice.between(0.3, 0.5);
  // 1. A gabled part stands forward beside a plain one; a bay window before one of them.
  const double gable_rise = split * dice.between(0.35, 0.6), forward = -dice.length(0.5, 1.6);
  const size_t gabled = k.wall(
      "gabled part", forward,
      {{{0, 0}}, {{split, 0}}, {{split, eaves}}, {{split / 2, eaves + gable_rise}}, {{0, eaves}}});
  const double half = std::min(dice.length(1.2, 1.7), (front - split) / 2 - 0.5);
  const double bay_u = split + (front - split) * dice.between(0.4, 0.6),
               reach = dice.length(0.6, 1.2);
  const bool has_bay = half > 0.7;
  const double bay_top = k.floor(1) - 0.1;
  Contour plain{{{split, 0}}, {{front, 0}}, {{front, eaves}}, {{split, eaves}}};
  if (has_bay)
    plain = {{{split, 0}},
             {{bay_u - half, 0}},
             {{bay_u - half, bay_top}},
             {{bay_u + half, bay_top}},
             {{bay_u + half, 0}},
             {{front, 0}},
             {{front, eaves}},
             {{split, eaves}}};
  const size_t wall = k.wall("plain part", 0, plain);
  k.joint(split, forward, 0, eaves);
  // 2. Windows with their shutters open beside them, of different widths.
  WindowStyle s;
  s.width_m = dice.length(0.8, 1.2);
  s.height_m = dice.length(1.3, 1.7);
  s.depth_m = dice.between(0.1, 0.25);
  s.has_shutters = true;
  s.has_sill = true;
  s.transoms = dice.count(0, 3);
  WindowStyle triple = s;
  triple.width_m = std::min(dice.length(1.8, 2.4), split - 0.6);
  triple.mullions = 2;
  triple.has_shutters = false;
  triple.surround_m = 0.14;
  for (int storey = 0; storey < floors; ++storey) {
    if (dice.chance(0.5)) k.window(gabled, triple, split / 2, storey);
    else k.window_row(gabled, s, k.axes_by(0.2, split - 0.2, 2.2, 3), storey);
  }
  PlannedOpening oculus;
  oculus.shape =
      Shape::round({split / 2, eaves + gable_rise * 0.4}, std::min(0.4, gable_rise * 0.25));
  oculus.storey = floors;
  oculus.filling.mullions = 1;
  oculus.filling.transoms = 1;
  k.open(gabled, oculus);
  const double door_u = bay_u < (split + front) / 2 ? front - 0.9 : split + 0.9;
  k.door(wall, door_u, dice.length(0.9, 1.1), dice.length(2.1, 2.3), dice.between(0.1, 0.3));
  for (int storey = 1; storey < floors; ++storey)
    k.window_row(wall, s, k.axes_by(split + 0.2, front - 0.2, 2.4, 3.2), storey);
  if (!has_bay) k.window(wall, s, (split + front) / 2, 0);
  // 3. The bay window: a front, two sides, a lid.
  if (has_bay) {
    const size_t bay =
        k.wall("bay window", -reach, jalon::contour_of({bay_u - half, bay_u + half, 0, bay_top}));
    WindowStyle own = s;
    own.width_m = half * 0.75;
    own.height_m = bay_top - 1.3;
    own.sill_m = 0.8;
    own.has_shutters = false;
    for (const double side : {-0.48, 0.48}) k.window(bay, own, bay_u + side * half, 0);
    k.joint(bay_u - half, 0, -reach, bay_top);
    k.joint(bay_u + half, -reach, 0, bay_top);
    k.plan().blocks.push_back({"lid",
                               {bay_u - half - 0.1, -reach - 0.1, bay_top + 0.001},
                               {2 * half + 0.2, reach + 0.099, 0.08}});
  }
  k.finish();
  if (dice.chance(0.5)) k.canopy(wall, door_u - 0.8, door_u + 0.8, 2.7, dice.length(0.6, 1));
  if (dice.chance(0.5)) k.quoins(gabled, eaves - 0.3);
  if (dice.chance(0.5)) k.plinth(wall);
  k.roof(split, front, eaves, 0);
  k.clutter(wall, 2);
}

}  // namespace jalon::grammar
