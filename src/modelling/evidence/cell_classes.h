// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "base/task.h"
#include "modelling/evidence/wall_cells.h"

namespace jalon {

/// What points say of a cell; several may hold.
constexpr uint8_t kMarkOn = 1, kMarkBehind = 2, kMarkProud = 4, kMarkBefore = 8, kMarkRelief = 16,
                  kMarkDeep = 32, kMarkFlush = 64, kMarkParallel = 128;

/// One state a cell from its marks.
/// 1. On the plane before behind it, behind it before relief, then proud, then hidden, then deep: what lies behind
///    was seen through, what lies far behind something that hides the wall was seen past it.
///    What stands proud in planes parallel to the wall and is taller than parapets is relief: pilasters.
///    Narrow things that stand proud between gaps hide what is behind: bars and rails of balconies.
/// 2. Points on the plane in strips narrower than a pier, with little of the wall about them, are strips.
/// 3. So are small pieces apart from the wall, seen through all about: leaves and stiles flush with it.
/// 4. Inside are cells with wall above and no lower than the wall's foot nearby, and those with wall to the left and
///    right that were seen through; the sky between gables is neither.
/// Before: one mark a cell of out, whose states are ignored. O(cells).
void classify_cells(std::span<const uint8_t> marks, WallCells& out, Task& task);

}  // namespace jalon
