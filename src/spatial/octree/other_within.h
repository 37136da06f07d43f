// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "spatial/octree/octree.h"

namespace jalon {

/// Whether another point lies within the radius of the one at this sorted position: the first that is found ends the
/// search.
bool has_other_within(const Octree& tree, size_t sorted_position, double radius);

}  // namespace jalon
