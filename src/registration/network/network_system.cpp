// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/network/network_system.h"

#include <algorithm>

#include "base/error.h"

namespace jalon {

namespace {

using Index = Eigen::Index;

// A pivot that is this small a share of its diagonal element is rounding: nothing holds that unknown.
constexpr double kPivotShare = 1e-11;

[[noreturn]] void refuse(const NetworkProblem& problem, Index unknown) {
  const NetworkUnknowns& u = problem.unknowns;
  for (size_t p = 0; p < u.points.size(); ++p)
    for (size_t axis = 0; axis < 3; ++axis)
      if (u.points[p][axis] == unknown)
        fail(Status::kDegenerate,
             "nothing holds the %s of point %.40s: fixed or weak points, or more sights, are "
             "missing",
             axis < 2 ? "place" : "height", problem.survey.points[p].id.c_str());
  for (size_t i = 0; i < u.orientations.size(); ++i)
    if (u.orientations[i] == unknown)
      fail(Status::kDegenerate,
           "nothing holds the orientation of the instrument on point %.40s: a second fixed or "
           "weak point is missing",
           problem.survey.points[problem.survey.setups[i].station].id.c_str());
  fail(Status::kDegenerate, "nothing holds the network");
}

bool has_distances(const NetworkProblem& problem) {
  return std::any_of(problem.observations.begin(), problem.observations.end(),
                     [](const NetworkObservation& o) {
                       return o.kind == ObservationKind::kDistance && o.is_used;
                     });
}

// B: shifts along the axes, a turn about the vertical and, without distances, a change of size, about the centre of
// all points; columns of length 1.
Eigen::MatrixXd inner_constraints(const NetworkProblem& problem) {
  const auto& points = problem.survey.points;
  Vec3 centre;
  for (const SurveyPoint& p : points) centre += p.position;
  centre *= 1 / static_cast<double>(points.size());
  Eigen::MatrixXd b = Eigen::MatrixXd::Zero(problem.unknowns.count, has_distances(problem) ? 4 : 5);
  for (size_t p = 0; p < points.size(); ++p) {
    const auto& at = problem.unknowns.points[p];
    const Vec3 d = points[p].position - centre;
    for (int axis = 0; axis < 3; ++axis) b(at[static_cast<size_t>(axis)], axis) = 1;
    b(at[0], 3) = d.y, b(at[1], 3) = -d.x;
    if (b.cols() == 5) b(at[0], 4) = d.x, b(at[1], 4) = d.y, b(at[2], 4) = d.z;
  }
  b.colwise().normalize();
  return b;
}

// Column by column: Eigen's products and solutions of whole matrices are cut by the size of the machine's caches, and
// the last bits with them.
Eigen::MatrixXd inverse_of(const Eigen::MatrixXd& m) {
  const Eigen::LDLT<Eigen::MatrixXd> factors(m);
  Eigen::MatrixXd out(m.rows(), m.cols());
  for (Index i = 0; i < m.cols(); ++i)
    out.col(i) = factors.solve(Eigen::VectorXd(Eigen::VectorXd::Unit(m.rows(), i)));
  return out;
}

}  // namespace

NetworkLinearised::NetworkLinearised(const NetworkProblem& problem, const Eigen::VectorXd& x)
    : rows(problem.observations.size()), residual(static_cast<Index>(rows.size())) {
  for (size_t i = 0; i < rows.size(); ++i)
    residual[static_cast<Index>(i)] = problem.residual(problem.observations[i], x, rows[i]);
  for (const ObservationGroup& group : problem.groups) {
    Group made;
    ObservationGroup used;
    for (const uint32_t i : group.members)
      if (problem.observations[i].is_used) used.members.push_back(i);
    made.members = used.members;
    made.covariance = problem.covariance(used, x);
    made.residual.resize(static_cast<Index>(used.members.size()));
    for (size_t k = 0; k < used.members.size(); ++k)
      made.residual[static_cast<Index>(k)] = residual[static_cast<Index>(used.members[k])];
    made.weight = inverse_of(made.covariance);
    groups.push_back(std::move(made));
  }
}

NetworkSystem::NetworkSystem(const NetworkProblem& problem, const NetworkLinearised& equations) {
  const Index n = problem.unknowns.count;
  std::vector<Eigen::Triplet<double>> triplets;
  right_ = Eigen::VectorXd::Zero(n);
  for (Index i = 0; i < n; ++i) triplets.emplace_back(static_cast<int>(i), static_cast<int>(i), 0);
  for (const auto& group : equations.groups) {
    const Eigen::VectorXd weighted = group.weight * group.residual;
    for (size_t i = 0; i < group.members.size(); ++i) {
      const SparseRow& a = equations.rows[group.members[i]];
      for (size_t k = 0; k < a.count; ++k)
        right_[a.entries[k].first] += a.entries[k].second * weighted[static_cast<Index>(i)];
      for (size_t j = 0; j < group.members.size(); ++j) {
        const SparseRow& b = equations.rows[group.members[j]];
        const double weight = group.weight(static_cast<Index>(i), static_cast<Index>(j));
        for (size_t k = 0; k < a.count; ++k)
          for (size_t m = 0; m < b.count; ++m)
            triplets.emplace_back(a.entries[k].first, b.entries[m].first,
                                  weight * a.entries[k].second * b.entries[m].second);
      }
    }
  }
  normal_.resize(n, n);
  normal_.setFromTriplets(triplets.begin(), triplets.end());
  if (problem.is_free) factor_free(problem);
  else factor_sparse(problem);
}

void NetworkSystem::factor_sparse(const NetworkProblem& problem) {
  if (normal_.rows() == 0) return;
  sparse_.compute(normal_);
  const Eigen::VectorXd pivots = sparse_.vectorD();
  for (Index i = 0; i < pivots.size(); ++i) {
    const Index unknown = sparse_.permutationPinv().indices()[i];
    if (!(pivots[i] > kPivotShare * normal_.coeff(unknown, unknown))) refuse(problem, unknown);
  }
}

// With M = N + s B B^T, which is positive definite, the bordered equations [N B; B^T 0] have the solution
// M^-1 b - M^-1 B (B^T M^-1 B)^-1 B^T M^-1 b; s is the size of N.
void NetworkSystem::factor_free(const NetworkProblem& problem) {
  const Index n = normal_.rows();
  if (n > kMostFree)
    fail(Status::kUnsupported, "a free network of %zu unknowns: at most %d", static_cast<size_t>(n),
         kMostFree);
  constraints_ = inner_constraints(problem);
  Eigen::MatrixXd whole(normal_);
  const Eigen::VectorXd diagonal = whole.diagonal();
  whole += diagonal.mean() * constraints_.lazyProduct(constraints_.transpose());
  dense_.compute(whole);
  const Eigen::VectorXd pivots = dense_.vectorD();
  if (!(pivots.minCoeff() > kPivotShare * diagonal.minCoeff()))
    fail(Status::kDegenerate, "a free network of parts that no sight joins, or of too few sights");
  reached_.resize(n, constraints_.cols());
  for (Index i = 0; i < constraints_.cols(); ++i)
    reached_.col(i) = dense_.solve(Eigen::VectorXd(constraints_.col(i)));
  held_ = inverse_of(constraints_.transpose().lazyProduct(reached_));
}

Eigen::VectorXd NetworkSystem::solve(const Eigen::VectorXd& b) const {
  if (b.size() == 0) return b;
  if (constraints_.cols() == 0) return sparse_.solve(b);
  const Eigen::VectorXd x = dense_.solve(b);
  const Eigen::VectorXd broken = constraints_.transpose() * x;
  const Eigen::VectorXd forces = held_ * broken;
  return x - reached_ * forces;
}

}  // namespace jalon
