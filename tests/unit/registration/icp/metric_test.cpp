// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "geometry/symmetric_eigen.h"
#include "registration/icp/pairs.h"

using namespace jalon;

namespace {

Vec3 sum_along(const PairTerm (&terms)[3], size_t count) {
  Vec3 sum;
  for (size_t k = 0; k < count; ++k) sum += terms[k].normal * terms[k].residual_m;
  return sum;
}

IcpPair pair_of_planes(const Vec3& a, const Vec3& b, const Vec3& offset) {
  IcpPair pair;
  pair.normal = normalized(a);
  pair.other = normalized(b);
  pair.offset = offset;
  return pair;
}

}  // namespace

TEST_CASE("pair_terms__point_to_plane_is_the_residual_along_the_normal") {
  IcpPair pair;
  pair.normal = {0, 0, 1};
  pair.residual_m = -0.25;
  PairTerm terms[3];
  REQUIRE(pair_terms(pair, IcpMetric::kPointToPlane, terms) == 1);
  CHECK(terms[0].normal == Vec3{0, 0, 1});
  CHECK(terms[0].residual_m == -0.25);
  CHECK(terms[0].weight == 1);
}

TEST_CASE("pair_terms__point_to_point_are_the_components_of_the_offset") {
  IcpPair pair;
  pair.offset = {1, -2, 3};
  PairTerm terms[3];
  REQUIRE(pair_terms(pair, IcpMetric::kPointToPoint, terms) == 3);
  CHECK(sum_along(terms, 3) == pair.offset);
  for (const PairTerm& term : terms) CHECK(term.weight == 1);
}

TEST_CASE("pair_terms__of_parallel_planes_weigh_1_across_and_little_along") {
  const Vec3 n = normalized(Vec3{1, 2, 2});
  const IcpPair pair = pair_of_planes(n, -n, {0.3, -0.1, 0.2});
  PairTerm terms[3];
  REQUIRE(pair_terms(pair, IcpMetric::kPlaneToPlane, terms) == 3);
  CHECK(norm(sum_along(terms, 3) - pair.offset) < 1e-12);
  double across = 0, squares = 0;
  for (const PairTerm& term : terms) {
    if (std::abs(dot(term.normal, n)) > 0.99) across = term.weight;
    else CHECK(term.weight == doctest::Approx(1e-3).scale(0).epsilon(1e-6));
    squares += term.weight * term.residual_m * term.residual_m;
  }
  CHECK(across == doctest::Approx(1).epsilon(1e-6));
  const double height = dot(n, pair.offset);
  CHECK(squares ==
        doctest::Approx(height * height + 1e-3 * (squared_norm(pair.offset) - height * height))
            .scale(0));
}

TEST_CASE("pair_terms__of_two_planes_are_the_form_of_both_shapes") {
  // offset^T (C1 + C2)^-1 offset, with C = I - (1 - e) n n^T, up to the factor 2 e: solved here as 3 x 3 equations.
  const IcpPair pair = pair_of_planes({1, 0, 0.2}, {1, 0.3, -0.1}, {0.2, 0.5, -0.4});
  PairTerm terms[3];
  pair_terms(pair, IcpMetric::kPlaneToPlane, terms);
  double squares = 0;
  for (const PairTerm& term : terms) squares += term.weight * term.residual_m * term.residual_m;
  const double s = 1 - 1e-3;
  const auto row = [&](int i) {
    Vec3 out;
    for (int k = 0; k < 3; ++k)
      out[k] = (i == k ? 2.0 : 0.0) -
               s * (pair.normal[i] * pair.normal[k] + pair.other[i] * pair.other[k]);
    return out;
  };
  const Vec3 a = row(0), b = row(1), c = row(2);
  const double volume = dot(a, cross(b, c));
  const Vec3 solved =
      (cross(b, c) * pair.offset.x + cross(c, a) * pair.offset.y + cross(a, b) * pair.offset.z) /
      volume;
  CHECK(squares == doctest::Approx(2e-3 * dot(pair.offset, solved)).scale(0).epsilon(1e-9));
}
