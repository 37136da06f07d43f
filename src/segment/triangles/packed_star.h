// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "spatial/octree/octree.h"

namespace jalon {

// The triangles about a point are kept as a chain of its neighbours, of which two that follow one another make a
// triangle with it; kNoPoint parts chains. All round a point that takes about half of what the pairs would take.

/// Writes the star of one point behind what a list holds.
class StarWriter {
 public:
  explicit StarWriter(std::vector<uint32_t>& out) : out_(out) {}
  /// The triangle of the point and these two. Those of a fan come one after the other, in either direction.
  void add(uint32_t a, uint32_t b);

 private:
  std::vector<uint32_t>& out_;
  size_t chain_ = 0;  ///< neighbours since the last break
};

/// f(a, b) of every triangle, in the order in which they came.
template <class F>
void for_each_pair(std::span<const uint32_t> star, F&& f) {
  for (size_t i = 1; i < star.size(); ++i)
    if (star[i - 1] != kNoPoint && star[i] != kNoPoint) f(star[i - 1], star[i]);
}

/// Whether the point has a triangle with both.
inline bool star_has(std::span<const uint32_t> star, uint32_t a, uint32_t b) {
  for (size_t i = 1; i < star.size(); ++i)
    if ((star[i - 1] == a && star[i] == b) || (star[i - 1] == b && star[i] == a)) return true;
  return false;
}

}  // namespace jalon
