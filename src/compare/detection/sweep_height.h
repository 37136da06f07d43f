// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "cloud/cloud.h"

namespace jalon {

/// Height of a scanner whose place in plan is known (place.z is not read), from the points [first, end) of its sweeps:
/// that from which the angles between points that follow one another differ least. Nothing where they are even from
/// nowhere.
std::optional<double> sweep_height(const Cloud& cloud, uint64_t first, uint64_t end,
                                   const Vec3& place, Task& task);

}  // namespace jalon
