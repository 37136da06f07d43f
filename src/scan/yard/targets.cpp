// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "scan/yard/plan.h"

namespace jalon::yard {

namespace {

constexpr double kPaper_m = 0.002;   // a target before what it sticks on
constexpr double kFarthest_m = 0.6;  // of a listed target from its wall, in plan
constexpr double kInLight_m = 0.06;  // of a target's middle from the edge of its pane
constexpr int kWindowCode = 3;

struct ListedTarget {
  int code, id;
  double x, y, z;
};
// Those with a code, in the list's order: the two of a facade's windows follow one another.
constexpr ListedTarget kListed[] = {
    {3, 101, 89.518, 124.272, 248.210}, {3, 102, 109.277, 105.158, 248.042},
    {3, 105, 65.187, 75.448, 248.133},  {3, 106, 45.447, 94.539, 248.161},
    {3, 107, 75.320, 82.318, 248.075},  {3, 108, 94.400, 101.980, 248.014},
    {1, 109, 96.039, 103.381, 247.047}, {2, 112, 102.709, 111.406, 247.135},
    {2, 114, 92.549, 106.714, 247.326}, {2, 115, 90.872, 108.319, 247.343},
    {1, 116, 89.160, 110.141, 247.055}, {2, 119, 95.946, 117.969, 247.276},
    {1, 120, 88.618, 124.825, 247.117}, {3, 122, 77.423, 119.634, 248.056},
    {3, 123, 57.685, 99.168, 248.091},  {1, 124, 78.485, 120.369, 247.044},
    {3, 125, 88.449, 109.191, 248.134}, {2, 129, 82.179, 102.859, 247.315},
    {2, 132, 49.842, 90.392, 247.272},  {3, 133, 68.621, 88.750, 248.122},
    {4, 134, 57.249, 83.411, 247.967},  {4, 135, 61.644, 79.167, 247.796},
    {1, 136, 67.668, 88.061, 246.970},  {4, 137, 52.858, 87.645, 248.005},
    {1, 142, 74.551, 81.310, 247.092},  {2, 144, 62.735, 71.481, 247.483},
    {2, 145, 71.183, 84.735, 247.150},  {1, 146, 65.959, 74.777, 246.993},
    {1, 148, 44.242, 95.844, 246.990},  {4, 149, 66.053, 74.913, 247.693}};

struct OnSide {
  const Side* side = nullptr;
  double u_m = 0;
};

bool has_opening_at(const Side& side, double u, bool is_door) {
  return std::any_of(side.openings.begin(), side.openings.end(), [&](const Opening& o) {
    return o.is_door == is_door && u > o.left_m && u < o.right_m;
  });
}

// A target at a corner lies near two walls: the code of a door or window tells which.
OnSide side_of(const Plan& plan, const ListedTarget& t) {
  OnSide found;
  double nearest = kFarthest_m;
  for (const Side& side : plan.sides) {
    const Vec3 d = Vec3{t.x, t.y, 0} - Vec3{side.wall.origin.x, side.wall.origin.y, 0};
    const double u = dot(d, side.wall.u), off = std::fabs(dot(d, side.wall.normal()));
    const bool is_opening = t.code == 2 || t.code == kWindowCode;
    if (u < -0.1 || u > side.length_m + 0.1 || off >= nearest) continue;
    if (is_opening && !has_opening_at(side, u, t.code == 2)) continue;
    nearest = off;
    found = {&side, u};
  }
  return found;
}

const Opening& opening_at(const Side& side, double u, bool is_door) {
  return *std::find_if(side.openings.begin(), side.openings.end(), [&](const Opening& o) {
    return o.is_door == is_door && u > o.left_m && u < o.right_m;
  });
}

void put(Target& target, const Frame& frame, double u, double v) {
  target.has_patch = true;
  target.frame = frame;
  target.u_m = u;
  target.v_m = v;
  target.place = frame.point(u, v);
}

void put_on_wall(Target& target, const Side& side, double u, double v) {
  put(target, target_sheet(side), std::clamp(u, kInLight_m, side.length_m - kInLight_m), v);
}

void put_on_pane(Target& target, const Side& side, const Opening& o, double u, double v) {
  const std::vector<Rect> lights = o.lights();
  const auto nearest =
      std::min_element(lights.begin(), lights.end(), [&](const Rect& a, const Rect& b) {
        return std::fabs(u - (a.u0 + a.u1) / 2) < std::fabs(u - (b.u0 + b.u1) / 2);
      });
  put(target, side.front_of(o).raised(kPaper_m - o.pane_behind_m()),
      std::clamp(u, nearest->u0 + kInLight_m, nearest->u1 - kInLight_m),
      std::clamp(v, nearest->v0 + kInLight_m, nearest->v1 - kInLight_m));
}

// At the lower outer corner of the first window and the upper one of the last, on their frames.
void put_on_corner(Target& target, const Side& side, double u) {
  const Opening *first = nullptr, *last = nullptr;
  for (const Opening& o : side.openings) {
    if (o.is_door) continue;
    if (first == nullptr || o.left_m < first->left_m) first = &o;
    if (last == nullptr || o.right_m > last->right_m) last = &o;
  }
  const bool at_left = u < side.length_m / 2;
  const Opening& o = at_left ? *first : *last;
  put(target, side.front_of(o).raised(kPaper_m),
      at_left ? o.left_m + kTargetHalf_m : o.right_m - kTargetHalf_m,
      at_left ? o.low_m + kTargetHalf_m : o.high_m - kTargetHalf_m);
}

bool put_on_gutter(Target& target, const Plan& plan, const ListedTarget& t) {
  for (const Gutter& g : plan.gutters) {
    if (norm(Vec2{t.x, t.y} - g.centre) > kFarthest_m) continue;
    const Vec2 at = g.centre + g.outward * kGutterRadius_m;
    target.place = {at.u, at.v, t.z};
    return true;
  }
  return false;
}

}  // namespace

void add_targets(const YardSettings& settings, Plan& plan) {
  bool is_missing = settings.missing_target;
  for (const ListedTarget& t : kListed) {
    Target target{t.id, t.code, {}, false, {}, 0, 0};
    if (t.code == 4) {
      if (put_on_gutter(target, plan, t)) plan.targets.push_back(target);
      continue;
    }
    const OnSide at = side_of(plan, t);
    if (at.side == nullptr) continue;
    if (t.code == 1) put_on_wall(target, *at.side, at.u_m, t.z);
    else if (t.code == 2)
      put_on_pane(target, *at.side, opening_at(*at.side, at.u_m, true), at.u_m, t.z);
    else if (settings.corner_targets) put_on_corner(target, *at.side, at.u_m);
    else put_on_pane(target, *at.side, opening_at(*at.side, at.u_m, false), at.u_m, t.z);
    if (t.code == 2 && std::exchange(is_missing, false)) continue;
    plan.targets.push_back(target);
  }
}

}  // namespace jalon::yard
