// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/icp/confirm.h"

#include <algorithm>

#include "geometry/rigid_motion.h"
#include "registration/icp/settle.h"
#include "registration/verdict/slide.h"

namespace jalon {

namespace {

constexpr double kFarthest = 1.5;  // radii of gyration: the half of a long cloud
// Reaches that the last steps may lead away from where the surfaces held the pose.
constexpr double kStays = 4;

SlideWay way_of(const Coefficients<6>& unit, const IcpFrame& frame) {
  return {frame.centre, Vec3{unit[0], unit[1], unit[2]} / frame.extent_m,
          Vec3{unit[3], unit[4], unit[5]}};
}

double greatest_move_m(const IcpProblem& problem, const Transform& from, const Transform& to) {
  const Transform move = to * inverse(from);
  const IcpFrame frame = problem.frame(from);
  return norm(move.point(frame.centre) - frame.centre) +
         norm(rotation_vector(move)) * problem.extent_m;
}

}  // namespace

double icp_confirm(const IcpProblem& problem, const IcpJudged& judged, const IcpLevel& all,
                   IcpState& state, Task& task) {
  if (!state.has_all(problem) || state.stopped == StopReason::kTooFewPairs) return 0;
  // 1. What the surfaces say of each direction that is open.
  const IcpDirections& directions = state.last.directions;
  const IcpFrame frame = problem.frame(state.T_reference_moving);
  size_t open = 0, fixed = 0;
  double better_m = 0;
  for (size_t k = 0; k < 6; ++k) {
    if (directions.observable[k]) continue;
    const Slide slide =
        slide_along(judged.reference, judged.moving, state.T_reference_moving,
                    way_of(directions.unit[k], frame), kFarthest * problem.extent_m, task);
    ++open;
    fixed += slide.is_fixed;
    if (slide.better_m != 0) better_m = slide.better_m;
  }
  if (open == 0 || fixed < open || better_m != 0) return better_m;
  // 2. The last steps again, in all directions.
  IcpState again;
  again.T_reference_moving = state.T_reference_moving;
  again.distance_m = state.distance_m;
  again.sigma_m = state.sigma_m;
  again.log = state.log;
  again.over_noise = kOverNoiseConfirmed;
  if (icp_iterate(problem, all, again, task)) {
    icp_settle(problem, again, task);
    const double most_m = kStays * reach_of(judged.reference, judged.moving);
    if (greatest_move_m(problem, state.T_reference_moving, again.T_reference_moving) <= most_m)
      state = std::move(again);
  }
  return 0;
}

}  // namespace jalon
