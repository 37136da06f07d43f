// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "registration/joint/joint_points.h"
#include "registration/joint/strip_scene.h"

namespace jalon {

/// Where each block stands best before anything is adjusted, within five of its standard deviations: where most beams
/// end on its walls and few go through them (beams that end before a wall say nothing). A block that is off by metres
/// along its street meets the walls of its neighbours, and no loop of matching and adjusting brings it back. All else
/// is taken as it is given, so that it must be surer than the blocks: else each block stays where it is given
/// (is_block_search_wanted). Of a grid of places the best are kept and looked at ever more finely, with an ever smaller
/// tolerance. O(blocks places points log strips), parallel.
std::vector<Vec2> find_blocks(const JointPoints& points, const StripScene& scene,
                              const JointSettings& settings, Task& task);

/// By the sigmas: blocks may be off by more than the loop bridges, and by more than everything else together.
bool is_block_search_wanted(const JointPoints& points, const JointSettings& settings);

}  // namespace jalon
