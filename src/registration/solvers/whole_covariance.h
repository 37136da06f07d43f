// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Dense>

#include "registration/solvers/joint_problem.h"

namespace jalon {

/// The covariance of all observations in the order (T_x, T_y, d_x, d_y, turns, o_f, o_s) from that of those before o_f:
/// the reduced form eliminates offsets, and here they come back. With y = -(h + A x), where A are the derivatives of a
/// facade's conditions and U the prior covariance of its offsets with what they sum to in each condition,
///
///   o = U V^-1 y,  Cov(o, x) = -U V^-1 A Cov(x),
///   Cov(o, o) = P - U V^-1 U^T (within a facade) + U V^-1 A Cov(x) A^T V^-1 U^T.
///
/// O(strips (strips + unknowns)).
Eigen::MatrixXd whole_covariance(const JointProblem& problem, const Eigen::MatrixXd& of_places);

}  // namespace jalon
