// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/ground/height_chain.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <cmath>
#include <cstdlib>

#include "base/random.h"

using namespace jalon;

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr size_t kControls = 60;

// A drive of a minute at 5 m/s, which stands for ten seconds amid; the ground's errors reach 25 m.
struct HeightScene {
  std::vector<Vec3> controls;
  GaussMarkov drive, ground;
  std::vector<GroundRise> rises;

  HeightScene() {
    std::vector<double> times, sigmas, drift;
    double at = 0;
    for (size_t c = 0; c < kControls; ++c) {
      controls.push_back({at, 0, 1.2});
      times.push_back(static_cast<double>(c)),
          sigmas.push_back(0.5 + 0.01 * static_cast<double>(c));
      drift.push_back(0.02);
      if (c < 20 || c >= 30) at += 5;
    }
    drive = gauss_markov(times, sigmas, drift);
    ground = ground_chain(controls, 0.15, 25);
    for (uint32_t c = 0; c + 1 < kControls; ++c)
      if (c % 7 != 3) rises.push_back({c, 0.3 + 0.01 * (c % 40), 0, 4e-6, 100});
  }
  // Rises of errors drawn from the priors: the drive's, whose corrections are expected, are given back.
  std::vector<double> draw(uint64_t seed) {
    const std::vector<double> z = drawn(drive, seed, 13), g = drawn(ground, seed, 14);
    RandomStream noise(seed, 15);
    for (GroundRise& r : rises) {
      const size_t c = r.interval;
      r.rise_m = (1 - r.share) * (z[c] + g[c]) + r.share * (z[c + 1] + g[c + 1]) +
                 std::sqrt(variance_of(r, ground)) * noise.normal();
    }
    return z;
  }
};

}  // namespace

TEST_CASE("ground_chain__of_a_way__correlates_by_its_length") {
  const std::vector<Vec3> controls{{0, 0, 0}, {3, 4, 7}, {3, 4, 7}, {13, 4, 7}};
  const GaussMarkov made = ground_chain(controls, 0.2, 10);
  CHECK(made.covariance(0, 1) == doctest::Approx(0.04 * std::exp(-0.5)));
  CHECK(made.covariance(0, 3) == doctest::Approx(0.04 * std::exp(-1.5)).epsilon(1e-5));
  CHECK(made.covariance(3, 3) == doctest::Approx(0.04));
  CHECK(made.innovations[1] > 0);  // where it stands, too
}

// Means of a chain drawn in steps of a tenth of the interval, off the line between its ends.
TEST_CASE("variance_of__a_rise__has_what_the_mean_of_an_interval_is_off_the_line") {
  std::vector<Vec3> fine;
  for (int i = 0; i <= 40000; ++i) fine.push_back({0.5 * i, 0, 0});
  const std::vector<double> g = drawn(ground_chain(fine, 0.1, 25), 12, 0);
  double square = 0, n = 0;
  for (size_t first = 0; first + 10 < g.size(); first += 10, ++n) {
    double mean = (g[first] + g[first + 10]) / 20;
    for (size_t k = 1; k < 10; ++k) mean += g[first + k] / 10;
    square += std::pow(mean - (g[first] + g[first + 10]) / 2, 2);
  }
  const GroundRise rise{0, 0.5, 0, 1e-6, 1};
  const std::vector<Vec3> interval{{0, 0, 0}, {5, 0, 0}};
  CHECK(variance_of(rise, ground_chain(interval, 0.1, 25)) - 1e-6 ==
        doctest::Approx(square / n).epsilon(0.08).scale(0));
}

// 0.6 m over 4 of the drive, 1 of the ground and 1 of the measurement.
TEST_CASE("solve_heights__of_one_rise__shares_it_by_the_variances") {
  const double times[] = {0, 1}, sigmas[] = {2, 2}, slow[] = {1e-5, 1e-5};
  const std::vector<Vec3> stands{{0, 0, 0}, {0, 0, 0}};
  const GroundRise rise{0, 0.5, 0.6, 1, 1};
  const HeightSolution made =
      solve_heights(gauss_markov(times, sigmas, slow), ground_chain(stands, 1, 10), {&rise, 1});
  CHECK(made.by_m[0] == doctest::Approx(0.4).epsilon(1e-4));
  CHECK(made.by_m[1] == doctest::Approx(0.4).epsilon(1e-4));
  CHECK(made.sigmas_m[0] == doctest::Approx(2 * std::sqrt(1 - 4.0 / 6)).epsilon(1e-4));
  CHECK(made.chi_square == doctest::Approx(0.36 / 6).epsilon(1e-4));
}

TEST_CASE("solve_heights__of_a_drive__equals_the_dense_form") {
  HeightScene scene;
  scene.draw(81);
  const HeightSolution made = solve_heights(scene.drive, scene.ground, scene.rises);
  const auto n = static_cast<Index>(kControls), m = static_cast<Index>(scene.rises.size());
  MatrixXd C = MatrixXd::Zero(2 * n, 2 * n), B = MatrixXd::Zero(2 * n, m);
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j) {
      C(i, j) = scene.drive.covariance(static_cast<size_t>(i), static_cast<size_t>(j));
      C(n + i, n + j) = scene.ground.covariance(static_cast<size_t>(i), static_cast<size_t>(j));
    }
  VectorXd rise(m), noise(m);
  for (Index k = 0; k < m; ++k) {
    const GroundRise& r = scene.rises[static_cast<size_t>(k)];
    for (const Index of : {Index{0}, n}) {
      B(of + r.interval, k) = 1 - r.share;
      B(of + r.interval + 1, k) = r.share;
    }
    rise[k] = r.rise_m, noise[k] = variance_of(r, scene.ground);
  }
  MatrixXd M = B.transpose() * C * B;
  M.diagonal() += noise;
  const Eigen::LDLT<MatrixXd> factor(M);
  const VectorXd x = C * B * factor.solve(rise);
  const MatrixXd after = C - C * B * factor.solve(MatrixXd(B.transpose() * C));
  double worst = 0;
  for (size_t c = 0; c < kControls; ++c) {
    const auto i = static_cast<Index>(c);
    worst = std::max({worst, std::fabs(made.by_m[c] - x[i]),
                      std::fabs(made.sigmas_m[c] - std::sqrt(after(i, i)))});
  }
  MESSAGE("FIGURE joint, heights by the chain against the dense form: ", worst, " m");
  CHECK(worst < 1e-9);
  CHECK(made.chi_square == doctest::Approx(rise.dot(factor.solve(rise))).epsilon(1e-6));
}

TEST_CASE("solve_heights__of_errors_drawn_from_their_priors__are_as_sure_as_told") {
  const int draws = std::getenv("JALON_FULL") != nullptr ? 2000 : 200;
  HeightScene scene;
  double before = 0, after = 0, mean = 0, mean2 = 0, square = 0, square2 = 0, chi = 0, chi2 = 0;
  for (int draw = 0; draw < draws; ++draw) {
    const std::vector<double> truth = scene.draw(6700 + static_cast<uint64_t>(draw));
    const HeightSolution made = solve_heights(scene.drive, scene.ground, scene.rises);
    double sum = 0, sum2 = 0;
    for (size_t c = 0; c < kControls; ++c) {
      const double e = made.by_m[c] - truth[c], z = e / made.sigmas_m[c];
      sum += z / kControls, sum2 += z * z / kControls;
      before += truth[c] * truth[c], after += e * e;
    }
    const double of_rises = made.chi_square / static_cast<double>(scene.rises.size());
    mean += sum / draws, mean2 += sum * sum / draws;
    square += sum2 / draws, square2 += sum2 * sum2 / draws;
    chi += of_rises / draws, chi2 += of_rises * of_rises / draws;
  }
  const auto error = [&](double m, double m2) { return std::sqrt((m2 - m * m) / draws); };
  MESSAGE("FIGURE joint, heights by the ground, ", draws,
          " draws: ", std::sqrt(before / kControls / draws), " m before, ",
          std::sqrt(after / kControls / draws), " m after, normalised mean ", mean, " +- ",
          error(mean, mean2), ", mean square ", square, " +- ", error(square, square2),
          ", chi-square over rises ", chi, " +- ", error(chi, chi2));
  CHECK(std::fabs(mean) < 4 * error(mean, mean2));
  CHECK(std::fabs(square - 1) < 4 * error(square, square2));
  CHECK(std::fabs(chi - 1) < 4 * error(chi, chi2));
  CHECK(after < 0.25 * before);
}
