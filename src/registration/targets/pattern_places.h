// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/field.h"
#include "cloud/cloud.h"
#include "registration/targets/measure.h"

namespace jalon {

/// Where the brightness may show a pattern.
struct PatternPlace {
  Vec3 place;
  TargetKind kind = TargetKind::kChecker;
  double size_m = 0;    ///< the one it was looked for
  double likeness = 0;  ///< squared correlation of the brightness with the pattern: 0 ... 1
};

/// The whole cloud is looked through at a quarter of the size apart: around each place the plane of
/// its points, and in it the brightness against the second harmonic about the place (a checker,
/// however turned) or what is near the place against what is not (a disc). Where points are dense, means of cells are
/// looked at first, and the points only where these show something.
///
/// After: of places less than 0.3 of a size apart the one most alike; the most alike first. The same
/// for any number of threads.
std::vector<PatternPlace> pattern_places(const Cloud& cloud, const Octree& tree,
                                         const Column& intensity, TargetKind kind, double size_m,
                                         double tolerance_m, uint64_t min_points, Task& task);

}  // namespace jalon
