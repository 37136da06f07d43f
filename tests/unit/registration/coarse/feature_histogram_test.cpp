// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Features of surfaces made by hand: a plane in closed form, and what must not change them.

#include <doctest/doctest.h>

#include <algorithm>

#include "unit/registration/coarse_surfaces.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr double kReach = 4.3;  // cells

Vec3 jitter(RandomStream& random) {
  const double x = random.uniform() - 0.5, y = random.uniform() - 0.5;
  return Vec3{x, y, random.uniform() - 0.5} * 0.2;
}

// Two sheets that meet in an edge along y, rough, so that no angle lies on the border of two bins.
CoarseSurface rough_corner(const Transform& by = {}, bool flip = false) {
  RandomStream random(8, 1), coin(9, 1);
  Cells cells;
  const auto add = [&](const Vec3& point, const Vec3& normal) {
    const Vec3 place = by.point(point + jitter(random));
    const Vec3 n = by.direction(normalized(normal + jitter(random)));
    cells.add(place, flip && coin.below(2) == 1 ? -n : n);
  };
  for (int i = 0; i < 12; ++i)
    for (int k = 0; k < 12; ++k) {
      add({i + 0.5, 1.0 * k, 0}, {0, 0, 1});
      add({0, 1.0 * k, i + 0.5}, {1, 0, 0});
    }
  return cells.surface();
}

CoarseSurface described_cells(CoarseSurface surface, size_t most = 1000) {
  Task task;
  describe_features(surface, kReach, most, task);
  return surface;
}

}  // namespace

TEST_CASE("describe_features__of_a_plane_fill_the_middle_bin_of_each_angle") {
  Feature flat{};                       // up to the rounding of floats
  flat[5] = flat[16] = flat[27] = 100;  // all angles 0: bin 5 of 11
  const auto s = described_cells(Cells().sheet({}, {1, 0, 0}, {0, 1, 0}, 9, 9).surface());
  for (const Feature& f : s.features) CHECK(squared_distance(f, flat) < 1e-6f);
  CHECK(squared_distance(s.mean_feature, flat) < 1e-6f);
}

TEST_CASE("describe_features__sum_to_100_an_angle_and_are_nothing_without_neighbours_or_normal") {
  Cells cells;
  cells.sheet({}, {1, 0, 0}, {0, 1, 0}, 8, 8).sheet({0, 40, 0}, {1, 0, 0}, {0, 1, 0}, 5, 1);
  cells.add({3.5, 3.5, 0.5}, {});
  const CoarseSurface s = described_cells(cells.surface());
  for (size_t i = 0; i < s.size(); ++i)
    for (size_t angle = 0; angle < 3; ++angle) {
      float sum = 0;
      for (size_t b = 0; b < 11; ++b) sum += s.features[i][11 * angle + b];
      if (i < 64) CHECK(sum == doctest::Approx(100).epsilon(1e-5));  // of floats
      else CHECK(sum == 0);  // five in a row, and a point without a normal
    }
  CHECK(s.distinct.size() == 64);
  CHECK(s.distinct.back() == 63);
}

TEST_CASE("describe_features__of_a_floor_show_a_wall_within_two_radii") {
  const auto s = described_cells(Cells()
                                     .sheet({0.5, 0, 0}, {1, 0, 0}, {0, 1, 0}, 14, 12)
                                     .sheet({0, 0, 0.5}, {0, 1, 0}, {0, 0, 1}, 12, 8)
                                     .surface());
  for (size_t i = 0; i < s.size(); ++i) {
    if (s.points[i].z > 0) continue;
    // Neighbours lie within a radius; what these see beside themselves, within another.
    const bool is_flat = s.features[i][5] > 99.99f && s.features[i][27] > 99.99f;
    if (s.points[i].x > 2 * kReach) CHECK(is_flat);
    if (s.points[i].x < 2 * kReach - 2) CHECK_FALSE(is_flat);
  }
}

TEST_CASE("describe_features__are_the_same_from_behind_and_wherever_the_surface_lies") {
  const CoarseSurface s = described_cells(rough_corner());
  const CoarseSurface behind = described_cells(rough_corner({}, true));
  const CoarseSurface moved = described_cells(rough_corner(random_start(5, true)));
  for (size_t i = 0; i < s.size(); ++i) {
    CHECK(behind.features[i] == s.features[i]);
    CHECK(squared_distance(moved.features[i], s.features[i]) < 1e-6f);  // rounding of floats
  }
  CHECK(behind.distinct == s.distinct);
}

TEST_CASE("describe_features__distinct_and_salient_are_those_farthest_from_the_mean") {
  const size_t most = 30;
  const CoarseSurface s = described_cells(rough_corner(), most);
  REQUIRE(s.distinct.size() == most);
  REQUIRE(s.salient.size() == s.size() / 7);
  CHECK(std::is_sorted(s.distinct.begin(), s.distinct.end()));
  for (const auto& chosen : {s.distinct, s.salient}) {
    float least = 1e9f, most_left = 0;
    for (uint32_t i = 0; i < s.size(); ++i) {
      const float far = squared_distance(s.features[i], s.mean_feature);
      if (std::binary_search(chosen.begin(), chosen.end(), i)) least = std::min(least, far);
      else most_left = std::max(most_left, far);
    }
    CHECK(least >= most_left);
  }
  // An edge is what the scene has only once: most of them see it.
  size_t near = 0;
  for (const uint32_t i : s.distinct) near += s.points[i].x < kReach && s.points[i].z < kReach;
  CHECK(near > most / 2);
}
