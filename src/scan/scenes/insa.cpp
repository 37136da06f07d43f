// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Three buildings after the south-west facade of INSA Strasbourg: scanned, surveyed, and with the
// balconies of its residence (Boulaassal 2010, 3.2, 5.5.3.2 and 5.6.3.2).
#include "scan/scenes/grid_facade.h"
#include "scan/builder/objects.h"
#include "scan/scenes/scenes.h"

namespace jalon {

namespace {

/// S1: main plane y = 0, posts and bands 0.50 m before it, breast walls 0.10 m and glass 0.25 m behind it.
constexpr GridFacade kInsa{.wall_width_m = 8,
                           .bay_width_m = 6,
                           .bays = 10,
                           .storeys = 5,
                           .storey_height_m = 4,
                           .band_height_m = 0.40,
                           .post_width_m = 0.40,
                           .front_y = -0.50,
                           .wall_y = 0,
                           .breast_y = 0.10,
                           .glass_y = 0.25,
                           .mullion_y = 0,
                           .breast_height_m = 1.0,
                           .window_height_m = 2.6,
                           .mullion_width_m = 0.15,
                           .mullions = 3,
                           .cornice_z = 22,
                           .cornice_height_m = 0.30,
                           .cornice_y = -1.80,
                           .curtain_share = 0.20,
                           .open_share = 0.10,
                           .curtain_nearest_y = 0.30,
                           .curtain_farthest_y = 0.40,
                           .balcony_depth_m = 0};

/// DS1: posts and string courses in y = 0, the closed wall at 0.20, parapets at 0.60, windows at 0.70; mullions of
/// 0.30 x 2.43 m (0.73 m2).
constexpr GridFacade kSurveyed{.wall_width_m = 9,
                               .bay_width_m = 5.9,
                               .bays = 10,
                               .storeys = 5,
                               .storey_height_m = 4.2,
                               .band_height_m = 0.35,
                               .post_width_m = 0.40,
                               .front_y = 0,
                               .wall_y = 0.20,
                               .breast_y = 0.60,
                               .glass_y = 0.70,
                               .mullion_y = 0.40,
                               .breast_height_m = 1.0,
                               .window_height_m = 2.43,
                               .mullion_width_m = 0.30,
                               .mullions = 2,
                               .cornice_z = 21.5,
                               .cornice_height_m = 0.50,
                               .cornice_y = -1.80,
                               .curtain_share = 1.0 / 3,
                               .open_share = 0.10,
                               .curtain_nearest_y = 0.80,
                               .curtain_farthest_y = 1.00,
                               .balcony_depth_m = 0};

RandomStream windows_of(const SceneSettings& settings) { return {settings.seed, 0}; }

void add_obstacles(SceneBuilder& out, double car_length_m) {
  const uint32_t unwanted = out.part("unwanted", "unwanted");
  add_car(out, unwanted, {20, -9, 0}, car_length_m);
  add_car(out, unwanted, {46, -8, 0}, car_length_m);
  add_stair(out, unwanted, {30, -4, 0});
}

}  // namespace

void build_insa(const SceneSettings& settings, SceneBuilder& out) {
  build_grid_facade(kInsa, windows_of(settings), out);
  add_obstacles(out, 4.2);
}

void build_insa_surveyed(const SceneSettings& settings, SceneBuilder& out) {
  build_grid_facade(kSurveyed, windows_of(settings), out);
  add_obstacles(out, 4.5);
}

void build_residence(const SceneSettings& settings, SceneBuilder& out) {
  GridFacade facade = kSurveyed;
  facade.balcony_depth_m = 1.2;
  build_grid_facade(facade, windows_of(settings), out);
  add_obstacles(out, 4.5);
}

}  // namespace jalon
