// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/evaluation/sparse_assignment.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace jalon {

namespace {

constexpr int64_t kFar = std::numeric_limits<int64_t>::max();
constexpr uint32_t kRowsPerCheckpoint = 64;

// Costs are negative weights; staying alone costs 0. A row that stays alone does so for good: nothing but its own
// search or a path through its column reaches it.
class Assignment {
 public:
  Assignment(uint32_t rows, uint32_t columns, std::span<const WeightedEdge> edges)
      : edges_(edges),
        first_(rows + size_t{1}, 0),
        column_of_(rows, kUnassigned),
        weight_of_(rows, 0),
        row_of_(columns, kUnassigned),
        price_(columns, 0),
        distance_(columns, kFar),
        from_(columns, 0),
        done_(columns, 0) {
    for (const WeightedEdge& edge : edges) ++first_[edge.row + size_t{1}];
    for (size_t r = 1; r < first_.size(); ++r) first_[r] += first_[r - 1];
  }

  void add(uint32_t row) {
    search(row);
    for (const uint32_t column : scanned_) price_[column] += distance_[column] - end_distance_;
    flip(row);
    for (const uint32_t column : touched_) {
      distance_[column] = kFar;
      done_[column] = 0;
    }
    touched_.clear();
    scanned_.clear();
  }
  std::vector<uint32_t> take() { return std::move(column_of_); }

 private:
  // Shortest alternating path from the row to a free column, or to a row that is best left alone.
  void search(uint32_t start) {
    heap_ = {};
    end_column_ = kUnassigned;
    end_row_ = start;
    end_distance_ = 0;
    relax(start, 0);
    while (!heap_.empty()) {
      const auto [distance, column] = heap_.top();
      heap_.pop();
      if (done_[column] != 0 || distance != distance_[column]) continue;
      if (distance > end_distance_) return;
      if (row_of_[column] == kUnassigned) {
        end_column_ = column;
        end_distance_ = distance;
        return;
      }
      done_[column] = 1;
      scanned_.push_back(column);
      const uint32_t row = row_of_[column];
      const int64_t base = distance + weight_of_[row] + price_[column];
      if (base < end_distance_) {
        end_distance_ = base;
        end_row_ = row;
      }
      relax(row, base);
    }
  }

  void relax(uint32_t row, int64_t base) {
    for (size_t e = first_[row]; e < first_[row + size_t{1}]; ++e) {
      const uint32_t column = edges_[e].column;
      const int64_t distance = base - edges_[e].weight - price_[column];
      if (done_[column] != 0 || distance >= distance_[column]) continue;
      if (distance_[column] == kFar) touched_.push_back(column);
      distance_[column] = distance;
      from_[column] = static_cast<uint32_t>(e);
      heap_.push({distance, column});
    }
  }

  // Every row of the path takes the column it was reached over; the last one may stay alone.
  void flip(uint32_t start) {
    uint32_t column = end_column_;
    if (column == kUnassigned) {
      column = column_of_[end_row_];
      column_of_[end_row_] = kUnassigned;
      weight_of_[end_row_] = 0;
      if (end_row_ == start) return;
    }
    for (;;) {
      const WeightedEdge& edge = edges_[from_[column]];
      const uint32_t next = column_of_[edge.row];
      column_of_[edge.row] = column;
      weight_of_[edge.row] = edge.weight;
      row_of_[column] = edge.row;
      if (edge.row == start) return;
      column = next;
    }
  }

  using Reached = std::pair<int64_t, uint32_t>;  // ties by column
  std::span<const WeightedEdge> edges_;
  std::vector<size_t> first_;
  std::vector<uint32_t> column_of_;
  std::vector<int64_t> weight_of_;
  std::vector<uint32_t> row_of_;
  std::vector<int64_t> price_, distance_;
  std::vector<uint32_t> from_;
  std::vector<uint8_t> done_;
  std::vector<uint32_t> touched_, scanned_;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> heap_;
  uint32_t end_column_ = kUnassigned, end_row_ = 0;
  int64_t end_distance_ = 0;
};

}  // namespace

std::vector<uint32_t> assign_sparse(uint32_t rows, uint32_t columns,
                                    std::span<const WeightedEdge> edges, Task& task) {
  Assignment assignment(rows, columns, edges);
  for (uint32_t row = 0; row < rows; ++row) {
    if (row % kRowsPerCheckpoint == 0) task.checkpoint(static_cast<double>(row) / rows);
    assignment.add(row);
  }
  return assignment.take();
}

}  // namespace jalon
