// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Ground, rooms, and what stands in the way.
#include <algorithm>

#include "scan/builder/objects.h"
#include "scan/grammar/realise.h"

namespace jalon::grammar {

namespace {

constexpr double kPavement_m = 1.8, kKerb_m = 0.12;
constexpr double kBeside_m = 6;
constexpr uint64_t kOccluderStream = 2, kLeavesStream = 1000;  // of the scene's seed

/// A body and a cabin.
void add_parked_car(SceneBuilder& out, uint32_t parent, double x, double y, Dice& dice) {
  const uint32_t car = out.part("car", "car", parent);
  const double length = dice.between(3.6, 4.8), height = dice.between(1.35, 1.75);
  out.box(car, {x, y, -kKerb_m + 0.2}, {length, 1.75, 0.65}, true);
  out.box(car, {x + 0.2 * length, y + 0.1, -kKerb_m + 0.85}, {0.6 * length, 1.55, height - 0.85},
          false);
}

}  // namespace

void add_ground(const Plan& plan, double reach_m, SceneBuilder& out) {
  const uint32_t ground = out.part("ground", "ground");
  const double x0 = -kBeside_m, x1 = plan.width_m + kBeside_m;
  const Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  out.face(ground, {{0, 0, 0}, x, y}, {x0, x1, -kPavement_m, plan.rooms_to_m});
  out.face(ground, {{0, -kPavement_m, 0}, x, z}, {x0, x1, -kKerb_m, 0});
  out.face(ground, {{0, 0, -kKerb_m}, x, y}, {x0, x1, -reach_m, -kPavement_m});
}

void add_rooms(const Plan& plan, SceneBuilder& out) {
  const uint32_t rooms = out.part("rooms", "interior");
  const double from = plan.rooms_from_m, to = plan.rooms_to_m;
  const double top = plan.rooms_top_m > 0 ? plan.rooms_top_m : plan.floors_m.back();
  const Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  out.face(rooms, {{0, to, 0}, x, z}, {0, plan.width_m, 0, top});
  for (const double side : {0.0, plan.width_m})
    out.face(rooms, {{side, 0, 0}, y, z}, {from, to, 0, top});
  if (!plan.has_rooms) return;
  for (size_t k = 1; k < plan.floors_m.size(); ++k)
    out.face(rooms, {{0, 0, plan.floors_m[k]}, x, y}, {0, plan.width_m, from, to});
}

void add_occluders(const Plan& plan, uint64_t seed, SceneBuilder& out) {
  Dice dice(seed, kOccluderStream);
  const uint32_t unwanted = out.part("unwanted", "unwanted");
  const double width = plan.width_m;
  const int share = std::max(1, static_cast<int>(width / 8));
  const int trees = dice.count(0, share), cars = dice.count(0, share),
            people = dice.count(0, 2 * share), posts = dice.count(0, share);
  for (int i = 0; i < trees; ++i) {
    const double radius = dice.between(0.8, 2.2);
    const Vec3 crown{dice.between(0, width), -dice.between(2.2, 3.5) - radius / 2,
                     dice.between(2.8, 5.5)};
    add_tree(out, unwanted, crown, radius, dice.between(0.5, 0.9),
             {seed, kLeavesStream + static_cast<uint64_t>(i)});
  }
  const int bushes = dice.chance(0.3) ? dice.count(1, 2 * share) : 0;
  for (int i = 0; i < bushes; ++i) {
    const double radius = dice.between(0.35, 0.8);
    const double share_of_leaves = dice.between(0.7, 0.95);
    const Vec3 middle{dice.between(0, width), -radius - dice.between(0.25, 0.8), 0.8 * radius};
    add_crown(out, unwanted, middle, radius, share_of_leaves,
              {seed, kLeavesStream + 500 + static_cast<uint64_t>(i)});
  }
  double x = dice.between(-2, 2);
  for (int i = 0; i < cars; ++i, x += dice.between(5.5, 8))
    add_parked_car(out, unwanted, x, -kPavement_m - dice.between(2.0, 2.4), dice);
  for (int i = 0; i < people; ++i)
    add_pedestrian(out, unwanted, {dice.between(0, width), -dice.between(0.6, 6), 0});
  if (posts > 0) out.part("posts", "post", unwanted);
  for (int i = 0; i < posts; ++i) {
    const double height = dice.chance(0.5) ? 1.0 : dice.between(3, 6);
    const double radius = dice.between(0.04, 0.09);
    const Vec3 foot{dice.between(0, width), -dice.between(1.2, 1.7), 0};
    out.cylinder(foot, radius, height, 24);
  }
}

}  // namespace jalon::grammar
