// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "modelling/walls/hole_content.h"

namespace jalon {

/// What closes an opening, and what stands in it before that.
struct Joinery {
  const HoleFiller* filler =
      nullptr;  ///< of the content given; null: nothing parallel to the wall lies behind it
  std::vector<uint32_t>
      standing;  ///< segments parallel to the wall before it: parapets, mullions, surrounds
};

/// The joinery (Boulaassal 2010, 4.4.2) among the fillers min_depth_m and more behind the wall:
/// 1. fillers of nearly one depth are one level (frame and glass);
/// 2. the level with the most cells, unless a deeper one lies beside it in the elevation (panes above a parapet): then
/// the deepest such; or a nearer one covers much of the same place (a pane before a curtain): then that;
/// 3. of that level its foremost filler that is no handle: the frame, where it shows.
Joinery joinery_of(const HoleContent& content, double min_depth_m);

}  // namespace jalon
