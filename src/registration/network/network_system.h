// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <memory>

#include "registration/network/network_equations.h"

namespace jalon {

/// The equations of a network at values x of its unknowns: l = A dx + e, by groups of observations that are used.
struct NetworkLinearised {
  NetworkLinearised(const NetworkProblem& problem, const Eigen::VectorXd& x);

  struct Group {
    std::vector<uint32_t> members;  ///< of the group, those that are used
    Eigen::VectorXd residual;       ///< l
    Eigen::MatrixXd covariance, weight;
  };
  std::vector<SparseRow> rows;  ///< of all observations
  Eigen::VectorXd residual;     ///< of all observations
  std::vector<Group> groups;    ///< may be empty ones
};

/// The normal equations N dx = A^T P l. A constrained network by sparse Cholesky factors (Davis 2006); a free one with
/// the inner constraints B^T dx = 0 (Meissl 1969), dense: O(n^3), kMostFree unknowns.
class NetworkSystem {
 public:
  static constexpr int kMostFree = 6000;  // 288 MB

  /// Error(kDegenerate) names a point that the network does not hold.
  NetworkSystem(const NetworkProblem& problem, const NetworkLinearised& equations);

  Eigen::VectorXd step() const { return solve(right_); }
  /// N^-1 b, of a free network its inverse under the inner constraints. Any thread.
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
  /// Inner constraints: what no observation tells of a free network.
  int defect() const { return static_cast<int>(constraints_.cols()); }

 private:
  void factor_sparse(const NetworkProblem& problem);
  void factor_free(const NetworkProblem& problem);

  Eigen::SparseMatrix<double> normal_;
  Eigen::VectorXd right_;
  Eigen::MatrixXd constraints_;  ///< B
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> sparse_;
  Eigen::LDLT<Eigen::MatrixXd> dense_;
  Eigen::MatrixXd reached_, held_;  ///< M^-1 B and (B^T M^-1 B)^-1
};

}  // namespace jalon
