// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "solid/cut_envelope.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "unit/solid/brute_force.h"

using namespace jalon;

namespace {

const std::array<Vec3, 3> kTriangle{{{0, 0, 0}, {2, 0, 0}, {0, 1, 1}}};

Cut cut_of(double value, const Vec3& gradient) {
  Cut cut{value, {0.5, 0.25, 0}, gradient, {}};
  for (size_t i = 0; i < 3; ++i) cut.corners[i] = cut.at(kTriangle[i]);
  return cut;
}

Vec3 place(const Weights& w) {
  return kTriangle[0] * w[0] + kTriangle[1] * w[1] + kTriangle[2] * w[2];
}

double highest(const std::vector<Cut>& cuts, const Vec3& p) {
  double out = cuts[0].at(p);
  for (const Cut& cut : cuts) out = std::max(out, cut.at(p));
  return out;
}

}  // namespace

TEST_CASE("cut_envelope__of_one_cut_is_least_at_a_corner") {
  CutEnvelope envelope;
  envelope.add(cut_of(1, {-1, 0, 0}), {1, 0, 0});
  Weights where{};
  CHECK(envelope.minimise(where) == doctest::Approx(1 - 1.5));
  CHECK(where[1] == doctest::Approx(1));
}

TEST_CASE("cut_envelope__minimum_equals_a_search_and_the_best_mixture_proves_it") {
  RandomStream random(5, 0);
  for (int scene = 0; scene < 100; ++scene) {
    CutEnvelope envelope;
    std::vector<Cut> cuts;
    for (int i = 0; i < 2 + scene % 7; ++i) {
      const double at = brute::uniform(random, -0.2, 0.2);
      cuts.push_back(cut_of(at, brute::any_vector(random, 1)));
      envelope.add(cuts.back(), {1, 0, 0});
    }
    Weights where{};
    const double least = envelope.minimise(where);
    const double searched = brute::least_on_triangle(
        [&](const Vec3& p) { return highest(cuts, p); }, kTriangle[0], kTriangle[1], kTriangle[2]);
    CHECK(least == doctest::Approx(searched).epsilon(1e-6));
    CHECK(highest(cuts, place(where)) == doctest::Approx(least).epsilon(1e-9));
    double height = 0;
    Vec3 slope;
    const Vec3 p = place(where);
    CHECK(envelope.best_mixture(p, height, slope) == doctest::Approx(least).epsilon(1e-9));
    double lowest = 1e300;
    for (const Vec3& corner : kTriangle) lowest = std::min(lowest, height + dot(slope, corner - p));
    CHECK(lowest == doctest::Approx(least).epsilon(1e-9));
    for (int i = 0; i < 20; ++i) {  // a plane below the function everywhere, not only here
      const Vec3 q = brute::any_vector(random, 5);
      CHECK(height + dot(slope, q - p) <= highest(cuts, q) + 1e-9);
    }
  }
}

TEST_CASE("cut_envelope__without_room_the_lowest_cut_goes") {
  CutEnvelope envelope;
  for (int i = 0; i < 40; ++i) envelope.add(cut_of(i == 7 ? 100 : i, {}), {1, 0, 0});
  Weights where{};
  CHECK(envelope.minimise(where) == doctest::Approx(100));
}
