// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Propagated standard deviations against drawn planes and against the sums of known variances.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <vector>

#include "base/random.h"
#include "report/elevation/opening_precision.h"
#include "unit/report/named_facade.h"

using namespace jalon;

namespace {

// A wall turned by this azimuth with one hole of 2 x 1 m, a pane 0.1 m behind it; corners of the hole from its lower
// left one clockwise: vertices 4 ... 7.
Model one_window(double azimuth) {
  Model m;
  const double c = std::cos(azimuth), s = std::sin(azimuth);
  const auto turned = [&](std::vector<Vec3> ring) {
    for (Vec3& p : ring) p = {c * p.x - s * p.y, s * p.x + c * p.y, p.z};
    return ring;
  };
  const Vec3 normal{s, -c, 0};
  const std::vector<Vec2> hole = named_facade::hole(3, 1, 2, 1);
  named_facade::add(m, 0, {normal, 0},
                    {turned(named_facade::lifted({{0, 0}, {8, 0}, {8, 5}, {0, 5}}, 0)),
                     turned(named_facade::lifted(hole, 0))},
                    {}, 38, 1);
  named_facade::add(m, 2, {normal, -0.1}, {turned(named_facade::lifted(hole, 0.1, true))}, {}, 2,
                    2);
  for (Face& face : m.faces) face.covariance.fill(0);
  return m;
}

// Variances along and across the wall and upward.
std::array<double, 9> corner_covariance(double azimuth, const Vec3& variances) {
  const double c = std::cos(azimuth), s = std::sin(azimuth);
  const double xy = c * s * (variances.x - variances.y);
  return {c * c * variances.x + s * s * variances.y,
          xy,
          0,
          xy,
          s * s * variances.x + c * c * variances.y,
          0,
          0,
          0,
          variances.z};
}

OpeningRow window_of_model(const Model& m) {
  OpeningRow row;
  row.contour = {{0, 1}};
  row.joinery = {1};
  set_precision(row, m);
  return row;
}

}  // namespace

TEST_CASE("opening_precision__of_a_plane_is_the_scatter_of_drawn_planes") {
  constexpr int kDraws = 4000;
  RandomStream random(1, 0);
  for (int trial = 0; trial < 5; ++trial) {
    CAPTURE(trial);
    // Correlated errors of normal and offset: e = L z.
    double l[4][4] = {};
    for (int i = 0; i < 4; ++i)
      for (int k = 0; k <= i; ++k) l[i][k] = 1e-3 * random.normal();
    std::array<double, 16> covariance{};
    for (size_t i = 0; i < 4; ++i)
      for (size_t k = 0; k < 4; ++k)
        for (size_t j = 0; j < 4; ++j) covariance[4 * i + k] += l[i][j] * l[k][j];
    const Vec3 p{10 * random.normal(), 10 * random.normal(), 10 * random.normal()};
    double sum = 0;
    for (int n = 0; n < kDraws; ++n) {
      double e[4] = {};
      const double z[] = {random.normal(), random.normal(), random.normal(), random.normal()};
      for (int i = 0; i < 4; ++i)
        for (int k = 0; k < 4; ++k) e[i] += l[i][k] * z[k];
      const double change = e[0] * p.x + e[1] * p.y + e[2] * p.z - e[3];
      sum += change * change;
    }
    // A standard deviation of n draws scatters by 1 / sqrt(2 n): four times that.
    CHECK(sigma_at(covariance, p) ==
          doctest::Approx(std::sqrt(sum / kDraws)).epsilon(4 / std::sqrt(2.0 * kDraws)).scale(0));
  }
}

TEST_CASE("opening_precision__sides_add_the_mean_variance_of_their_corners_at_every_azimuth") {
  for (const double azimuth : {0.0, 0.6, 2.5, -1.3}) {
    CAPTURE(azimuth);
    Model m = one_window(azimuth);
    m.vertex_covariances.resize(m.vertices.size());
    // Lower left, upper left, upper right, lower right; across the wall a metre, which must not count.
    const Vec3 variances[] = {{1e-6, 1, 16e-6}, {9e-6, 1, 4e-6}, {2e-6, 1, 8e-6}, {6e-6, 1, 4e-6}};
    for (size_t i = 0; i < 4; ++i)
      m.vertex_covariances[4 + i] = corner_covariance(azimuth, variances[i]);
    // Left 5, right 4: 9 mm2. Low 10, high 6: 16 mm2.
    OpeningRow row = window_of_model(m);
    CHECK(row.sigma_width_m == doctest::Approx(0.003).scale(0));
    CHECK(row.sigma_height_m == doctest::Approx(0.004).scale(0));
    // A corner without a covariance leaves its side to the other one: left 1, low 16 and high 8.
    m.vertex_covariances[5].fill(NAN);
    m.vertex_covariances[7].fill(NAN);
    row = window_of_model(m);
    CHECK(row.sigma_width_m == doctest::Approx(std::sqrt(1e-6 + 2e-6)));
    CHECK(row.sigma_height_m == doctest::Approx(std::sqrt(16e-6 + 8e-6)));
    m.vertex_covariances[6].fill(NAN);
    CHECK(std::isnan(window_of_model(m).sigma_width_m));
  }
}

TEST_CASE("opening_precision__of_the_depth_needs_both_planes_and_joins_their_errors") {
  Model m = one_window(0);
  CHECK(std::isnan(window_of_model(m).sigma_depth_m));
  m.faces[0].covariance[15] = 9e-6;  // the wall: 3 mm
  CHECK(std::isnan(window_of_model(m).sigma_depth_m));
  m.faces[1].covariance[15] = 16e-6;
  CHECK(window_of_model(m).sigma_depth_m == doctest::Approx(0.005).scale(0));
  // The pane leans by 1 mrad (sigma) about the axis x = 0; the middle of the opening is at x = 4.
  m.faces[1].covariance.fill(0);
  m.faces[1].covariance[0] = 1e-6;
  CHECK(window_of_model(m).sigma_depth_m == doctest::Approx(std::hypot(0.003, 0.004)));
  m.faces[0].covariance.fill(0);
  CHECK(std::isnan(window_of_model(m).sigma_depth_m));
  OpeningRow nothing;
  set_precision(nothing, m);
  CHECK(std::isnan(nothing.sigma_width_m));
  CHECK(std::isnan(nothing.sigma_depth_m));
}
