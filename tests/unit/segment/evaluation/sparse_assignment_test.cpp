// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/evaluation/sparse_assignment.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <numeric>
#include <set>

#include "base/random.h"

using namespace jalon;

namespace {

std::vector<WeightedEdge> random_edges(RandomStream& random, uint32_t rows, uint32_t columns,
                                       uint32_t degree, int64_t largest) {
  std::vector<WeightedEdge> out;
  for (uint32_t row = 0; row < rows; ++row) {
    std::set<uint32_t> chosen;
    for (uint32_t k = 0; k < degree; ++k)
      chosen.insert(static_cast<uint32_t>(random.below(columns)));
    for (const uint32_t column : chosen)
      out.push_back(
          {row, column, 1 + static_cast<int64_t>(random.below(static_cast<uint64_t>(largest)))});
  }
  return out;
}

// Weight of an assignment; -1 when a column is used twice or an edge does not exist.
int64_t weight_of(const std::vector<uint32_t>& columns, const std::vector<WeightedEdge>& edges) {
  std::set<uint32_t> used;
  int64_t sum = 0;
  for (uint32_t row = 0; row < columns.size(); ++row) {
    if (columns[row] == kUnassigned) continue;
    if (!used.insert(columns[row]).second) return -1;
    bool exists = false;
    for (const WeightedEdge& edge : edges)
      if (edge.row == row && edge.column == columns[row]) sum += edge.weight, exists = true;
    if (!exists) return -1;
  }
  return sum;
}

// Every assignment, row by row.
int64_t best_by_trial(const std::vector<WeightedEdge>& edges, uint32_t row, uint32_t rows,
                      uint32_t used) {
  if (row == rows) return 0;
  int64_t best = best_by_trial(edges, row + 1, rows, used);
  for (const WeightedEdge& edge : edges)
    if (edge.row == row && (used >> edge.column & 1) == 0)
      best = std::max(best,
                      edge.weight + best_by_trial(edges, row + 1, rows, used | 1u << edge.column));
  return best;
}

// The heaviest edge first, of the ends that are left.
int64_t greedy_weight(std::vector<WeightedEdge> edges, uint32_t n) {
  std::stable_sort(edges.begin(), edges.end(), [](const WeightedEdge& a, const WeightedEdge& b) {
    return a.weight > b.weight;
  });
  std::vector<bool> rows(n), columns(n);
  int64_t sum = 0;
  for (const WeightedEdge& edge : edges) {
    if (rows[edge.row] || columns[edge.column]) continue;
    rows[edge.row] = columns[edge.column] = true;
    sum += edge.weight;
  }
  return sum;
}

// Every row with its best column, whoever else has it.
int64_t wished_weight(const std::vector<WeightedEdge>& edges, uint32_t n) {
  std::vector<int64_t> best(n);
  for (const WeightedEdge& edge : edges) best[edge.row] = std::max(best[edge.row], edge.weight);
  return std::accumulate(best.begin(), best.end(), int64_t{0});
}

}  // namespace

TEST_CASE("sparse assignment reaches the largest weight that trying everything finds") {
  RandomStream random(1, 3);
  Task task;
  for (int trial = 0; trial < 2000; ++trial) {
    const auto rows = static_cast<uint32_t>(1 + random.below(6)),
               columns = static_cast<uint32_t>(1 + random.below(7));
    const auto edges = random_edges(random, rows, columns, static_cast<uint32_t>(random.below(5)),
                                    trial % 2 == 0 ? 5 : 1000);
    CAPTURE(trial);
    CHECK(weight_of(assign_sparse(rows, columns, edges, task), edges) ==
          best_by_trial(edges, 0, rows, 0));
  }
}

TEST_CASE(
    "sparse assignment of 5000 rows in one component weighs more than greed, less than wishes") {
  RandomStream random(2, 3);
  Task task;
  const uint32_t n = 5000;
  auto edges = random_edges(random, n, n, 8, 1000);
  const auto before = std::chrono::steady_clock::now();
  const auto columns = assign_sparse(n, n, edges, task);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
  MESSAGE("FIGURE assignment of 5000 x 5000 segments with " << edges.size()
                                                            << " overlaps: " << seconds << " s");
  const int64_t weight = weight_of(columns, edges);
  CHECK(weight > greedy_weight(edges, n));
  CHECK(weight < wished_weight(edges, n));  // columns that several rows want are given once
}
