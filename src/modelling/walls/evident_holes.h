// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "modelling/evidence/find_openings.h"
#include "modelling/walls/holes.h"

namespace jalon {

/// The opening among the candidates that a hole was drawn for, or -1: that whose box has most in common with its own.
int32_t candidate_of(const WallHole& hole, std::span<const OpeningCandidate> candidates);

/// The holes of a wall that was drawn by its evidence: those of its faces; for each opening at the border the notch
/// that was cut for it, or, where its form shows in no face (a pier beside it whose foot nobody saw; a canopy that
/// hides the wall above it, so that the notch goes on there), the shape itself as a bay. Other notches are the wall's
/// own outline. Openings that are in no face at all are left out.
std::vector<WallHole> evident_holes(const VectorPlane& wall,
                                    std::span<const OpeningCandidate> candidates);

/// Of notches that stand for one opening (the outline goes down beside it in steps, and each step's notch holds it) the
/// one that has most in common with it stays.
void drop_second_notches(std::span<const OpeningCandidate> candidates,
                         std::vector<WallHole>& holes);

/// Whether a hole holds several openings side by side, none of them most of it, and a pier comes down between them:
/// where the foot of the pier was hidden the outline has one notch for them all, which stands for none.
bool holds_several(const WallHole& hole, std::span<const OpeningCandidate> candidates);

/// Bays for openings of a wall that none of its holes stands for, as evident_holes has them: those that the broad wall
/// frames, or with faces of the wall beside them.
void add_bays(const VectorPlane& wall, std::span<const OpeningCandidate> candidates,
              std::vector<WallHole>& holes);

}  // namespace jalon
