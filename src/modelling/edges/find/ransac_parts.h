// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "modelling/edges/find/chain_parts.h"

namespace jalon {

/// How lines are drawn from contour points; zeros are worked out from the spacing.
struct RansacPartsSetting {
  double spacing_m = 0.01;    ///< of the points of the segment
  bool arcs = true;           ///< false: what is no line is a line all the same
  double tolerance_m = 0;     ///< half-width of a line; 0: half a spacing
  double gap_m = 0;           ///< between neighbouring points of one straight part; 0: 5 spacings
  uint32_t min_points = 5;    ///< of a straight part
  double probability = 0.99;  ///< that the best line is not missed
  uint64_t seed = 1;
};

/// The straight and curved parts of a closed chain as Boulaassal 2010, 4.3.1 and 4.3.3, finds them: lines by RANSAC
/// (Fischler & Bolles 1981), the one of most points first, its points taken away, as long as one has enough; each line
/// cut where its points lie further apart than the gap, and refitted (total least squares); what is left between two of
/// them is a curve where a circle explains it. Three stretches or more that one circle explains are chords of an arc.
///
/// Before: chain closed, 3 points or more, none twice in a row. After: as of split_chain(): parts follow each other
/// round the chain, every point is in one, and those between two in both. Same seed, same parts. O(n d) for d draws.
std::vector<ChainPart> ransac_parts(std::span<const Vec2> chain, const RansacPartsSetting& setting);

}  // namespace jalon
