// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/codes/openings.h"

#include <doctest/doctest.h>

using namespace jalon;

namespace {

constexpr int64_t kOffset = 8;

CodedPoint at(double x, double y, double z, int64_t modifier = kNoModifier) {
  return {"p", {x, y, z}, 1, 360, modifier};
}

bool is(const Vec3& p, double x, double y, double z) { return norm(p - Vec3{x, y, z}) < 1e-12; }

}  // namespace

TEST_CASE("openings__two_points_are_the_corners") {
  const CodedPoint points[] = {at(0, 0.2, 1), at(2, 0.2, 2)};
  const OpeningCorners c = opening_corners(points, kOffset);
  CHECK(is(c.a, 0, 0.2, 1));
  CHECK(is(c.b, 2, 0.2, 2));
}

TEST_CASE("openings__the_twin_of_either_corner_moves_the_other_to_the_frame") {
  const CodedPoint second[] = {at(0, 0, 1), at(0, 0.2, 1, kOffset), at(2, 0, 2)};
  const CodedPoint third[] = {at(2, 0, 2), at(0, 0, 1), at(0, 0.2, 1, kOffset)};
  for (const std::span<const CodedPoint> points :
       {std::span<const CodedPoint>(second), std::span<const CodedPoint>(third)}) {
    const OpeningCorners c = opening_corners(points, kOffset);
    CHECK(c.fault == "");
    CHECK(is(c.a, 0, 0.2, 1));
    CHECK(is(c.b, 2, 0.2, 2));
  }
}

TEST_CASE("openings__four_points_leave_the_inclined_sill_out") {
  const CodedPoint points[] = {at(0, 0, 1), at(2, 0, 1), at(2, 0.2, 1.07, kOffset),
                               at(2, 0.2, 2, kOffset)};
  const OpeningCorners c = opening_corners(points, kOffset);
  CHECK(is(c.a, 2, 0.2, 2));
  CHECK(is(c.b, 0, 0.2, 1.07));
}

TEST_CASE("openings__faults_are_told_with_the_point_to_blame") {
  const auto fault = [](std::initializer_list<CodedPoint> points) {
    return opening_corners(std::span(points.begin(), points.size()), kOffset).fault;
  };
  CHECK(fault({at(0, 0, 1), at(2, 0, 2), at(0, 0.2, 1, kOffset)}).find("2.245 m") !=
        std::string::npos);
  CHECK(fault({at(0, 0.2, 1, kOffset), at(0, 0, 1), at(2, 0, 2)}).find("follows no corner") !=
        std::string::npos);
  CHECK(fault({at(0, 0.2, 1), at(0, 0, 1), at(2, 0, 2)}).find("0 offset") != std::string::npos);
  CHECK(fault({at(0, 0, 1), at(2, 0, 1, kOffset), at(2, 0.2, 1), at(2, 0.2, 2)}) != "");
  CHECK(fault({at(0, 0, 1), at(0, 0, 2)}).find("above each other") != std::string::npos);
}
