// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/detection/common_misfit.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "base/random.h"

using namespace jalon;

namespace {

constexpr double kWell_m = 0.0005, kRough_m = 0.05;  // known to
constexpr size_t kSurfaces = 1000;

/// Surfaces of a scene of 40 x 20 x 10 m that face all ways; of every five one is well known.
std::vector<SurfaceOffset> surfaces_with(const CommonMisfit& misfit, uint64_t seed) {
  RandomStream random(seed, 0);
  std::vector<SurfaceOffset> out(kSurfaces);
  for (size_t k = 0; k < kSurfaces; ++k) {
    SurfaceOffset& s = out[k];
    s.place = {40 * random.uniform(), 20 * random.uniform(), 10 * random.uniform()};
    for (int c = 0; c < 3; ++c) s.normal[c] = random.normal();
    s.normal = normalized(s.normal);
    s.sigma_m = k % 5 == 0 ? kWell_m : kRough_m;
    s.offset_m = misfit.offset_m(s.place, s.normal) + s.sigma_m * random.normal();
  }
  return out;
}

double farthest_off(const CommonMisfit& found, const CommonMisfit& truth,
                    const std::vector<SurfaceOffset>& surfaces) {
  double most = 0;
  for (const SurfaceOffset& s : surfaces)
    most = std::max(
        most, std::abs(found.offset_m(s.place, s.normal) - truth.offset_m(s.place, s.normal)));
  return most;
}

}  // namespace

TEST_CASE("common_misfit__is_told_by_the_few_surfaces_that_are_well_known") {
  const CommonMisfit truth{{10, 5, 0}, {0.003, -0.006, 0.002}, {0.0002, 0, -0.0003}};
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    const auto surfaces = surfaces_with(truth, seed);
    Task task;
    CHECK(farthest_off(common_misfit(surfaces, task), truth, surfaces) < 2 * kWell_m);
  }
}

TEST_CASE("common_misfit__of_scans_that_fit_to_their_noise_is_none") {
  size_t found = 0;
  for (uint64_t seed = 1; seed <= 40; ++seed) {
    Task task;
    found += norm(common_misfit(surfaces_with({}, seed), task).shift_m) > 0 ? 1 : 0;
  }
  CHECK(found == 0);
}

TEST_CASE("common_misfit__leaves_what_moved_by_itself_where_it_is") {
  auto surfaces = surfaces_with({}, 11);
  for (SurfaceOffset& s : surfaces)
    if (s.place.x < 10) s.offset_m += 0.05;  // a quarter
  Task task;
  CHECK(farthest_off(common_misfit(surfaces, task), {}, surfaces) < kWell_m);
}

TEST_CASE("common_misfit__moves_nothing_in_directions_that_no_surface_tells") {
  auto surfaces = surfaces_with({}, 12);
  for (SurfaceOffset& s : surfaces) {
    s.normal = {0, 0, 1};
    s.offset_m += 0.008;
  }
  Task task;
  const CommonMisfit found = common_misfit(surfaces, task);
  CHECK(std::abs(found.shift_m.z - 0.008) < kWell_m);
  CHECK(std::hypot(found.shift_m.x, found.shift_m.y) < 1e-6);
  CHECK(std::abs(found.turn_rad.z) < 1e-6);
}

TEST_CASE("common_misfit__of_a_few_surfaces_or_of_one_place_is_none") {
  Task task;
  CHECK(norm(common_misfit({}, task).shift_m) == 0);
  std::vector<SurfaceOffset> one_place(100, {{1, 2, 3}, {0, 0, 1}, 0.01, 0.001});
  CHECK(norm(common_misfit(one_place, task).shift_m) == 0);
}
