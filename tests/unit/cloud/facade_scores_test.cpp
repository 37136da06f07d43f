// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cloud/facade_scores.h"

#include <doctest/doctest.h>

#include "base/random.h"

using namespace jalon;

namespace {

// n points in the box (0, 0, 0) ... size.
Cloud points_in(const Vec3& size, size_t n) {
  RandomStream random(5, 1);
  Buffer<double> xyz(3 * n);
  for (size_t i = 0; i < n; ++i)
    for (int k = 0; k < 3; ++k) xyz[3 * i + static_cast<size_t>(k)] = size[k] * random.uniform();
  return make_cloud(std::move(xyz));
}

double share_above(const Cloud& cloud, double least) {
  Task task;
  size_t above = 0;
  for (const FacadeScore& s : facade_scores(cloud, task)) above += double{s.score} > least ? 1 : 0;
  return static_cast<double>(above) / static_cast<double>(cloud.size());
}

}  // namespace

TEST_CASE("facade_scores__tell_a_wall_from_ground_and_bushes") {
  CHECK(share_above(points_in({20, 0.01, 8}, 4000), 0.8) > 0.5);
  CHECK(share_above(points_in({20, 8, 0.01}, 4000), 0.1) == 0);
  CHECK(share_above(points_in({3, 3, 3}, 4000), 0.6) < 0.01);
}

TEST_CASE("facade_scores__of_a_wall__have_its_normal") {
  Task task;
  for (const FacadeScore& s : facade_scores(points_in({20, 0.01, 8}, 4000), task))
    if (double{s.score} > 0.8) {
      CHECK(std::fabs(s.normal.v) > 0.99);
      CHECK(norm(s.normal) == doctest::Approx(1));
    }
}

TEST_CASE("facade_scores__of_few_points__are_zero") {
  Task task;
  for (const FacadeScore& s : facade_scores(points_in({1, 1, 1}, 5), task)) CHECK(s.score == 0);
}
