// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/yard/plan.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/polygon2.h"

namespace jalon::yard {

namespace {

constexpr double kWallBehindEaves_m = 0.10;  // building A: its outline is the edge of its roof
constexpr double kLeastDepth_m = 0.01;
constexpr double kHalfOpen_rad = 15 * 0.017453292519943295;
constexpr double kTwoLights_m = 0.8;  // wider windows have a mullion
constexpr double kDoorPane = 0.632;   // of width and height of a leaf: 40 % of its area
constexpr uint64_t kPlanStream = 1;

// Of the outlines, in the order of the survey; low and upper heights.
constexpr size_t kMostCorners = 12;
struct BuildingRow {
  char name;
  int sequence;
  size_t corners;
  double low_m, top_m;
  std::array<Vec2, kMostCorners> outline;
};
constexpr BuildingRow kBuildings[] = {
    {'A',
     300,
     4,
     246.706,
     249.57,
     {{{43.987, 96.234}, {37.294, 89.327}, {59.445, 67.931}, {66.151, 74.830}}}},
    {'B',
     300,
     4,
     246.728,
     249.743,
     {{{74.599, 81.248}, {67.622, 87.996}, {89.098, 110.162}, {96.096, 103.448}}}},
    {'C',
     301,
     12,
     246.706,
     249.767,
     {{{45.254, 126.516},
       {52.239, 119.795},
       {56.471, 124.218},
       {62.828, 118.145},
       {50.100, 104.951},
       {57.074, 98.226},
       {78.528, 120.408},
       {71.570, 127.164},
       {67.312, 122.758},
       {60.926, 128.876},
       {73.608, 142.065},
       {66.629, 148.777}}}},
    {'D',
     302,
     4,
     246.778,
     249.747,
     {{{88.556, 124.882}, {95.265, 131.896}, {117.501, 110.425}, {110.793, 103.458}}}}};

Building building_of(const BuildingRow& row) {
  Building building{row.name, row.sequence, {}, row.low_m, row.top_m};
  for (size_t k = 0; k < row.corners; ++k) building.outline.push_back(row.outline[k]);
  return building;
}

// Sides are counted through all buildings, each from its corner to the next of the outline: of each opening the side,
// whether it is a door, the number of its first surveyed point, where it begins and ends along the side, its heights,
// and how far its frame lies behind the outline.
struct PlanRow {
  size_t side;
  bool is_door;
  int id;
  double from_m, to_m, low_m, high_m, depth_m;
};
constexpr PlanRow kOpenings[] = {{0, false, 122, 4.59, 5.06, 248.62, 249.21, 0.17},
                                 {1, false, 125, 0.68, 2.66, 247.69, 248.86, 0.20},
                                 {1, false, 128, 3.67, 5.71, 247.70, 248.88, 0.19},
                                 {1, false, 131, 6.82, 8.76, 247.70, 248.89, 0.21},
                                 {1, true, 134, 9.52, 10.43, 246.83, 248.87, 0.11},
                                 {1, false, 728, 11.54, 12.05, 248.64, 249.21, 0.18},
                                 {1, false, 136, 13.01, 13.49, 248.62, 249.21, 0.18},
                                 {1, false, 139, 14.28, 14.75, 248.63, 249.22, 0.18},
                                 {1, false, 142, 15.98, 17.92, 247.72, 248.91, 0.21},
                                 {1, false, 145, 18.98, 20.97, 247.72, 248.91, 0.20},
                                 {1, false, 149, 22.03, 24.02, 247.71, 248.90, 0.20},
                                 {1, false, 725, 25.10, 27.07, 247.73, 248.90, 0.20},
                                 {1, false, 722, 28.14, 30.13, 247.73, 248.90, 0.20},
                                 {2, true, 720, 4.37, 5.31, 246.83, 248.91, 0.11},
                                 {3, false, 276, 0.69, 2.68, 247.72, 248.88, 0.19},
                                 {3, false, 279, 3.73, 5.74, 247.71, 248.90, 0.18},
                                 {3, false, 282, 6.78, 8.78, 247.72, 248.89, 0.19},
                                 {3, false, 285, 9.84, 11.82, 247.72, 248.88, 0.19},
                                 {3, false, 288, 12.89, 14.87, 247.73, 248.89, 0.19},
                                 {3, false, 290, 15.95, 17.93, 247.73, 248.89, 0.19},
                                 {3, false, 292, 19.01, 20.99, 247.72, 248.89, 0.23},
                                 {3, true, 295, 22.09, 23.99, 246.85, 248.87, 0.12},
                                 {3, false, 297, 25.06, 27.09, 247.73, 248.90, 0.17},
                                 {3, false, 300, 28.21, 30.13, 247.71, 248.88, 0.21},
                                 {4, true, 303, 4.40, 5.31, 246.83, 248.88, 0.11},
                                 {5, false, 220, 0.68, 2.67, 247.73, 248.90, 0.16},
                                 {5, false, 224, 3.74, 5.73, 247.73, 248.91, 0.17},
                                 {5, false, 228, 6.79, 8.80, 247.73, 248.88, 0.17},
                                 {5, false, 232, 9.84, 11.85, 247.73, 248.91, 0.16},
                                 {5, false, 236, 12.90, 13.41, 248.33, 248.90, 0.18},
                                 {5, false, 240, 14.41, 14.92, 248.32, 248.89, 0.17},
                                 {5, false, 244, 15.97, 16.48, 248.32, 248.90, 0.17},
                                 {5, false, 400, 17.52, 18.02, 248.34, 248.93, 0.17},
                                 {5, true, 404, 20.26, 21.25, 246.80, 248.93, 0.12},
                                 {5, false, 407, 22.10, 24.11, 247.74, 248.91, 0.17},
                                 {5, false, 411, 25.16, 27.16, 247.74, 248.91, 0.17},
                                 {5, false, 415, 28.21, 30.22, 247.74, 248.92, 0.17},
                                 {6, true, 419, 1.08, 3.06, 246.81, 248.91, 0.10},
                                 {6, true, 422, 4.37, 5.32, 246.82, 248.92, 0.11},
                                 {7, false, 666, 0.69, 2.70, 247.74, 248.91, 0.18},
                                 {7, false, 670, 3.71, 5.73, 247.73, 248.91, 0.17},
                                 {7, false, 674, 6.78, 8.79, 247.74, 248.91, 0.17},
                                 {7, false, 678, 9.84, 11.85, 247.74, 248.91, 0.17},
                                 {7, false, 682, 12.90, 14.90, 247.71, 248.91, 0.17},
                                 {7, false, 686, 15.95, 17.96, 247.74, 248.91, 0.18},
                                 {7, false, 690, 19.02, 21.04, 247.74, 248.91, 0.18},
                                 {7, false, 694, 22.06, 24.05, 247.74, 248.91, 0.18},
                                 {7, false, 698, 25.13, 27.07, 247.74, 248.89, 0.18},
                                 {7, false, 702, 28.17, 30.21, 247.73, 248.91, 0.18},
                                 {8, false, 154, 4.62, 5.06, 248.36, 248.92, 0.18},
                                 {9, false, 184, 0.70, 2.70, 247.76, 248.95, 0.20},
                                 {10, false, 178, 0.64, 2.64, 247.77, 248.94, 0.18},
                                 {10, true, 187, 3.42, 4.40, 246.85, 248.94, 0.14},
                                 {10, true, 189, 4.41, 5.40, 246.85, 248.93, 0.15},
                                 {10, false, 175, 6.20, 8.19, 247.75, 248.94, 0.28},
                                 {11, false, 172, 0.37, 2.39, 247.76, 248.94, 0.22},
                                 {11, false, 169, 3.43, 5.43, 247.77, 248.94, 0.22},
                                 {11, false, 167, 6.49, 8.47, 247.75, 248.94, 0.23},
                                 {11, false, 164, 9.53, 11.52, 247.76, 248.94, 0.22},
                                 {11, false, 161, 12.58, 14.59, 247.76, 248.94, 0.23},
                                 {11, false, 158, 15.62, 17.63, 247.75, 248.94, 0.23},
                                 {12, true, 152, 4.42, 5.42, 246.85, 248.90, 0.12},
                                 {13, false, 202, 0.70, 2.68, 247.77, 248.94, 0.21},
                                 {13, false, 205, 3.72, 5.72, 247.78, 248.94, 0.17},
                                 {13, false, 208, 6.81, 8.79, 247.78, 248.94, 0.19},
                                 {13, false, 211, 9.83, 11.84, 247.75, 248.94, 0.18},
                                 {13, false, 214, 12.96, 14.90, 247.75, 248.93, 0.20},
                                 {13, false, 217, 16.00, 17.95, 247.75, 248.93, 0.20},
                                 {13, false, 425, 19.02, 21.03, 247.76, 248.93, 0.19},
                                 {13, false, 428, 22.08, 24.09, 247.79, 248.94, 0.20},
                                 {13, false, 431, 25.13, 27.12, 247.78, 248.95, 0.21},
                                 {13, false, 434, 28.19, 30.19, 247.78, 248.95, 0.20},
                                 {14, true, 506, 7.61, 8.61, 246.85, 248.93, 0.13},
                                 {15, false, 509, 0.73, 2.70, 247.75, 248.94, 0.20},
                                 {15, false, 512, 3.76, 5.75, 247.75, 248.94, 0.21},
                                 {16, true, 515, 0.66, 2.64, 246.85, 248.93, 0.09},
                                 {16, true, 517, 3.45, 5.43, 246.84, 248.92, 0.14},
                                 {16, true, 519, 6.21, 8.21, 246.85, 248.93, 0.15},
                                 {17, false, 522, 0.35, 2.34, 247.76, 248.93, 0.20},
                                 {17, false, 525, 3.39, 5.39, 247.78, 248.94, 0.20},
                                 {17, false, 528, 6.45, 8.46, 247.77, 248.95, 0.20},
                                 {17, false, 456, 9.50, 11.48, 247.76, 248.94, 0.20},
                                 {17, false, 458, 12.56, 14.54, 247.76, 248.93, 0.17},
                                 {17, false, 531, 15.61, 17.60, 247.75, 248.94, 0.19},
                                 {18, true, 553, 4.33, 5.34, 246.71, 248.92, 0.14},
                                 {19, false, 592, 0.71, 2.72, 247.76, 248.93, 0.20},
                                 {19, false, 589, 6.80, 8.81, 247.77, 248.92, 0.19},
                                 {19, false, 586, 9.86, 11.85, 247.77, 248.92, 0.18},
                                 {19, false, 583, 12.92, 14.91, 247.77, 248.94, 0.19},
                                 {19, false, 580, 15.96, 17.97, 247.76, 248.93, 0.18},
                                 {19, false, 578, 19.04, 21.01, 247.75, 248.93, 0.17},
                                 {19, false, 576, 22.07, 24.05, 247.75, 248.93, 0.18},
                                 {19, false, 573, 25.10, 27.10, 247.76, 248.93, 0.18},
                                 {19, false, 570, 28.16, 30.15, 247.77, 248.92, 0.19},
                                 {20, true, 504, 1.13, 2.11, 246.81, 248.90, 0.11},
                                 {21, false, 556, 3.72, 5.75, 247.74, 248.91, 0.16},
                                 {21, false, 560, 6.80, 8.82, 247.74, 248.90, 0.15},
                                 {21, false, 564, 9.82, 11.87, 247.74, 248.89, 0.13},
                                 {21, false, 625, 12.94, 14.96, 247.74, 248.90, 0.14},
                                 {21, false, 621, 16.00, 18.00, 247.73, 248.89, 0.15},
                                 {21, false, 617, 19.06, 21.07, 247.74, 248.90, 0.16},
                                 {21, false, 613, 22.11, 24.13, 247.74, 248.91, 0.16},
                                 {21, false, 609, 25.17, 27.18, 247.75, 248.92, 0.17},
                                 {21, false, 605, 28.23, 30.24, 247.74, 248.91, 0.17},
                                 {22, true, 602, 4.35, 5.35, 246.82, 248.93, 0.11},
                                 {23, false, 662, 0.68, 2.68, 247.75, 248.92, 0.15},
                                 {23, false, 658, 3.74, 5.74, 247.74, 248.91, 0.15},
                                 {23, false, 654, 6.79, 8.79, 247.74, 248.91, 0.16},
                                 {23, true, 651, 9.85, 11.85, 246.82, 248.91, 0.11},
                                 {23, false, 452, 12.91, 13.42, 248.34, 248.94, 0.16},
                                 {23, false, 448, 14.43, 14.93, 248.34, 248.94, 0.17},
                                 {23, false, 444, 15.97, 16.46, 248.34, 248.93, 0.18},
                                 {23, false, 440, 17.48, 17.97, 248.34, 248.92, 0.19},
                                 {23, true, 437, 20.25, 21.25, 246.82, 248.93, 0.13},
                                 {23, false, 252, 22.07, 24.04, 247.74, 248.90, 0.19},
                                 {23, false, 250, 25.12, 27.11, 247.74, 248.89, 0.19},
                                 {23, false, 248, 28.17, 30.16, 247.74, 248.90, 0.18}};

constexpr std::array<Vec2, 6> kGutters = {{{66.017, 74.880},
                                           {61.628, 79.102},
                                           {57.223, 83.405},
                                           {52.829, 87.632},
                                           {48.463, 91.871},
                                           {44.070, 96.126}}};

// The facades about the yard: the long one and a gable of A, one each of C and D.
bool is_built(YardZone zone, char building, size_t side_of_building) {
  if (zone == YardZone::kAll) return true;
  if (zone == YardZone::kComplete) return building == 'B';
  return (building == 'A' && side_of_building >= 2) || (building == 'C' && side_of_building == 5) ||
         (building == 'D' && side_of_building == 3);
}

// Outlines run either way; a wall is seen from outside.
Side side_between(const Building& building, size_t k, bool& is_turned) {
  const Vec2 a = building.outline[k], b = building.outline[(k + 1) % building.outline.size()];
  is_turned = signed_area(building.outline) < 0;
  const Vec2 from = is_turned ? b : a, along = (is_turned ? a - b : b - a) * (1 / norm(b - a));
  Side side;
  side.building = building.name;
  side.wall = {{from.u, from.v, 0}, {along.u, along.v, 0}, {0, 0, 1}};
  side.length_m = norm(b - a);
  side.top_m = building.top_m;
  return side;
}

Opening opening_of(const PlanRow& row, const Side& side, bool is_turned) {
  Opening o;
  o.is_door = row.is_door;
  o.id = row.id;
  o.left_m = is_turned ? side.length_m - row.to_m : row.from_m;
  o.right_m = is_turned ? side.length_m - row.from_m : row.to_m;
  o.low_m = row.low_m;
  o.high_m = row.high_m;
  o.depth_m = row.depth_m;
  return o;
}

void set_back(Side& side, bool has_flush_doors) {
  side.wall = side.wall.raised(-kWallBehindEaves_m);
  side.wall.origin += side.wall.u * kWallBehindEaves_m;
  side.length_m -= 2 * kWallBehindEaves_m;
  for (Opening& o : side.openings) {
    o.left_m -= kWallBehindEaves_m;
    o.right_m -= kWallBehindEaves_m;
    o.depth_m =
        o.is_door && has_flush_doors ? 0 : std::max(kLeastDepth_m, o.depth_m - kWallBehindEaves_m);
  }
}

// Windows that carry a target stay shut.
void open_and_shade(Plan& plan, uint64_t seed) {
  constexpr int kHalfOpen = 2, kBlindEvery = 3;
  RandomStream random(seed, kPlanStream);
  std::vector<Opening*> windows;
  for (Side& side : plan.sides)
    for (Opening& o : side.openings) {
      if (o.is_door) continue;
      o.has_blind = random.below(kBlindEvery) == 0;
      const bool has_target =
          std::any_of(plan.targets.begin(), plan.targets.end(), [&](const Target& t) {
            const double s = dot(t.place - side.wall.origin, side.wall.u);
            const double off = dot(t.place - side.wall.origin, side.wall.normal());
            return std::fabs(off) < 0.5 && s > o.left_m - 0.5 && s < o.right_m + 0.5;
          });
      if (!has_target) windows.push_back(&o);
    }
  for (int k = 0; k < kHalfOpen && !windows.empty(); ++k) {
    const size_t at = random.below(windows.size());
    windows[at]->is_half_open = true;
    windows.erase(windows.begin() + static_cast<std::ptrdiff_t>(at));
  }
}

}  // namespace

std::vector<Rect> Opening::lights() const {
  if (is_door) {
    const double u = (left_m + right_m) / 2, v = (low_m + high_m) / 2;
    const double du = kDoorPane * (right_m - left_m) / 2, dv = kDoorPane * (high_m - low_m) / 2;
    return {{u - du, u + du, v - dv, v + dv}};
  }
  const Rect inner{left_m + kFrameWidth_m, right_m - kFrameWidth_m, low_m + kFrameWidth_m,
                   high_m - kFrameWidth_m};
  if (right_m - left_m < kTwoLights_m) return {inner};
  const double middle = (left_m + right_m) / 2, half = kFrameWidth_m / 2;
  return {{inner.u0, middle - half, inner.v0, inner.v1},
          {middle + half, inner.u1, inner.v0, inner.v1}};
}

Frame Side::front_of(const Opening& opening) const {
  const Frame front = wall.raised(-opening.depth_m);
  if (!opening.is_half_open) return front;
  const Vec3 along = front.u * std::cos(kHalfOpen_rad) - front.normal() * std::sin(kHalfOpen_rad);
  return {front.point(opening.left_m, 0) - along * opening.left_m, along, front.v};
}

Plan plan_of(const YardSettings& settings, uint64_t seed) {
  Plan plan;
  size_t number = 0;
  for (const BuildingRow& row_of_building : kBuildings) {
    const Building building = building_of(row_of_building);
    bool is_seen = false;
    for (size_t k = 0; k < building.outline.size(); ++k, ++number) {
      if (!is_built(settings.zone, building.name, k)) continue;
      is_seen = true;
      bool is_turned = false;
      Side side = side_between(building, k, is_turned);
      for (const PlanRow& row : kOpenings)
        if (row.side == number) side.openings.push_back(opening_of(row, side, is_turned));
      if (building.name == 'A') set_back(side, settings.flush_doors);
      const bool has_gutters = building.name == 'A' && k == 3;
      for (const Vec2& centre : kGutters)
        if (has_gutters)
          plan.gutters.push_back({centre, {side.wall.normal().x, side.wall.normal().y}});
      plan.sides.push_back(std::move(side));
    }
    if (is_seen) plan.buildings.push_back(building);
  }
  add_targets(settings, plan);
  open_and_shade(plan, seed);
  return plan;
}

}  // namespace jalon::yard
