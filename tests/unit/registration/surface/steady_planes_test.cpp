// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Planes of two lines that are no surface go, those of a surface in lines stay.

#include "registration/surface/steady_planes.h"

#include <doctest/doctest.h>

#include <cmath>

#include "unit/registration/icp_problems.h"

using namespace jalon;
using namespace jalon::test;

namespace {

// Lines along x, each at a height of its own.
std::vector<Vec3> lines_at(double (*height)(int line)) {
  RandomStream random(23, 0);
  std::vector<Vec3> out;
  for (int line = 0; line < 30; ++line)
    for (int k = 0; k < 60; ++k)
      out.push_back(
          {0.05 * (k + random.uniform()), 0.12 * line, height(line) + 0.001 * random.normal()});
  return out;
}

size_t flat_of(const SurfacePlanes& surface) {
  size_t out = 0;
  for (size_t i = 0; i < surface.size(); ++i) out += surface.flat(i);
  return out;
}

struct Kept {
  size_t before, after;
};
Kept kept_of(const std::vector<Vec3>& points) {
  Task task;
  const SurfacePlanes all = surface_planes(cloud_of(points).octree(task), 10, task);
  const SurfacePlanes steady = steady_planes(all, 10, task);
  CHECK(steady.size() == all.size());
  CHECK(steady.noise_m == all.noise_m);
  for (size_t i = 0; i < all.size(); ++i)
    if (std::isfinite(steady.planes[i].sigma_m))
      CHECK(steady.planes[i].height_m == all.planes[i].height_m);
  return {flat_of(all), flat_of(steady)};
}

}  // namespace

TEST_CASE("steady_planes__of_a_floor_in_lines_stay") {
  const Kept kept = kept_of(lines_at([](int) { return 0.0; }));
  CHECK(kept.before > 1500);
  CHECK(kept.after > 0.97 * static_cast<double>(kept.before));
}

TEST_CASE("steady_planes__through_neighbouring_lines_of_a_rough_thing_go") {
  // Up and down by more than the lines are apart: a plane through any two of them is chance.
  const Kept kept = kept_of(lines_at([](int line) { return 0.2 * ((line * 7) % 5 - 2); }));
  CHECK(kept.before > 100);
  CHECK(kept.after < 0.35 * static_cast<double>(kept.before));
}
