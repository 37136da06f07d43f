// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/field.h"
#include "base/params.h"
#include "cloud/cloud.h"
#include "geometry/cholesky.h"
#include "geometry/vec.h"
#include "registration/judgement.h"

namespace jalon {

/// Why a registration stopped; the numbers of jalon/registrar.h.
enum class StopReason : uint8_t {
  kConverged = 1,
  kIterationLimit = 2,
  kTooFewPairs = 3,   ///< what is left in common does not carry the pose
  kAmbiguous = 4,     ///< another pose, clearly different, fits about as well
  kNothingFound = 5,  ///< no pose explains both
};

/// Result of a registrar: immutable. The methods fill in the numbers and their own columns; the common columns of
/// summary and directions come from fill_tables().
struct Registration {
  Transform pose;  ///< T_reference_moving; of a similarity with the scale in its matrix
  double scale = 1;
  bool converged = false;
  StopReason stopped = StopReason::kNothingFound;
  PoseJudgement judgement;
  /// In the reference frame: the point that the small rotation of the covariance turns about.
  Vec3 centre;
  /// Of the rotation vector (rad) about the centre, then the shift (m) of the centre: the pose is
  /// motion_about(centre, rotation, shift) * true pose. NaN where unknown.
  Square<6> covariance{};
  uint64_t pairs = 0;  ///< that the last step stood on
  uint64_t iterations = 0;
  double rms_m = 0;  ///< of the residuals of those pairs
  /// A length that makes turns and shifts comparable: radius of gyration of what carries the pose.
  double extent_m = 1;
  uint64_t unobservable = 0;  ///< directions of the six that nothing fixes
  FieldTable summary, iteration_log, residuals, directions;
  std::vector<std::string>
      pair_names;  ///< of the rows of residuals; empty where pairs have no names
  std::string parameters_json;
};
using RegistrationPtr = std::shared_ptr<const Registration>;

}  // namespace jalon
