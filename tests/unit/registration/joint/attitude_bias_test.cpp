// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/joint/attitude_bias.h"

#include <doctest/doctest.h>

#include <cstdlib>

#include "base/random.h"
#include "registration/joint/adjusted.h"
#include "registration/solvers/joint_residuals.h"
#include "scan/mobile/drive_scenario.h"
#include "unit/registration/joint/joint_street.h"
#include "unit/registration/solvers/dense_form.h"

using namespace jalon;

namespace {

const Vec3 kBias_rad{0.004, -0.003, 0.006};

// The street's points with their vehicles.
JointPoints street_points() {
  const JointStreet& street = joint_street();
  const auto times = street.cloud.fields.require("time").values<double>();
  const PoseInterpolator poses(street.drive);
  JointPoints made;
  TimePlace at;
  for (uint32_t i = 0; i < street.cloud.size(); ++i) {
    at = time_place(street.drive.times_s, times[i], i, at.epoch);
    made.index.push_back(i);
    made.at.push_back(street.cloud.point(i));
    made.vehicle.push_back(poses.position(at));
    made.axes.push_back(poses.rotation(at));
    made.origin.push_back(made.vehicle.back());
    made.direction.push_back(normalized(made.at.back() - made.origin.back()));
  }
  return made;
}

StripConditions conditions_of(const JointPoints& points) {
  const JointStreet& street = joint_street();
  std::vector<double> xyz;
  for (const Vec3& p : points.at) xyz.insert(xyz.end(), {p.x, p.y, p.z});
  const std::vector<std::array<Vec2, 3>> turns = plan_turns(points);
  MatchedPoints matched = street.matches(street.cloud);
  matched.xyz = xyz, matched.turns = turns;
  return strip_conditions(matched, street.given(street.strips), street.controls(), 1, 0);
}

// A drive whose places are known to centimetres, and as sure a model: what is left tells of the attitudes.
JointProblem unsure_attitudes(const StripConditions& perfect) {
  JointProblem problem = joint_street().problem({0.05, 0.05, 0.05, 0.05});
  problem.strips = perfect.conditions;
  problem.sigma_attitude_rad = {0.01, 0.01, 0.02};
  return problem;
}

// Adds what attitudes in error by this do to the distances.
void add_turns(JointProblem& problem, const Vec3& error_rad) {
  for (StripCondition& strip : problem.strips)
    for (size_t k = 0; k < 3; ++k)
      strip.distance_m += strip.turns_m[k] * error_rad[static_cast<int>(k)];
}

double worst_difference(const JointSolution& a, const JointSolution& b) {
  double worst = (a.covariance - b.covariance).cwiseAbs().maxCoeff();
  const auto compare = [&](double x, double y) { worst = std::max(worst, std::fabs(x - y)); };
  for (size_t c = 0; c < a.trajectory.size(); ++c) {
    compare(a.trajectory[c].u, b.trajectory[c].u), compare(a.trajectory[c].v, b.trajectory[c].v);
    compare(a.trajectory_sigmas[c].u, b.trajectory_sigmas[c].u);
  }
  for (size_t f = 0; f < a.facades.size(); ++f) {
    compare(a.facades[f], b.facades[f]);
    compare(a.facades_sigmas[f], b.facades_sigmas[f]);
  }
  for (size_t s = 0; s < a.strips.size(); ++s) {
    compare(a.strips[s], b.strips[s]);
    compare(a.strips_sigmas[s], b.strips_sigmas[s]);
  }
  for (int k = 0; k < 3; ++k) {
    compare(a.attitude_rad[k], b.attitude_rad[k]);
    compare(a.attitude_sigmas_rad[k], b.attitude_sigmas_rad[k]);
  }
  return worst;
}

}  // namespace

TEST_CASE("turned_points__go_round_the_vehicle_as_their_derivatives_say") {
  const JointPoints given = street_points(), made = turned(given, kBias_rad);
  for (size_t i = 0; i < given.at.size(); i += 501) {
    const Vec3 arm = given.at[i] - given.vehicle[i];
    CHECK(norm(made.at[i] - made.vehicle[i]) == doctest::Approx(norm(arm)).epsilon(1e-12));
    const auto by = turn_derivatives(given.axes[i], arm);
    const Vec3 linear = by[0] * kBias_rad.x + by[1] * kBias_rad.y + by[2] * kBias_rad.z;
    CHECK(norm(made.at[i] - given.at[i] - linear) < 0.5 * squared_norm(kBias_rad) * norm(arm));
    // The vehicle's axes turn with it: R Exp(b).
    const Vec3 forward = given.axes[i] * Vec3{1, kBias_rad.z, -kBias_rad.y};
    CHECK(norm(made.axes[i].column(0) - forward) < squared_norm(kBias_rad));
  }
}

TEST_CASE("turned_trajectory__puts_points_where_turned_points_are") {
  const JointStreet& street = joint_street();
  const auto values = [&](const char* name) {
    return street.cloud.fields.require(name).values<double>();
  };
  Task task;
  for (const AxesConvention axes : {AxesConvention::kEnu, AxesConvention::kNed}) {
    Trajectory drive = street.drive;
    drive.axes = axes;
    for (size_t i = 0; i < drive.size(); ++i)
      drive.attitudes_rad[i] = attitude_angles(
          axes, attitude_rotation(AxesConvention::kEnu, street.drive.attitudes_rad[i]));
    const LaserReturns returns{values("time"), values("range"), values("theta"), values("phi")};
    const Cloud before = georeferenced(drive, returns, street.scanner.mount, task),
                after =
                    georeferenced(turned(drive, kBias_rad), returns, street.scanner.mount, task);
    const PoseInterpolator poses(drive);
    for (uint32_t i = 0; i < before.size(); i += 501) {
      const TimePlace at = time_place(drive.times_s, returns.times_s[i], i);
      JointPoints one;
      one.at = {before.point(i)}, one.origin = {poses.position(at)}, one.direction = {{1, 0, 0}};
      one.vehicle = {poses.position(at)}, one.axes = {poses.rotation(at)};
      CHECK(norm(turned(one, kBias_rad).at[0] - after.point(i)) < 1e-9);
    }
  }
}

TEST_CASE("strip_conditions__of_turned_points__change_as_their_derivatives_say") {
  const JointPoints given = street_points();
  const StripConditions before = conditions_of(given);
  for (int k = 0; k < 3; ++k) {
    Vec3 step;
    step[k] = 1e-6;
    const StripConditions after = conditions_of(turned(given, step));
    for (size_t s = 0; s < before.conditions.size(); ++s) {
      const double slope =
          (after.conditions[s].distance_m - before.conditions[s].distance_m) / step[k];
      CHECK(std::fabs(slope - before.conditions[s].turns_m[static_cast<size_t>(k)]) < 1e-4);
    }
  }
}

TEST_CASE("solve_reduced__with_attitude_biases__equals_the_dense_form") {
  const StripConditions perfect = conditions_of(street_points());
  for (const double roll : {0.01, 0.0}) {
    JointProblem problem = unsure_attitudes(perfect);
    problem.sigma_attitude_rad[0] = roll;
    set_distances(problem, drawn_errors(joint_street(), problem, 79), perfect.strip_of);
    add_turns(problem, {roll, -0.01, 0.015});
    problem.control_points = {{{{10, 0.25}, {11, 0.75}}, {0.8, -0.4}, 0.02}};
    const JointSolution sparse = solve_reduced(problem, JointWanted::kCovariance),
                        dense = solve_dense(problem);
    CHECK(sparse.covariance.rows() ==
          static_cast<Eigen::Index>(2 * (problem.controls() + problem.blocks) + 3));
    CHECK(worst_difference(sparse, dense) < 1e-9);
    CHECK(sparse.chi_square == doctest::Approx(dense.chi_square).epsilon(1e-6));
    if (roll == 0) CHECK(sparse.attitude_rad.x == 0);
  }
}

// Errors of everything, attitudes too, drawn from their priors: over draws residuals are standard normal.
TEST_CASE("attitude_biases__drawn_from_their_prior__are_as_sure_as_told") {
  const int draws = std::getenv("JALON_FULL") != nullptr ? 400 : 40;
  const StripConditions perfect = conditions_of(street_points());
  JointProblem problem = unsure_attitudes(perfect);
  double before[3]{}, after[3]{}, sum[3]{}, squares[3]{}, fourths[3]{}, sigma[3]{},
      chi = 0, whitened = 0, whitened2 = 0;
  for (int draw = 0; draw < draws; ++draw) {
    const auto seed = 6500 + static_cast<uint64_t>(draw);
    const JointErrors errors = drawn_errors(joint_street(), problem, seed);
    set_distances(problem, errors, perfect.strip_of);
    RandomStream random(seed, 31);
    Vec3 off;
    for (int k = 0; k < 3; ++k)
      off[k] = problem.sigma_attitude_rad[static_cast<size_t>(k)] * random.normal();
    add_turns(problem, off);
    const JointSolution made = solve_reduced(problem, JointWanted::kCovariance);
    JointTruth truth;
    truth.attitude_rad = -off;
    for (size_t c = 0; c < errors.x.size(); ++c)
      truth.trajectory.push_back({-errors.x[c], -errors.y[c]});
    for (const Vec2& b : errors.model.blocks) truth.blocks.push_back({-b.u, -b.v});
    const double w = whitened_mean_square(made, truth);
    whitened += w / draws, whitened2 += w * w / draws;
    chi += made.chi_square / static_cast<double>(problem.strips.size()) / draws;
    for (int k = 0; k < 3; ++k) {
      const double e = made.attitude_rad[k] + off[k], z = e / made.attitude_sigmas_rad[k];
      before[k] += off[k] * off[k] / draws, after[k] += e * e / draws;
      sum[k] += z / draws, squares[k] += z * z / draws, fourths[k] += z * z * z * z / draws;
      sigma[k] = made.attitude_sigmas_rad[k];
    }
  }
  const char* names[] = {"roll", "pitch", "heading"};
  for (int k = 0; k < 3; ++k) {
    MESSAGE("FIGURE joint, attitude biases, ", draws, " draws: ", std::string(names[k]), " ",
            1e3 * std::sqrt(before[k]), " mrad before, ", 1e3 * std::sqrt(after[k]),
            " after (sigma ", 1e3 * sigma[k], "), normalised mean ", sum[k], ", mean square ",
            squares[k]);
    const double of_mean = 1 / std::sqrt(draws),
                 of_square = std::sqrt((fourths[k] - squares[k] * squares[k]) / draws);
    CHECK(std::fabs(sum[k]) < 4 * of_mean);
    CHECK(std::fabs(squares[k] - 1) < 4 * of_square);
    CHECK(after[k] < before[k]);
  }
  const double of_whitened = std::sqrt((whitened2 - whitened * whitened) / draws);
  MESSAGE("FIGURE joint, attitude biases, ", draws, " draws: whitened ", whitened, " +- ",
          of_whitened, ", chi-square over strips ", chi);
  CHECK(std::fabs(whitened - 1) < 4 * of_whitened);
  CHECK(chi == doctest::Approx(1).epsilon(0.05));
}

// The whole way, by rays: a drive whose inertial unit sits turned by some tenths of a degree.
TEST_CASE("adjust_jointly__of_a_turned_inertial_unit__turns_drive_and_cloud_back") {
  DriveScenarioSettings from;
  from.scenario = 0;
  from.sigma_block_m = from.sigma_facade_m = from.sigma_strip_m = from.sigma_trajectory_m = 0.02;
  from.leg_m = 60, from.revolutions_per_s = 10, from.pulses = 400;
  Task task;
  DriveScenario made = drive_scenario(from, task);
  const auto values = [&](const char* name) {
    return made.cloud.fields.require(name).values<double>();
  };
  const Trajectory wrong = turned(made.trajectory, -kBias_rad);
  Cloud cloud =
      georeferenced(wrong, {values("time"), values("range"), values("theta"), values("phi")},
                    joint_street().scanner.mount, task);
  JointSettings settings;
  settings.sigma_block_x_m = settings.sigma_block_y_m = 0.02;
  settings.sigma_facade_m = settings.sigma_strip_m = 0.02;
  const JointAdjustment without = adjust_jointly(made.model, cloud, wrong, settings, task);
  CHECK(without.attitude_bias_rad == Vec3{});
  settings.sigma_roll_bias_rad = settings.sigma_pitch_bias_rad = 0.005;
  settings.sigma_heading_bias_rad = 0.01;
  settings.covariance = true;
  const JointAdjustment with = adjust_jointly(made.model, cloud, wrong, settings, task);
  CHECK(with.converged);
  for (int k = 0; k < 3; ++k)
    CHECK(std::fabs(with.attitude_bias_rad[k] - kBias_rad[k]) <
          4 * with.attitude_bias_sigmas_rad[k]);
  // Points of both clouds from where they were in truth.
  const auto truth = made.cloud.fields.require("true_xyz").values<double>();
  const auto off = [&](const JointAdjustment& a) {
    const Cloud moved = adjusted_cloud(a, wrong, cloud, task);
    double squares = 0;
    for (uint32_t i = 0; i < moved.size(); ++i) {
      const Vec3 p = moved.point(i);
      const double x = p.x - truth[3 * size_t{i}], y = p.y - truth[3 * size_t{i} + 1];
      squares += x * x + y * y;
    }
    return std::sqrt(squares / static_cast<double>(moved.size()));
  };
  MESSAGE("FIGURE joint, attitude biases by rays: points in plan ", off(without),
          " m off without, ", off(with), " m with them; bias ", with.attitude_bias_rad.x, " ",
          with.attitude_bias_rad.y, " ", with.attitude_bias_rad.z, " rad");
  CHECK(off(with) < off(without));
  // The drive turned is the drive that the cloud was turned by.
  const Trajectory drive = adjusted_trajectory(with, wrong);
  const Cloud again =
      georeferenced(drive, {values("time"), values("range"), values("theta"), values("phi")},
                    joint_street().scanner.mount, task);
  const Cloud moved = adjusted_cloud(with, wrong, cloud, task);
  for (uint32_t i = 0; i < again.size(); i += 97)
    CHECK(norm(again.point(i) - moved.point(i)) < 1e-6);
}
