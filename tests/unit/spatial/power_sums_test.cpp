// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/power_sums.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "base/random.h"

using namespace jalon;

namespace {

std::vector<Vec3> some_points(size_t n, uint64_t seed) {
  RandomStream random(seed, 0);
  std::vector<Vec3> out(n);
  for (Vec3& p : out)
    for (int axis = 0; axis < 3; ++axis) p[axis] = 2 * random.uniform() - 1;
  return out;
}

double power(double x, int n) {
  double out = 1;
  for (int i = 0; i < n; ++i) out *= x;
  return out;
}

template <int Degree, class Check>
void for_each_term(Check check) {
  for (int a = 0; a <= Degree; ++a)
    for (int b = 0; a + b <= Degree; ++b)
      for (int c = 0; a + b + c <= Degree; ++c) check(a, b, c);
}

}  // namespace

TEST_CASE("power_sums__are_sums_of_products_of_powers_each_at_a_place_of_its_own") {
  const auto points = some_points(50, 1);
  PowerSums<4> sums;
  for (const Vec3& p : points) sums.add(p);
  CHECK(sums.count() == 50);
  std::vector<int> taken(PowerSums<4>::kTerms, 0);
  for_each_term<4>([&](int a, int b, int c) {
    double truth = 0;
    for (const Vec3& p : points) truth += power(p.x, a) * power(p.y, b) * power(p.z, c);
    CHECK(sums.of(a, b, c) == doctest::Approx(truth).scale(1).epsilon(1e-13));
    ++taken[PowerSums<4>::index(a, b, c)];
  });
  CHECK(taken == std::vector<int>(PowerSums<4>::kTerms, 1));
}

TEST_CASE("power_sums__shifted_are_those_of_the_moved_points_in_any_unit") {
  const auto points = some_points(80, 2);
  for (const Vec3& d : {Vec3{0, 0, 0}, Vec3{0.5, -2, 3}, Vec3{-7, 0, 0.25}}) {
    PowerSums<4> here, there;
    PowerSums<2> planes_here, planes_there;
    for (const Vec3& p : points) {
      here.add(p), planes_here.add(p);
      there.add(p + d), planes_there.add(p + d);
    }
    const PowerSums<4> shifted = here.shifted(d), in_feet = shifted.in_units_of(0.25);
    const PowerSums<2> planes_shifted = planes_here.shifted(d);
    const double reach = 1 + norm(d);
    for_each_term<4>([&](int a, int b, int c) {
      const double scale = 80 * power(reach, a + b + c);
      CHECK(std::fabs(shifted.of(a, b, c) - there.of(a, b, c)) < 1e-14 * scale);
      CHECK(in_feet.of(a, b, c) == doctest::Approx(shifted.of(a, b, c) * power(4, a + b + c)));
    });
    for_each_term<2>([&](int a, int b, int c) {
      CHECK(std::fabs(planes_shifted.of(a, b, c) - planes_there.of(a, b, c)) <
            1e-14 * 80 * power(reach, a + b + c));
    });
  }
}

TEST_CASE("power_sums__of_two_parts_add_up") {
  const auto points = some_points(40, 3);
  PowerSums<2> all, first, second;
  for (size_t i = 0; i < points.size(); ++i) {
    all.add(points[i]);
    (i < 13 ? first : second).add(points[i]);
  }
  first += second;
  for_each_term<2>([&](int a, int b, int c) {
    CHECK(first.of(a, b, c) == doctest::Approx(all.of(a, b, c)).scale(1).epsilon(1e-13));
  });
}
