// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Scenes for pairs of scans, drawn from a seed: triangles, and where a scanner may stand.

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "base/random.h"
#include "spatial/triangles/tree.h"

namespace jalon::test {

/// Triangles of a scene, and standpoints that see much of each other's view.
struct PairScene {
  std::vector<Vec3> vertices;
  std::vector<std::array<uint32_t, 3>> triangles;
  std::vector<Vec3> standpoints;
  double range_m = 60;  ///< of the scanner
  double step_m = 0;    ///< along x, by which it repeats itself; 0: it does not

  void triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
    const auto n = static_cast<uint32_t>(vertices.size());
    vertices.insert(vertices.end(), {a, b, c});
    triangles.push_back({n, n + 1, n + 2});
  }
  void sheet(const Vec3& corner, const Vec3& u, const Vec3& v) {
    triangle(corner, corner + u, corner + u + v);
    triangle(corner, corner + u + v, corner + v);
  }
  /// Closed and upright, turned about its corner.
  void box(const Vec3& corner, const Vec3& size, double turn_rad = 0) {
    const Vec3 x = Vec3{std::cos(turn_rad), std::sin(turn_rad), 0} * size.x;
    const Vec3 y = Vec3{-std::sin(turn_rad), std::cos(turn_rad), 0} * size.y, z{0, 0, size.z};
    sheet(corner, x, z), sheet(corner + y, x, z), sheet(corner, y, z), sheet(corner + x, y, z);
    sheet(corner, x, y), sheet(corner + z, x, y);
  }
  /// A pipe without lids, of 16 sides.
  void pipe(const Vec3& from, const Vec3& to, double radius_m) {
    const Vec3 axis = normalized(to - from);
    const Vec3 u = normalized(cross(axis, std::abs(axis.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0}));
    const Vec3 v = cross(axis, u);
    constexpr int kSides = 16;
    for (int i = 0; i < kSides; ++i) {
      const double a = 2 * std::numbers::pi * i / kSides,
                   b = 2 * std::numbers::pi * (i + 1) / kSides;
      const Vec3 p = from + (u * std::cos(a) + v * std::sin(a)) * radius_m;
      const Vec3 q = from + (u * std::cos(b) + v * std::sin(b)) * radius_m;
      sheet(p, q - p, to - from);
    }
  }
  /// A grid of heights over a square about the origin.
  template <class Height>
  void ground(double half_m, double cell_m, const Height& height) {
    const int n = static_cast<int>(2 * half_m / cell_m);
    const auto at = [&](int i, int j) {
      const double x = -half_m + i * cell_m, y = -half_m + j * cell_m;
      return Vec3{x, y, height(x, y)};
    };
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        triangle(at(i, j), at(i + 1, j), at(i + 1, j + 1));
        triangle(at(i, j), at(i + 1, j + 1), at(i, j + 1));
      }
  }
  /// A closed lump: a sphere whose radius waves with its direction, in a way of its own.
  void lump(const Vec3& centre, double radius_m, double waves, RandomStream& random) {
    double phase[6], amplitude[6];
    Vec3 way[6];
    for (int k = 0; k < 6; ++k) {
      phase[k] = 2 * std::numbers::pi * random.uniform();
      amplitude[k] = waves * (0.4 + 0.6 * random.uniform()) / 3;
      way[k] = Vec3{random.normal(), random.normal(), random.normal()} * 2.2;
    }
    const auto at = [&](int i, int j) {
      const double polar = std::numbers::pi * i / 24, turn = 2 * std::numbers::pi * j / 48;
      const Vec3 d{std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn),
                   std::cos(polar)};
      double r = 1;
      for (int k = 0; k < 6; ++k) r += amplitude[k] * std::sin(dot(way[k], d) + phase[k]);
      return centre + d * (radius_m * r);
    };
    for (int i = 0; i < 24; ++i)
      for (int j = 0; j < 48; ++j) {
        triangle(at(i, j), at(i + 1, j), at(i + 1, j + 1));
        triangle(at(i, j), at(i + 1, j + 1), at(i, j + 1));
      }
  }
};

/// Uniform between two numbers.
inline double between(RandomStream& random, double low, double high) {
  return low + (high - low) * random.uniform();
}

// ---- kinds to develop with ------------------------------------------------------------------------------------------

/// Houses with bays and windows about a crossing, cars, posts.
inline PairScene crossing(uint64_t seed) {
  RandomStream random(seed, 1);
  PairScene s;
  s.sheet({-30, -30, 0}, {60, 0, 0}, {0, 60, 0});
  for (int corner = 0; corner < 4; ++corner) {
    if (random.uniform() < 0.2) continue;
    const double x = corner % 2 == 0 ? -between(random, 20, 24) : between(random, 5, 9);
    const double y = corner / 2 == 0 ? -between(random, 20, 24) : between(random, 5, 9);
    const Vec3 size{between(random, 10, 14), between(random, 10, 14), between(random, 6, 13)};
    s.box({x, y, 0}, size);
    const int windows = 2 + static_cast<int>(random.below(4));
    for (int w = 0; w < windows; ++w) {
      const double z = between(random, 1, size.z - 2.5), at = between(random, 0.5, size.x - 2);
      s.box({x + at, y - 0.25, z}, {between(random, 0.8, 2), 0.25, 1.5});
      s.box({x + at, y + size.y, z}, {between(random, 0.8, 2), 0.3, 1.2});
      s.box({x + size.x, y + at, z}, {0.3, between(random, 0.8, 2), 1.4});
      s.box({x - 0.2, y + at, z}, {0.2, between(random, 0.8, 2), 1.6});
    }
  }
  // Of two arguments the last is drawn first here and below: compilers may choose, these scenes may not.
  for (int car = 0; car < 3; ++car) {
    const double turn_rad = between(random, 0, 3);
    s.box({between(random, -12, 10), between(random, -4, 3), 0}, {4.3, 1.8, 1.5}, turn_rad);
  }
  for (int post = 0; post < 4; ++post) {
    const Vec3 top{between(random, -15, 15), between(random, -4, 4), 5};
    s.pipe({between(random, -15, 15), between(random, -4, 4), 0}, top, 0.12);
  }
  s.standpoints = {{0, 0, 1.7}, {-3.5, 1, 1.7}, {2, -3, 1.8}};
  return s;
}

/// A room with furniture; rooms of one seed and other contents are those of other floors.
inline PairScene furnished(uint64_t seed, uint64_t contents) {
  RandomStream walls(seed, 2), random(contents, 22);
  PairScene s;
  const Vec3 size{between(walls, 4, 8), between(walls, 3.5, 6), between(walls, 2.4, 3)};
  s.box({0, 0, 0}, size);
  const int things = 5 + static_cast<int>(random.below(6));
  for (int k = 0; k < things; ++k) {
    const Vec3 thing{between(random, 0.3, 1.6), between(random, 0.3, 1), between(random, 0.3, 2)};
    const double turn_rad = random.uniform() < 0.5 ? 0 : between(random, -0.4, 0.4);
    s.box({between(random, 0.3, size.x - 1.8), between(random, 0.3, size.y - 1.4), 0}, thing,
          turn_rad);
  }
  s.standpoints = {{size.x * 0.45, size.y * 0.5, 1.9},
                   {size.x * 0.3, size.y * 0.35, 2},
                   {size.x * 0.6, size.y * 0.6, 1.95}};
  return s;
}

/// Rolling ground with boulders.
inline PairScene boulders(uint64_t seed) {
  RandomStream random(seed, 3);
  PairScene s;
  const double a = between(random, 6, 12), b = between(random, 6, 12), c = between(random, 0, 6);
  s.ground(25, 0.5, [&](double x, double y) {
    return 1.2 * std::sin(x / a + c) * std::cos(y / b) + 0.4 * std::sin(x / 2.7 + y / 3.1 + c);
  });
  for (int k = 0; k < 25; ++k) {
    const double radius_m = between(random, 0.5, 1.6);
    s.lump({between(random, -20, 20), between(random, -20, 20), 0.3}, radius_m, 0.5, random);
  }
  s.standpoints = {{0, 0, 4}, {3, 1.5, 4}, {-2, 2, 4.2}};
  return s;
}

/// A street front: bays and storeys of one step, as builders love them, with a few things of its own.
inline PairScene front(uint64_t seed, uint64_t contents) {
  RandomStream walls(seed, 4), random(contents, 24);
  PairScene s;
  const double bay = between(walls, 2.4, 4), storey = between(walls, 2.8, 3.6);
  const double width = between(walls, 0.9, 1.5), height = between(walls, 1.3, 2);
  const int bays = 5 + static_cast<int>(walls.below(4)),
            storeys = 2 + static_cast<int>(walls.below(3));
  s.step_m = bay;
  const double length = bays * bay;
  s.sheet({-4, -12, 0}, {length + 8, 0, 0}, {0, 12, 0});
  for (int i = 0; i < bays; ++i)
    for (int j = 0; j < storeys; ++j) {
      const Vec3 o{i * bay, 0, j * storey};
      const double left = (bay - width) / 2, sill = (storey - height) / 2;
      s.sheet(o, {left, 0, 0}, {0, 0, storey});
      s.sheet(o + Vec3{left + width, 0, 0}, {bay - left - width, 0, 0}, {0, 0, storey});
      s.sheet(o + Vec3{left, 0, 0}, {width, 0, 0}, {0, 0, sill});
      s.sheet(o + Vec3{left, 0, sill + height}, {width, 0, 0}, {0, 0, storey - sill - height});
      s.box(o + Vec3{left, 0, sill}, {width, 0.22, height});
    }
  for (int k = 0; k < 4; ++k) {
    const Vec3 size{between(random, 0.4, 2), between(random, 0.4, 1), between(random, 0.8, 3)};
    s.box({between(random, 0, length), between(random, -6, -1), 0}, size);
  }
  const Vec3 balcony{between(random, 2, 3), 1, 1.2};
  s.box({between(random, 0, length - 3), -1, storey - 0.3}, balcony);
  s.standpoints = {{length * 0.5, -9, 1.7}, {length * 0.4, -8, 1.7}, {length * 0.58, -10, 1.7}};
  return s;
}

/// A corridor with doors of one step on both sides, and its ends; other contents are another floor.
inline PairScene corridor_with_doors(uint64_t seed, uint64_t contents) {
  RandomStream walls(seed, 5), random(contents, 25);
  PairScene s;
  const double length = between(walls, 16, 24), width = between(walls, 1.8, 2.6);
  const double step = between(walls, 2.5, 4);
  s.step_m = step;
  s.box({0, 0, 0}, {length, width, 2.6});
  for (double x = step / 2; x + 1 < length; x += step) {
    s.box({x, 0, 0}, {0.95, 0.05, 2.1});
    s.box({x, width - 0.05, 0}, {0.95, 0.05, 2.1});
  }
  for (int k = 0; k < 5; ++k) {
    const Vec3 thing{between(random, 0.3, 1), 0.35, between(random, 0.4, 1.2)};
    s.box({between(random, 0.5, length - 1), random.uniform() < 0.5 ? 0.02 : width - 0.4, 0},
          thing);
  }
  s.standpoints = {{length * 0.4, width / 2, 1.7},
                   {length * 0.5, width / 2, 1.7},
                   {length * 0.33, width * 0.45, 1.6}};
  return s;
}

/// One thing on a table, seen from around it; the table is not scanned.
inline PairScene thing(uint64_t seed) {
  RandomStream random(seed, 14);
  PairScene s;
  s.lump({0, 0, 0}, 1, 0.7, random);
  const double radius_m = between(random, 0.4, 0.6);
  s.lump({between(random, -0.4, 0.4), between(random, -0.4, 0.4), 1}, radius_m, 0.6, random);
  s.standpoints = {{6, 0, 1}, {5.4, 2.6, 1.2}, {5.6, -2, 0.6}};
  return s;
}

}  // namespace jalon::test
