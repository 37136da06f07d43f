// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "fieldtools/sort_along.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace jalon {

namespace {

// Below it counting all others is faster than two rounds over 256 counters.
constexpr size_t kFew = 48;
constexpr size_t kByte = 256;
constexpr double kLastStep = kByte * kByte - 1;
// Places that values may move by on the average when the rounds are set right.
constexpr size_t kMostMoves = 8;

void sort_by_counting(std::vector<double>& values, std::vector<double>& work) {
  const size_t n = values.size();
  const double* const from = values.data();
  for (size_t i = 0; i < n; ++i) {
    const double value = from[i];
    int64_t before = 0;
    for (size_t j = 0; j < i; ++j) before += from[j] <= value;
    for (size_t j = i + 1; j < n; ++j) before += from[j] < value;
    work[static_cast<size_t>(before)] = value;
  }
  values.swap(work);
}

using Counters = std::array<uint32_t, kByte>;

void to_begins(Counters& counters) {
  uint32_t sum = 0;
  for (uint32_t& c : counters) {
    const uint32_t count = c;
    c = sum;
    sum += count;
  }
}

void sort_by_bytes(std::vector<double>& values, std::vector<double>& work, double least,
                   double largest) {
  const double scale = kLastStep / (largest - least);
  const auto step = [&](double value) { return static_cast<uint32_t>((value - least) * scale); };
  Counters low{}, high{};
  for (const double v : values) {
    const uint32_t s = step(v);
    ++low[s % kByte];
    ++high[s / kByte];
  }
  to_begins(low);
  to_begins(high);
  for (const double v : values) work[low[step(v) % kByte]++] = v;
  for (const double v : work) values[high[step(v) / kByte]++] = v;
}

void set_right(std::vector<double>& values) {
  size_t moves = 0;
  for (size_t i = 1; i < values.size(); ++i) {
    const double value = values[i];
    size_t at = i;
    for (; at > 0 && value < values[at - 1]; --at) values[at] = values[at - 1];
    values[at] = value;
    moves += i - at;
    if (moves > kMostMoves * values.size()) return std::sort(values.begin(), values.end());
  }
}

}  // namespace

void sort_along(std::vector<double>& values, std::vector<double>& work) {
  work.resize(values.size());
  if (values.size() <= kFew) return sort_by_counting(values, work);
  double least = values[0], largest = values[0];
  for (const double v : values) {
    least = std::min(least, v);
    largest = std::max(largest, v);
  }
  // A width that underflows has no scale.
  constexpr double kLeastWidth = 0x1p-900;
  if (largest - least > kLeastWidth) sort_by_bytes(values, work, least, largest);
  set_right(values);
}

}  // namespace jalon
