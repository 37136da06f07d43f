// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace jalon {

/// Balls of more points go by ranges where sums over these suffice (Octree::for_each_ranged_ball): such a sum costs
/// what about a thousand points do.
constexpr size_t kManyInRanges = size_t{1} << 10;

}  // namespace jalon
