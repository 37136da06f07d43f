// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace jalon {

/// How many of a range of positions are of each class: a range costs O(1). Two bytes a position for 32 classes.
template <uint32_t Classes>
class RangeCounts {
 public:
  using Counts = std::array<uint32_t, Classes>;

  /// The class of each position, below Classes.
  explicit RangeCounts(std::vector<uint8_t> classes) : classes_(std::move(classes)) {
    Counts so_far{};
    for (size_t i = 0; i < classes_.size(); ++i) {
      if (i % kBlock == 0) before_.push_back(so_far);
      ++so_far[classes_[i]];
    }
    before_.push_back(so_far);
  }

  void add(size_t first, size_t last, Counts& out) const {
    const size_t low = (first + kBlock - 1) / kBlock, high = last / kBlock;
    if (low >= high) return add_each(first, last, out);
    add_each(first, low * kBlock, out);
    for (uint32_t c = 0; c < Classes; ++c) out[c] += before_[high][c] - before_[low][c];
    add_each(high * kBlock, last, out);
  }

 private:
  static constexpr size_t kBlock = 64;

  void add_each(size_t first, size_t last, Counts& out) const {
    for (size_t i = first; i < last; ++i) ++out[classes_[i]];
  }

  std::vector<uint8_t> classes_;
  std::vector<Counts> before_;  ///< those before each block
};

}  // namespace jalon
