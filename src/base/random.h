// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

namespace jalon {

/// Counter-based random stream: value i of stream s under a seed is a pure function of (seed, s, i), so threads may
/// draw in any order and give the same bits. The mixer is splitmix64's finaliser (Steele, Lea & Flood 2014), applied to
/// each key word in turn.
class RandomStream {
 public:
  RandomStream(uint64_t seed, uint64_t stream)
      : key_(mix(mix(seed + kGolden) ^ (stream * kGolden + 1))) {}

  uint64_t bits() { return mix(key_ + kGolden * ++counter_); }
  /// Uniform in [0, 1), 53 bits.
  double uniform() { return static_cast<double>(bits() >> 11) * 0x1.0p-53; }
  /// Uniform in [0, n), n > 0, by multiply-shift; the bias is below n / 2^64.
  uint64_t below(uint64_t n) {
    return static_cast<uint64_t>((static_cast<unsigned __int128>(bits()) * n) >> 64);
  }
  /// Standard normal (Box & Muller 1958), one of the pair.
  double normal() {
    const double u = static_cast<double>((bits() >> 11) + 1) * 0x1.0p-53;  // (0, 1]
    return std::sqrt(-2 * std::log(u)) * std::cos(2 * std::numbers::pi * uniform());
  }

 private:
  static constexpr uint64_t kGolden = 0x9E3779B97F4A7C15ull;
  static uint64_t mix(uint64_t z) {
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
    return z ^ (z >> 31);
  }

  uint64_t key_;
  uint64_t counter_ = 0;
};

}  // namespace jalon
