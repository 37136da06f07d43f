// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "model/trajectory/trajectory.h"
#include "registration/joint/joint_adjustment.h"
#include "registration/joint/strip_scene.h"

namespace jalon {

/// Plan of a drive and the buildings that it was adjusted with, as SVG, north up, axes in metres: facades where they
/// are given, those that points hold dark; the drive as given red and as adjusted green, its corrections and 95 %
/// ellipses drawn larger than they are by a stated factor; blue, by the same factor, as it was, where that is known
/// (truth may be null; epochs beyond its ends are left out).
std::string drive_plan(const StripScene& scene, const JointAdjustment& adjustment,
                       const Trajectory& given, const Trajectory* truth);

/// A strip as given, seen from above: the longest extent of the corners of its faces along the wall.
struct PlanLine {
  Vec2 a, b;
  bool is_held;  ///< points were matched to it
  uint32_t strip;
};
std::vector<PlanLine> plan_lines(const StripScene& scene, const JointAdjustment& adjustment);

/// The factor: 1, or a 1, 2 or 5 times a power of ten by which the greatest of the corrections stays below
/// paper_mm on a plan of this scale.
double drive_plan_factor(double greatest_m, double mm_per_m, double paper_mm);

}  // namespace jalon
