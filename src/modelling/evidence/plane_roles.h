// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/task.h"
#include "modelling/evidence/evidence.h"

namespace jalon {

/// What each plane is to those before and behind it.
/// 1. Rooms' walls: parallel to walls before them and straight behind what was measured of these, all together, as
///    what is seen at a slant through openings is. Wings that stand back are seen beside the walls before them.
/// 2. Surrounds, panes, leaves: of two planes near each other the one that explains more is the wall: what was measured
///    of it, and its openings as far as it frames them. So a lattice of posts comes before the panes in its bays, and
///    a wall before the surrounds of its windows, however far apart they stand.
///    Timbers and lesenes that frame panels count by what was measured of them alone where more was of a wall with
///    windows close behind them. Panels between windows that they do not frame come after the wall that goes on all
///    about them, however much of them there is. A house that stands forward by as much as panels do, with windows of
///    its own in a place where nothing of the other wall is, covers none.
/// 3. What was taken for an opening but is not framed, and another wall with openings of its own fills it: there the
///    one wall ends and the other begins (a house that stands back by a hand's breadth). So it does where hardly
///    anything was seen through, and such a wall stands before it: a bay window. Windows of a house that stands
///    little before a wall are of the one that frames them.
///
/// Before: cells, openings and areas; after: role, and is_opening of step 3. The same bits for any number of threads.
/// O(planes^2) looks at up to 20 000 cells each.
/// Told again, of planes that were told before, all is forgotten first.
void tell_roles(std::vector<WallEvidence>& all, const CellSetting& setting, Task& task);

/// Whether a place lies in an opening that a wall frames, as deep behind the wall as panes and leaves are; by_border:
/// or in one that it was measured all about. Between posts of timber no wall is broad enough to frame anything.
bool is_filling_at(const WallEvidence& wall, const Vec3& p, bool by_border);

/// Of a plane's points in such openings: what fills them has that many there.
inline constexpr double kFillingShare = 0.6;
inline constexpr double kFillingDepth_m = 0.6;  ///< panes and leaves stand no deeper, loggias do

/// What of a wall a plane accounts for: what was measured, and the openings as far as it frames them.
double explained_m2(const WallEvidence& plane);

}  // namespace jalon
