// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Paraboloids through neighbours and the planes that touch them, against surfaces that are known.

#include <doctest/doctest.h>

#include <cmath>

#include "registration/surface/quadric_plane.h"
#include "unit/registration/icp_problems.h"

using namespace jalon;
using namespace jalon::test;

namespace {

struct Tree {
  Cloud cloud;
  std::shared_ptr<const Octree> tree;

  explicit Tree(const std::vector<Vec3>& points) : cloud(cloud_of(points)) {
    Task task;
    tree = cloud.octree(task);
  }
  std::vector<uint32_t> near(uint32_t position, uint32_t k) const {
    return positions_near(*tree, position, k);
  }
};

// A grid of (2 n + 1)^2 points over the origin on z = p x^2 + q x y + r y^2, noise along z.
std::vector<Vec3> saddle(int n, double p, double q, double r, double noise_m, uint64_t draw) {
  RandomStream random(121, draw);
  std::vector<Vec3> out;
  for (int i = -n; i <= n; ++i)
    for (int k = -n; k <= n; ++k) {
      const double x = 0.1 * i, y = 0.1 * k;
      out.push_back({x, y, p * x * x + q * x * y + r * y * y + noise_m * random.normal()});
    }
  return out;
}

}  // namespace

TEST_CASE("local_quadric__gives_an_exact_paraboloid_back") {
  const Tree grid(saddle(3, 0.5, 0.3, -0.5, 0, 0));
  const uint32_t middle = position_in(*grid.tree, 24);
  const auto found = local_quadric(*grid.tree, middle, grid.near(middle, 49));
  REQUIRE(found);
  CHECK(std::abs(found->n.z) > 1 - 1e-9);  // by symmetry: trace 0
  CHECK(found->sigma_m < 1e-8);            // the step of the tree's grid
  const double side = found->n.z > 0 ? 1 : -1;
  for (const Vec3& d : {Vec3{0.2, 0.1, 0}, Vec3{-0.3, 0.05, 0}, Vec3{0, 0, 0}}) {
    const auto terms = found->terms(d);
    double height = 0;
    for (size_t k = 0; k < 6; ++k) height += found->a[k] * terms[k];
    CHECK(std::abs(side * height - (0.5 * d.x * d.x + 0.3 * d.x * d.y - 0.5 * d.y * d.y)) < 1e-8);
  }
}

TEST_CASE("local_quadric__cofactors_and_scatter_are_those_of_least_squares") {
  // The leverages of all points sum to the number of coefficients.
  const Tree grid(saddle(2, 0.4, 0, 0.2, 0.01, 1));
  const uint32_t middle = position_in(*grid.tree, 12);
  const auto near = grid.near(middle, 25);
  const auto found = local_quadric(*grid.tree, middle, near);
  REQUIRE(found);
  double leverages = 0;
  for (const uint32_t n : near) {
    const auto terms = found->terms(grid.tree->local(n) - grid.tree->local(middle));
    for (size_t r = 0; r < 6; ++r)
      for (size_t c = 0; c < 6; ++c) leverages += terms[r] * found->cofactors[6 * r + c] * terms[c];
  }
  CHECK(leverages == doctest::Approx(6).epsilon(1e-9));
  double variance = 0;
  constexpr int kDraws = 200;
  for (uint64_t draw = 0; draw < kDraws; ++draw) {
    const Tree drawn(saddle(2, 0.4, 0, 0.2, 0.001, draw));
    const uint32_t at = position_in(*drawn.tree, 12);
    variance += std::pow(local_quadric(*drawn.tree, at, drawn.near(at, 25))->sigma_m, 2) / kDraws;
  }
  // Of 19 degrees of freedom a draw; along the normal, a few degrees off z in the mean.
  CHECK(variance ==
        doctest::Approx(1e-6).scale(0).epsilon(4 * std::sqrt(2.0 / (19 * kDraws)) + 0.01));
}

TEST_CASE("tangent_plane__of_a_ball_faces_its_centre_and_passes_through_the_point") {
  constexpr double kRadius_m = 0.5;
  const Tree ball(sphere(400, kRadius_m));
  for (uint32_t p = 0; p < 400; p += 7) {
    const Vec3 radial = normalized(ball.tree->cube().origin + ball.tree->local(p));
    const SurfacePlane plane = tangent_plane(*ball.tree, p, ball.near(p, 20), 0.001);
    REQUIRE(std::isfinite(plane.sigma_m));
    CHECK(plane.shape == SurfaceShape::kQuadric);
    // The radius of the neighbours is a fifth of the ball's: terms of third and fourth order are below a hundredth.
    CHECK(norm(cross(plane.unit(), radial)) < 0.01);
    CHECK(std::abs(plane.height_m) < 0.002 * kRadius_m);
  }
}

TEST_CASE("tangent_plane__is_none_where_points_are_few_in_a_strip_or_scatter") {
  const auto is_none = [](const Tree& tree, uint32_t position, uint32_t k, double most_m) {
    return std::isinf(tangent_plane(*tree.tree, position, tree.near(position, k), most_m).sigma_m);
  };
  const Tree ball(sphere(400, 0.5));
  CHECK_FALSE(is_none(ball, 50, 12, 0.01));
  CHECK(is_none(ball, 50, 11, 0.01));
  const Tree rough(saddle(2, 0, 0, 0, 0.01, 2));
  CHECK_FALSE(is_none(rough, 12, 25, 0.02));
  CHECK(is_none(rough, 12, 25, 0.005));
  std::vector<Vec3> strip;
  for (int i = 0; i < 40; ++i)
    for (int k = 0; k < 3; ++k) strip.push_back({0.1 * i, 0.04 * k, 0.002 * (i % 3)});
  CHECK(is_none(Tree(strip), 60, 24, 1));
}
