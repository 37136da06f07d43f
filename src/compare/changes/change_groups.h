// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "compare/changes/change_pieces.h"
#include "compare/changes/object_motion.h"

namespace jalon {

/// Pieces of one change.
struct ChangeGroup {
  ChangedObject object;
  double before_m2 = 0, after_m2 = 0;  ///< changed area
  double moved_share = 0;              ///< of its points, on a surface that both epochs saw
  Box3 box;                            ///< local

  size_t points() const { return object.before.size() + object.after.size(); }
  /// Less than a tenth of the other side is the edge of that.
  bool only_after() const;
  bool only_before() const;
};

/// Groups of all pieces, by their first.
std::vector<ChangeGroup> change_groups(const ObjectMotionJob& job);

/// Does the whole hold most of the part's points? Both ascending.
bool lies_in(const ChangedObject& part, const ChangedObject& whole);

}  // namespace jalon
