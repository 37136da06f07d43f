// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "modelling/facade/plan.h"

namespace jalon {

/// What the class of an opening is told from, in this order; opening_features.cpp says how each is reckoned.
enum class OpeningFeature : uint8_t {
  kOne,
  kWidth,  ///< logarithms of full sizes in m, and their products
  kHeight,
  kWidthSquared,
  kHeightSquared,
  kWidthByHeight,
  kFoot,      ///< over the ground, m, up to 2
  kOnGround,  ///< 1 at the ground, 0 above a step's height
  kUpstairs,  ///< 0 in the lowest storey, 1 above
  kHead,      ///< over the ground, m, up to 5
  kDepth,     ///< of the joinery, m, up to 1
  kNoDepth,   ///< 1: it is not known
  kShallow,   ///< 1 flush with the wall, falling to 0 within a decimetre
  kJoinery,   ///< OpeningContent
  kBehind,
  kEmpty,
  kSetBack,   ///< share of the opening that a wall farther behind it fills
  kSameRow,   ///< logarithm of 1 + the number of openings of its size at its height in the facade
  kSameSize,  ///< ... and anywhere in it
  kArched,
  kRound,     ///< no straight side
  kAtBorder,  ///< of its wall's face
  kGroundWidth,  ///< products with kOnGround: what tells doors, gateways and shop fronts from each other
  kGroundHeight,
  kGroundJoinery,
  kGroundBehind,
  kGroundEmpty,
  kGroundSameRow,
  kGroundDepth,
  kSmallShallow,  ///< kShallow of those below half a square metre
  kOverDoor,  ///< 1 right over one of its size on the ground, and its foot below those beside it: loading doors
  kCount
};
inline constexpr size_t kOpeningFeatures = static_cast<size_t>(OpeningFeature::kCount);
using OpeningFeatures = std::array<double, kOpeningFeatures>;

/// Of all openings of a facade, wall by wall. plan: its planes' faces are final.
std::vector<std::vector<OpeningFeatures>> opening_features(const FacadePlan& plan,
                                                           const PlannedFacade& facade);

}  // namespace jalon
