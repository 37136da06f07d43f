// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/ground/height_chain.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace jalon {

namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

struct BlockChain {
  std::vector<Matrix2d> diagonal, beside;  ///< beside[c]: from c to c + 1
  std::vector<Vector2d> right;
};

BlockChain normal_equations(const GaussMarkov& drive, const GaussMarkov& ground,
                            std::span<const GroundRise> rises) {
  const TridiagonalInformation z = information_of(drive), g = information_of(ground);
  BlockChain made;
  for (size_t c = 0; c < drive.size(); ++c) {
    made.diagonal.push_back(Vector2d(z.diagonal[c], g.diagonal[c]).asDiagonal());
    made.right.push_back(Vector2d::Zero());
    if (c + 1 < drive.size())
      made.beside.push_back(Vector2d(z.beside[c], g.beside[c]).asDiagonal());
  }
  const Matrix2d both = Matrix2d::Ones();
  for (const GroundRise& r : rises) {
    const double weight = 1 / variance_of(r, ground), before = 1 - r.share, behind = r.share;
    made.diagonal[r.interval] += weight * before * before * both;
    made.diagonal[r.interval + 1] += weight * behind * behind * both;
    made.beside[r.interval] += weight * before * behind * both;
    made.right[r.interval] += weight * before * r.rise_m * Vector2d::Ones();
    made.right[r.interval + 1] += weight * behind * r.rise_m * Vector2d::Ones();
  }
  return made;
}

}  // namespace

GaussMarkov ground_chain(std::span<const Vec3> controls, double sigma_m, double correlation_m) {
  constexpr double kLeastWay =
      1e-6;  // of the length: a vehicle that stands leaves no singular chain
  GaussMarkov made;
  made.sigmas_m.assign(controls.size(), sigma_m);
  for (size_t c = 0; c + 1 < controls.size(); ++c) {
    const Vec3 way = controls[c + 1] - controls[c];
    const double share = std::max(kLeastWay, std::hypot(way.x, way.y) / correlation_m);
    made.factors.push_back(std::exp(-share));
    made.innovations.push_back(-sigma_m * sigma_m * std::expm1(-2 * share));
  }
  return made;
}

// Over a way short beside the length the chain between its ends is a Brownian bridge of 2 sigma^2 / length a metre,
// and the mean of one has a twelfth of its way; over a long way ends tell nothing.
double variance_of(const GroundRise& rise, const GaussMarkov& ground) {
  const double sigma = ground.sigmas_m[rise.interval],
               way = -std::log(ground.factors[rise.interval]);  // over the length
  return rise.variance_m2 + sigma * sigma * std::min(1.0, way / 6);
}

HeightSolution solve_heights(const GaussMarkov& drive, const GaussMarkov& ground,
                             std::span<const GroundRise> rises) {
  BlockChain h = normal_equations(drive, ground, rises);
  const size_t n = h.diagonal.size();
  const std::vector<Vector2d> right = h.right;
  // 1. Forward: what is before c is eliminated from c.
  std::vector<Matrix2d> pivots{h.diagonal[0].inverse()}, gains;
  for (size_t c = 0; c + 1 < n; ++c) {
    gains.push_back(pivots[c] * h.beside[c]);
    const Matrix2d left = h.diagonal[c + 1] - h.beside[c].transpose() * gains[c];
    h.right[c + 1] -= gains[c].transpose() * h.right[c];
    pivots.push_back(((left + left.transpose()) / 2).inverse());
  }
  // 2. Back: values, and the blocks on the inverse's diagonal.
  std::vector<Vector2d> x(n);
  HeightSolution made;
  made.by_m.resize(n), made.sigmas_m.resize(n);
  Matrix2d covariance = Matrix2d::Zero();
  for (size_t c = n; c-- > 0;) {
    x[c] = pivots[c] * h.right[c];
    Matrix2d of = pivots[c];
    if (c + 1 < n) {
      x[c] -= gains[c] * x[c + 1];
      of += gains[c] * covariance * gains[c].transpose();
    }
    covariance = of;
    made.by_m[c] = x[c][0];
    made.sigmas_m[c] = std::sqrt(std::max(0.0, covariance(0, 0)));
  }
  // 3. The weighted square sum of the corrections.
  for (const GroundRise& r : rises) made.chi_square += r.rise_m * r.rise_m / variance_of(r, ground);
  for (size_t c = 0; c < n; ++c) made.chi_square -= right[c].dot(x[c]);
  return made;
}

}  // namespace jalon
