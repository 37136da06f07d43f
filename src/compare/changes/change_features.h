// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace jalon {

struct Change;
struct ObjectMotionJob;

/// What speaks for a statement of the diagnosis by evidence and against it. Shares are 0 ... 1, sizes and counts are
/// logarithms, and all are limited, so that none outweighs the others far from where the weights were fitted.
enum ChangeFeature : size_t {
  kFeatureOne,         ///< 1
  kFeaturePoints,      ///< changed points of both epochs
  kFeatureNoStations,  ///< 1 where what the scanners could see is unknown
  kFeatureThrough,  ///< share of the changed points whose place the other epoch's stations saw through
  kFeatureNothingNear,  ///< without stations: share of those that have nothing near
  kFeatureThresholds,   ///< median distance in thresholds
  kFeatureLevels,       ///< the same in standard deviations of noise
  kFeatureSpacings,     ///< the same in spacings of the changed points
  kFeatureExtent,       ///< diagonal of the changed points' box in spacings
  kFeatureSlender,      ///< second over first standard deviation of the changed points
  kFeatureBesideHidden,  ///< share of what lies beside the changed points that the other epoch could not see
  kFeatureBesideSame,  ///< the same of what did not change: a thing that came or went is found whole
  kFeatureBothSides,   ///< lesser over larger changed area of the two epochs
  kFeatureExplained,   ///< share of the points explained by one rigid motion
  kFeatureLike,  ///< how like a change of the opposite kind nearby is, by area: it may be the same thing
  kFeatureNear,  ///< 1 right beside another statement: they may be pieces of one change
  kChangeFeatures
};
using ChangeFeatures = std::array<double, kChangeFeatures>;

/// Families of statements, each with weights of its own: came or went, moved, gave way.
constexpr size_t kChangeFamilies = 3;
size_t family_of(const Change& change);

/// Sets the features of all changes of a diagnosis by evidence.
void set_features(const ObjectMotionJob& job, std::vector<Change>& changes);

}  // namespace jalon
