// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Scenes whose surfaces are known, sampled anew for each cloud: points evenly by area, with normal noise on each axis.

#include <array>
#include <cmath>
#include <vector>

#include "base/random.h"
#include "cloud/cloud.h"

namespace jalon::scenes {

struct Patch {
  Vec3 corner, u, v;
  double area() const { return norm(cross(u, v)); }
};

struct Scene {
  const char* name;
  std::vector<Patch> patches;
  double noise_m = 0.005;
  size_t points = 3000;
  bool terrain = false;        ///< the patches are the plan of a slope with waves
  size_t open_directions = 0;  ///< that nothing fixes
};

/// Five faces of a box that stands on the ground.
inline void add_box(std::vector<Patch>& patches, const Vec3& o, double x, double y, double z) {
  patches.push_back({o + Vec3{0, 0, z}, {x, 0, 0}, {0, y, 0}});
  patches.push_back({o, {x, 0, 0}, {0, 0, z}});
  patches.push_back({o + Vec3{0, y, 0}, {x, 0, 0}, {0, 0, z}});
  patches.push_back({o, {0, y, 0}, {0, 0, z}});
  patches.push_back({o + Vec3{x, 0, 0}, {0, y, 0}, {0, 0, z}});
}

inline Scene street_corner() {
  return {"street corner",
          {{{0, 0, 0}, {14, 0, 0}, {0, 14, 0}},
           {{4, 4, 0}, {10, 0, 0}, {0, 0, 7}},
           {{4, 4, 0}, {0, 10, 0}, {0, 0, 7}}}};
}
inline Scene facade() {
  Scene scene{"facade", {{{0, 0, 0}, {14, 0, 0}, {0, 0, 9}}, {{0, 0, 0}, {14, 0, 0}, {0, -3, 0}}}};
  add_box(scene.patches, {5, -1.5, 3}, 3, 1.5, 4);  // an oriel
  return scene;
}
inline Scene corridor() {
  Scene scene{"corridor",
              {{{0, 0, 0}, {18, 0, 0}, {0, 2.4, 0}},
               {{0, 0, 2.6}, {18, 0, 0}, {0, 2.4, 0}},
               {{0, 0, 0}, {18, 0, 0}, {0, 0, 2.6}},
               {{0, 2.4, 0}, {18, 0, 0}, {0, 0, 2.6}}}};
  scene.open_directions = 1;
  return scene;
}
inline Scene one_plane() {
  Scene scene{"one plane", {{{0, 0, 0}, {10, 0, 0}, {0, 0, 8}}}};
  scene.open_directions = 3;
  return scene;
}
inline Scene room() {
  Scene scene{"room",
              {{{0, 0, 0}, {6, 0, 0}, {0, 5, 0}},
               {{0, 0, 2.8}, {6, 0, 0}, {0, 5, 0}},
               {{0, 0, 0}, {6, 0, 0}, {0, 0, 2.8}},
               {{0, 5, 0}, {6, 0, 0}, {0, 0, 2.8}},
               {{0, 0, 0}, {0, 5, 0}, {0, 0, 2.8}},
               {{6, 0, 0}, {0, 5, 0}, {0, 0, 2.8}}}};
  add_box(scene.patches, {2, 1.5, 0}, 1.6, 0.9, 0.75);  // a table
  return scene;
}
inline Scene sloping_terrain() {
  return {"sloping terrain", {{{0, 0, 0}, {40, 0, 0}, {0, 40, 0}}}, 0.02, 4000, true};
}
inline std::array<Scene, 6> all_scenes() {
  return {street_corner(), facade(), corridor(), one_plane(), room(), sloping_terrain()};
}

inline double terrain_height_m(double x, double y) {
  return 0.25 * x + 0.6 * std::sin(0.25 * x + 0.7) * std::cos(0.21 * y) +
         0.4 * std::sin(0.17 * (x + 1.3 * y));
}

/// A sample of the scene, moved.
inline Cloud sampled(const Scene& scene, uint64_t seed, const Transform& motion = {},
                     size_t points = 0) {
  double total = 0;
  for (const Patch& patch : scene.patches) total += patch.area();
  RandomStream random(seed, 77);
  const size_t n = points > 0 ? points : scene.points;
  Buffer<double> xyz(3 * n);
  for (size_t i = 0; i < n; ++i) {
    double at = random.uniform() * total;
    size_t k = 0;
    while (k + 1 < scene.patches.size() && at > scene.patches[k].area())
      at -= scene.patches[k++].area();
    const double a = random.uniform(), b = random.uniform();
    Vec3 p = scene.patches[k].corner + scene.patches[k].u * a + scene.patches[k].v * b;
    if (scene.terrain) p.z = terrain_height_m(p.x, p.y);
    const double nx = random.normal(), ny = random.normal();
    p = motion.point(p + Vec3{nx, ny, random.normal()} * scene.noise_m);
    for (int c = 0; c < 3; ++c) xyz[3 * i + static_cast<size_t>(c)] = p[c];
  }
  return make_cloud(std::move(xyz));
}

}  // namespace jalon::scenes
