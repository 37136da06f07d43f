// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "base/error.h"
#include "registration/solvers/facade_strips.h"
#include "registration/solvers/joint_problem.h"

// The adjustment as its text has it, to hold the reduced form against: l^ = C B (B^T C B)^-1 c and
// C_l^ = C - C B (B^T C B)^-1 B^T C with all observations. O(strips^3).
namespace jalon {

namespace dense {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Behind trajectory, blocks and turns stand facades, then strips.
struct DenseOrder : JointOrder {
  size_t facades, strips;
  Index facade(size_t f) const { return static_cast<Index>(JointOrder::size() + f); }
  Index strip(size_t s) const { return static_cast<Index>(JointOrder::size() + facades + s); }
  Index all() const { return static_cast<Index>(JointOrder::size() + facades + strips); }
};

inline MatrixXd prior_covariance(const JointProblem& problem, const DenseOrder& at) {
  MatrixXd C = MatrixXd::Zero(at.all(), at.all());
  for (size_t i = 0; i < at.controls; ++i)
    for (size_t j = 0; j < at.controls; ++j) {
      C(static_cast<Index>(at.tx(i)), static_cast<Index>(at.tx(j))) = problem.x.covariance(i, j);
      C(static_cast<Index>(at.ty(i)), static_cast<Index>(at.ty(j))) = problem.y.covariance(i, j);
    }
  const auto set = [&](Index i, double sigma) { C(i, i) = sigma * sigma; };
  for (size_t b = 0; b < at.blocks; ++b) {
    set(static_cast<Index>(at.dx(b)), problem.sigma_block_x_m);
    set(static_cast<Index>(at.dy(b)), problem.sigma_block_y_m);
  }
  for (size_t k = 0; k < at.turns; ++k)
    set(static_cast<Index>(at.turn(k)), problem.sigma_attitude_rad[k]);
  for (uint32_t f = 0; f < at.facades; ++f)
    set(at.facade(f), std::sqrt(problem.facade_variance_m2(f)));
  for (size_t s = 0; s < at.strips; ++s) set(at.strip(s), problem.sigma_strip_m);
  if (!(problem.strip_correlation_m > 0)) return C;
  const double strip_m2 = problem.sigma_strip_m * problem.sigma_strip_m;
  for (size_t s = 0; s < at.strips; ++s)
    for (size_t t = 0; t < at.strips; ++t)
      if (problem.strips[s].facade == problem.strips[t].facade)
        C(at.strip(s), at.strip(t)) =
            strip_m2 * strip_correlation(problem, problem.strips[s], problem.strips[t]);
  return C;
}

// A column a strip, and two a control point behind them: v - sum w T = 0.
inline MatrixXd conditions(const JointProblem& problem, const DenseOrder& at) {
  MatrixXd B = MatrixXd::Zero(at.all(), static_cast<Index>(problem.conditions()));
  for (size_t s = 0; s < at.strips; ++s) {
    const StripCondition& strip = problem.strips[s];
    const auto column = static_cast<Index>(s);
    for (const auto& [control, share] : strip.shares) {
      B(static_cast<Index>(at.tx(control)), column) -= share * strip.normal.u;
      B(static_cast<Index>(at.ty(control)), column) -= share * strip.normal.v;
    }
    B(static_cast<Index>(at.dx(strip.block)), column) = strip.normal.u;
    B(static_cast<Index>(at.dy(strip.block)), column) = strip.normal.v;
    for (size_t k = 0; k < at.turns; ++k)
      B(static_cast<Index>(at.turn(k)), column) = strip.turns_m[k];
    B(at.facade(strip.facade), column) = 1;
    B(at.strip(s), column) = 1;
  }
  auto column = static_cast<Index>(at.strips);
  for (const ControlCondition& point : problem.control_points) {
    for (const auto& [control, share] : point.shares) {
      B(static_cast<Index>(at.tx(control)), column) = -share;
      B(static_cast<Index>(at.ty(control)), column + 1) = -share;
    }
    column += 2;
  }
  return B;
}

inline VectorXd misclosures(const JointProblem& problem) {
  VectorXd c(static_cast<Index>(problem.conditions()));
  Index at = 0;
  for (const StripCondition& strip : problem.strips) c[at++] = -strip.distance_m;
  for (const ControlCondition& point : problem.control_points)
    c[at++] = -point.correction_m.u, c[at++] = -point.correction_m.v;
  return c;
}
inline double measured_variance_m2(const JointProblem& problem, Index condition) {
  const auto i = static_cast<size_t>(condition), strips = problem.strips.size();
  if (i < strips) return problem.strips[i].measured_variance_m2;
  const double sigma = problem.control_points[(i - strips) / 2].sigma_m;
  return sigma * sigma;
}

}  // namespace dense

inline JointSolution solve_dense(const JointProblem& problem) {
  using namespace dense;
  validate(problem);
  const DenseOrder at{order_of(problem), problem.facades, problem.strips.size()};
  const MatrixXd C = prior_covariance(problem, at), B = conditions(problem, at);
  const MatrixXd CB = C * B;
  MatrixXd BCB = B.transpose() * CB;
  const VectorXd c = misclosures(problem);
  for (Index i = 0; i < c.size(); ++i) BCB(i, i) += measured_variance_m2(problem, i);
  const Eigen::LDLT<MatrixXd> factor(BCB);
  if (factor.info() != Eigen::Success || !(factor.vectorD().minCoeff() > 0))
    fail(Status::kDegenerate, "the conditions of the strips contradict each other");
  const VectorXd k = factor.solve(c), l = CB * k;
  MatrixXd solved(CB.cols(), CB.rows());
  for (Index i = 0; i < CB.rows(); ++i) {
    const VectorXd row = CB.row(i).transpose();
    solved.col(i) = factor.solve(row);
  }
  const MatrixXd posterior = C - CB * solved;
  const VectorXd sigmas = posterior.diagonal().cwiseMax(0).cwiseSqrt();
  JointSolution made;
  made.chi_square = c.dot(k);
  const auto n = static_cast<Index>(at.JointOrder::size());
  made.covariance = posterior.topLeftCorner(n, n);
  made.whole_covariance = posterior;
  const auto pair = [](const VectorXd& v, size_t i, size_t j) {
    return Vec2{v[static_cast<Index>(i)], v[static_cast<Index>(j)]};
  };
  for (size_t i = 0; i < at.controls; ++i) {
    made.trajectory.push_back(pair(l, at.tx(i), at.ty(i)));
    made.trajectory_sigmas.push_back(pair(sigmas, at.tx(i), at.ty(i)));
  }
  for (size_t b = 0; b < at.blocks; ++b) {
    made.blocks.push_back(pair(l, at.dx(b), at.dy(b)));
    made.blocks_sigmas.push_back(pair(sigmas, at.dx(b), at.dy(b)));
  }
  for (int axis = 0; axis < static_cast<int>(at.turns); ++axis) {
    const auto i = static_cast<Index>(at.turn(static_cast<size_t>(axis)));
    made.attitude_rad[axis] = l[i], made.attitude_sigmas_rad[axis] = sigmas[i];
  }
  made.facade_pulls.assign(at.facades, 0);
  for (size_t s = 0; s < at.strips; ++s)
    made.facade_pulls[problem.strips[s].facade] += k[static_cast<Index>(s)];
  for (size_t f = 0; f < at.facades; ++f) {
    made.facades.push_back(l[at.facade(f)]);
    made.facades_sigmas.push_back(sigmas[at.facade(f)]);
  }
  for (size_t s = 0; s < at.strips; ++s) {
    made.strips.push_back(l[at.strip(s)]);
    made.strips_sigmas.push_back(sigmas[at.strip(s)]);
  }
  return made;
}

}  // namespace jalon
