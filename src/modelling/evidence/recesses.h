// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/task.h"
#include "modelling/evidence/evidence.h"

namespace jalon {

/// Tells the back walls of loggias and arcades (is_recess): walls farther behind the openings of another wall than
/// panes are, with openings of their own, to which the sides of these openings go all the way. Between a pane and what
/// hangs behind it nothing is seen at their sides.
///
/// Before: roles. After: is_recess of walls whose area in such openings is mostly in openings with a side, a head or a
/// floor measured all along the depth. Openings of these walls end where the opening ends that they are seen through.
/// The same bits for any number of threads. O(points x such openings).
void tell_recesses(const Segmentation& segmentation, std::vector<WallEvidence>& all, Task& task);

/// Segments whose planes face away from those who saw them: mostly seen through a wall that explains more and faces the
/// other way, no farther behind it than the back of an arcade. Each is told from what lies about it alone, and rooms
/// behind shop fronts outweigh a passage. Where stations tell the sides there are none. Before: roles.
std::vector<size_t> turned_away(const Segmentation& segmentation,
                                const std::vector<WallEvidence>& all, Task& task);

}  // namespace jalon
