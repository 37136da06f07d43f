// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/raster/grey_plane.h"

#include <doctest/doctest.h>

#include <cmath>

#include "base/random.h"

using namespace jalon;

TEST_CASE("grey_plane__is_the_plane_of_its_pixels_far_from_the_origin_too") {
  for (const double far : {0.0, 1e5}) {
    GreySums sums(far, -far, far);
    for (int i = 0; i < 7; ++i)
      for (int k = 0; k < 5; ++k)
        sums.add(far + 0.1 * i, -far + 0.1 * k, far + 0.25 * 0.1 * i - 0.5 * 0.1 * k + 2);
    GreyPlane plane;
    REQUIRE(sums.fit(plane));
    CHECK(plane.a == doctest::Approx(0.25).epsilon(1e-9).scale(0));
    CHECK(plane.b == doctest::Approx(-0.5).epsilon(1e-9).scale(0));
    CHECK(plane.at(far + 1, -far) == doctest::Approx(far + 2.25).epsilon(1e-12));
    CHECK(plane.rms < 1e-6);
    CHECK(plane.cosine() == doctest::Approx(1 / std::sqrt(1 + 0.0625 + 0.25)));
  }
}

TEST_CASE("grey_plane__no_plane_leaves_a_smaller_residual") {
  RandomStream random(5, 0);
  GreySums sums;
  std::vector<std::array<double, 3>> pixels;
  for (int i = 0; i < 40; ++i) {
    pixels.push_back({random.uniform(), random.uniform(), random.normal()});
    sums.add(pixels.back()[0], pixels.back()[1], pixels.back()[2]);
  }
  GreyPlane plane;
  REQUIRE(sums.fit(plane));
  const auto rms_of = [&](const GreyPlane& p) {
    double sum = 0;
    for (const auto& x : pixels) sum += std::pow(x[2] - p.at(x[0], x[1]), 2);
    return std::sqrt(sum / static_cast<double>(pixels.size()));
  };
  CHECK(rms_of(plane) == doctest::Approx(plane.rms));
  for (const double step : {-0.01, 0.01}) {
    CHECK(rms_of({plane.a + step, plane.b, plane.c, 0}) > plane.rms);
    CHECK(rms_of({plane.a, plane.b + step, plane.c, 0}) > plane.rms);
    CHECK(rms_of({plane.a, plane.b, plane.c + step, 0}) > plane.rms);
  }
}

TEST_CASE("grey_plane__pixels_on_a_line_have_none") {
  GreySums sums;
  GreyPlane plane;
  CHECK_FALSE(sums.fit(plane));
  for (int i = 0; i < 9; ++i) sums.add(i, 2.0 * i, i);
  CHECK_FALSE(sums.fit(plane));
}
