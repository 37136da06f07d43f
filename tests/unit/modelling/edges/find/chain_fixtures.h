// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/random.h"
#include "modelling/edges/find/chain_parts.h"

// Closed chains whose lines and arcs are known, for tests of what cuts them.
namespace chains {

using namespace jalon;

/// A wall 3 m wide and 4 m high to the top of its round head, its border moved in at random.
inline std::vector<Vec2> round_headed(double step_m, uint64_t seed) {
  RandomStream random(seed, 1);
  const auto in = [&] { return 0.3 * step_m * random.uniform(); };
  std::vector<Vec2> out;
  for (double u = 0; u < 3; u += step_m) out.push_back({u, in()});
  for (double v = 0; v < 2.5; v += step_m) out.push_back({3 - in(), v});
  for (double a = 0; a < std::numbers::pi; a += step_m / 1.5) {
    const double r = 1.5 - in();
    out.push_back({1.5 + r * std::cos(a), 2.5 + r * std::sin(a)});
  }
  for (double v = 2.5; v > step_m / 2; v -= step_m) out.push_back({in(), v});
  return out;
}

inline std::vector<Vec2> started_at(std::vector<Vec2> chain, size_t start) {
  std::rotate(chain.begin(), chain.begin() + static_cast<ptrdiff_t>(start), chain.end());
  return chain;
}

/// Each part ends where the next begins, and they go round once.
inline void check_closed(const std::vector<ChainPart>& parts, size_t n) {
  size_t points = 0;
  for (size_t i = 0; i < parts.size(); ++i) {
    CHECK((parts[i].first + parts[i].count - 1) % n == parts[(i + 1) % parts.size()].first);
    points += parts[i].count - 1;
  }
  CHECK(points == n);
}

}  // namespace chains
