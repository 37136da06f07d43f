// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "compare/changes/change_objects.h"

namespace jalon {

/// A changed region of one epoch, with what tells whether it belongs with another.
struct ChangePiece {
  bool is_after = false;
  uint32_t label = 0;
  size_t points = 0;
  double moved_share =
      0;  ///< of its points, on a surface that both epochs saw; the others were seen through
  Vec3 centroid, normal;   ///< local; of the plane through it
  double thickness_m = 0;  ///< standard deviation about that plane
  double size_m = 0;       ///< diagonal of its box
  double offset_m = 0;     ///< mean distance from the other epoch along the normal, with its sign
  Box3 box;                ///< local
  std::vector<Vec3> sample;
};

/// The least distance between two boxes.
double box_gap(const Box3& a, const Box3& b);

std::vector<ChangePiece> change_pieces(const Epoch& before, const Epoch& after, Task& task);

/// Pieces of one change: 1. of both epochs, where one's points have their nearest in the other; 2. of one epoch, the
/// same surface moved by the same way, parted by what stands before it; 3. of one epoch, side by side;
/// 4. of one epoch, parts of one surface by a station's view; 5. of a surface that moved, what the other epoch has no
/// piece for and lies where another moved: the foot of a wall with the ground that it stood on. Indices into pieces,
/// ascending; the groups by their first piece. O(pieces^2 + points).
std::vector<std::vector<size_t>> group_pieces(const Epoch& before, const Epoch& after,
                                              const std::vector<ChangePiece>& pieces, double cell_m,
                                              Task& task);

}  // namespace jalon
