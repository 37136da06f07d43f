// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "registration/registration.h"

namespace jalon {

/// One direction of the six unknowns: a unit vector over (turns x extent, shifts), all in metres.
struct PoseDirection {
  Coefficients<6> unit{};
  double sigma_m = 0;  ///< standard deviation along it; NaN where nothing fixes it
  bool observable = true;
};

/// The principal directions of a pose's covariance, the weakest first: eigenvectors, the turns scaled by the extent.
std::array<PoseDirection, 6> pose_directions(const Square<6>& covariance, double extent_m);

/// Sets the columns that every method gives in summary, and directions with their count of those unobservable;
/// columns that a method has put into summary before come after the common ones.
void fill_tables(Registration& registration, const std::array<PoseDirection, 6>& directions);

/// Sets the columns "converged" and "stopped" of the summary anew.
void set_stopped(Registration& registration);
/// Sets the judgement and its columns of the summary, after those of fill_tables().
void fill_judgement(Registration& registration, PoseJudgement judgement);
/// The judgement by why a search stopped: not judged where it found its pose, else refused.
PoseJudgement judgement_of_search(StopReason stopped);
/// Makes the covariance and the sigmas of all directions NaN: those of a pose that is not accepted would mislead.
void hide_sigmas(Registration& registration);

}  // namespace jalon
