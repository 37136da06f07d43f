// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <optional>

#include "base/error.h"
#include "registration/solvers/facade_strips.h"
#include "registration/solvers/joint_problem.h"
#include "registration/solvers/sparse_inverse.h"
#include "registration/solvers/whole_covariance.h"

namespace jalon {

namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;
using Triplets = std::vector<Eigen::Triplet<double, Eigen::Index>>;
using Index = Eigen::Index;

struct RowElement {
  Index column;
  double value;
};

// The row of a strip: derivatives of its condition by T_x, T_y and, in units of their own sigmas so that a sigma of 0
// leaves no singular matrix, by d_x, d_y and the turns.
std::vector<RowElement> row_of(const StripCondition& strip, const JointProblem& problem,
                               const JointOrder& at) {
  std::vector<RowElement> row;
  for (const auto& [control, share] : strip.shares) {
    row.push_back({static_cast<Index>(at.tx(control)), -share * strip.normal.u});
    row.push_back({static_cast<Index>(at.ty(control)), -share * strip.normal.v});
  }
  row.push_back({static_cast<Index>(at.dx(strip.block)), strip.normal.u * problem.sigma_block_x_m});
  row.push_back({static_cast<Index>(at.dy(strip.block)), strip.normal.v * problem.sigma_block_y_m});
  for (size_t k = 0; k < at.turns; ++k)
    row.push_back(
        {static_cast<Index>(at.turn(k)), strip.turns_m[k] * problem.sigma_attitude_rad[k]});
  return row;
}

void add_prior(const JointProblem& problem, const JointOrder& at, Triplets& into) {
  const auto chain = [&](const GaussMarkov& of, size_t first) {
    const TridiagonalInformation made = information_of(of);
    for (size_t c = 0; c < made.diagonal.size(); ++c) {
      const auto i = static_cast<Index>(first + c);
      into.push_back({i, i, made.diagonal[c]});
      if (c + 1 == made.diagonal.size()) continue;
      into.push_back({i + 1, i, made.beside[c]});
      into.push_back({i, i + 1, made.beside[c]});
    }
  };
  chain(problem.x, at.tx(0));
  chain(problem.y, at.ty(0));
  for (auto i = static_cast<Index>(at.dx(0)); i < static_cast<Index>(at.size()); ++i)
    into.push_back({i, i, 1});
}

class ReducedSolver {
 public:
  explicit ReducedSolver(const JointProblem& problem)
      : problem_(problem), at_(order_of(problem)), facades_(strips_by_facade(problem)) {
    for (const StripCondition& strip : problem.strips) rows_.push_back(row_of(strip, problem, at_));
    factorise();
  }

  JointSolution solve(JointWanted wanted) {
    JointSolution made;
    made.facades.assign(problem_.facades, 0);
    made.facade_pulls.assign(problem_.facades, 0);
    for (uint32_t f = 0; f < problem_.facades; ++f)
      made.facades_sigmas.push_back(std::sqrt(problem_.facade_variance_m2(f)));
    made.strips.assign(problem_.strips.size(), 0);
    made.strips_sigmas.assign(problem_.strips.size(), problem_.sigma_strip_m);
    const Eigen::VectorXd x = factor_.solve(right_side_);
    made.chi_square = distances_square_ - right_side_.dot(x);
    for (const FacadeStrips& f : facades_) offsets_of(f, x, made);
    place(x, made);
    if (wanted == JointWanted::kValues) return made;
    inverse_.emplace(factor_);
    const Eigen::VectorXd variances = variances_of(wanted, made);
    place_sigmas(variances, made);
    for (const FacadeStrips& f : facades_) sigmas_of(f, made);
    if (wanted == JointWanted::kWhole)
      made.whole_covariance = whole_covariance(problem_, made.covariance);
    return made;
  }

 private:
  // H = C^-1 + sum A^T V^-1 A and -sum A^T V^-1 h, facade by facade.
  void factorise() {
    Triplets elements;
    add_prior(problem_, at_, elements);
    right_side_ = Eigen::VectorXd::Zero(static_cast<Index>(at_.size()));
    for (const ControlCondition& point : problem_.control_points)
      add_control_point(point, elements);
    for (const FacadeStrips& f : facades_) {
      std::vector<double> h;
      for (const uint32_t s : f.strips) h.push_back(problem_.strips[s].distance_m);
      const std::vector<double> weighted_h = f.weighted(h);
      for (size_t i = 0; i < f.strips.size(); ++i) {
        distances_square_ += h[i] * weighted_h[i];
        for (const RowElement& a : rows_[f.strips[i]])
          right_side_[a.column] -= a.value * weighted_h[i];
      }
      if (f.is_correlated()) add_correlated(f, elements);
      else add_independent(f, elements);
    }
    SparseMatrix H(static_cast<Index>(at_.size()), static_cast<Index>(at_.size()));
    H.setFromTriplets(elements.begin(), elements.end());
    factor_.compute(H);
    if (factor_.info() != Eigen::Success || !(factor_.vectorD().minCoeff() > 0))
      fail(Status::kDegenerate,
           "the normal equations of trajectory and blocks are singular: is a sigma 0?");
  }

  void add_control_point(const ControlCondition& point, Triplets& elements) {
    const double weight = 1 / (point.sigma_m * point.sigma_m);
    const auto axis = [&](double correction, size_t first) {
      distances_square_ += weight * correction * correction;
      for (const auto& [a, share] : point.shares) {
        right_side_[static_cast<Index>(first + a)] += weight * share * correction;
        for (const auto& [b, other] : point.shares)
          elements.push_back({static_cast<Index>(first + a), static_cast<Index>(first + b),
                              weight * share * other});
      }
    };
    axis(point.correction_m.u, at_.tx(0));
    axis(point.correction_m.v, at_.ty(0));
  }

  // A^T D^-1 A strip by strip, less the facade's own outer product.
  void add_independent(const FacadeStrips& f, Triplets& elements) const {
    std::vector<RowElement> total;  // sum of rows / D
    for (size_t i = 0; i < f.strips.size(); ++i) {
      const std::vector<RowElement>& row = rows_[f.strips[i]];
      for (const RowElement& a : row)
        for (const RowElement& b : row)
          elements.push_back({a.column, b.column, f.inverse_d[i] * a.value * b.value});
      add_to(total, row, f.inverse_d[i]);
    }
    for (const RowElement& a : total)
      for (const RowElement& b : total)
        elements.push_back({a.column, b.column, -f.weight * a.value * b.value});
  }
  void add_correlated(const FacadeStrips& f, Triplets& elements) const {
    for (size_t i = 0; i < f.strips.size(); ++i) {
      const std::vector<RowElement> weighted =
          mixed(f, f.inverse.row(static_cast<Index>(i)).transpose());
      for (const RowElement& a : rows_[f.strips[i]])
        for (const RowElement& b : weighted)
          elements.push_back({a.column, b.column, a.value * b.value});
    }
  }
  // Sum of the rows of a facade's strips, each so many times.
  std::vector<RowElement> mixed(const FacadeStrips& f, const Eigen::VectorXd& times) const {
    std::vector<RowElement> made;
    for (size_t i = 0; i < f.strips.size(); ++i)
      add_to(made, rows_[f.strips[i]], times[static_cast<Index>(i)]);
    return made;
  }

  static void add_to(std::vector<RowElement>& sum, const std::vector<RowElement>& row,
                     double factor) {
    for (const RowElement& element : row) {
      auto same = std::find_if(sum.begin(), sum.end(),
                               [&](const RowElement& e) { return e.column == element.column; });
      if (same == sum.end()) sum.push_back({element.column, factor * element.value});
      else same->value += factor * element.value;
    }
  }

  // Two unknowns of one facade have an element in the normal equations, and so in this inverse.
  double variance_along(const std::vector<RowElement>& row) const {
    double sum = 0;
    for (const RowElement& a : row) {
      sum += a.value * a.value * inverse_->at(a.column, a.column);
      for (const RowElement& b : row)
        if (b.column < a.column) sum += 2 * a.value * b.value * inverse_->at(a.column, b.column);
    }
    return sum;
  }

  // Back from trajectory and blocks to the facade and its strips: given these, the offsets follow from
  // y = -(h + A x) by o_f = sigma_f^2 1^T V^-1 y, o_s = S V^-1 y.
  void offsets_of(const FacadeStrips& f, const Eigen::VectorXd& x, JointSolution& made) const {
    if (f.strips.empty()) return;
    std::vector<double> y;
    for (const uint32_t s : f.strips) {
      double sum = problem_.strips[s].distance_m;
      for (const RowElement& e : rows_[s]) sum += e.value * x[e.column];
      y.push_back(-sum);
    }
    const std::vector<double> v = f.weighted(y);
    double v_sum = 0;
    for (size_t i = 0; i < v.size(); ++i) {
      v_sum += v[i];
      made.strips[f.strips[i]] = f.is_correlated() ? dot_of_row(f.prior, i, v) : strip_m2() * v[i];
    }
    const uint32_t facade = problem_.strips[f.strips[0]].facade;
    made.facade_pulls[facade] = v_sum;
    made.facades[facade] = problem_.facade_variance_m2(facade) * v_sum;
  }
  double strip_m2() const { return problem_.sigma_strip_m * problem_.sigma_strip_m; }
  static double dot_of_row(const Eigen::MatrixXd& m, size_t row, const std::vector<double>& v) {
    double sum = 0;
    for (size_t j = 0; j < v.size(); ++j)
      sum += m(static_cast<Index>(row), static_cast<Index>(j)) * v[j];
    return sum;
  }

  // What is left of the prior of a facade and its strips, and what the uncertainty of x brings along.
  void sigmas_of(const FacadeStrips& f, JointSolution& made) const {
    if (f.strips.empty()) return;
    if (f.is_correlated()) return sigmas_of_correlated(f, made);
    const uint32_t facade = problem_.strips[f.strips[0]].facade;
    const double facade_m2 = problem_.facade_variance_m2(facade), strip_m2 = this->strip_m2();
    std::vector<RowElement> total;
    for (size_t i = 0; i < f.strips.size(); ++i) add_to(total, rows_[f.strips[i]], f.inverse_d[i]);
    // 1^T V^-1 = (1 - weight sum) / D.
    const double left = 1 - f.weight * f.sum;
    const double of_prior = facade_m2 - facade_m2 * facade_m2 * left * f.sum;
    made.facades_sigmas[facade] = std::sqrt(
        std::max(0.0, of_prior + facade_m2 * facade_m2 * left * left * variance_along(total)));
    for (size_t i = 0; i < f.strips.size(); ++i) {
      const uint32_t s = f.strips[i];
      const double d = f.inverse_d[i], diagonal = d * (1 - f.weight * d);
      // Row of V^-1 A: (row_s - weight total) / D_s.
      std::vector<RowElement> row;
      add_to(row, rows_[s], d);
      add_to(row, total, -f.weight * d);
      made.strips_sigmas[s] =
          std::sqrt(std::max(0.0, strip_m2 - strip_m2 * strip_m2 * diagonal +
                                      strip_m2 * strip_m2 * variance_along(row)));
    }
  }
  // S - S V^-1 S + (S V^-1 A) H^-1 (S V^-1 A)^T, and the same with sigma_f^2 1^T for S.
  void sigmas_of_correlated(const FacadeStrips& f, JointSolution& made) const {
    const auto n = static_cast<Index>(f.strips.size());
    const uint32_t facade = problem_.strips[f.strips[0]].facade;
    const double facade_m2 = problem_.facade_variance_m2(facade);
    const auto sigma = [&](double prior, const Eigen::VectorXd& with) {
      const Eigen::VectorXd weights = f.inverse.lazyProduct(with);
      return std::sqrt(
          std::max(0.0, prior - with.dot(weights) + variance_along(mixed(f, weights))));
    };
    made.facades_sigmas[facade] = sigma(facade_m2, Eigen::VectorXd::Constant(n, facade_m2));
    for (Index i = 0; i < n; ++i)
      made.strips_sigmas[f.strips[static_cast<size_t>(i)]] = sigma(f.prior(i, i), f.prior.col(i));
  }

  Eigen::VectorXd variances_of(JointWanted wanted, JointSolution& made) const {
    const auto n = static_cast<Index>(at_.size());
    if (wanted == JointWanted::kCovariance || wanted == JointWanted::kWhole) {
      made.covariance = factor_.solve(Eigen::MatrixXd::Identity(n, n));
      for (Index i = 0; i < n; ++i) {
        made.covariance.row(i) *= unit_of(i);
        made.covariance.col(i) *= unit_of(i);
      }
    }
    Eigen::VectorXd variances(n);
    for (Index i = 0; i < n; ++i) variances[i] = inverse_->at(i, i);
    return variances;
  }

  // What an unknown is counted in.
  double unit_of(Index unknown) const {
    const auto i = static_cast<size_t>(unknown);
    if (i >= at_.turn(0)) return problem_.sigma_attitude_rad[i - at_.turn(0)];
    if (i >= at_.dy(0)) return problem_.sigma_block_y_m;
    return i >= at_.dx(0) ? problem_.sigma_block_x_m : 1;
  }
  double value_of(const Eigen::VectorXd& v, size_t i) const {
    const auto at = static_cast<Index>(i);
    return unit_of(at) * v[at];
  }
  Vec2 pair(const Eigen::VectorXd& v, size_t i, size_t j) const {
    return {value_of(v, i), value_of(v, j)};
  }
  Vec3 turns_of(const Eigen::VectorXd& v) const {
    Vec3 made;
    for (int k = 0; k < static_cast<int>(at_.turns); ++k)
      made[k] = value_of(v, at_.turn(static_cast<size_t>(k)));
    return made;
  }
  void place(const Eigen::VectorXd& x, JointSolution& made) const {
    for (size_t c = 0; c < at_.controls; ++c)
      made.trajectory.push_back(pair(x, at_.tx(c), at_.ty(c)));
    for (size_t b = 0; b < at_.blocks; ++b) made.blocks.push_back(pair(x, at_.dx(b), at_.dy(b)));
    made.attitude_rad = turns_of(x);
  }
  void place_sigmas(const Eigen::VectorXd& variances, JointSolution& made) const {
    const Eigen::VectorXd sigmas = variances.cwiseMax(0).cwiseSqrt();
    for (size_t c = 0; c < at_.controls; ++c)
      made.trajectory_sigmas.push_back(pair(sigmas, at_.tx(c), at_.ty(c)));
    for (size_t b = 0; b < at_.blocks; ++b)
      made.blocks_sigmas.push_back(pair(sigmas, at_.dx(b), at_.dy(b)));
    made.attitude_sigmas_rad = turns_of(sigmas);
  }

  const JointProblem& problem_;
  JointOrder at_;
  std::vector<FacadeStrips> facades_;
  std::vector<std::vector<RowElement>> rows_;
  SparseInverse::Factor factor_;
  std::optional<SparseInverse> inverse_;  ///< where sigmas are wanted
  Eigen::VectorXd right_side_;
  double distances_square_ = 0;  ///< h^T V^-1 h
};

void require_drift(const JointProblem& problem) {
  for (const GaussMarkov* chain : {&problem.x, &problem.y})
    for (const double q : chain->innovations)
      if (!(q > 0)) fail(Status::kInvalidArgument, "a velocity sigma of the trajectory is 0");
}

}  // namespace

JointSolution solve_reduced(const JointProblem& problem, JointWanted wanted) {
  validate(problem);
  require_drift(problem);
  return ReducedSolver(problem).solve(wanted);
}

}  // namespace jalon
