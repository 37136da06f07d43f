// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// What noise of the points puts into the normal equations, against points that are moved one by one.

#include <doctest/doctest.h>

#include <cmath>

#include "registration/icp/influence.h"
#include "unit/registration/icp_problems.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr uint32_t kNear = 8;
constexpr double kSmall_m = 5e-4;          // noise; points are 0.2 m apart
constexpr double kInfluenceStep_m = 1e-4;  // what points are moved by

// Two sheets that do not meet.
std::vector<Vec3> two_sheets(uint64_t seed) {
  RandomStream random(seed, 0);
  auto out = noisy_sheet({0.3, 0.3, 0.4}, {0.2, 0, 0.03}, {0, 0.2, 0.05}, 5, 5, kSmall_m, random);
  const auto wall =
      noisy_sheet({3.3, 0.3, 0.5}, {0.02, 0.2, 0}, {0.05, 0, 0.2}, 5, 5, kSmall_m, random);
  out.insert(out.end(), wall.begin(), wall.end());
  return out;
}

// Both clouds where they lie, with partners that stay the same points whatever order the trees have.
struct Laid {
  IcpProblem problem;
  IcpNeighbours neighbours;
  Transform T_reference_moving;
  IcpLevel all;
  PairRule rule{IcpMetric::kPointToPlane, 1, 10, 0, kNear};
  IcpFrame frame{{1, 2, 0.5}, 2};

  Laid(const std::vector<Vec3>& reference, const std::vector<Vec3>& moving)
      : problem(problem_between(cloud_of(reference), cloud_of(moving), {.k = kNear})) {
    problem.clouds.reference.flat_m = problem.clouds.moving.flat_m = 1;
    T_reference_moving = problem.clouds.to_local({});
    const Octree &r = *problem.clouds.reference.tree, &m = *problem.clouds.moving.tree;
    std::vector<uint32_t> forth, back;
    // The next point of the row, so that planes are met beside their points.
    const auto partner = [](uint32_t i) { return i % 5 == 4 ? i : i + 1; };
    for (const uint32_t i : m.order()) forth.push_back(position_in(r, partner(i)));
    for (const uint32_t i : r.order()) back.push_back(position_in(m, partner(i)));
    neighbours = {positions_of(forth), positions_of(back)};
  }
  IcpPairing pairing() const { return {problem.clouds, all, neighbours, rule, T_reference_moving}; }
  Coefficients<6> right() const {
    Task task;
    return icp_sums(pairing(), {KernelKind::kNone, 1}, frame, task).right;
  }
};

// Adds sigma^2 b b^T, b the change of the right-hand side for a metre along the normal of each point.
void add_squares_of(const Laid& laid, const std::vector<Vec3>& reference,
                    const std::vector<Vec3>& moving, bool of_moving, Square<6>& sum) {
  const SurfacePlanes& planes =
      of_moving ? laid.problem.clouds.moving : laid.problem.clouds.reference;
  for (uint32_t i = 0; i < reference.size(); ++i) {
    const SurfacePlane& plane = planes.planes[position_in(*planes.tree, i)];
    Coefficients<6> sides[2];
    for (const int side : {0, 1}) {
      std::vector<Vec3> r = reference, m = moving;
      (of_moving ? m : r)[i] += plane.unit() * (side == 0 ? -kInfluenceStep_m : kInfluenceStep_m);
      sides[side] = Laid(r, m).right();
    }
    const double sigma = plane.sigma_m;
    for (size_t a = 0; a < 6; ++a)
      for (size_t c = 0; c < 6; ++c)
        sum[6 * a + c] += sigma * sigma * (sides[1][a] - sides[0][a]) *
                          (sides[1][c] - sides[0][c]) / (4 * kInfluenceStep_m * kInfluenceStep_m);
  }
}

}  // namespace

TEST_CASE("icp_influence__is_what_moving_every_point_does_to_the_normal_equations") {
  const auto reference = two_sheets(71), moving = two_sheets(72);
  const Laid laid(reference, moving);
  Task task;
  const Square<6> found = icp_influence(laid.pairing(), laid.frame, kNear, task);
  Square<6> expected{};
  add_squares_of(laid, reference, moving, false, expected);
  add_squares_of(laid, reference, moving, true, expected);
  for (size_t a = 0; a < 6; ++a)
    for (size_t c = 0; c < 6; ++c) {
      const double size = std::sqrt(expected[7 * a] * expected[7 * c]);
      // Normals turn with the points: by noise over the extent of eight points, 1 %, of either sign.
      CHECK(std::abs(found[6 * a + c] - expected[6 * a + c]) < 0.02 * size);
      CHECK(found[6 * a + c] == doctest::Approx(found[6 * c + a]).scale(size).epsilon(1e-9));
    }
}

TEST_CASE("icp_influence__grows_with_the_variance_of_the_points_and_is_nothing_without_pairs") {
  Laid laid(two_sheets(73), two_sheets(74));
  SurfacePlanes* const both[] = {&laid.problem.clouds.reference, &laid.problem.clouds.moving};
  for (SurfacePlanes* planes : both)
    for (SurfacePlane& plane : planes->planes) plane.shape = SurfaceShape::kPlane;
  Task task;
  const Square<6> once = icp_influence(laid.pairing(), laid.frame, kNear, task);
  for (SurfacePlanes* planes : both) {
    planes->noise_m *= 2;  // of points without a plane
    for (SurfacePlane& plane : planes->planes) plane.sigma_m *= 2;
  }
  const Square<6> twice = icp_influence(laid.pairing(), laid.frame, kNear, task);
  for (size_t i = 0; i < 36; ++i) CHECK(twice[i] == 4 * once[i]);
  laid.rule.most_m = 0;
  CHECK(icp_influence(laid.pairing(), laid.frame, kNear, task) == Square<6>{});
}
