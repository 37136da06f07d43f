// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "segment/front/wall_sheet.h"

namespace jalon {

/// Somebody close before the middle of a wall, on the side of its normal (1) or behind (-1).
Vec3 viewer_before(const WallSheet& sheet, double side);

/// Log odds of the sides of walls, each by itself, become those of all together: the surest wall is settled first;
/// who stands before it sees other walls, and on that side they were likelier scanned; then the surest of the others,
/// and so on. Storeys of one front, that stand out over one another, were seen from one side; the back wall of an
/// arcade was seen from one of several tripods, most of them before its piers. O(walls^3).
void share_viewers(const std::vector<WallSheet>& sheets, std::vector<double>& log_odds);

}  // namespace jalon
