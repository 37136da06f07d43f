// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Kinds of scenes that no constant of the library was chosen with: figures are reported on these.

#include "accuracy/pair_scenes.h"

namespace jalon::test {

/// Pipes, tanks and girders of a plant.
inline PairScene plant(uint64_t seed) {
  RandomStream random(seed, 11);
  PairScene s;
  s.sheet({-15, -15, 0}, {30, 0, 0}, {0, 30, 0});
  for (int k = 0; k < 14; ++k) {
    const Vec3 from{between(random, -10, 10), between(random, -10, 10), between(random, 0.3, 4)};
    const int axis = static_cast<int>(random.below(3));
    Vec3 to = from;
    to[axis] += between(random, 3, 9);
    s.pipe(from, to, between(random, 0.06, 0.35));
  }
  for (int k = 0; k < 4; ++k) {
    const Vec3 o{between(random, -12, 12), between(random, -12, 12), 0};
    s.pipe(o, o + Vec3{0, 0, between(random, 2, 5)}, between(random, 0.6, 1.6));
    s.box({between(random, -12, 12), between(random, -12, 12), 0},
          {0.3, 0.3, between(random, 3, 6)});
  }
  s.standpoints = {{0, 0, 1.7}, {2.5, -1, 1.8}, {-2, 2, 1.7}};
  return s;
}

/// A hall of columns of one step; other contents are another floor.
inline PairScene columns(uint64_t seed, uint64_t contents) {
  RandomStream walls(seed, 12), random(contents, 32);
  PairScene s;
  const double step = between(walls, 4, 6);
  const Vec3 size{4 * step, 3 * step, between(walls, 3.5, 5)};
  s.step_m = step;
  s.box({0, 0, 0}, size);
  for (int i = 1; i < 4; ++i)
    for (int j = 1; j < 3; ++j) s.pipe({i * step, j * step, 0}, {i * step, j * step, size.z}, 0.3);
  for (int k = 0; k < 8; ++k)
    s.box({between(random, 0.5, size.x - 2), between(random, 0.5, size.y - 2), 0},
          {between(random, 0.4, 1.5), between(random, 0.4, 1.5), between(random, 0.5, 2)});
  s.standpoints = {
      {1.5 * step, 1.5 * step, 1.7}, {1.9 * step, 1.6 * step, 1.8}, {1.4 * step, 1.2 * step, 1.7}};
  return s;
}

/// Trees on a slope: trunks, and crowns of many leaves.
inline PairScene wood(uint64_t seed) {
  RandomStream random(seed, 13);
  PairScene s;
  const double slope = between(random, 0.05, 0.2), phase = between(random, 0, 6);
  const auto height = [&](double x, double y) {
    return slope * x + 0.3 * std::sin(x / 3 + phase) * std::cos(y / 4);
  };
  s.ground(18, 0.75, height);
  for (int k = 0; k < 22; ++k) {
    const double x = between(random, -16, 16), y = between(random, -16, 16);
    if (x * x + y * y < 6) continue;
    const Vec3 foot{x, y, height(x, y) - 0.2};
    const Vec3 top =
        foot + Vec3{between(random, -0.5, 0.5), between(random, -0.5, 0.5), between(random, 4, 8)};
    s.pipe(foot, top, between(random, 0.1, 0.3));
    for (int leaf = 0; leaf < 60; ++leaf) {
      const Vec3 p = top + Vec3{random.normal(), random.normal(), random.normal()} * 1.1;
      const Vec3 u = normalized(Vec3{random.normal(), random.normal(), random.normal()}) * 0.25;
      const Vec3 v = normalized(Vec3{random.normal(), random.normal(), random.normal()}) * 0.25;
      s.triangle(p, p + u, p + v);
    }
  }
  s.standpoints = {{0, 0, 2}, {1.5, 1, 2.1}, {-1.2, 0.8, 2}};
  return s;
}

/// A machine on its frame, scanned from outside: cabinets, a tank, pipes between them.
inline PairScene machine(uint64_t seed) {
  RandomStream random(seed, 16);
  PairScene s;
  const double length = between(random, 2.5, 4);
  s.box({0, 0, 0.1}, {length, 1.2, 0.15});
  const int cabinets = 2 + static_cast<int>(random.below(3));
  for (int k = 0; k < cabinets; ++k)
    s.box({between(random, 0, length - 0.9), between(random, 0, 0.5), 0.25},
          {between(random, 0.3, 0.9), between(random, 0.3, 0.7), between(random, 0.5, 1.6)},
          between(random, -0.15, 0.15));
  const double x = between(random, 0.4, length - 0.4);
  s.pipe({x, 0.6, 0.25}, {x, 0.6, between(random, 1.2, 1.9)}, between(random, 0.2, 0.35));
  for (int k = 0; k < 6; ++k)
    s.pipe({between(random, 0, length), between(random, 0, 1.2), between(random, 0.4, 1.5)},
           {between(random, 0, length), between(random, 0, 1.2), between(random, 0.4, 1.5)},
           between(random, 0.03, 0.08));
  s.standpoints = {
      {length / 2, -4, 1.6}, {length / 2 + 1.8, -3.6, 1.7}, {length / 2 - 1.4, -4.2, 1.5}};
  return s;
}

/// A stairwell: flights and landings, each like the next.
inline PairScene stairs(uint64_t seed) {
  RandomStream random(seed, 15);
  PairScene s;
  const double tread = between(random, 0.26, 0.3), rise = between(random, 0.165, 0.185);
  const double width = between(random, 1.1, 1.5);
  const int steps = 8 + static_cast<int>(random.below(4));
  const double run = steps * tread, half_storey = steps * rise;
  s.box({-1.6, 0, 0}, {run + 3.2, 2 * width + 0.3, 4 * half_storey + 2.5});
  for (int flight = 0; flight < 4; ++flight) {
    const bool back = flight % 2 == 1;
    for (int k = 0; k < steps; ++k) {
      const double x = back ? run - (k + 1) * tread : k * tread;
      s.box({x, back ? width + 0.3 : 0, flight * half_storey + k * rise - 0.1},
            {tread, width, rise + 0.1});
    }
    s.box({back ? -1.6 : run, 0, (flight + 1) * half_storey - 0.15}, {1.6, 2 * width + 0.3, 0.15});
  }
  for (int k = 0; k < 4; ++k)
    s.box({between(random, -1.5, -0.8), between(random, 0, 2 * width - 0.5), 0},
          {between(random, 0.2, 0.6), 0.3, between(random, 0.3, 1.5)});
  s.standpoints = {{-0.8, width, 1.6}, {-0.7, width * 0.8, 2.1}, {-0.9, width * 1.3, 1.5}};
  return s;
}

}  // namespace jalon::test
