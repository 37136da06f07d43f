// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// What stands out from walls.
#include <algorithm>
#include <cmath>

#include "scan/grammar/sketch.h"

namespace jalon::grammar {

namespace {

constexpr double kBar_m = 0.02, kBarEvery_m = 0.13;  // of railings: a child's head stays out
constexpr double kRailing_m = 1.0;
constexpr const char* kDark = "dark";  // returns nothing: scan/surfaces.h

}  // namespace

void Sketch::band(size_t wall, const char* part_class, double v0, double v1, double proud_m) {
  PlannedWall& w = at(wall);
  const Rect box = bounds_of(w.outline);
  std::vector<std::pair<double, double>> taken;
  for (const PlannedOpening& o : w.openings) {
    const Rect b = bounds_of(contour_of(o.shape));
    const double aside = o.surround_m + 1e-6;
    if (b.v0 < v1 + aside && b.v1 > v0 - aside) taken.push_back({b.u0 - aside, b.u1 + aside});
  }
  std::sort(taken.begin(), taken.end());
  taken.push_back({box.u1, box.u1});
  double from = box.u0;
  for (const auto& [u0, u1] : taken) {
    if (u0 - from > 0.1) pad(wall, part_class, {from, u0, v0, v1}, 0, proud_m);
    from = std::max(from, u1);
  }
}

void Sketch::plinth(size_t wall) {
  band(wall, "base_course", 0, dice_.length(0.3, 0.9), dice_.between(0.02, 0.06));
}

void Sketch::cornice(size_t wall, double top_v) {
  const double height = dice_.length(0.2, 0.45);
  band(wall, "cornice", top_v - height, top_v, dice_.between(0.15, 0.5));
}

void Sketch::balcony(size_t wall, double u0, double u1, double v, double depth_m, bool is_solid) {
  const double y = at(wall).y_m, slab = 0.16;
  plan_.blocks.push_back(
      {"balcony", {u0, y - depth_m, v - slab}, {u1 - u0, depth_m - 0.001, slab}});
  if (is_solid) {
    const double t = 0.1;
    plan_.blocks.push_back({"balcony", {u0, y - depth_m, v}, {u1 - u0, t, kRailing_m}});
    for (const double u : {u0, u1 - t})
      plan_.blocks.push_back(
          {"balcony", {u, y - depth_m + t, v}, {t, depth_m - t - 0.001, kRailing_m}});
    return;
  }
  plan_.blocks.push_back({"railing", {u0, y - depth_m, v + kRailing_m}, {u1 - u0, 0.05, 0.04}});
  const int bars = std::max(2, static_cast<int>((u1 - u0) / kBarEvery_m));
  for (int i = 0; i <= bars; ++i)
    plan_.blocks.push_back({"railing",
                            {u0 + (u1 - u0 - kBar_m) * i / bars, y - depth_m + 0.015, v},
                            {kBar_m, kBar_m, kRailing_m}});
  for (const double u : {u0, u1 - 0.05})
    plan_.blocks.push_back(
        {"railing", {u, y - depth_m + 0.05, v + kRailing_m}, {0.05, depth_m - 0.051, 0.04}});
}

void Sketch::sign(size_t wall, double u0, double u1, double v0, double v1) {
  const bool is_dark = plan_.has_gaps && dice_.chance(0.5);
  pad(wall, is_dark ? kDark : "sign", {u0, u1, v0, v1}, 0, dice_.between(0.04, 0.15));
}

void Sketch::canopy(size_t wall, double u0, double u1, double v, double reach_m) {
  const bool is_dark = plan_.has_gaps && dice_.chance(0.5);
  const double fall = dice_.between(0.15, 0.6);
  const Vec3 out = normalized(Vec3{0, -reach_m, -fall});
  plan_.plates.push_back({is_dark ? kDark : "canopy",
                          {{u1, at(wall).y_m - 0.001, v}, {-1, 0, 0}, out},
                          {0, u1 - u0, 0, std::hypot(reach_m, fall)}});
}

void Sketch::quoins(size_t wall, double top_v) {
  constexpr double kStone_m = 0.35;
  const Rect box = bounds_of(at(wall).outline);
  const double proud = dice_.between(0.02, 0.05);
  bool is_long = true;
  for (double v = box.v0; v + kStone_m < top_v; v += kStone_m, is_long = !is_long) {
    const double width = is_long ? 0.45 : 0.28;
    pad(wall, "quoin", {box.u0, box.u0 + width, v + 0.01, v + kStone_m - 0.01}, 0, proud);
    pad(wall, "quoin", {box.u1 - width, box.u1, v + 0.01, v + kStone_m - 0.01}, 0, proud);
  }
}

bool Sketch::is_clear(const PlannedWall& wall, const Rect& rect) const {
  for (const PlannedOpening& o : wall.openings) {
    const Rect b = bounds_of(contour_of(o.shape));
    if (rect.u0 < b.u1 && b.u0 < rect.u1 && rect.v0 < b.v1 && b.v0 < rect.v1) return false;
  }
  return is_free_of_pads(wall, rect);
}

void Sketch::clutter(size_t wall, int most) {
  const PlannedWall& w = at(wall);
  const Rect box = bounds_of(w.outline);
  const int count = dice_.count(0, most);
  for (int i = 0; i < count; ++i) {
    const double u = dice_.between(box.u0, box.u1 - 1), y = w.y_m;
    struct Thing {
      const char* part_class;
      double width_m, out_m, height_m, low_m, high_m;  // the last two: of its foot
    };
    constexpr Thing kThings[] = {{"cooler", 0.8, 0.3, 0.6, 2.5, 8},
                                 {"lamp", 0.25, 0.3, 0.4, 2.4, 3.5},
                                 {"sign", 0.08, 0.7, 0.7, 2.5, 3.2},
                                 {"meter", 0.4, 0.12, 0.6, 0.8, 1.3},
                                 {"duct", 0.06, 0.05, 2.5, 0.2, 4}};
    const Thing& thing = kThings[static_cast<size_t>(dice_.count(0, 4))];
    const double v = dice_.between(thing.low_m, thing.high_m);
    const Rect rect{u, u + thing.width_m, v, v + thing.height_m};
    if (rect.v1 > box.v1 - 0.3 || !is_clear(w, rect)) continue;
    plan_.blocks.push_back({thing.part_class,
                            {u, y - thing.out_m - 0.002, v},
                            {thing.width_m, thing.out_m, thing.height_m}});
  }
}

void Sketch::drainpipe(size_t wall, double u, double top_v) {
  plan_.pipes.push_back(
      {{u, at(wall).y_m - dice_.between(0.08, 0.12), 0}, dice_.between(0.04, 0.06), top_v});
}

void Sketch::roof(double u0, double u1, double v, double y_m) {
  const double slope = dice_.between(0.45, 0.75), eave = dice_.between(0.15, 0.45);
  plan_.plates.push_back({"roof",
                          {{u0, y_m - eave, v - eave * std::tan(slope) + 0.15},
                           {1, 0, 0},
                           {0, std::cos(slope), std::sin(slope)}},
                          {0, u1 - u0, 0, 4}});
  plan_.blocks.push_back(
      {"gutter", {u0, y_m - eave - 0.12, v - eave * std::tan(slope) + 0.05}, {u1 - u0, 0.12, 0.1}});
}

void Sketch::joint(double u, double from_y_m, double to_y_m, double top_v) {
  const double from = std::min(from_y_m, to_y_m), depth = std::fabs(to_y_m - from_y_m);
  if (!(depth > 0)) return;
  // Looks along -X where the wall at the right stands forward.
  const bool looks_left = to_y_m < from_y_m;
  const Frame left{{u, from, 0}, {0, 0, 1}, {0, 1, 0}}, right{{u, from, 0}, {0, 1, 0}, {0, 0, 1}};
  plan_.plates.push_back({"return", looks_left ? left : right,
                          looks_left ? Rect{0, top_v, 0, depth} : Rect{0, depth, 0, top_v}});
}

}  // namespace jalon::grammar
