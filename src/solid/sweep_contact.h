// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "solid/motion.h"
#include "solid/triangle_contact.h"

namespace jalon {

/// The least signed distance of an obstacle from a piece during a motion.
struct SweptContact {
  Contact contact;  ///< in the gauge's frame at that time
  double time = 0;  ///< 0 ... 1
};

/// Accuracy of least_during: the value is reached at the time given, and no other time is lower by more.
constexpr double kSweepTolerance_m = 5e-7;

/// The least signed distance of an obstacle (one corner or three, each Motion::start) while the gauge moves; false when
/// it is above limit, or not by more than the tolerance below it.
///
/// No contact between the poses is missed. Branch and bound on the time: over a span the corners leave their chords by
/// at most h^2 / 8 of their acceleration, and only across the axis; along the chords the planes that touch the (convex)
/// signed distance at both ends of the span bound it from below; spans whose bound is above the best value so far are
/// done, others are cut where the bound is least.
bool least_during(const ConvexPiece& piece, const Motion& motion, std::span<const Vec3> corners,
                  double limit, SweptContact& out);

/// False only if no point of a ball comes within limit of the piece during the motion: the same bounds, given up after
/// a few cuts. lowest: the least distance of the ball that was met.
bool may_come_within(const ConvexPiece& piece, const Motion& motion, const Vec3& centre,
                     double radius_m, double limit, double& lowest);

}  // namespace jalon
