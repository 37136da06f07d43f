// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "geometry/rigid_motion.h"
#include "unit/cloud/clouds.h"

namespace jalon::test {

/// Parallelograms with an even density of points on them: scenes whose every sample is drawn anew.
class SampledScene {
 public:
  SampledScene& add(const Vec3& corner, const Vec3& u, const Vec3& v) {
    sheets_.push_back({corner, u, v, norm(cross(u, v))});
    return *this;
  }
  /// The six or, without a lid and a floor, four sides of an upright box turned about the vertical.
  SampledScene& box(const Vec3& corner, const Vec3& size, double turn_rad = 0, bool closed = true) {
    const Vec3 x = Vec3{std::cos(turn_rad), std::sin(turn_rad), 0} * size.x;
    const Vec3 y = Vec3{-std::sin(turn_rad), std::cos(turn_rad), 0} * size.y;
    const Vec3 z{0, 0, size.z};
    add(corner, x, z).add(corner + y, x, z).add(corner, y, z).add(corner + x, y, z);
    if (closed) add(corner, x, y).add(corner + z, x, y);
    return *this;
  }

  using Keep = std::function<bool(const Vec3&)>;
  std::vector<Vec3> sample(size_t n, double noise_m, uint64_t seed, const Keep& keep = {}) const {
    double area = 0;
    for (const Sheet& s : sheets_) area += s.area;
    RandomStream random(seed, 0);
    std::vector<Vec3> out;
    while (out.size() < n) {
      double at = area * random.uniform();
      size_t k = 0;
      while (k + 1 < sheets_.size() && at >= sheets_[k].area) at -= sheets_[k++].area;
      const Sheet& s = sheets_[k];
      const double a = random.uniform(), b = random.uniform(), off = noise_m * random.normal();
      const Vec3 p = s.corner + s.u * a + s.v * b + normalized(cross(s.u, s.v)) * off;
      if (!keep || keep(p)) out.push_back(p);
    }
    return out;
  }

 private:
  struct Sheet {
    Vec3 corner, u, v;
    double area;
  };
  std::vector<Sheet> sheets_;
};

/// 6 x 5 x 2.8 m: half a turn about any axis lays it onto itself.
inline SampledScene bare_room() { return SampledScene().box({0, 0, 0}, {6, 5, 2.8}); }
/// The same with a table, a cupboard, a chest and a door's recess.
inline SampledScene furnished_room() {
  return bare_room()
      .box({1, 1, 0.7}, {1.6, 0.8, 0.05}, 0.3)
      .box({0.05, 3.5, 0}, {0.6, 1.4, 2})
      .box({4.2, 0.05, 0}, {1.2, 0.5, 0.9})
      .box({6, 2, 0}, {0.3, 1, 2.1});
}
/// 20 m of floor, ceiling and two walls without ends.
inline SampledScene corridor() {
  return SampledScene()
      .box({0, 0, 0}, {20, 2, 2.5}, 0, false)
      .add({0, 0, 0}, {20, 0, 0}, {0, 2, 0})
      .add({0, 0, 2.5}, {20, 0, 0}, {0, 2, 0});
}
inline SampledScene one_plane() { return SampledScene().add({0, 0, 0}, {10, 0, 0}, {0, 8, 0}); }
/// A crossing: ground, two houses of unlike windows and bays, two cars, a post.
inline SampledScene street_corner() {
  SampledScene s;
  s.add({-15, -15, 0}, {40, 0, 0}, {0, 40, 0});
  s.box({-15, 8, 0}, {13, 12, 9}).box({6, 6, 0}, {16, 11, 12});
  for (int i = 0; i < 4; ++i) {
    s.box({-13.5 + 3.1 * i, 7.8, 1}, {1.2, 0.2, 1.6});
    s.box({7.5 + 3.6 * i, 5.7, 1.2}, {1.5, 0.3, 2});
  }
  return s.box({12, 5, 4}, {3, 1, 3})
      .box({-6, 0, 0}, {4.2, 1.8, 1.5}, 0.2)
      .box({3, -8, 0}, {4.4, 1.9, 1.6}, 1.3)
      .box({0, 4, 0}, {0.3, 0.3, 5});
}

/// Rolling ground of 60 x 60 m with boulders: no planes at all.
inline std::vector<Vec3> rolling_ground(size_t n, double noise_m, uint64_t seed) {
  RandomStream random(seed, 0);
  std::vector<Vec3> out(n);
  for (Vec3& p : out) {
    const double x = 60 * random.uniform(), y = 60 * random.uniform();
    double z =
        1.5 * std::sin(x / 9) * std::cos(y / 7) + 0.6 * std::sin(x / 2.3 + y / 3.1) + 0.05 * x;
    for (uint64_t k = 0; k < 40; ++k) {
      RandomStream boulder(99, k);
      const double bx = 60 * boulder.uniform(), by = 60 * boulder.uniform(),
                   r = 0.6 + 1.4 * boulder.uniform();
      const double d2 = (x - bx) * (x - bx) + (y - by) * (y - by);
      if (d2 < r * r) z += 0.8 * std::sqrt(r * r - d2);
    }
    p = {x, y, z + noise_m * random.normal()};
  }
  return out;
}

/// Any rotation about the vertical, or about any axis, and a shift of up to 20 m each way.
inline Transform random_start(uint64_t draw, bool any_axis = false) {
  RandomStream random(4711, draw);
  const double angle = 2 * std::numbers::pi * random.uniform();
  const double a = random.normal(), b = random.normal(), c = random.normal();
  const Vec3 axis = any_axis ? normalized(Vec3{a, b, c}) : Vec3{0, 0, 1};
  const double x = 40 * random.uniform() - 20, y = 40 * random.uniform() - 20;
  return motion_about({}, axis * angle, {x, y, 40 * random.uniform() - 20});
}

}  // namespace jalon::test
