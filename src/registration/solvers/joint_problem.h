// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/vec.h"
#include "model/trajectory/gauss_markov.h"

// The adjustment of a mobile cloud and a building model together (Monnier 2014; Gauss-Helmert without
// parameters, Mikhail 1976). Observations, with their covariances:
//
//   T   corrections of the trajectory's control positions, x and y: Gauss-Markov chains, expected 0
//   d   translations of blocks, x and y: independent, expected 0
//   o_f, o_s  offsets of facades and of strips along the facade's normal: independent, expected 0
//
// and one condition for each matched strip: its plane passes through the centroid of its points,
//
//   h_s + n . (d_b - sum_c w_sc T_c) + o_f + o_s = 0
//
// h_s: mean signed distance of the given plane from the given points, (Q - P) . n; w_sc: the mean share
// of control position c in the points of the strip (linear interpolation in time; they sum to 1).
//
// Beyond the text: strips of a facade may hang together, exp(-distance / length) of their places along it,
// and a control point, seen at a time whose shares are w_c and known to the map, asks for its own
// correction: sum_c w_c T_c = v. Attitudes may have a constant error, three small turns b about the vehicle's own axes,
// independent, expected 0; they add sum_k t_sk b_k to a strip's condition, t_sk: its mean distance's derivative.
namespace jalon {

struct StripCondition {
  uint32_t block = 0, facade = 0;
  Vec2 normal;                                      ///< level, unit
  std::vector<std::pair<uint32_t, double>> shares;  ///< control position and its w, ascending
  double distance_m = 0;                            ///< h
  double measured_variance_m2 =
      0;               ///< of h beside the prior: noise of ranges over the number of points
  double place_m = 0;  ///< along the facade; where strips hang together
  /// Of h, by turns of the vehicle about its axes (m/rad); where attitudes are adjusted.
  std::array<double, 3> turns_m{};
};

/// A point whose place is known: what the drive has to be corrected by when it was seen.
struct ControlCondition {
  std::vector<std::pair<uint32_t, double>> shares;  ///< control position and its w, ascending
  Vec2 correction_m;
  double sigma_m = 0;  ///< of each coordinate
};

struct JointProblem {
  GaussMarkov x, y;  ///< of the control positions
  uint32_t blocks = 0, facades = 0;
  double sigma_block_x_m = 1, sigma_block_y_m = 1, sigma_facade_m = 0.5, sigma_strip_m = 0.3;
  /// How far along its facade a strip's offset tells of others': their correlation is 1 / e there; 0: not at all.
  double strip_correlation_m = 0;
  std::vector<StripCondition> strips;
  std::vector<ControlCondition> control_points;
  std::array<double, 3> sigma_attitude_rad{};  ///< of constant turns of the vehicle about its axes
  std::vector<bool> is_held;  ///< of each facade: it stays where it is given; empty: none does

  size_t controls() const { return x.size(); }
  /// Unknown turns: all three where one of them is; one with a sigma of 0 stays 0.
  size_t turns() const {
    return std::ranges::any_of(sigma_attitude_rad, [](double s) { return s > 0; }) ? 3 : 0;
  }
  double facade_variance_m2(uint32_t facade) const {
    const bool held = !is_held.empty() && is_held[facade];
    return held ? 0 : sigma_facade_m * sigma_facade_m;
  }
  /// Two coordinates of a control point are two conditions.
  size_t conditions() const { return strips.size() + 2 * control_points.size(); }
};

/// Adjusted values, each expected 0 before, and their standard deviations.
struct JointSolution {
  std::vector<Vec2> trajectory, blocks;  ///< corrections of control positions, translations
  std::vector<double> facades, strips;
  std::vector<Vec2> trajectory_sigmas, blocks_sigmas;
  std::vector<double> facades_sigmas, strips_sigmas;
  Vec3 attitude_rad, attitude_sigmas_rad;  ///< turns about the vehicle's axes
  /// Of each facade (1/m): how strongly its strips pull it forward from where it is.
  std::vector<double> facade_pulls;
  /// Weighted square sum of the corrections: chi-square with as many degrees of freedom as conditions,
  /// where the priors are right.
  double chi_square = 0;
  /// Of (T_x, T_y, d_x, d_y), in this order, and the three turns where there are any.
  Eigen::MatrixXd covariance;
  Eigen::MatrixXd whole_covariance;  ///< of those, then the facades, then the strips; where wanted
};

/// Indices into that order.
struct JointOrder {
  size_t controls, blocks, turns = 0;
  size_t tx(size_t c) const { return c; }
  size_t ty(size_t c) const { return controls + c; }
  size_t dx(size_t b) const { return 2 * controls + b; }
  size_t dy(size_t b) const { return 2 * controls + blocks + b; }
  size_t turn(size_t k) const { return 2 * (controls + blocks) + k; }
  size_t size() const { return 2 * (controls + blocks) + turns; }
};
inline JointOrder order_of(const JointProblem& problem) {
  return {problem.controls(), problem.blocks, problem.turns()};
}

/// Error(kInvalidArgument) naming the first strip with a block, facade or control position that is
/// not there, or saying which sigma is negative.
void validate(const JointProblem& problem);

/// What a solution is to have.
enum class JointWanted {
  kValues,      ///< values and chi-square
  kSigmas,      ///< their standard deviations as well
  kCovariance,  ///< and the field covariance, dense
  kWhole,       ///< and the field whole_covariance
};
/// By the normal equations of trajectory, blocks and turns alone, facades and strips eliminated: sparse, the same
/// answer to rounding as l^ = C B (B^T C B)^-1 c and C_l^ = C - C B (B^T C B)^-1 B^T C with all observations. Sigmas of
/// strips and of velocities must be positive; what has a sigma of 0 stays. Without measured noise the conditions hold
/// exactly.
JointSolution solve_reduced(const JointProblem& problem, JointWanted wanted);

}  // namespace jalon
