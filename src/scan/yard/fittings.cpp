// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "scan/yard/sheets.h"

namespace jalon::yard {

namespace {

constexpr double kFlat_m = 1e-6;                                   // shallower reveals are none
constexpr double kNearestBlind_m = 0.05, kFarthestBlind_m = 0.10;  // behind the pane
constexpr double kSlat_m = 0.01, kSlatEvery_m = 0.10;              // a tenth of the pane
constexpr double kNearestInside_m = 0.5, kFarthestInside_m = 4;
constexpr double kInsideShare = 0.85;  // of the pane's area that what is behind it shows

void add_reveals(Sheets& out, const Side& side, const Opening& o) {
  if (o.depth_m < kFlat_m) return;
  const uint32_t part = out.part("reveal", "reveal");
  const auto at = [&](double u, double v, double depth) { return side.wall.point(u, v, -depth); };
  const double low = o.hole_low_m(), d = o.depth_m;
  out.corners(part, kWall,
              {at(o.left_m, low, 0), at(o.left_m, o.low_m, d), at(o.left_m, o.high_m, d),
               at(o.left_m, o.high_m, 0)});
  out.corners(part, kWall,
              {at(o.right_m, o.high_m, 0), at(o.right_m, o.high_m, d), at(o.right_m, o.low_m, d),
               at(o.right_m, low, 0)});
  out.corners(part, kWall,
              {at(o.left_m, o.high_m, 0), at(o.left_m, o.high_m, d), at(o.right_m, o.high_m, d),
               at(o.right_m, o.high_m, 0)});
  out.corners(part, kWall,
              {at(o.left_m, low, 0), at(o.right_m, low, 0), at(o.right_m, o.low_m, d),
               at(o.left_m, o.low_m, d)});
}

// The inner sides of a frame, as far as the pane lets them be seen.
void add_rebate(Sheets& out, uint32_t part, PointClass c, const Frame& front, const Rect& light,
                double pane_behind_m) {
  const auto at = [&](double u, double v, double depth) { return front.point(u, v, -depth); };
  const double d = pane_behind_m;
  const auto side = [&](const Vec2& a, const Vec2& b) {
    out.corners(part, c, {at(a.u, a.v, 0), at(b.u, b.v, 0), at(b.u, b.v, d), at(a.u, a.v, d)});
  };
  side({light.u0, light.v0}, {light.u1, light.v0});
  side({light.u1, light.v0}, {light.u1, light.v1});
  side({light.u1, light.v1}, {light.u0, light.v1});
  side({light.u0, light.v1}, {light.u0, light.v0});
}

void add_blind(Sheets& out, const Frame& pane, const Rect& light, RandomStream& random) {
  const uint32_t part = out.part("blind", "blind");
  const Frame slats =
      pane.raised(-kNearestBlind_m - (kFarthestBlind_m - kNearestBlind_m) * random.uniform());
  for (double v = light.v0 + kSlatEvery_m / 2; v + kSlat_m < light.v1; v += kSlatEvery_m)
    out.rect(part, kRest, slats, {light.u0, light.u1, v, v + kSlat_m});
}

void add_inside(Sheets& out, const Frame& pane, const Rect& light, RandomStream& random) {
  const uint32_t part = out.part("inside", "inside");
  const Frame sheet =
      pane.raised(-kNearestInside_m - (kFarthestInside_m - kNearestInside_m) * random.uniform());
  const double aside = 0.5 * (random.uniform() - 0.5), height = kInsideShare * light.height();
  out.rect(part, kRest, sheet, {light.u0 + aside, light.u1 + aside, light.v0, light.v0 + height});
}

}  // namespace

void add_fittings(Sheets& out, const Side& side, const Opening& o, RandomStream random) {
  add_reveals(out, side, o);
  const PointClass c = o.is_door ? kDoor : kWindow;
  const Frame front = side.front_of(o), pane = front.raised(-o.pane_behind_m());
  const uint32_t fitting = o.is_door ? out.part("leaf", "door") : out.part("frame", "window");
  const std::vector<Rect> lights = o.lights();
  out.rect(fitting, c, front, {o.left_m, o.right_m, o.low_m, o.high_m}, lights);
  const uint32_t glass = out.part("glass", "glass", fitting);
  for (const Rect& light : lights) {
    add_rebate(out, fitting, c, front, light, o.pane_behind_m());
    out.rect(glass, c, pane, light);
    if (o.has_blind) add_blind(out, pane, light, random);
    add_inside(out, pane, light, random);
  }
}

}  // namespace jalon::yard
