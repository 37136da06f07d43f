// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/solvers/whole_covariance.h"

#include <map>

#include "registration/solvers/facade_strips.h"

namespace jalon {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using SparseRow = std::map<Index, double>;  ///< by columns

// Derivatives of a strip's condition by what stands before the offsets, each times so much.
void add_derivatives(const StripCondition& strip, const JointOrder& at, double times,
                     SparseRow& into) {
  const auto add = [&](size_t column, double value) {
    into[static_cast<Index>(column)] += times * value;
  };
  for (const auto& [control, share] : strip.shares) {
    add(at.tx(control), -share * strip.normal.u);
    add(at.ty(control), -share * strip.normal.v);
  }
  add(at.dx(strip.block), strip.normal.u);
  add(at.dy(strip.block), strip.normal.v);
  for (size_t k = 0; k < at.turns; ++k) add(at.turn(k), strip.turns_m[k]);
}

class WholeCovariance {
 public:
  WholeCovariance(const JointProblem& problem, const MatrixXd& of_places)
      : problem_(problem),
        at_(order_of(problem)),
        before_(of_places.rows()),
        offsets_(static_cast<Index>(problem.facades + problem.strips.size())),
        gains_(static_cast<size_t>(offsets_)),
        made_(MatrixXd::Zero(before_ + offsets_, before_ + offsets_)) {
    made_.topLeftCorner(before_, before_) = of_places;
  }

  MatrixXd made() {
    const std::vector<FacadeStrips> facades = strips_by_facade(problem_);
    for (uint32_t f = 0; f < problem_.facades; ++f) {
      made_(before_ + f, before_ + f) = problem_.facade_variance_m2(f);
      if (!facades[f].strips.empty()) add_facade(f, facades[f]);
    }
    add_of_places();
    return std::move(made_);
  }

 private:
  Index strip_at(uint32_t s) const { return static_cast<Index>(problem_.facades + s); }

  // P, U and U V^-1 of a facade and its strips; rows of U V^-1 A.
  void add_facade(uint32_t facade, const FacadeStrips& f) {
    const auto n = static_cast<Index>(f.strips.size());
    const double facade_m2 = problem_.facade_variance_m2(facade),
                 strip_m2 = problem_.sigma_strip_m * problem_.sigma_strip_m;
    MatrixXd prior = MatrixXd::Zero(n + 1, n + 1);
    prior(0, 0) = facade_m2;
    if (f.is_correlated()) prior.bottomRightCorner(n, n) = f.prior;
    else prior.bottomRightCorner(n, n).diagonal().setConstant(strip_m2);
    MatrixXd U(n + 1, n);
    U.row(0).setConstant(facade_m2);
    U.bottomRows(n) = prior.bottomRightCorner(n, n);
    std::vector<Index> rows{static_cast<Index>(facade)};
    for (const uint32_t s : f.strips) rows.push_back(strip_at(s));
    for (Index i = 0; i <= n; ++i) {
      std::vector<double> row(static_cast<size_t>(n));
      for (Index j = 0; j < n; ++j) row[static_cast<size_t>(j)] = U(i, j);
      const std::vector<double> gain = f.weighted(row);  // V is symmetric
      const Index own = rows[static_cast<size_t>(i)];
      for (size_t j = 0; j < gain.size(); ++j)
        add_derivatives(problem_.strips[f.strips[j]], at_, gain[j],
                        gains_[static_cast<size_t>(own)]);
      for (Index k = 0; k <= n; ++k) {
        double sum = prior(i, k);
        for (Index j = 0; j < n; ++j) sum -= gain[static_cast<size_t>(j)] * U(k, j);
        made_(before_ + own, before_ + rows[static_cast<size_t>(k)]) = sum;
      }
    }
  }

  void add_of_places() {
    for (Index o = 0; o < offsets_; ++o) {
      Eigen::VectorXd with = Eigen::VectorXd::Zero(before_);
      for (const auto& [column, gain] : gains_[static_cast<size_t>(o)])
        with -= gain * made_.col(column).head(before_);
      made_.row(before_ + o).head(before_) = with.transpose();
      made_.col(before_ + o).head(before_) = with;
      for (Index other = 0; other < offsets_; ++other)
        for (const auto& [column, gain] : gains_[static_cast<size_t>(other)])
          made_(before_ + o, before_ + other) -= gain * with[column];
    }
  }

  const JointProblem& problem_;
  JointOrder at_;
  Index before_, offsets_;
  std::vector<SparseRow> gains_;  ///< U V^-1 A, of each facade and each strip
  MatrixXd made_;
};

}  // namespace

MatrixXd whole_covariance(const JointProblem& problem, const MatrixXd& of_places) {
  return WholeCovariance(problem, of_places).made();
}

}  // namespace jalon
