// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "model/trajectory/gauss_markov.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>

#include "base/error.h"
#include "unit/model/trajectory/drives.h"

using namespace jalon;

namespace {

Eigen::MatrixXd covariance_matrix(const GaussMarkov& chain) {
  const auto n = static_cast<Eigen::Index>(chain.size());
  Eigen::MatrixXd c(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j)
      c(i, j) = chain.covariance(static_cast<size_t>(i), static_cast<size_t>(j));
  return c;
}

}  // namespace

TEST_CASE("gauss_markov__with_sigmas_that_vary__keeps_each_and_its_inverse_is_tridiagonal") {
  const GaussMarkov chain = position_prior(bent_drive(40), 1);
  const Eigen::MatrixXd c = covariance_matrix(chain);
  for (size_t i = 0; i < chain.size(); ++i)
    CHECK(c(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i)) ==
          doctest::Approx(std::pow(0.03 + 0.005 * static_cast<double>(i), 2)).epsilon(1e-13));
  const TridiagonalInformation made = information_of(chain);
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(c.rows(), c.cols());
  for (Eigen::Index i = 0; i < c.rows(); ++i) {
    information(i, i) = made.diagonal[static_cast<size_t>(i)];
    if (i + 1 < c.rows())
      information(i, i + 1) = information(i + 1, i) = made.beside[static_cast<size_t>(i)];
  }
  const Eigen::MatrixXd product = information * c;
  CHECK((product - Eigen::MatrixXd::Identity(c.rows(), c.cols())).cwiseAbs().maxCoeff() < 1e-11);
}

TEST_CASE("gauss_markov__at_the_ends_of_the_velocity__is_one_error_or_many") {
  const double times[] = {0, 1, 3}, sigmas[] = {0.1, 0.2, 0.4};
  const double slow[] = {1e-9, 1e-9, 1e-9}, fast[] = {1e9, 1e9, 1e9};
  CHECK(gauss_markov(times, sigmas, slow).covariance(0, 2) == doctest::Approx(0.1 * 0.4));
  CHECK(gauss_markov(times, sigmas, slow).covariance(2, 1) == doctest::Approx(0.2 * 0.4));
  CHECK(gauss_markov(times, sigmas, fast).covariance(0, 1) < 1e-10);
}

TEST_CASE("gauss_markov__drawn_often__has_its_covariance") {
  const GaussMarkov chain = position_prior(bent_drive(6), 0);
  const Eigen::MatrixXd c = covariance_matrix(chain);
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(6, 6);
  constexpr int kDraws = 40000;
  for (int draw = 0; draw < kDraws; ++draw) {
    const std::vector<double> e = drawn(chain, 11, static_cast<uint64_t>(draw));
    const Eigen::Map<const Eigen::VectorXd> v(e.data(), 6);
    sum += v * v.transpose();
  }
  // The standard error of an element of a sample covariance: sqrt((c_ii c_jj + c_ij^2) / draws).
  for (Eigen::Index i = 0; i < 6; ++i)
    for (Eigen::Index j = 0; j < 6; ++j) {
      const double error = std::sqrt((c(i, i) * c(j, j) + c(i, j) * c(i, j)) / kDraws);
      CHECK(std::fabs(sum(i, j) / kDraws - c(i, j)) < 4.5 * error);
    }
}

TEST_CASE("perturbed__trajectory__moves_in_plan_alone_and_the_same_for_the_same_seed") {
  const Trajectory drive = bent_drive(20), a = perturbed(drive, 5), b = perturbed(drive, 5),
                   c = perturbed(drive, 6);
  CHECK(a.positions == b.positions);
  CHECK(a.positions != c.positions);
  CHECK(a.positions[7].z == drive.positions[7].z);
  CHECK(a.positions[7].x - drive.positions[7].x != a.positions[7].y - drive.positions[7].y);
  CHECK(a.times_s == drive.times_s);
}

TEST_CASE("position_prior__without_sigmas__is_refused_and_without_velocities_takes_the_drift") {
  Trajectory drive = bent_drive(4);
  drive.velocity_sigmas_m_s.clear();
  const double drift[] = {0.01, 0.01, 0.01, 0.01};
  std::vector<double> sigmas;
  for (const Vec3& s : drive.position_sigmas_m) sigmas.push_back(s.y);
  CHECK(position_prior(drive, 1).factors == gauss_markov(drive.times_s, sigmas, drift).factors);
  drive.position_sigmas_m.clear();
  CHECK_THROWS_AS(position_prior(drive, 0), Error);
}
