// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/task.h"

namespace jalon {

struct WeightedEdge {
  uint32_t row = 0, column = 0;
  int64_t weight = 0;  ///< > 0
};

constexpr uint32_t kUnassigned = ~uint32_t{0};

/// The one-to-one pairs of rows and columns with the largest sum of weights; rows and columns may stay alone. Gives the
/// column of each row, or kUnassigned. edges: ascending by row. Successive shortest paths with potentials on the sparse
/// graph (Kuhn 1955; Jonker & Volgenant 1987), exact in integers; a search stays inside its connected component. O(rows
/// x edges log edges) at worst. Ties: the smaller column.
std::vector<uint32_t> assign_sparse(uint32_t rows, uint32_t columns,
                                    std::span<const WeightedEdge> edges, Task& task);

}  // namespace jalon
