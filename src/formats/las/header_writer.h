// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "formats/las/plan.h"
#include "formats/las/records.h"

namespace jalon::las {

/// What was written between the header and the extended records.
struct Written {
  Tally tally;
  uint64_t bytes = 0;  ///< of the points
};

size_t header_size(const Plan& plan);
/// Of the first point: behind the header and the records.
uint64_t point_offset_of(const Plan& plan);
/// The header of a file of so many points, whose bits say whether they are compressed.
std::vector<std::byte> header_bytes(const Plan& plan, const Written& written, uint64_t count,
                                    bool compressed);

}  // namespace jalon::las
