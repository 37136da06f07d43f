// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/similarity.h"

#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <vector>

#include "registration/targets/adjustment.h"
#include "unit/registration/target_scenes.h"

namespace jalon {
namespace {

using namespace test;

std::vector<PointPair> noisy_pairs(size_t n, const Transform& truth, double noise_m,
                                   RandomStream& random) {
  std::vector<PointPair> out;
  for (size_t i = 0; i < n; ++i) {
    const Vec3 m = within(10, random);
    out.push_back({truth.point(m) + within(noise_m, random), m});
  }
  return out;
}

// Horn (1987), by the largest eigenvector of his 4 x 4 matrix: another way to the same least squares.
Transform by_quaternion(const std::vector<PointPair>& pairs, bool with_scale) {
  Vec3 r, m;
  for (const PointPair& p : pairs) r += p.reference, m += p.moving;
  r *= 1.0 / static_cast<double>(pairs.size());
  m *= 1.0 / static_cast<double>(pairs.size());
  double s[3][3] = {}, moving = 0;
  for (const PointPair& p : pairs) {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) s[i][j] += (p.moving - m)[i] * (p.reference - r)[j];
    moving += squared_norm(p.moving - m);
  }
  Eigen::Matrix4d n;
  n << s[0][0] + s[1][1] + s[2][2], s[1][2] - s[2][1], s[2][0] - s[0][2], s[0][1] - s[1][0],  //
      s[1][2] - s[2][1], s[0][0] - s[1][1] - s[2][2], s[0][1] + s[1][0], s[2][0] + s[0][2],   //
      s[2][0] - s[0][2], s[0][1] + s[1][0], -s[0][0] + s[1][1] - s[2][2], s[1][2] + s[2][1],  //
      s[0][1] - s[1][0], s[2][0] + s[0][2], s[1][2] + s[2][1], -s[0][0] - s[1][1] + s[2][2];
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(n);
  const Eigen::Vector4d q = solver.eigenvectors().col(3);
  const double w = q(0), x = q(1), y = q(2), z = q(3);
  const double scale = with_scale ? solver.eigenvalues()(3) / moving : 1;
  Transform out;
  out.m = {w * w + x * x - y * y - z * z, 2 * (x * y - w * z),
           2 * (x * z + w * y),           0,
           2 * (x * y + w * z),           w * w - x * x + y * y - z * z,
           2 * (y * z - w * x),           0,
           2 * (x * z - w * y),           2 * (y * z + w * x),
           w * w - x * x - y * y + z * z, 0};
  for (double& c : out.m) c *= scale;
  const Vec3 t = r - out.direction(m);
  out.m[3] = t.x, out.m[7] = t.y, out.m[11] = t.z;
  return out;
}

double objective(std::span<const TargetPair> pairs, const Transform& pose) {
  double sum = 0;
  for (const TargetPair& p : pairs) {
    const auto& m = pose.m;
    Square<3> c = propagated<3, 3>({m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]},
                                   p.moving_covariance);
    for (size_t i = 0; i < 9; ++i) c[i] += p.reference_covariance[i];
    const Vec3 e = pose.point(p.moving) - p.reference;
    sum += squared_length<3>(c, {e.x, e.y, e.z});
  }
  return sum;
}

}  // namespace

TEST_CASE("similarity__equals_horns_quaternions") {
  for (uint64_t draw = 0; draw < 200; ++draw) {
    RandomStream random(21, draw);
    const bool with_scale = draw % 2 == 1;
    const auto pairs =
        noisy_pairs(3 + draw % 6, any_motion(random, with_scale ? 0.3 : 1), 0.05, random);
    const auto found = fit_similarity(pairs, with_scale);
    REQUIRE(found);
    const SimilarityFit& fit = *found;
    const Transform other = by_quaternion(pairs, with_scale);
    for (size_t i = 0; i < 12; ++i)
      CHECK(std::fabs(fit.T_reference_moving.m[i] - other.m[i]) < 1e-9);
    double squares = 0;
    for (const PointPair& p : pairs)
      squares += squared_norm(fit.T_reference_moving.point(p.moving) - p.reference);
    CHECK(squares == doctest::Approx(fit.squares_m2).scale(0).epsilon(1e-6));
    CHECK(fit.T_reference_moving.determinant() > 0);
  }
}

TEST_CASE("similarity__refuses_lines_and_pairs_of_points") {
  std::vector<PointPair> pairs;
  for (int i = 0; i < 5; ++i) {
    CHECK(!fit_similarity(pairs, false));
    const double t = i;
    pairs.push_back({{1 + t, 2 * t, 3 - t}, {t, t, t}});
  }
  CHECK(!fit_similarity(pairs, false));
}

TEST_CASE("target_adjustment__is_the_maximum_of_the_likelihood_with_errors_on_both_sides") {
  for (uint64_t draw = 0; draw < 20; ++draw) {
    RandomStream random(22, draw);
    const bool with_scale = draw % 2 == 1;
    const Transform truth = any_motion(random, with_scale ? 1.2 : 1);
    std::vector<TargetPair> pairs;
    std::vector<PointPair> places;
    for (int i = 0; i < 6; ++i) {
      const Vec3 m = within(10, random);
      TargetPair p{truth.point(m), m, along_ray({0, 1, 1}, 0.03, 0.01), along_ray(m, 0.05, 0.01)};
      p.reference += noise_of(p.reference_covariance, random);
      p.moving += noise_of(p.moving_covariance, random);
      pairs.push_back(p);
      places.push_back({p.reference, p.moving});
    }
    const std::optional<SimilarityFit> closed = fit_similarity(places, with_scale);
    REQUIRE(closed);
    const AdjustedTargets adjusted = adjust_targets(pairs, with_scale, closed->T_reference_moving);
    REQUIRE(adjusted.failure == AdjustmentFailure::kNone);
    const TargetAdjustment& out = adjusted.adjustment;
    CHECK(out.converged);
    const double best = objective(pairs, out.T_reference_moving);
    CHECK(best == doctest::Approx(out.weighted_squares).scale(0));
    CHECK(best <= objective(pairs, closed->T_reference_moving));
    const Vec3 from = inverse(out.T_reference_moving).point(out.centre);
    for (int unknown = 0; unknown < (with_scale ? 7 : 6); ++unknown) {
      // A tenth of a standard deviation either way: the slope is nothing against the curvature.
      const double sigma = std::sqrt(out.cofactor[static_cast<size_t>(8 * unknown)]);
      double sides[2];
      for (int side = 0; side < 2; ++side) {
        Coefficients<7> x{};
        x[static_cast<size_t>(unknown)] = (side == 0 ? -0.1 : 0.1) * sigma;
        Transform moved = motion_about(out.centre, {x[0], x[1], x[2]}, {x[3], x[4], x[5]}) *
                          out.T_reference_moving;
        for (size_t i = 0; i < 12; ++i)
          if (i % 4 != 3) moved.m[i] *= std::exp(x[6]);
        const Vec3 t = out.centre + Vec3{x[3], x[4], x[5]} - moved.direction(from);
        moved.m[3] = t.x, moved.m[7] = t.y, moved.m[11] = t.z;
        sides[side] = objective(pairs, moved) - best;
      }
      CHECK(sides[0] > 0);
      CHECK(sides[1] > 0);
      CHECK(std::fabs(sides[1] - sides[0]) < 0.01 * (sides[0] + sides[1]));
    }
  }
}

}  // namespace jalon
