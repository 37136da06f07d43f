// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "base/random.h"
#include "base/text_number.h"
#include "registration/solvers/joint_residuals.h"

// What one draw's normalised residuals look like: they hang together, so that their mean is not near 0 nor their spread
// near 1; how far off is foretold by the covariance of the solution.
namespace jalon {

constexpr int kDrawsOfBands = 1000;  ///< from here on a quantile of 95 % is sure to 3 %
constexpr const char* kJointGroupNames[] = {"trajectory x", "trajectory y", "blocks x",
                                            "blocks y",     "facades",      "strips"};

class DrawBands {
 public:
  void add(const std::vector<double>& z) {
    const auto n = static_cast<double>(z.size());
    double sum = 0, squares = 0, most = 0;
    for (const double v : z) sum += v / n, most = std::max(most, std::fabs(v));
    for (const double v : z) squares += (v - sum) * (v - sum);
    means_.push_back(std::fabs(sum)), spreads_.push_back(std::sqrt(squares / (n - 1)));
    mosts_.push_back(most);
  }
  std::array<double, 4> quantiles() const {
    return {at(means_, 0.95), at(spreads_, 0.025), at(spreads_, 0.975), at(mosts_, 0.95)};
  }
  std::string told() const {
    const auto q = quantiles();
    return text_of(q[0], 2) + "; " + text_of(q[1], 2) + "-" + text_of(q[2], 2) + "; " +
           text_of(q[3], 1);
  }
  double worst_ratio(const DrawBands& other) const {
    const auto a = quantiles(), b = other.quantiles();
    double worst = 1;
    for (size_t i = 0; i < a.size(); ++i) worst = std::max({worst, a[i] / b[i], b[i] / a[i]});
    return worst;
  }

 private:
  static double at(std::vector<double> values, double share) {
    std::ranges::sort(values);
    return values[static_cast<size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
  }
  std::vector<double> means_, spreads_, mosts_;
};

/// Bands by draws of normal values that hang together as the whole covariance says.
inline std::array<DrawBands, kJointGroups> foretold_bands(const JointSolution& solution) {
  const JointOrder at{solution.trajectory.size(), solution.blocks.size()};
  std::array<DrawBands, kJointGroups> made;
  const auto fill = [&](JointGroup g, size_t first, size_t count) {
    const auto n = static_cast<Eigen::Index>(count);
    const auto start = static_cast<Eigen::Index>(first);
    const Eigen::MatrixXd C = solution.whole_covariance.block(start, start, n, n);
    const Eigen::VectorXd scale = C.diagonal().cwiseSqrt().cwiseInverse();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> of(scale.asDiagonal() * C *
                                                            scale.asDiagonal());
    const Eigen::MatrixXd root =
        of.eigenvectors() * of.eigenvalues().cwiseMax(0).cwiseSqrt().asDiagonal();
    RandomStream random(77, g);
    constexpr int kDraws = 4000;
    for (int draw = 0; draw < kDraws; ++draw) {
      Eigen::VectorXd xi(n);
      for (Eigen::Index i = 0; i < n; ++i) xi[i] = random.normal();
      const Eigen::VectorXd z = root * xi;
      made[g].add({z.data(), z.data() + n});
    }
  };
  fill(kTrajectoryX, at.tx(0), at.controls), fill(kTrajectoryY, at.ty(0), at.controls);
  fill(kBlocksX, at.dx(0), at.blocks), fill(kBlocksY, at.dy(0), at.blocks);
  fill(kFacades, at.size(), solution.facades.size());
  fill(kStrips, at.size() + solution.facades.size(), solution.strips.size());
  return made;
}

/// The same bands, and what is left of errors (m), on the street of 272 strips of one front each side (2 000 draws).
constexpr const char* kStreetBands[5][kJointGroups] = {
    {"0.97; 0.56-1.32; 3.1", "1.01; 0.55-1.36; 3.2", "0.65; 0.61-1.40; 2.9", "0.64; 0.61-1.40; 2.9",
     "0.34; 0.79-1.20; 3.3", "0.25; 0.84-1.15; 3.7"},
    {"0.68; 0.68-1.30; 3.3", "0.68; 0.67-1.27; 3.3", "0.65; 0.61-1.37; 2.9", "0.64; 0.59-1.38; 2.9",
     "0.34; 0.79-1.21; 3.3", "0.25; 0.84-1.15; 3.6"},
    {"0.69; 0.66-1.26; 3.2", "0.67; 0.67-1.26; 3.3", "0.52; 0.62-1.39; 2.9", "0.52; 0.63-1.41; 2.9",
     "0.39; 0.69-1.30; 3.3", "0.24; 0.84-1.16; 3.6"},
    {"0.63; 0.68-1.29; 3.3", "0.62; 0.68-1.26; 3.2", "0.53; 0.63-1.38; 2.9", "0.52; 0.64-1.40; 2.9",
     "0.26; 0.81-1.19; 3.4", "0.35; 0.75-1.26; 3.4"},
    {"1.94; 0.04-0.16; 2.1", "1.99; 0.04-0.16; 2.1", "0.88; 0.53-1.36; 2.9", "0.92; 0.54-1.40; 2.9",
     "0.47; 0.69-1.27; 3.2", "0.27; 0.80-1.18; 3.4"}};

/// Root mean squares before and after, over draws and items.
class ErrorsLeft {
 public:
  void add(const JointSolution& s, const JointTruth& t) {
    for (size_t c = 0; c < s.trajectory.size(); ++c)
      put(0, t.trajectory[c], s.trajectory[c], s.trajectory_sigmas[c]);
    for (size_t b = 0; b < s.blocks.size(); ++b)
      put(1, t.blocks[b], s.blocks[b], s.blocks_sigmas[b]);
    for (size_t f = 0; f < s.facades.size(); ++f)
      put(2, t.facades[f], s.facades[f], s.facades_sigmas[f]);
    for (size_t i = 0; i < s.strips.size(); ++i)
      put(3, t.strips[i], s.strips[i], s.strips_sigmas[i]);
  }
  double after(size_t g) const { return std::sqrt(after_[g] / n_[g]); }
  double foretold(size_t g) const { return std::sqrt(foretold_[g] / n_[g]); }
  std::string told() const {
    const char* names[] = {"trajectory ", ", blocks ", ", facades ", ", strips "};
    std::string made = "errors left";
    for (size_t g = 0; g < 4; ++g)
      made += std::string(g == 0 ? ": " : "") + names[g] +
              text_of(std::sqrt(before_[g] / n_[g]), 3) + " -> " + text_of(after(g), 4) +
              " m (foretold " + text_of(foretold(g), 4) + ")";
    return made;
  }
  void are_as_foretold() const {
    for (size_t g = 0; g < 4; ++g)
      CHECK(after(g) == doctest::Approx(foretold(g)).epsilon(0.05).scale(0));
  }
  /// What is left on the street of 272 strips. What holds a block along its street is how much its fronts differ in
  /// turn ("by 0.05 rad"): of blocks of scenario 2 turns of -0.05, 0 and 0.05 rad after each other leave 0.10 m, turns
  /// to either side 0.08, even steps 0.12, drawn ones 0.18 to 0.34 (20 streets).
  void check_reductions(int scenario) const {
    struct Line {
      int scenario;
      size_t group;
      double left_m;
    };
    constexpr Line kLines[] = {{1, 0, 0.025}, {2, 1, 0.10}, {3, 2, 0.014}, {4, 3, 0.017},
                               {5, 0, 0.35},  {5, 1, 0.76}, {5, 2, 0.27},  {5, 3, 0.13}};
    for (const Line& line : kLines)
      if (line.scenario == scenario)
        CHECK(after(line.group) == doctest::Approx(line.left_m).epsilon(0.15).scale(0));
  }

 private:
  void put(size_t g, double truth, double value, double sigma) {
    before_[g] += truth * truth, after_[g] += (value - truth) * (value - truth);
    foretold_[g] += sigma * sigma, n_[g] += 1;
  }
  void put(size_t g, const Vec2& truth, const Vec2& value, const Vec2& sigma) {
    put(g, truth.u, value.u, sigma.u), put(g, truth.v, value.v, sigma.v);
  }
  std::array<double, 4> before_{}, after_{}, foretold_{}, n_{};
};

}  // namespace jalon
