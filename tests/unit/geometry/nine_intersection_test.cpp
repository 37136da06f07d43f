// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/nine_intersection.h"

#include <doctest/doctest.h>

#include <string>

using namespace jalon;

namespace {

using Matrix = std::array<int8_t, 9>;

// The eight matrices of simple regions (Egenhofer & Herring 1990), dimensions as two regions in general position.
struct Named {
  const char* name;
  Matrix matrix;
};
constexpr Named kSimple[] = {
    {"disjoint", {-1, -1, 1, -1, -1, 2, 1, 2, 2}},  {"meet", {1, -1, 1, -1, -1, 2, 1, 2, 2}},
    {"overlap", {0, 1, 1, 1, 2, 2, 1, 2, 2}},       {"covers", {1, -1, 1, 1, 2, 2, -1, -1, 2}},
    {"covered_by", {1, 1, -1, -1, 2, -1, 1, 2, 2}}, {"contains", {-1, -1, 1, 1, 2, 2, -1, -1, 2}},
    {"inside", {-1, 1, -1, -1, 2, -1, 1, 2, 2}},    {"equal", {1, -1, -1, -1, 2, -1, -1, -1, 2}}};

}  // namespace

TEST_CASE("nine_intersection__the_eight_matrices_of_simple_regions_have_their_names") {
  for (const Named& simple : kSimple) {
    CAPTURE(simple.name);
    CHECK(name_of(relation_of({simple.matrix})) == std::string(simple.name));
  }
}

TEST_CASE("nine_intersection__transposed_is_the_relation_seen_from_the_other_side") {
  const auto seen = [](const char* name) -> std::string {
    for (const Named& simple : kSimple)
      if (name == std::string(simple.name))
        return name_of(relation_of(NineIntersection{simple.matrix}.transposed()));
    return "";
  };
  for (const char* name : {"disjoint", "meet", "overlap", "equal"}) CHECK(seen(name) == name);
  CHECK(seen("covers") == "covered_by");
  CHECK(seen("covered_by") == "covers");
  CHECK(seen("contains") == "inside");
  CHECK(seen("inside") == "contains");
  const NineIntersection skew{{0, 1, 2, 3, -1, 0, 1, 2, 3}};
  CHECK(skew.transposed().transposed() == skew);
  CHECK(skew.transposed().at(NineIntersection::kBoundary, NineIntersection::kInterior) == 3);
}

TEST_CASE("nine_intersection__raise_keeps_the_higher_dimension_and_contact_looks_at_closures") {
  using enum NineIntersection::Place;
  NineIntersection m;
  CHECK(m.contact() == -1);
  m.raise(kExterior, kInterior, 3);
  CHECK(m.contact() == -1);
  m.raise(kBoundary, kInterior, 1);
  m.raise(kBoundary, kInterior, 0);
  CHECK(m.at(kBoundary, kInterior) == 1);
  CHECK(m.contact() == 1);
  CHECK(relation_of(m) == RegionRelation::kMeet);
}
