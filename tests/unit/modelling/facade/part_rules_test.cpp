// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <string>

#include "model/part_classes.h"
#include "modelling/facade/part_rules.h"

using namespace jalon;

namespace {

// A facade of 12 x 9 m with one window of 1 x 1.5 m at (4, 2).
const FacadeShape kFacade{{{0, 0, 0}, {12, 0, 9}}, {{{4, 0, 2}, {5, 0, 3.5}}}};
const Vec3 kFront{0, 1, 0}, kUp{0, 0, 1}, kSide{1, 0, 0};

std::string class_of(const Vec3& low, const Vec3& high, const Vec3& normal, double area_m2) {
  return class_of_element({{low, high}, normal, area_m2}, kFacade);
}

}  // namespace

TEST_CASE("part rules: position, size, depth and orientation tell what an element is") {
  CHECK(class_of({-2, -0.2, -0.1}, {14, 6, 0.1}, kUp, 90) == part_class::kGround);
  CHECK(class_of({3.9, 0.1, 1.9}, {5.1, 0.1, 2.0}, kFront, 0.12) == part_class::kSill);
  CHECK(class_of({3.9, 0, 2.0}, {5.1, 0.12, 2.0}, kUp, 0.14) == part_class::kSill);
  CHECK(class_of({0, 0.35, 8.5}, {12, 0.35, 9}, kFront, 6) == part_class::kCornice);
  CHECK(class_of({0, 0, 8.5}, {12, 0.35, 8.5}, -kUp, 4.2) == part_class::kCornice);
  CHECK(class_of({0, 0.05, 0}, {12, 0.05, 0.6}, kFront, 7) == part_class::kBaseCourse);
  CHECK(class_of({0, 0.1, 4.5}, {12, 0.1, 4.9}, kFront, 5) == part_class::kStringCourse);
  CHECK(class_of({8, 0.2, 0.5}, {8.4, 0.2, 8}, kFront, 3) == part_class::kPost);
  CHECK(class_of({0, -6, 9}, {12, -0.5, 12}, normalized(Vec3{0, 1, 2}), 80) == part_class::kRoof);
  CHECK(class_of({6, -0.5, 3}, {7, -0.5, 4}, kFront, 1) == part_class::kElement);
  CHECK(class_of({6, 0, 3}, {6, 1, 4}, kSide, 1) == part_class::kElement);
}

TEST_CASE("part rules: numbers count rows from below and places from the left") {
  const auto box = [](double x, double z) { return Box3{{x, 0, z}, {x + 1, 0, z + 1.5}}; };
  const auto numbers = row_numbers({box(5, 4), box(2, 1.1), box(8, 1), box(2, 4.2)});
  CHECK(numbers == std::vector<std::string>{"2.2", "1.1", "1.2", "2.1"});
  CHECK(row_numbers({}).empty());
}
