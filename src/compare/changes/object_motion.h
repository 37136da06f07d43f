// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "compare/changes/diagnosis.h"

namespace jalon {

/// Both epochs and what motions are judged by.
struct ObjectMotionJob {
  const Epoch &before, &after;
  double tolerance_m, threshold_m, cell_m;
  SeenTest seen_before, seen_after;
  Task& task;

  std::vector<Vec3> points(const Epoch& epoch, const std::vector<uint32_t>& indices) const {
    std::vector<Vec3> out;
    out.reserve(indices.size());
    for (const uint32_t i : indices) out.push_back(epoch.local(i));
    return out;
  }
  std::vector<Vec3> before_of(const ChangedObject& o) const { return points(before, o.before); }
  std::vector<Vec3> after_of(const ChangedObject& o) const { return points(after, o.after); }
};

/// Does the object after take up room that it took before?
bool overlaps(const ObjectMotionJob& job, const ChangedObject& object, double margin_m);
/// One rigid motion of the object, or none that explains enough.
Change moved_or_deformed(const ObjectMotionJob& job, ChangedObject object);
/// Of a rigid motion by more than the threshold that lays the whole object onto itself as well as any does: what
/// speaks for it. Of a thing that was pushed only the ends changed (by the labels of the epochs). False where there is
/// none, or it would go through what the object stands on.
bool motion_of_whole(const ObjectMotionJob& job, ChangedObject whole, Change& out);
/// Of an object's upright box, the least first.
using Extents = std::array<double, 3>;
Extents extents_of(const std::vector<Vec3>& points, const ChangedObject& object);
/// Could one be the other, moved?
bool are_twins(const ObjectMotionJob& job, const Extents& gone, const Extents& come);
/// The points before of one, those after of the other.
ChangedObject joined(const ChangedObject& gone, const ChangedObject& come);

}  // namespace jalon
