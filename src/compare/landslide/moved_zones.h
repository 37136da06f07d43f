// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compare/landslide/ground_errors.h"
#include "compare/landslide/settings.h"

namespace jalon {

struct MovedZones {
  std::vector<uint32_t> labels;  ///< one a cell: 1 = most cells; 0 = in none
  uint32_t count = 0;
  GroundErrors errors;
};

/// Where ground went down or came, each of one sign: cells that hang together about one whose mean over nine cells
/// exceeds what one of as many tests of the whole slope would reach by chance (Bonferroni at 1 - confidence), as far as
/// the mean over nine and the cell itself go the same way beyond theirs (hysteresis; Canny 1986). Errors are those of
/// the ground that has not moved: twice, for that is only known then.
MovedZones moved_zones(const VolumeGrid& grid, const GroundChange& change,
                       const LandslideSettings& settings, Task& task);

}  // namespace jalon
