// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "fieldtools/range_ranks.h"

#include <algorithm>
#include <bit>
#include <numeric>

#include "fieldtools/field_values.h"

namespace jalon {

namespace {

constexpr uint32_t kWord = 64;

}  // namespace

uint32_t RangeRanks::Level::ones_before(uint32_t i) const {
  const uint64_t below = i % kWord == 0 ? 0 : ones[i / kWord] << (kWord - i % kWord);
  return before[i / kWord] + static_cast<uint32_t>(std::popcount(below));
}

RangeRanks::RangeRanks(std::span<const double> values, Task& task) {
  const auto n = static_cast<uint32_t>(values.size());
  // 1. Ranks; equal values by position.
  struct Placed {
    double value;
    uint32_t position;
    bool operator<(const Placed& b) const {
      return value < b.value || (value == b.value && position < b.position);
    }
  };
  std::vector<uint32_t> ranks(n), next(n);
  {
    std::vector<Placed> placed(n);
    for (uint32_t i = 0; i < n; ++i) placed[i] = {values[i], i};
    placed = sorted_in_chunks(std::move(placed), std::less<>(), task);
    sorted_.resize(n);
    for (uint32_t r = 0; r < n; ++r) {
      sorted_[r] = placed[r].value;
      ranks[placed[r].position] = r;
    }
  }
  // 2. Bit by bit: zeros go before ones, either in the order they had.
  for (int bit = std::bit_width(n) - 1; bit >= 0; --bit) {
    if (task.cancelled()) task.checkpoint(0);
    Level level;
    level.ones.assign(n / kWord + 1, 0);
    for (uint32_t i = 0; i < n; ++i)
      level.ones[i / kWord] |= uint64_t{ranks[i] >> bit & 1} << i % kWord;
    level.before.assign(level.ones.size(), 0);
    for (size_t w = 1; w < level.ones.size(); ++w)
      level.before[w] =
          level.before[w - 1] + static_cast<uint32_t>(std::popcount(level.ones[w - 1]));
    level.zeros = n - level.ones_before(n);
    uint32_t zero = 0, one = level.zeros;
    for (const uint32_t r : ranks) next[r >> bit & 1 ? one++ : zero++] = r;
    ranks.swap(next);
    levels_.push_back(std::move(level));
  }
}

double RangeRanks::least(std::vector<Range>& ranges, size_t k) const {
  size_t rank = 0;
  for (const Level& level : levels_) {
    size_t zeros = 0;
    for (const Range& r : ranges)
      zeros += (r.last - level.ones_before(r.last)) - (r.first - level.ones_before(r.first));
    const bool is_one = k >= zeros;
    if (is_one) k -= zeros;
    rank = 2 * rank + (is_one ? 1 : 0);
    for (Range& r : ranges) {
      const uint32_t first = level.ones_before(r.first), last = level.ones_before(r.last);
      r = is_one ? Range{level.zeros + first, level.zeros + last}
                 : Range{r.first - first, r.last - last};
    }
    std::erase_if(ranges, [](const Range& r) { return r.first == r.last; });
  }
  return sorted_[rank];
}

}  // namespace jalon
