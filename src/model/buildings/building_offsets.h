// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "base/params.h"
#include "model/model.h"

namespace jalon {

/// How well blocks, facades and strips are placed: independent, centred (operation "building_sigmas").
struct BuildingSigmas {
  double block_m = 1, facade_m = 0.5, strip_m = 0.3;
  uint64_t seed = 1;  ///< of a draw
};
std::span<const ParamRow> building_sigma_rows();

/// How far each stands off: blocks in plan, facades and strips along the facade's normal.
struct BuildingOffsets {
  std::vector<Vec2> blocks;
  std::vector<double> facades, strips;
};
/// For as many as the model has of parts of these classes.
BuildingOffsets drawn_offsets(const Model& strips, const BuildingSigmas& sigmas);
/// A model of strips (building_tree.h) with each face moved by the offsets of its block, facade and strip; what is of
/// no strip goes with its block, or stays. Error(kInvalidArgument) for a model without strips.
Model moved_strips(const Model& strips, const BuildingOffsets& offsets);

}  // namespace jalon
