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
  kFeatureLike,  ///< how like a change of the opposite kind nearby is, by area: it may be the same thing
  kFeatureNear,          ///< 1 right beside another statement: they may be pieces of one change
  kFeatureMovedSurface,  ///< share of the changed points that lie on a surface which both epochs saw
  kFeatureMayHaveMoved,  ///< of what did not move: the largest probability of a motion that explains it as well
  // Of a motion: what it does not explain, as a logarithm, laid forth and back, the larger and the lesser, of the thing
  // and of what changed of it; before and after tell alike.
  kFeatureWorst,
  kFeatureBest,
  kFeatureChangedWorst,
  kFeatureChangedBest,
  kFeatureJudged,  ///< share of the points that could have been seen, of both epochs the lesser
  kFeatureChangedOfWhole,  ///< share of the thing's points that changed
  kFeatureWay,             ///< in thresholds
  kFeatureWayOfSize,       ///< in sizes of the thing
  kFeatureLikeCount,       ///< lesser over larger number of points, as a logarithm
  kFeatureLikeExtents,     ///< the same of the extents of its upright box, where they differ most
  kFeatureWhole,           ///< 1 where the thing ended within reach
  // And of that nothing moved: what that does not explain, of both epochs the lesser and the larger. A thing that was
  // pushed left a place, and a thing that grew did not.
  kFeatureStayBest,
  kFeatureStayWorst,
  kFeatureTilt,        ///< of the motion's way, what turns the thing off that which it stands on
  kFeatureTiltOfSize,  ///< that way in sizes of the thing: what leans gave way, what fell over moved
  kFeatureSpread,      ///< lower decile over median distance: what gave way does so from nothing
  kFeatureLikeShape,  ///< of what kFeatureLike is of: how like in extents as well, whichever side is up
  kFeatureBorderAlong,  ///< at its borders, how far the changed surface leaves the other epoch's along it: what gave
                        ///< way does, what stands on something does not
  kFeatureGone,  ///< share of the changed points whose nearest surface of the other epoch is gone or out of sight
  kFeatureFacing,      ///< how far they face as that surface does
  kFeatureFacingGone,  ///< both at once: the surface that gave way
  kChangeFeatures
};
using ChangeFeatures = std::array<double, kChangeFeatures>;

/// The logarithm of what is at least 0; it ends at e^-5 and e^5: beyond, more of it tells nothing more.
double limited_log(double value);

/// Families of statements, each with weights of its own: came or went, moved, gave way.
constexpr size_t kChangeFamilies = 3;
size_t family_of(const Change& change);

/// Sets what speaks for a change by itself.
void set_own_features(const ObjectMotionJob& job, Change& change);
/// Sets the features of all changes of a diagnosis by evidence: their own, and what each is among the others; motions
/// have theirs. others: the motions that were weighed and not chosen.
void set_features(const ObjectMotionJob& job, const std::vector<Change>& others,
                  std::vector<Change>& changes);

}  // namespace jalon
