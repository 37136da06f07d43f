// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/buildings/building_tree.h"

namespace jalon {

/// Whether the model is of strips already, as one that was adjusted and read again: parts of class strip below facades
/// below buildings below blocks, none of them without, the strips of a facade upright and turned the same way (5
/// degrees).
bool is_of_strips(const Model& model);
/// The tree of such a model: same blocks, buildings, facades and strips in the same order. A facade stands upright in
/// the mean of its strips' planes, weighted by area; its strips keep their places before it.
BuildingTree given_strips(const Model& model);

}  // namespace jalon
