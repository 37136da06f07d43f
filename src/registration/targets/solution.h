// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/task.h"
#include "registration/targets/pairs.h"
#include "registration/targets/snooping.h"

namespace jalon {

/// Both sets, relative to their origins.
struct TargetSets {
  std::span<const Target> reference, moving;
  Vec3 reference_origin, moving_origin;
};

/// One pair after the adjustment: in use, or removed as an outlier and predicted by the others.
struct TestedPair {
  IndexPair pair;
  Vec3 residual_m;
  Square<3> cofactor{};
  TargetTest test;
  bool removed = false;
};

struct TargetSolution {
  TargetAdjustment adjustment;  ///< relative to the origins of the sets
  std::vector<TestedPair> pairs;
  std::vector<TargetPair> used;
  double sigma0 = 1;  ///< factor of all standard deviations
  uint64_t removed = 0;
};

/// Closed form, then adjustment, of 3 pairs or more. Nothing, and why, for pairs along one line, as
/// far as the covariances can tell, and for mirrored sets; kInvalidArgument for covariances without
/// an inverse. After: the weakest turn is fixed.
std::optional<TargetAdjustment> solve_pairs(std::span<const TargetPair> pairs,
                                            const TargetSettings& setting, std::string& why);
/// Adjusts, tests and, where the setting asks for it, removes the worst outlier and starts again
/// while 3 pairs and more are left. kInsufficientData below 3 pairs; kDegenerate where they give no
/// pose. After: the pairs in use in the order they came, as in used and in the adjustment, then
/// those removed in the order of their removal.
TargetSolution solve_targets(const TargetSets& sets, std::vector<IndexPair> pairs,
                             const TargetSettings& setting, Task& task);
/// Back from the origins of the sets to the coordinates that came: the pose between these.
Transform placed(const Transform& T_reference_moving, const TargetSets& sets);

}  // namespace jalon
