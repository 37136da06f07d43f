// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/field.h"
#include "model/trajectory/corrections.h"
#include "registration/ground/height_chain.h"
#include "registration/joint/joint_settings.h"
#include "registration/joint/ray_matching.h"
#include "registration/solvers/joint_problem.h"

namespace jalon {

/// One pass of the loop.
struct JointPass {
  uint64_t matched = 0, nothing = 0, behind = 0, far = 0, turned = 0, unsteady = 0;
  uint64_t strips = 0,
           changed = 0;  ///< strips that are adjusted; points whose match is another than before
  double rms_m = 0;      ///< of the accepted points off their strips, before the step
  double step_m = 0;     ///< the greatest change of a control position, block, facade or strip
  double chi_square = 0;
};

/// The result of an adjustment: immutable.
struct JointAdjustment {
  bool converged = false;
  std::vector<JointPass> passes;
  Corrections trajectory;                                  ///< at the control times
  std::vector<Vec2> trajectory_sigmas, trajectory_priors;  ///< standard deviations after and before
  /// Corrections of the control heights, standard deviations after and before; 0 and as before where no ground tells.
  std::vector<double> heights_m, height_sigmas_m, height_priors_m;
  std::vector<GroundRise> ground;  ///< what told the heights; empty: they stay
  double ground_chi_square = 0;    ///< with as many degrees of freedom
  BuildingOffsets model;           ///< of all strips, those not seen included
  std::vector<Vec2> block_sigmas;
  std::vector<double> facade_sigmas, strip_sigmas;
  std::vector<double>
      strip_distances_m;  ///< h: the given plane from the given points; NaN: not adjusted
  std::vector<uint64_t> strip_points;
  std::vector<bool> strip_is_doubtful;  ///< its wall may be another's: given back as it was given
  JointPoints points;
  std::vector<PointMatch> matches;  ///< of the last pass
  std::vector<double> weights;
  Vec3 attitude_bias_rad, attitude_bias_sigmas_rad;  ///< about the vehicle's axes; 0: not adjusted
  double chi_square = 0,
         p_value = 1;   ///< of the corrections, with as many degrees of freedom as strips
  uint64_t strips = 0;  ///< that are adjusted
  /// Of the matches that count, by the field "strip": those to another strip, those to another facade; NaN without
  /// it.
  double wrong_share = 0, wrong_facade_share = 0;
  /// The level direction that the strips' normals hold least, and how much: its share of the normals' squares over
  /// that of the direction held best.
  Vec2 weak_direction;
  double weak_share = 1;
  /// Of (T_x, T_y, d_x, d_y, turns), and of facades and the strips that were adjusted; empty unless asked for.
  Eigen::MatrixXd covariance;
  std::string parameters_json;

  double height_at(const TimePlace& at) const { return along(heights_m, at); }
  double height_sigma_at(const TimePlace& at) const { return along(height_sigmas_m, at); }

 private:
  static double along(const std::vector<double>& list, const TimePlace& at) {
    return list[at.epoch] * (1 - at.share) + list[at.epoch + 1] * at.share;
  }
};
using JointAdjustmentPtr = std::shared_ptr<const JointAdjustment>;

/// Below this share a direction is not held: the normals stand off it by less than 6 degrees, as those of a straight
/// street's fronts do.
constexpr double kHeldShare = 0.01;

/// The loop of Monnier (2014): match, adjust, move; the prior stays the one given. It ends when no match changes,
/// when nothing moves by more than tolerance_m, or after most_passes; once it has settled, facades that stand on the
/// wall of another change places (facade_exchange.h), strips that are rarely so far off are left out where strips were
/// searched for, and it goes on. Then, with sigma_ground_m, the heights by the
/// ground. model: of strips.
JointAdjustment adjust_jointly(const Model& model, const Cloud& cloud, const Trajectory& trajectory,
                               const JointSettings& settings, Task& task);

}  // namespace jalon
