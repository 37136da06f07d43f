// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "registration/targets/adjustment.h"
#include "registration/targets/targets.h"

namespace jalon {

/// A target of the reference and one of the moving set, by index.
struct IndexPair {
  size_t reference, moving;
  bool operator==(const IndexPair&) const = default;
};

/// Refuses two targets of one name or at one place, and covariances that are none (kInvalidArgument). side: "reference"
/// or "moving".
void require_distinct(std::span<const Target> targets, const char* side);

/// Targets of the same name, in the order of the moving ones.
std::vector<IndexPair> pairs_by_name(std::span<const Target> reference,
                                     std::span<const Target> moving);

/// Whole metres near the targets: coordinates of a national grid are worked on relative to them.
Vec3 origin_of(std::span<const Target> targets);
/// Pairs for the adjustment, relative to these origins, in the order of the pairs. sigma_m: of
/// targets without a covariance of their own.
std::vector<TargetPair> measured_pairs(std::span<const Target> reference,
                                       std::span<const Target> moving,
                                       std::span<const IndexPair> pairs,
                                       const Vec3& reference_origin, const Vec3& moving_origin,
                                       double sigma_m);
/// The covariance of a target: its own, or sigma_m on each axis.
Square<3> covariance_of(const Target& target, double sigma_m);

}  // namespace jalon
