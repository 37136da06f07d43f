// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "model/relations/solid_relation.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "unit/model/relations/boxes.h"

using namespace jalon;
using namespace jalon::test;

namespace {

using SolidMatrix = std::array<int8_t, 9>;
constexpr double kSolidTolerance_m = 0.001;

struct Box {
  Vec3 low, high;
};

// Turned about all axes, at seven digits.
Transform somewhere(int k) {
  const double a = 0.3 + k, c = std::cos(a), s = std::sin(a), d = std::cos(0.7 * k),
               e = std::sin(0.7 * k);
  const Transform about_z{{c, -s, 0, 1234567.25, s, c, 0, 654321.5, 0, 0, 1, 42}},
      about_x{{1, 0, 0, 0, 0, d, -e, 0, 0, e, d, 0}};
  return k == 0 ? Transform{} : about_z * about_x;
}

void check_solids(const Box& a, const Box& b, const SolidMatrix& matrix, const char* name) {
  CAPTURE(std::string(name));
  for (int k = 0; k < 4; ++k) {
    CAPTURE(k);
    Model model;
    add_box(model, a.low, a.high, somewhere(k));
    add_box(model, b.low, b.high, somewhere(k));
    const PlacedSolid p = placed_solid(model, model.solids[0], kSolidTolerance_m),
                      q = placed_solid(model, model.solids[1], kSolidTolerance_m);
    const NineIntersection found = solid_intersection(p, q, kSolidTolerance_m);
    CHECK(found.dimensions == matrix);
    CHECK(name_of(relation_of(found)) == std::string(name));
    CHECK(solid_intersection(q, p, kSolidTolerance_m) == found.transposed());
  }
}

double solids_apart(const Box& a, const Box& b) {
  Model model;
  add_box(model, a.low, a.high, somewhere(2));
  add_box(model, b.low, b.high, somewhere(2));
  return solid_distance(placed_solid(model, model.solids[0], kSolidTolerance_m),
                        placed_solid(model, model.solids[1], kSolidTolerance_m), kSolidTolerance_m);
}

constexpr Box kBlock{{0, 0, 0}, {4, 2, 3}};

}  // namespace

TEST_CASE("solid_relation__the_eight_relations_of_two_blocks_with_their_matrices") {
  check_solids(kBlock, {{5, 0, 0}, {6, 2, 3}}, {-1, -1, 2, -1, -1, 3, 2, 3, 3}, "disjoint");
  check_solids(kBlock, {{4, 0, 0}, {6, 1, 1}}, {2, -1, 2, -1, -1, 3, 2, 3, 3}, "meet");
  check_solids(kBlock, {{3, 1, 2}, {6, 4, 5}}, {1, 2, 2, 2, 3, 3, 2, 3, 3}, "overlap");
  check_solids(kBlock, {{1, 0, 1}, {2, 1, 2}}, {2, -1, 2, 2, 3, 3, -1, -1, 3}, "covers");
  check_solids(kBlock, {{1, 0.5, 1}, {2, 1, 2}}, {-1, -1, 2, 2, 3, 3, -1, -1, 3}, "contains");
  check_solids(kBlock, kBlock, {2, -1, -1, -1, 3, -1, -1, -1, 3}, "equal");
  check_solids({{1, 0, 1}, {2, 1, 2}}, kBlock, {2, 2, -1, -1, 3, -1, 2, 3, 3}, "covered_by");
  check_solids({{1, 0.5, 1}, {2, 1, 2}}, kBlock, {-1, 2, -1, -1, 3, -1, 2, 3, 3}, "inside");
}

TEST_CASE("solid_relation__contact_has_the_dimension_of_what_is_shared") {
  check_solids(kBlock, {{4, 2, 0}, {6, 4, 3}}, {1, -1, 2, -1, -1, 3, 2, 3, 3}, "meet");  // an edge
  check_solids(kBlock, {{4, 2, 3}, {6, 4, 5}}, {0, -1, 2, -1, -1, 3, 2, 3, 3}, "meet");  // a corner
  check_solids(kBlock, {{-1, 0.5, 1}, {5, 1, 2}}, {1, 2, 2, 2, 3, 3, 2, 3, 3},
               "overlap");  // a beam through
}

TEST_CASE("solid_relation__less_than_the_tolerance_apart_is_together") {
  for (const double off : {0.0004, -0.0004}) {
    CAPTURE(off);
    check_solids(kBlock, {{4 + off, 0, 0}, {6, 2, 3}}, {2, -1, 2, -1, -1, 3, 2, 3, 3}, "meet");
    check_solids(kBlock, {{off, off, off}, {4 + off, 2 + off, 3 + off}},
                 {2, -1, -1, -1, 3, -1, -1, -1, 3}, "equal");
  }
}

TEST_CASE("solid_relation__distance_of_volumes") {
  CHECK(solids_apart(kBlock, {{5, 0, 0}, {6, 2, 3}}) == doctest::Approx(1));
  CHECK(solids_apart(kBlock, {{7, 6, 0}, {8, 7, 3}}) == doctest::Approx(5));
  CHECK(solids_apart(kBlock, {{5, 3, 5}, {6, 7, 6}}) == doctest::Approx(std::sqrt(6.0)));
  CHECK(solids_apart(kBlock, {{4, 0, 0}, {6, 1, 1}}) == 0);
  CHECK(solids_apart(kBlock, {{1, 0.5, 1}, {2, 1, 2}}) == 0);
}
