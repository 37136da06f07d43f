// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scan/grammar/dice.h"
#include "scan/grammar/plan.h"

namespace jalon::grammar {

/// Faces of the plan's walls, of what fills their openings and of what stands on them. Parts: facade, under it the
/// walls ("wall"), under these their openings (the word of the opening's class) with reveal, joinery, glass ...
void realise(const Plan& plan, Dice& dice, SceneBuilder& out);

/// What fills an opening of the wall with this frame, under its part: reveals, joinery, glass or a leaf.
void add_filling(SceneBuilder& out, uint32_t part, const Frame& wall, const PlannedOpening& opening,
                 Dice& dice);

/// Ground, and the rooms behind the walls, whose back walls and floors are seen through glass.
void add_ground(const Plan& plan, double reach_m, SceneBuilder& out);
void add_rooms(const Plan& plan, SceneBuilder& out);
/// Trees, parked cars, people and posts before the front.
void add_occluders(const Plan& plan, uint64_t seed, SceneBuilder& out);

}  // namespace jalon::grammar
