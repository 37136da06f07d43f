// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/task.h"
#include "modelling/evidence/evidence.h"

namespace jalon {

/// Two explanations of planes that lie on one another: pieces of one wall, or what fills the openings of another (the
/// leaves of its doors, as deep as the walls of dormers or the house next door stand back). Pieces that lie in framed
/// openings of a wall that explains more are its filling; they stay together and leave the others, whose largest is the
/// wall then. A piece that has measured wall on both sides and above it, whatever opening that has there, stands alone.
/// Pieces leave the others too that stand up to relief_m before another wall and touch that, and none of the others:
/// the surrounds of a house whose neighbour stands forward by as much.
///
/// whole: of each segment the label of the one it is a piece of (coplanar.h); evidence: of the segmentation with these.
/// After: the same with these apart.
std::vector<uint32_t> pieces_apart(const Segmentation& given, const std::vector<uint32_t>& whole,
                                   const std::vector<WallEvidence>& evidence, double relief_m,
                                   Task& task);

/// Evidence for walls as wholes: pieces joined where they lie on one plane, fillings apart. segmentation becomes that
/// with these wholes. A segment of a wall of which some points fill framed openings of a larger one is in two pieces:
/// these are a segment behind the last one given. tolerance_m: of coplanar.h.
std::vector<WallEvidence> gather_whole_walls(Segmentation& segmentation, double tolerance_m,
                                             const EvidenceSetting& setting, Task& task);

}  // namespace jalon
