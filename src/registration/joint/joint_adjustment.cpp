// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/joint/joint_adjustment.h"

#include <algorithm>
#include <cmath>

#include "base/distributions.h"
#include "base/error.h"
#include "base/numbers.h"
#include "registration/ground/ground_rises.h"
#include "registration/joint/adjusted.h"
#include "registration/joint/apart.h"
#include "registration/joint/attitude_bias.h"
#include "registration/joint/beam_fields.h"
#include "registration/joint/block_search.h"
#include "registration/joint/control_points.h"
#include "registration/joint/strip_conditions.h"
#include "registration/joint/strip_misfits.h"
#include "registration/joint/strip_search.h"
#include "registration/joint/strip_weights.h"
#include "registration/joint/wall_claims.h"
#include "registration/solvers/set_back.h"

namespace jalon {

namespace {

JointProblem problem_of(const StripScene& scene, const Trajectory& controls,
                        const JointSettings& settings) {
  JointProblem made;
  made.x = position_prior(controls, 0), made.y = position_prior(controls, 1);
  made.blocks = scene.blocks, made.facades = scene.facades;
  made.sigma_block_x_m = settings.sigma_block_x_m, made.sigma_block_y_m = settings.sigma_block_y_m;
  made.sigma_facade_m = settings.sigma_facade_m, made.sigma_strip_m = settings.sigma_strip_m;
  made.strip_correlation_m = settings.strip_correlation_m;
  made.sigma_attitude_rad = settings.sigma_attitude_rad();
  return made;
}

void require_prior(const Trajectory& trajectory, const JointSettings& settings) {
  validate(trajectory);
  if (trajectory.position_sigmas_m.empty())
    fail(Status::kInvalidArgument,
         "the trajectory has no sigmas of position: nothing is known of its errors");
  if (!(settings.sigma_strip_m > 0))
    fail(Status::kInvalidArgument,
         "sigma_strip_m is 0: the conditions of the strips could not all hold");
}

class JointLoop {
 public:
  JointLoop(const Model& model, const Cloud& cloud, const Trajectory& trajectory,
            const JointSettings& settings, Task& task)
      : settings_(settings),
        task_(task),
        scene_(strip_scene(model, settings.occluders)),
        problem_(problem_of(scene_,
                            interpolated(trajectory, control_times(trajectory, settings.control_s)),
                            settings)) {
    made_.trajectory.times_s = control_times(trajectory, settings.control_s);
    problem_.control_points = control_points(settings.control_points, made_.trajectory.times_s);
    made_.points = joint_points(cloud, trajectory, made_.trajectory.times_s, settings, task);
    stand_turned();
    const size_t controls = made_.trajectory.times_s.size();
    places_.trajectory.assign(controls, {});
    places_.model = {std::vector<Vec2>(scene_.blocks), std::vector<double>(scene_.facades, 0),
                     std::vector<double>(scene_.strips.size(), 0)};
    made_.strip_is_doubtful.assign(scene_.strips.size(), false);
    if (settings.kernel != JointSettings::Kernel::kNone &&
        settings.matches == JointSettings::Matches::kRays) {
      places_.model.blocks = find_blocks(made_.points, scene_, settings, task);
      found_ = find_strips(made_.points, scene_, settings, task);
      places_.model.strips = found_.offsets_m;
      made_.strip_is_doubtful = found_.is_doubtful;
    }
    for (size_t c = 0; c < controls; ++c)
      made_.trajectory_priors.push_back({problem_.x.sigmas_m[c], problem_.y.sigmas_m[c]});
  }

  JointAdjustment run() {
    for (int64_t pass = 0; pass < settings_.most_passes && !made_.converged; ++pass) {
      task_.checkpoint(static_cast<double>(pass) / static_cast<double>(settings_.most_passes));
      step();
      if (made_.converged && is_exchange_wanted()) exchange();
      if (made_.converged) leave_rare_out();
    }
    finish();
    return std::move(made_);
  }

 private:
  // The points by the attitudes as the pass before left them.
  void stand_turned() {
    if (settings_.has_attitude()) turned_ = turned(made_.points, attitude_rad_);
    turns_ = plan_turns(points());
    xyz_.clear();
    for (const Vec3& p : points().at) xyz_.insert(xyz_.end(), {p.x, p.y, p.z});
  }
  const JointPoints& points() const { return settings_.has_attitude() ? turned_ : made_.points; }

  // Conditions that were linearised where the attitudes stand now: their distances where they are as given.
  void refer_to_given_attitudes() {
    for (StripCondition& strip : problem_.strips)
      for (size_t k = 0; k < problem_.turns(); ++k)
        strip.distance_m -= strip.turns_m[k] * attitude_rad_[static_cast<int>(k)];
  }

  // One pass: match where everything stands, adjust from where it was given, move.
  void step() {
    JointPass pass;
    std::vector<PointMatch> matches = match_points(points(), scene_, places_, settings_, task_);
    leave_unsteady_out(matches);
    made_.weights = strip_weights(points(), scene_, matches, settings_);
    leave_doubtful_out(matches);
    count(matches, pass);
    made_.matches = std::move(matches);
    std::vector<uint32_t> strip_of_point;
    for (const PointMatch& m : made_.matches)
      strip_of_point.push_back(m.state == MatchState::kMatched ? m.strip : kNoStrip);
    conditions_ = strip_conditions(
        {xyz_, made_.points.times_s, strip_of_point, made_.weights, turns_}, scene_.strips,
        made_.trajectory.times_s, settings_.least_points, settings_.sigma_point_m);
    problem_.strips = conditions_.conditions;
    refer_to_given_attitudes();
    weigh_strips();
    pass.strips = problem_.strips.size();
    if (problem_.strips.empty())
      fail(Status::kInsufficientData,
           "no strip has %llu matched points or more: of %zu points that look like a wall's %llu "
           "are on one, %llu too far from it%s",
           static_cast<unsigned long long>(settings_.least_points), made_.points.size(),
           static_cast<unsigned long long>(pass.matched), static_cast<unsigned long long>(pass.far),
           apart_hint(points().at, scene_).c_str());
    const JointSolution solution = solve(JointWanted::kValues);
    pass.chi_square = solution.chi_square;
    pass.step_m = move_to(solution);
    made_.converged =
        (!made_.passes.empty() && pass.changed == 0) || pass.step_m < settings_.tolerance_m;
    made_.passes.push_back(pass);
  }

  // A strip that contradicts the others counts less: its variance grows with the square of its offset in the pass
  // before, from where of so many strips one is as far off in one drive of twenty. (A wrong strip has the offset of
  // another wall; three standard deviations have a strip or two of any drive, and its own offset would be held back.)
  // In the first pass too where blocks were found: strips half on a neighbour's front would drive one along its street.
  void weigh_strips() {
    const bool is_blind = made_.passes.empty() && !is_block_search_wanted(made_.points, settings_);
    if (is_blind || settings_.kernel == JointSettings::Kernel::kNone ||
        settings_.matches == JointSettings::Matches::kIds)
      return;
    const double greatest = rare_deviations(problem_.strips.size());
    const double variance = settings_.sigma_strip_m * settings_.sigma_strip_m;
    for (StripCondition& strip : problem_.strips)
      if (const double t = deviations_of(strip); t > greatest)
        strip.measured_variance_m2 += variance * (t * t / (greatest * greatest) - 1);
  }
  // Where everything but the strip stands as the pass before left it.
  double deviations_of(const StripCondition& strip) const {
    return std::fabs(strip_misfit_m(strip, places_, attitude_rad_)) / settings_.sigma_strip_m;
  }

  // Strips that hide each other by turns would go to and fro for ever; those points are no evidence of either.
  void leave_unsteady_out(std::vector<PointMatch>& matches) {
    constexpr size_t kLatePass = 5;  // most draws of the scenarios have settled by then
    if (made_.passes.size() < begun_ + kLatePass) return;
    for (size_t i = 0; i < matches.size(); ++i) {
      const bool was_out = made_.matches[i].state == MatchState::kUnsteady;
      if (was_out || !(matches[i] == made_.matches[i]))
        matches[i] = {made_.matches[i].strip, MatchState::kUnsteady, matches[i].distance_m};
    }
  }

  // Points of a strip that may be of another (strip_search.h) count for neither.
  void leave_doubtful_out(const std::vector<PointMatch>& matches) {
    for (size_t i = 0; i < matches.size(); ++i)
      if (matches[i].strip != kNoStrip && made_.strip_is_doubtful[matches[i].strip])
        made_.weights[i] = 0;
  }

  // Where all is settled and strips were searched for: one that is rarely so far off is between its wall as seen and
  // where it is given (weigh_strips), one that is elsewhere than where it was found on another surface. They are left
  // out, and the loop goes on without them.
  void leave_rare_out() {
    if (!found_.is_searched) return;
    const double greatest = rare_deviations(problem_.strips.size());
    for (size_t i = 0; i < problem_.strips.size(); ++i) {
      const StripCondition& strip = problem_.strips[i];
      const uint32_t s = conditions_.strip_of[i];
      if (deviations_of(strip) > greatest || found_.is_elsewhere(s, -strip.distance_m)) {
        made_.strip_is_doubtful[s] = true;
        go_on();
      }
    }
  }
  void go_on() {
    begun_ = made_.passes.size();
    made_.converged = false;
  }

  bool is_exchange_wanted() const {
    constexpr size_t kMostExchanges = 3;
    return settings_.exchange && settings_.kernel != JointSettings::Kernel::kNone &&
           settings_.matches == JointSettings::Matches::kRays && exchanges_ < kMostExchanges &&
           is_facade_exchange_wanted(settings_);
  }

  // Where all is settled: facades that stand on the wall of another go elsewhere, and the loop goes on from there.
  void exchange() {
    ++exchanges_;
    const FacadeExchange found = exchange_facades(
        wall_claims({points(), scene_, places_, made_.matches, made_.weights}, settings_, task_),
        scene_.facades);
    if (found.moves.empty() && found.doubtful.empty()) return;
    std::vector<bool> is_moved(scene_.facades, false), is_doubtful(scene_.facades, false);
    for (const FacadeExchange::Move& move : found.moves) {
      places_.model.facades[move.facade] = move.offset_m;
      is_moved[move.facade] = true;
    }
    for (const uint32_t facade : found.doubtful) is_doubtful[facade] = true;
    for (size_t s = 0; s < scene_.strips.size(); ++s) {
      if (is_moved[scene_.strips[s].facade]) places_.model.strips[s] = 0;
      if (is_doubtful[scene_.strips[s].facade]) made_.strip_is_doubtful[s] = true;
    }
    go_on();
  }

  JointSolution solve(JointWanted wanted) {
    const auto by = [&](const JointProblem& problem, JointWanted what) {
      task_.checkpoint(static_cast<double>(made_.passes.size()) /
                       static_cast<double>(settings_.most_passes));
      return solve_reduced(problem, what);
    };
    return settings_.set_back == JointSettings::SetBack::kBehind
               ? solve_set_back(problem_, wanted, by)
               : by(problem_, wanted);
  }

  void count(const std::vector<PointMatch>& matches, JointPass& pass) const {
    double squares = 0, weight = 0;
    for (size_t i = 0; i < matches.size(); ++i) {
      const PointMatch& m = matches[i];
      ++(m.state == MatchState::kMatched   ? pass.matched
         : m.state == MatchState::kNothing ? pass.nothing
         : m.state == MatchState::kBehind  ? pass.behind
         : m.state == MatchState::kFar     ? pass.far
         : m.state == MatchState::kTurned  ? pass.turned
                                           : pass.unsteady);
      if (made_.matches.empty() || !(made_.matches[i] == m)) ++pass.changed;
      squares += made_.weights[i] * m.distance_m * m.distance_m;
      weight += made_.weights[i];
    }
    pass.rms_m = weight > 0 ? std::sqrt(squares / weight) : 0;
  }

  // Everything to where the solution has it; the greatest change.
  double move_to(const JointSolution& solution) {
    JointPlaces next{solution.trajectory,
                     {solution.blocks, places_.model.facades, places_.model.strips}};
    // What has lost its points stays where it was: back at its place it would be met again, and so on for ever.
    for (size_t i = 0; i < solution.strips.size(); ++i) {
      const uint32_t facade = problem_.strips[i].facade;
      next.model.strips[conditions_.strip_of[i]] = solution.strips[i];
      next.model.facades[facade] = solution.facades[facade];
    }
    double most = 0;
    const auto pairs = [&](const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
      for (size_t i = 0; i < a.size(); ++i) most = std::max(most, norm(a[i] - b[i]));
    };
    const auto numbers = [&](const std::vector<double>& a, const std::vector<double>& b) {
      for (size_t i = 0; i < a.size(); ++i) most = std::max(most, std::fabs(a[i] - b[i]));
    };
    pairs(next.trajectory, places_.trajectory);
    pairs(next.model.blocks, places_.model.blocks);
    numbers(next.model.facades, places_.model.facades);
    numbers(next.model.strips, places_.model.strips);
    places_ = std::move(next);
    most = std::max(most, mean_reach_m(made_.points) * norm(solution.attitude_rad - attitude_rad_));
    attitude_rad_ = solution.attitude_rad;
    stand_turned();
    return most;
  }

  void finish() {
    const bool is_whole = settings_.covariance_of == JointSettings::CovarianceOf::kAll;
    JointSolution solution = solve(!settings_.covariance ? JointWanted::kSigmas
                                   : is_whole            ? JointWanted::kWhole
                                                         : JointWanted::kCovariance);
    made_.trajectory.by_m = solution.trajectory;
    made_.trajectory_sigmas = solution.trajectory_sigmas;
    made_.model = {solution.blocks, solution.facades, std::vector<double>(scene_.strips.size(), 0)};
    made_.attitude_bias_rad = solution.attitude_rad;
    made_.attitude_bias_sigmas_rad = solution.attitude_sigmas_rad;
    made_.block_sigmas = solution.blocks_sigmas, made_.facade_sigmas = solution.facades_sigmas;
    made_.strip_sigmas.assign(scene_.strips.size(), settings_.sigma_strip_m);
    made_.strip_distances_m.assign(scene_.strips.size(), kNaN);
    made_.strip_points.assign(scene_.strips.size(), 0);
    for (size_t i = 0; i < solution.strips.size(); ++i) {
      const uint32_t s = conditions_.strip_of[i];
      made_.model.strips[s] = solution.strips[i];
      made_.strip_sigmas[s] = solution.strips_sigmas[i];
      made_.strip_distances_m[s] = problem_.strips[i].distance_m;
      made_.strip_points[s] = conditions_.points[i];
    }
    made_.strips = problem_.strips.size(), made_.chi_square = solution.chi_square;
    // What is held at 0 is a condition as well.
    const auto held = std::count(problem_.is_held.begin(), problem_.is_held.end(), true);
    made_.p_value =
        chi_square_tail(static_cast<double>(problem_.conditions()) + static_cast<double>(held),
                        solution.chi_square);
    if (settings_.covariance)
      made_.covariance = std::move(is_whole ? solution.whole_covariance : solution.covariance);
    find_wrong_shares();
    const WeakDirection weak = weak_direction(problem_.strips);
    made_.weak_direction = weak.direction, made_.weak_share = weak.share;
  }

  void find_wrong_shares() {
    made_.wrong_share = made_.wrong_facade_share = kNaN;
    if (made_.points.id.empty()) return;
    uint64_t all = 0, wrong = 0, wrong_facades = 0;
    for (size_t i = 0; i < made_.matches.size(); ++i) {
      if (!(made_.weights[i] > 0)) continue;
      const uint32_t strip = made_.matches[i].strip, id = made_.points.id[i];
      ++all;
      wrong += strip != id ? 1 : 0;
      const bool is_other =
          id >= scene_.strips.size() || scene_.strips[id].facade != scene_.strips[strip].facade;
      wrong_facades += is_other ? 1 : 0;
    }
    made_.wrong_share = static_cast<double>(wrong) / static_cast<double>(all);
    made_.wrong_facade_share = static_cast<double>(wrong_facades) / static_cast<double>(all);
  }

  const JointSettings& settings_;
  Task& task_;
  StripScene scene_;
  JointProblem problem_;
  StripConditions conditions_;
  JointPlaces places_;
  FoundStrips found_;                 ///< before the first pass
  size_t exchanges_ = 0, begun_ = 0;  ///< of facades; the pass that the last of them led to
  Vec3 attitude_rad_;        ///< turns about the vehicle's axes, where the last pass left them
  JointPoints turned_;       ///< the points by them; empty where attitudes stay
  std::vector<double> xyz_;  ///< of points()
  std::vector<std::array<Vec2, 3>> turns_;  ///< of points(), their derivatives by turns
  JointAdjustment made_;
};

// Upright walls say nothing of heights: these follow from the points as they now stand in plan.
void adjust_heights(const Model& model, const Cloud& cloud, const Trajectory& given,
                    const JointSettings& settings, JointAdjustment& made, Task& task) {
  const std::vector<double>& times = made.trajectory.times_s;
  const Trajectory controls = interpolated(given, times);
  const GaussMarkov drive = position_prior(controls, 2);
  made.height_sigmas_m = made.height_priors_m = drive.sigmas_m;
  made.heights_m.assign(times.size(), 0);
  if (!(settings.sigma_ground_m > 0)) return;
  const auto ground = ground_of(model, task);
  if (ground == nullptr)
    fail(Status::kInvalidArgument,
         "sigma_ground_m is set, but the model has no ground: faces of class \"ground\"");
  GroundSearch search;
  search.noise_m = settings.sigma_point_m, search.least_points = settings.least_points;
  for (const double sigma : drive.sigmas_m)
    search.greatest_m.push_back(greatest_deviation(settings) *
                                std::hypot(sigma, settings.sigma_ground_m, settings.sigma_point_m));
  made.ground = ground_rises(adjusted_cloud(made, given, cloud, task),
                             adjusted_trajectory(made, given), times, *ground, search, task);
  if (made.ground.empty()) return;
  HeightSolution solved = solve_heights(
      drive,
      ground_chain(controls.positions, settings.sigma_ground_m, settings.ground_correlation_m),
      made.ground);
  made.heights_m = std::move(solved.by_m);
  made.height_sigmas_m = std::move(solved.sigmas_m);
  made.ground_chi_square = solved.chi_square;
}

}  // namespace

JointAdjustment adjust_jointly(const Model& model, const Cloud& cloud, const Trajectory& trajectory,
                               const JointSettings& settings, Task& task) {
  require_prior(trajectory, settings);
  JointAdjustment made =
      JointLoop(model, with_whole_beams(cloud), trajectory, settings, task).run();
  adjust_heights(model, cloud, trajectory, settings, made, task);
  return made;
}

}  // namespace jalon
